// Stable equilibria by a regularised Newton method: (K + m D) delta = r with the residual r, the tangent K
// and a diagonal D like that of the stiffness, where m is so large that the matrix is positive definite and
// the step stays within a trust region [conn2000]. A step is accepted for the energy that it takes away, not
// for how far the residual falls, so that the iteration goes downhill and cannot end in an unstable shape.
//
// Thin sheets are far stiffer in their plane than in bending: a straight step that turns an element by an
// angle a stretches it by a^2/2, and the stress of that stretch, which equilibrium does not have, would spoil
// the next tangent. Tangents are therefore evaluated with the stresses that the last step predicted linearly,
// as if stresses were unknowns of their own [magisano2017]. With them steps may turn the sheet by ten times
// as much as with the plain tangent.
//
// A step that does not lower the energy is taken on trial at first, since the next one often undoes the
// stretch; if the energy has not fallen below that of the best configuration so far after a few such steps,
// the iteration returns to that configuration and from then on every step must lower the energy: the watchdog
// technique of [chamberlain1982].
#pragma once
#include <memory>

#include "solver/newton.hpp"
#include "solver/stability.hpp"

namespace fabricsh::solver {

class TrustRegion {
 public:
  // symmetric: whether the problem's tangents are. For others the matrix is regularised until the step does
  // work against the residual. judge: what its tangents tell about the stability of an equilibrium.
  TrustRegion(std::unique_ptr<LinearSolver> linear, bool symmetric, Judge judge = Judge::energy)
      : linear_(std::move(linear)), symmetric_(symmetric), judge_(judge) {}
  // From the committed configuration: a first step moves the supports to their targets, then equilibrium is
  // sought. iterations: factorisations; residuals: relative, of the steps that were taken. Without
  // options.line_search every step within the trust region is accepted.
  NewtonResult solve(Problem& problem, const NewtonOptions& options);
  NewtonResult correct(Problem& problem, const NewtonOptions& options);  // from the trial configuration

 private:
  std::unique_ptr<LinearSolver> linear_;
  bool symmetric_;
  Judge judge_;
};

}  // namespace fabricsh::solver
