// The bending of cloth as a hysteretic spring: moment per width against curvature. It has an elastic
// part, whose rigidity B may change with the curvature, and a friction moment m (half the 2HB of a KES
// test), which builds up over a small curvature kappa_f with the initial stiffness k = M_f / kappa_f.
//   M = int_0^kappa B + m
// slip     m = k (kappa - kappa_s), held within +-M_f
// fading   dm = k dkappa - m |dkappa| / kappa_f: a moment decays as exp(-s / kappa_f), where s is
//          the curvature travelled, counted positive in both directions; under monotone bending
//          m tends to +-M_f
// Both store m^2 / (2 k) and dissipate the rest, M_f |dkappa_s| or m^2 |dkappa| / M_f, which is
// never negative.
#pragma once
#include <array>
#include <memory>

#include "law/backbone.hpp"

namespace fabricsh::law {

// Moment against curvature in one bending direction, expressed by a backbone: D is the rigidity B, P the
// moment, U the stored energy, as functions of the curvature >= 0; for negative curvature the moment is odd.
struct BendingCurve {
  BendingCurve() = default;
  BendingCurve(const BendingCurve&) = delete;
  BendingCurve& operator=(const BendingCurve&) = delete;
  Backbone backbone;
  std::vector<CurvePiece> pieces;  // what the backbone points to
  double steepest = 0;             // N.m, its largest slope
};

struct BendingSpring {
  double rigidity = 0;   // B(0), N.m
  double friction = 0;   // M_f, N (moment per width); 0: none
  double curvature = 0;  // kappa_f, 1/m: over which the friction builds up; positive if there is friction
  bool fading = false;
  std::shared_ptr<const BendingCurve> curve = {};  // null: B is constant
};

// The springs of warp, weft and twist. Error: a rigidity that is
// not positive up to the tested curvature, or an invalid curve.
std::array<BendingSpring, 3> bending_springs(const card::Card& card);

// The largest possible slope of the moment, N.m.
double stiffest(const BendingSpring& spring);

inline namespace FABRICSH_ISA {

// State: three numbers, all zero for virgin cloth. `last` is used only with fading and is otherwise 0.
template <class T>
struct BendingState {
  T slip{0.0};  // kappa_s, 1/m: m = k (kappa - kappa_s)
  T lost{0.0};  // dissipated, J/m^2
  T last{0.0};  // kappa of the last step, 1/m
};

template <class T>
struct BendingValue {
  T M, C;  // moment, N; dM/dkappa, N.m
};

template <class T>
BendingValue<T> elastic_moment(const BendingSpring& spring, T kappa) {
  const T B(spring.rigidity);
  if (spring.curve == nullptr) return {B * kappa, B};
  const auto at = backbone_at(spring.curve->backbone, abs(kappa));
  return {select(kappa < T(0.0), -at.P, at.P), at.D};
}

// The elastic part of the curvature when friction slips, kappa - kappa_s (1/m), and its moment's tangent.
template <class T>
struct Stuck {
  T held, C;
};

template <class T>
Stuck<T> slipped(const BendingSpring& spring, AtSwitch at, T kappa, BendingState<T>& s) {
  const T limit(spring.curvature), stiff(spring.friction / spring.curvature);
  const T stuck = kappa - s.slip;
  const T held = max(min(stuck, limit), -limit);
  const T edge = limit * T(at == AtSwitch::loading ? 1 - 1e-12 : 1 + 1e-12);
  const auto sticks = abs(stuck) < edge;
  s.lost += T(spring.friction) * abs(stuck - held);
  s.slip += stuck - held;
  return {held, select(sticks, stiff, T(0.0))};
}

// The exact solution over a straight step of curvature. For a step of zero length
// the tangent is that of continued loading or, after a reversal, of unloading.
template <class T>
BendingValue<T> fading_moment(const BendingSpring& spring, AtSwitch at, T kappa, BendingState<T>& s) {
  const double k = spring.friction / spring.curvature;
  const T limit(spring.friction), stiff(k), reach(spring.curvature), zero(0.0), one(1.0);
  const T way = kappa - s.last, m0 = stiff * (s.last - s.slip);
  const T side = select(way < zero, -one, one);
  const T kept = exp(-abs(way) / reach), gone = one - kept;
  const T from = m0 - side * limit;
  const T m = m0 * kept + side * limit * gone;
  const T lost =
      limit * abs(way) + reach * from * gone * (T(2.0) * side + from * (one + kept) / (T(2.0) * limit));
  s.lost += max(lost, zero);
  s.slip = kappa - m / stiff;
  s.last = kappa;
  const T turning = T(at == AtSwitch::loading ? 1.0 : -1.0) * abs(m0);
  const T along = select(way == zero, turning, side * m);
  return {m, (limit - along) / reach};
}

// s: the committed state on entry, the trial state on return.
template <class T>
BendingValue<T> bending_moment(const BendingSpring& spring, AtSwitch at, T kappa, BendingState<T>& s) {
  if (spring.curve == nullptr && spring.friction > 0 && !spring.fading) {
    // A single expression, because instruction sets with fused multiply-add round it as a whole.
    const auto rubs = slipped(spring, at, kappa, s);
    return {T(spring.rigidity) * kappa + T(spring.friction / spring.curvature) * rubs.held,
            T(spring.rigidity) + rubs.C};
  }
  const auto elastic = elastic_moment(spring, kappa);
  if (spring.friction <= 0) return elastic;
  if (spring.fading) {
    const auto rubs = fading_moment(spring, at, kappa, s);
    return {elastic.M + rubs.M, elastic.C + rubs.C};
  }
  const auto rubs = slipped(spring, at, kappa, s);
  return {elastic.M + T(spring.friction / spring.curvature) * rubs.held, elastic.C + rubs.C};
}

// Stored energy per area, J/m^2, from curvature and committed state; the dissipated part is s.lost.
template <class T>
T bending_stored(const BendingSpring& spring, T kappa, const BendingState<T>& s) {
  const T elastic = spring.curve == nullptr ? T(0.5 * spring.rigidity) * kappa * kappa
                                            : backbone_at(spring.curve->backbone, abs(kappa)).U;
  if (spring.friction <= 0) return elastic;
  const T stuck = kappa - s.slip;
  return elastic + T(0.5 * spring.friction / spring.curvature) * stuck * stuck;
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
