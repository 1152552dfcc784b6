// Base of the trust region (solver/trust_region.hpp) and of the overdamped descent (solver/descent.hpp), in
// common: Newton steps regularised until they go downhill, (K + m D) delta = r with the residual r, the
// tangent K and a diagonal D like that of the stiffness, and the loop about them. They differ in how far a
// step may go and in what they do about m.
#pragma once
#include <optional>

#include "solver/newton.hpp"

namespace fabricsh::solver {

class Downhill {
 public:
  // symmetric: whether negative pivots say that the matrix is not positive definite.
  Downhill(Problem& problem, const NewtonOptions& options, LinearSolver& linear, bool symmetric);
  virtual ~Downhill() = default;
  // begun: of what leads to the first iterate, with its residual and its tangent.
  NewtonResult run(Answer begun);

 protected:
  // converged: a step has been made, and r_ is the residual at the trial configuration.
  virtual NewtonStatus make_step() = 0;
  // The trial configuration becomes the iterate, with its tangent.
  virtual Answer move_on() = 0;
  // At a balance. Empty: it has been left.
  virtual std::optional<NewtonStatus> at_balance() { return NewtonStatus::converged; }
  // Where there is no balance. converged: the iteration may go on.
  virtual NewtonStatus out_of_balance() const = 0;

  // K + m D. False: it is singular, or symmetric and not positive definite.
  bool factorise(double m);
  bool solve(std::span<const double> b, std::span<double> x);
  // Sets delta_ from the factors, with what the problem adds, and work_. False: it does not go downhill. A
  // part at rest while another one is on its way has nothing to reduce.
  bool find_downhill();
  Answer tangent_at_iterate();  // the plain one, with its residual

  Problem& problem_;
  const NewtonOptions options_;
  LinearSolver& linear_;
  const bool symmetric_;
  Matrix K_, A_;
  linear::Vector r_, delta_, trial_r_, D_;
  NewtonResult result_;
  double work_ = 0;    // delta_ . r_, J
  bool gone_ = false;  // a part has gone so far that rounding of its coordinates looks like balance

 private:
  bool balanced();
  double first_floor_ = 0;        // N
  bool within_rounding_ = false;  // the first residual
};

}  // namespace fabricsh::solver
