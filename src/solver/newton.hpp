// Newton's method with a line search [williams2010, Box 5-1]. It works on vectors and does not know meshes.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/answer.hpp"
#include "linear/linear_solver.hpp"
#include "linear/vector.hpp"
#include "solver/stable.hpp"

namespace fabricsh::solver {

using linear::Index;
using linear::LinearReport;
using linear::LinearSolver;
using linear::Matrix;

// A problem as the solver sees it: unknowns, forces, tangent, and a way to update
// the configuration (directors lie on a sphere, so an increment is applied by a
// rotation, not a sum). There are three configurations: committed, iterate and trial.
class Problem {
 public:
  virtual ~Problem() = default;
  virtual Index size() const = 0;
  // At the committed configuration: the tangent K, which takes over the problem's pattern, the residual r =
  // f_ext - f_int, and the linearised forces of the supports' motion to their targets, lead = - K_fp du_p.
  // Sets iterate = trial = committed.
  virtual Answer predict(Matrix& K, std::span<double> r, std::span<double> lead) = 0;
  // trial = iterate moved by scale * delta, with the supports at their targets.
  virtual void apply_increment(std::span<const double> delta, double scale) = 0;
  // The share of `way` times a step from the iterate along delta that is safe, at most 1. At 0
  // the step must be cut. (The supports go to their targets whatever the fraction.)
  virtual double limit(std::span<const double> /*delta*/, double /*way*/ = 1) { return 1; }
  // Whether a part of the way that limit() was last asked for is safe, too. It need not lie on that way.
  virtual bool is_safe(std::span<const double> /*delta*/, double /*part*/) { return true; }
  // A direction delta = K^-1 r, to which the problem adds what it solves for beside the matrix; solve: K x =
  // b. False: there is none.
  using Solve = std::function<bool(std::span<const double> b, std::span<double> x)>;
  virtual bool finish_direction(const Solve& /*solve*/, std::span<double> /*delta*/) { return true; }
  virtual void accept() = 0;  // iterate = trial
  // Whether all that moves by fractions has reached its prescribed position; none converges before.
  virtual bool at_target() const { return true; }
  virtual Answer residual(std::span<double> r) = 0;  // r = f_ext - f_int at the trial configuration
  virtual Answer tangent(Matrix& K) = 0;             // at the trial configuration
  // The tangent at the trial configuration for the stresses of the strains that the step from the iterate
  // predicts linearly; the residual is as before. Without quadratic strains: the tangent.
  virtual Answer extrapolated_tangent(Matrix& K) { return tangent(K); }
  // Whether parts switch between branches, as yarns do. Then the tangent K at the trial configuration for the
  // stresses of such strains, and the residual r of stresses that are linear about them: each part is on the
  // branch that it had in the last such tangent, or in predict(), or on the neighbouring one.
  virtual bool has_branches() const { return false; }
  virtual Answer tangent_on_branches(Matrix& K, std::span<double> /*r*/) { return tangent(K); }
  // Adds `times` the inertia to K, which then is more like that of a shorter step in time.
  virtual void add_inertia(Matrix& /*K*/, double /*times*/) {}
  // rad: the largest turn that a step along delta makes, of a director, or of a mean edge by its end.
  virtual double turn_of(std::span<const double> delta) const = 0;
  virtual void save_iterate() = 0;     // stores the trial configuration, an iterate
  virtual void restore_iterate() = 0;  // trial = the iterate stored last
  // The largest entry of a residual in N (moments are divided by
  // the problem's length), and the unknown that has it (-1: none).
  virtual std::pair<double, Index> largest(std::span<const double> r) const = 0;
  virtual double force_scale() const = 0;  // N: the force that residuals are compared with
  // N: the residual caused by rounding of the coordinates
  // at this stiffness; a smaller tolerance cannot be met.
  virtual double rounding_floor(const Matrix& K) const = 0;
};

struct NewtonOptions {
  double tolerance = 1e-10;
  int max_iterations = 25;
  bool line_search = true;
  // Stable equilibria: an unstable one is left if the energy falls in no more than so many directions; with a
  // smaller step they may be met one after another, so that the shape does not depend on the step.
  Index most_unstable = 1;
  // Of the usual turns by which an unstable equilibrium is left: less in a shape that has already buckled.
  // From there the next one is near, and further away lie others, of which the step would decide.
  double turns = 1;
};

// law_failed: the forces could not be evaluated with this step; broken: with no step, however small.
enum class NewtonStatus {
  converged,
  law_failed,
  singular,
  diverged,
  too_many_iterations,
  turned_back,
  unstable,
  inverted,
  blocked,  // the problem permits no part of a direction
  broken
};
const char* describe(NewtonStatus status);
NewtonStatus status_of(Answer answer);  // for an answer that is not ok
// A residual over the force that it is compared with, both in N. Without a reference force the relative
// residual is 1.
inline double compared(double size, double scale) { return size == 0 ? 0 : scale > 0 ? size / scale : 1; }
// Turns ok into a failure if the residual is not finite.
Answer checked(Answer answer, std::span<const double> r);

struct NewtonResult {
  NewtonStatus status = NewtonStatus::too_many_iterations;
  int iterations = 0;                          // linear solves
  int far = 0;                                 // of them until the residual was near a solution
  std::vector<double> residuals;               // relative, after each solve
  Index worst = -1;                            // unknown with the largest residual
  Index negative_pivots = 0;                   // of the last tangent that was factorised
  Stability stability = Stability::unchecked;  // of the equilibrium
  int left_unstable = 0;  // unstable equilibria that were left to the side of less energy
};

class Newton {
 public:
  explicit Newton(std::unique_ptr<LinearSolver> linear) : linear_(std::move(linear)) {}
  NewtonResult solve(Problem& problem, const NewtonOptions& options);    // from the committed configuration
  NewtonResult correct(Problem& problem, const NewtonOptions& options);  // from the trial configuration

 private:
  Answer predict(Problem& problem);  // with the motion of the supports in r_
  bool bring_within(double furthest, Problem& problem, NewtonResult& result);
  NewtonResult follow_branches(Problem& problem, const NewtonOptions& options);
  NewtonResult iterate(Problem& problem, const NewtonOptions& options, bool predicted);
  std::optional<NewtonStatus> judge(Problem& problem, std::span<const double> r, double tolerance,
                                    NewtonResult& result) const;
  bool direction(Problem& problem);  // delta_ = K^-1 r_, and what the problem adds
  bool solve_with_factors(Problem& problem, std::span<const double> r);  // likewise, by the factors at hand
  // A last direction by the factors at hand, if that can do; r: the residual at the trial configuration.
  std::optional<NewtonStatus> finish(Problem& problem, std::span<double> r, double tolerance,
                                     NewtonResult& result);
  // Empty: done.
  std::optional<NewtonStatus> search(Problem& problem, bool line_search);
  void resize(Index size);
  std::unique_ptr<LinearSolver> linear_;
  Matrix K_;
  linear::Vector r_, delta_, trial_r_;  // trial_r_: also the forces of the supports' motion
};

}  // namespace fabricsh::solver
