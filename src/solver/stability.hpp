// Whether an equilibrium is stable: the lowest eigenvalue of its tangent.
#pragma once
#include <functional>
#include <memory>

#include "linear/linear_solver.hpp"
#include "linear/vector.hpp"
#include "solver/stable.hpp"

namespace fabricsh::solver {

using linear::Index;

// K v = lambda D v with a positive diagonal D; v^T D v = 1.
struct Mode {
  double value = 0;
  linear::Vector shape;  // empty: none was found
};

// Of the negative eigenvalues the lowest one that some steps of Lanczos' method [parlett1998] with the
// factors of K + shift D separate; D^1/2 (K + shift D)^-1 D^1/2 has the eigenvalues nearest to zero at its
// ends, where they converge in a few steps, however close to zero they are. solve: x = (K + shift D)^-1 b.
using Solve = std::function<bool(std::span<const double> b, std::span<double> x)>;
Mode lowest_mode(const linear::Matrix& K, std::span<const double> D, double shift, const Solve& solve);

// Properties of the loads and the law of a problem, on which it depends what a tangent tells.
enum class Judge {
  never,   // loads without a potential whose tangent may be symmetric by chance, as of moments
  energy,  // whatever is not symmetric comes from loads without a potential, as friction
  work     // it comes from the law, of which the second-order work decides, that is, the symmetric part
};

class StabilityCheck {
 public:
  // linear: factorises the tangents of the problem; symmetric: they are, but for what they keep apart.
  StabilityCheck(linear::LinearSolver& linear, bool symmetric, Judge judge)
      : linear_(linear), symmetric_(symmetric), judge_(judge) {}
  // Of the tangent at an equilibrium and its absolute sums. One factorisation where it is stable.
  Stability of(const linear::Matrix& K, std::span<const double> D);
  int factorisations() const { return factorisations_; }  // of the last question
  Index negative() const { return negative_; }            // pivots
  const Mode& mode() const { return mode_; }              // of what is unstable

 private:
  bool definite(const linear::Matrix& K, linear::LinearSolver& linear);
  Stability by_symmetric_part(const linear::Matrix& S, std::span<const double> D,
                              linear::LinearSolver& linear);
  Stability with_friction(const linear::Matrix& K, std::span<const double> D);
  linear::LinearSolver& linear_;
  const bool symmetric_;
  const Judge judge_;
  std::unique_ptr<linear::LinearSolver> own_,
      whole_;  // of symmetric parts; of all of a matrix with such apart
  linear::Matrix S_, A_;
  Mode mode_;
  Index negative_ = 0;
  int factorisations_ = 0;
};

}  // namespace fabricsh::solver
