// The one-dimensional hysteretic springs of the woven law: yarn (either axis), in-plane shear, biaxial.
// share/doc/theory.md, 4: S11 = H1(E11) + c E22, S22 = H2(E22) + c E11.
#pragma once
#include "law/backbone.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

// Strains closer than this to a switch count as lying on it when a tangent is chosen (not for a stress).
inline constexpr double switch_width = 1e-12;

// Whether the virgin tangent is used at x, where m is the largest strain before this step.
template <class T>
auto virgin_tangent(T x, T m, AtSwitch at) {
  const T width(switch_width);
  return at == AtSwitch::loading ? x >= m - width : x > m + width;
}

template <class T>
struct SpringValue {
  T S, C;  // stress and slope
};

// H(E) of one yarn; m: on entry the committed, on return the trial largest strain.
template <class Curve, class T>
SpringValue<T> yarn_spring(const AxisOf<Curve>& axis, double coupling, AtSwitch at, T E, T& m) {
  const T m0 = m;
  m = max(E, m0);
  const auto curve = backbone_at(axis.curve, m);
  const T Du(axis.unloading), h(axis.slack), cross(coupling * axis.poisson);
  const T residual = m - curve.P * T(axis.softness);
  const auto is_virgin = E >= m0;
  const auto is_slack = E < residual;
  const T unloading = Du * (E - residual);
  const T yarn = select(is_virgin, curve.P, unloading) + cross * E;
  const T slack = cross * residual + h * (E - residual);
  const T slope = select(virgin_tangent(E, m0, at), curve.D, Du) + cross;
  // Virgin cloth at E = 0: loading follows the virgin curve, unloading is slack at once.
  const auto slack_slope = at == AtSwitch::loading
                               ? is_slack & !(virgin_tangent(E, m0, at))
                               : is_slack | ((m <= T(switch_width)) & (E <= T(switch_width)));
  return {select(is_slack, slack, yarn), select(slack_slope, h, slope)};
}

// H(E) of a yarn on whose spring elements act: beyond the factor's limit the spring goes on along its
// unloading line, and its stress is multiplied by the factor; the coupling is not.
template <class Curve, class T>
SpringValue<T> factored_yarn(const AxisOf<Curve>& axis, double coupling, AtSwitch at,
                             const rheology::YarnFactor<T>& factor, T E, T& m) {
  const T m0 = m;
  m = max(min(E, factor.limit), m0);
  const auto curve = backbone_at(axis.curve, m);
  const T Du(axis.unloading), h(axis.slack), cross(coupling * axis.poisson);
  const T residual = m - curve.P * T(axis.softness);
  const T own = select((E >= m0) & (E <= factor.limit), curve.P, Du * (E - residual));
  const auto on_curve = virgin_tangent(E, m0, at) & (E < factor.limit);
  const auto is_slack = E < residual;
  const auto slack_slope = at == AtSwitch::loading
                               ? is_slack & !on_curve
                               : is_slack | ((m <= T(switch_width)) & (E <= T(switch_width)));
  const T slope = factor.value * select(on_curve, curve.D, Du) + factor.rate * own + cross;
  return {select(is_slack, cross * residual + h * (E - residual), factor.value * own + cross * E),
          select(slack_slope, h, slope)};
}

// Whether the shear spring keeps the previous branch; a plain law never does.
inline bool fades(const ShearData& shear) { return shear.fading; }
constexpr bool fades(const ShearOf<CubicBackbone>&) { return false; }

// State of the in-plane shear spring. sign 0 (virgin) counts as +1.
template <class T>
struct ShearState {
  T origin, peak, sign, lost;
  T faded;  // peak of the previous branch (memory "fading" only)
};

// Energy dissipated on a branch whose peak is g: U(g) - P(g)^2 / (2 Gu).
template <class T>
T branch_loss(const BackboneValue<T>& at_peak, T Gu) {
  return at_peak.U - at_peak.P * at_peak.P / (T(2.0) * Gu);
}

// The branch after a reversal of stress: it starts at zero stress, with the peak that the memory leaves.
template <class Curve, class T>
ShearState<T> reversed(const ShearOf<Curve>& shear, T gamma, const ShearState<T>& old,
                       const BackboneValue<T>& at_peak, T zero, T beyond) {
  const T Gu(shear.unloading);
  ShearState<T> s;
  s.sign = -old.sign;
  s.lost = old.lost + branch_loss(at_peak, Gu);
  s.peak = T(0.0);
  s.faded = old.peak;
  T start(0.0);
  if (fades(shear)) {
    s.peak = max(old.faded - zero, T(0.0));
    const auto again = backbone_at(shear.curve, s.peak);
    s.lost = s.lost - branch_loss(again, Gu);
    start = s.peak - again.P * T(shear.softness);
  }
  s.origin = gamma - s.sign * (start + beyond);
  return s;
}

