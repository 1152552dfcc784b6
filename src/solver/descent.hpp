// Relaxation by an overdamped motion in implicit steps: (K + m D) dx = r with the residual r, the tangent K,
// a viscosity D like the diagonal of the stiffness, and m that falls as long as the energy does and rises
// where it would not. Far from rest this is a creep downhill, which passes bifurcations towards less energy
// and ends in no unstable shape; near rest it is Newton's method. It does not depend on how much stiffer
// pulls are than bending, which is what dynamic relaxation fails at.
#pragma once
#include <memory>

#include "solver/newton.hpp"

namespace fabricsh::solver {

class Descent {
 public:
  explicit Descent(std::unique_ptr<LinearSolver> linear) : linear_(std::move(linear)) {}
  // From the committed configuration, with the supports moved to their targets first. iterations: linear
  // solves; residuals: relative, of the steps that were taken.
  NewtonResult solve(Problem& problem, const NewtonOptions& options);
  NewtonResult go_on(Problem& problem, const NewtonOptions& options);  // from the iterate saved last

 private:
  std::unique_ptr<LinearSolver> linear_;
};

}  // namespace fabricsh::solver
