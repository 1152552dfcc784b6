// Unloading and reloading of a yarn along curves, with loops inside loops (share/doc/law.md, Loops).
// At the largest strain m so far the way from the residual strain (x = 0) to m (x = 1) is scaled, and the
// stress by the peak P(m). An elastic part and a bundle of strands act in parallel:
//   T / P(m) = a(x) + sum k_j u_j,   a(x) = linear x + square x^2,   u_j = x - p_j held within 0 and z_j
// A strand is a spring that slips at the stress k_j z_j when pulled, and is slack at zero stress. At x = 0
// all are slack, at x = 1 all slip, so that the stress is then 0 and P(m), whatever happened between. A
// strand dissipates k_j z_j times its slip when pulled and nothing when let go: never negative.
#pragma once
#include "law/data.hpp"
#include "law/springs.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

// The way x of strain E, and how much a width of one in x is in strain.
template <class T>
struct LoopWay {
  T peak, residual, width, x;  // P(m), Pa; E_r; m - E_r
};

template <class T>
LoopWay<T> loop_way(const AxisData& axis, T E, T m, T peak) {
  const T width = peak * T(axis.softness), residual = m - width;
  const T x = (E - residual) / max(width, T(1e-300));
  return {peak, residual, width, max(min(x, T(1.0)), T(0.0))};
}

// H(E) of a yarn with a loop; s0 and s1: its part of the committed and of the trial state.
template <class T>
SpringValue<T> looped_yarn(const AxisData& axis, const LoopData& loop, double coupling, AtSwitch at, T E,
                           const T* s0, T* s1, T& m) {
  const T m0 = m, zero(0.0), one(1.0);
  m = max(E, m0);
  const auto curve = backbone_at(axis.curve, m);
  const auto way = loop_way(axis, E, m0, backbone_at(axis.curve, m0).P);
  const T near = T(at == AtSwitch::loading ? switch_width : -switch_width) / max(way.width, T(1e-300));
  const auto is_virgin = E >= m0;
  T share = way.x * (T(loop.linear) + T(loop.square) * way.x), lost = zero;
  T slope = T(loop.linear) + T(2 * loop.square) * way.x;
  for (int j = 0; j < loop_strands; ++j) {
    const T reach(loop.reach[j]), k(loop.stiffness[j]);
    const T pulled = way.x - s0[loop_state::slack + j], u = max(min(pulled, reach), zero);
    share += k * u;
    lost += k * reach * max(pulled - reach, zero);
    slope += select((pulled > near) & (pulled < reach - near), k, zero);
    s1[loop_state::slack + j] = select(is_virgin, one - reach, way.x - u);
  }
  s1[loop_state::lost] = s0[loop_state::lost] + way.peak * way.width * lost;
  const auto is_slack = E < way.residual, on_curve = virgin_tangent(E, m0, at);
  const T h(axis.slack), cross(coupling * axis.poisson);
  const T yarn = select(is_virgin, curve.P, way.peak * share) + cross * E;
  const T slack = cross * way.residual + h * (E - way.residual);
  const auto slack_slope = at == AtSwitch::loading
                               ? is_slack & !on_curve
                               : is_slack | ((m <= T(switch_width)) & (E <= T(switch_width)));
  const T taut_slope = select(on_curve, curve.D, T(axis.unloading) * slope) + cross;
  return {select(is_slack, slack, yarn), select(slack_slope, h, taut_slope)};
}

// Energy of a yarn with a loop besides what the coupling stores: what it gives back when let go to zero
// stress, and what it has dissipated. s: its part of the state, in which E is committed.
template <class T>
struct LoopEnergy {
  T stored, dissipated;
};

template <class T>
LoopEnergy<T> loop_energy(const AxisData& axis, const LoopData& loop, T E, T m, const T* s) {
  const auto curve = backbone_at(axis.curve, max(E, m));
  const auto way = loop_way(axis, E, max(E, m), curve.P);
  const T scale = curve.P * way.width;
  T stored = way.x * way.x * (T(loop.linear / 2) + T(loop.square / 3) * way.x);
  for (int j = 0; j < loop_strands; ++j) {
    const T reach(loop.reach[j]);
    const T u = max(min(way.x - s[loop_state::slack + j], reach), T(0.0));
    stored += T(loop.stiffness[j] / 2) * u * u;
  }
  return {scale * stored, curve.U - T(loop.stored) * scale + s[loop_state::lost]};
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
