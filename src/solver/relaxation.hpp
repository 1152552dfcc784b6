// Dynamic relaxation [day1965; papadrakakis1981] with kinetic damping: a fictitious motion
// with lumped masses under the residual forces is stopped at every peak of its kinetic
// energy until the residual vanishes. No matrix is factorised, so the method works where
// the tangent is singular or indefinite; in return it needs many cheap iterations.
#pragma once
#include "solver/newton.hpp"

namespace fabricsh::solver {

struct RelaxationOptions {
  double tolerance = 1e-4;
  int max_iterations = 20000;
  // Part of the largest mass below which none is. Of a membrane, which has no stiffness out of its plane
  // until it is taut, but then much.
  double least_mass = 0;
};

class Relaxation {
 public:
  // solve() starts from the committed configuration, with the supports moved to their targets first; go_on()
  // from the trial one. iterations: of the fictitious motion; residuals: at its peaks and at the end.
  NewtonResult solve(Problem& problem, const RelaxationOptions& options);
  NewtonResult go_on(Problem& problem, const RelaxationOptions& options);

 private:
  Answer masses(Problem& problem, double least);
  void resize(Index size);
  Matrix K_;
  linear::Vector r_, mass_, velocity_;
};

}  // namespace fabricsh::solver