template <class T>
ShearState<T> choose(decltype(T() < T()) c, const ShearState<T>& a, const ShearState<T>& b) {
  return {select(c, a.origin, b.origin), select(c, a.peak, b.peak), select(c, a.sign, b.sign),
          select(c, a.lost, b.lost), select(c, a.faded, b.faded)};
}

// S12(gamma), with at most one reversal per call.
template <class Curve, class T>
SpringValue<T> shear_spring(const ShearOf<Curve>& shear, AtSwitch at, T gamma, ShearState<T>& s) {
  const T Gu(shear.unloading), width(switch_width);
  s.sign = select(s.sign < T(0.0), T(-1.0), T(1.0));
  const T r_old = s.sign * (gamma - s.origin);
  const auto at_peak = backbone_at(shear.curve, s.peak);
  const T zero = s.peak - at_peak.P * T(shear.softness);
  // Unloading to exactly zero stress is no reversal; only a branch with a peak can be unloaded.
  const T slop = select(s.peak > width, width, T(0.0));
  const auto flip = r_old < zero - slop;
  if (any(flip)) s = choose(flip, reversed(shear, gamma, s, at_peak, zero, zero - r_old), s);

  const T r = s.sign * (gamma - s.origin);
  const T peak0 = s.peak;
  s.peak = max(r, peak0);
  const auto curve = backbone_at(shear.curve, s.peak);
  const T S = select(r >= peak0, curve.P, curve.P - Gu * (peak0 - r));
  // Just after a reversal r is the whole distance since then, however small: virgin for either value of `at`.
  const auto is_virgin = virgin_tangent(r, peak0, at) | (flip & (r >= peak0)) | (s.peak <= width);
  return {s.sign * S, select(is_virgin, curve.D, Gu)};
}

// Yield stress of the friction in shear.
template <class T>
T friction_limit(const FrictionData& f, T gamma) {
  return T(f.stress) + T(f.growth) * min(abs(gamma), T(f.limit));
}

// The integral of the yield stress from 0; odd.
template <class T>
T friction_area(const FrictionData& f, T gamma) {
  const T size = abs(gamma), inside = min(size, T(f.limit));
  const T area = T(f.stress) * size + T(f.growth) * inside * (size - T(0.5) * inside);
  return select(gamma < T(0.0), -area, area);
}

// The gamma at which friction that sticks at a given slip begins
// to slide towards larger gamma: k (gamma - slip) = limit(gamma).
template <class T>
T slide_begins(const FrictionData& f, T slip) {
  const T k(f.stiffness), reach = k * slip + T(f.stress);
  const T inside = reach / (k + select(reach < T(0.0), T(f.growth), T(-f.growth)));
  const T outside = slip + T(f.stress + f.growth * f.limit) / k;
  return select(abs(inside) <= T(f.limit), inside, outside);
}

// Friction in shear over a straight step; slip and lost: committed on entry, trial on return. Sliding
// from gamma_c to gamma loses int limit dgamma less what is stored, (limit^2 - limit_c^2) / (2 k).
template <class T>
SpringValue<T> shear_friction(const FrictionData& f, AtSwitch at, T gamma, T& slip, T& lost) {
  const T k(f.stiffness), limit = friction_limit(f, gamma), one(1.0), zero(0.0);
  const T stuck = k * (gamma - slip), held = max(min(stuck, limit), -limit);
  const T side = select(stuck < zero, -one, one);
  const auto slides = abs(stuck) > limit;
  const T begin = slide_begins(f, side * slip), first = friction_limit(f, begin);
  const T loss = friction_area(f, side * gamma) - friction_area(f, begin) -
                 (limit + first) * (limit - first) / (T(2.0) * k);
  lost += select(slides, max(loss, zero), zero);
  slip = select(slides, gamma - held / k, slip);
  const auto sticks = abs(stuck) < limit * T(at == AtSwitch::loading ? 1 - 1e-12 : 1 + 1e-12);
  const T outward = select(side * gamma < zero, -one, one);
  const T slope = select(abs(gamma) < T(f.limit), outward * T(f.growth), zero);
  return {held, select(sticks, k, slope)};
}

// T(y) of the biaxial spring, y = E11 + alpha E22 - offset; below its residual T = 0.
template <class T>
SpringValue<T> biaxial_spring(const BiaxialData& spring, AtSwitch at, T y, T& m) {
  const T m0 = m;
  m = max(y, m0);
  const auto curve = backbone_at(spring.curve, m);
  const T Tu(spring.unloading);
  const T residual = m - curve.P / Tu;
  const auto is_slack = y < residual;
  const T stress = select(y >= m0, curve.P, Tu * (y - residual));
  const T slope = select(virgin_tangent(y, m0, at), curve.D, Tu);
  return {select(is_slack, T(0.0), stress), select(is_slack, T(0.0), slope)};
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
