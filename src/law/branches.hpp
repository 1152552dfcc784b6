// Yarns as if each went on along one branch: slack, taut (letting go or reloading), or virgin. A yarn is taut
// within a strain of some 1e-4 only, between two branches that are far softer, and Newton's steps would jump
// over it from one of these to the other for ever. Where each keeps to the line of its branch, and leaves it
// for the neighbouring one alone, the solution of the linear equations tells which yarns are taut, as it
// tells which of several parts stick and which slide.
#pragma once
#include "law/data.hpp"
#include "law/springs.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

namespace yarn_branch {
inline constexpr double slack = -1, unknown = 0, taut = 1, virgin = 2;
}

// Whether the yarns of a law have branches of this kind.
inline bool has_branches(const Law& law) {
  return law.kind == CompiledKind::potential && !has_folds(law) && !is_curved(law.woven) &&
         !law.woven.friction.on && !law.woven.shear.fading && !rheology::any_on_springs(law.woven.elements);
}

// H(E) of a yarn without a loop on its branch; m: the committed largest strain. branch: the last one on
// entry, the present one on return.
template <class Curve, class T>
SpringValue<T> yarn_on_branch(const AxisOf<Curve>& axis, double coupling, T E, T m, T& branch) {
  using namespace yarn_branch;
  const auto peak = backbone_at(axis.curve, m), beyond = backbone_at(axis.curve, max(E, m));
  const T Du(axis.unloading), h(axis.slack), cross(coupling * axis.poisson);
  const T residual = m - peak.P * T(axis.softness), none(slack), tight(taut), first(virgin);
  const auto above = E >= m - T(switch_width), below = E < residual;
  const T here = select(above, first, select(below, none, tight));
  const T leaves = select(here == branch, here, tight);
  branch = select((branch == T(unknown)) | (branch == tight), here, leaves);
  const auto is_virgin = branch == first, is_slack = branch == none;
  const T along = select(E >= m, beyond.P, peak.P + peak.D * (E - m));
  const T S = select(is_virgin, along, Du * (E - residual)) + cross * E;
  const T C = select(is_virgin, beyond.D, Du) + cross;
  return {select(is_slack, cross * residual + h * (E - residual), S), select(is_slack, h, C)};
}

// The same of the shear spring: beyond the peak of its branch, before it, or on the branch after a reversal.
template <class Curve, class T>
SpringValue<T> shear_on_branch(const ShearOf<Curve>& shear, const ShearState<T>& old, T gamma, T& branch) {
  using namespace yarn_branch;
  const T Gu(shear.unloading), width(switch_width), none(slack), tight(taut), first(virgin);
  ShearState<T> s = old;
  s.sign = select(s.sign < T(0.0), T(-1.0), T(1.0));
  const T r = s.sign * (gamma - s.origin);
  const auto at_peak = backbone_at(shear.curve, s.peak);
  const T zero = s.peak - at_peak.P * T(shear.softness);
  const auto above = r >= s.peak - width, below = r < zero;
  const T here = select(above, first, select(below, none, tight));
  const T leaves = select((here == branch) | (s.peak <= width), here, tight);
  branch = select((branch == T(unknown)) | (branch == tight), here, leaves);
  const auto beyond = backbone_at(shear.curve, max(r, s.peak));
  const auto is_virgin = branch == first, is_back = branch == none;
  const T up = select(r >= s.peak, beyond.P, at_peak.P + at_peak.D * (r - s.peak));
  const auto back = reversed(shear, gamma, s, at_peak, zero, zero - r);
  const T q = back.sign * (gamma - back.origin), q0 = max(q, back.peak);
  const auto along = backbone_at(shear.curve, q0);
  const T other = back.sign * (along.P + along.D * (q - q0));
  const T S = s.sign * select(is_virgin, up, at_peak.P - Gu * (s.peak - r));
  return {select(is_back, other, S), select(is_back, along.D, select(is_virgin, beyond.D, Gu))};
}

// Puts the yarns and the shear on their branches in the response of law "potential" with straight unloading
// at the strain E. s0: its committed state; branches: of warp, weft and shear.
template <class Woven, class T>
void put_on_branches(const Woven& law, AtSwitch at, const T E[3], const T* s0, T* branches, T* const (&S)[3],
                     T* const (&C)[3]) {
  for (int i = 0; i < 2; ++i) {
    T m = s0[i];
    const auto own = yarn_spring(law.axis[i], law.coupling, at, E[i], m);
    const auto on = yarn_on_branch(law.axis[i], law.coupling, E[i], s0[i], branches[i]);
    *S[i] += on.S - own.S;
    *C[i] += on.C - own.C;
  }
  using namespace potential_state;
  const ShearState<T> old{s0[g0], s0[gp], s0[sg], s0[lost], T(0.0)};
  ShearState<T> trial = old;
  const auto own = shear_spring(law.shear, at, E[2], trial);
  const auto on = shear_on_branch(law.shear, old, E[2], branches[2]);
  *S[2] += on.S - own.S;
  *C[2] += on.C - own.C;
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
