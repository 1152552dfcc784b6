// Bending of cloth as one more hysteretic spring: moment per width against curvature, a rigidity B beside a
// friction moment (half the 2HB of a KES test) that builds up over a small curvature and then slips.
//   M = B kappa + (M_f / kappa_f) (kappa - kappa_s), the friction part held within +-M_f
#pragma once
#include <optional>

#include "fabric/law.hpp"
#include "tensor/pack.hpp"

namespace fabricsh::fabric {

struct BendingSpring {
  double rigidity = 0;   // B, N.m
  double friction = 0;   // M_f, N (moment per width); 0: none
  double curvature = 0;  // kappa_f, 1/m: over which the friction builds up; positive where friction is
};

// What card.bending says of one direction.
inline BendingSpring bending_spring_of(double rigidity,
                                       const std::optional<card::BendingFriction>& friction) {
  if (!friction || friction->moment <= 0) return {rigidity, 0, 0};
  return {rigidity, friction->moment, friction->curvature};
}

inline namespace FABRICSH_ISA {

// State: two numbers, both zero for virgin cloth.
template <class T>
struct BendingState {
  T slip{0.0};  // kappa_s, 1/m
  T lost{0.0};  // dissipated, J/m^2
};

template <class T>
struct BendingValue {
  T M, C;  // moment, N; dM/dkappa, N.m
};

// s: committed in, trial out.
template <class T>
BendingValue<T> bending_moment(const BendingSpring& spring, AtSwitch at, T kappa, BendingState<T>& s) {
  const T B(spring.rigidity);
  if (spring.friction <= 0) return {B * kappa, B};
  const T limit(spring.curvature), stiff(spring.friction / spring.curvature);
  const T stuck = kappa - s.slip;
  const T held = max(min(stuck, limit), -limit);
  const T edge = limit * T(at == AtSwitch::loading ? 1 - 1e-12 : 1 + 1e-12);
  const auto sticks = abs(stuck) < edge;
  s.lost += T(spring.friction) * abs(stuck - held);
  s.slip += stuck - held;
  return {B * kappa + stiff * held, B + select(sticks, stiff, T(0.0))};
}

// Stored energy per area, J/m^2, from curvature and committed state; the dissipated part is s.lost.
template <class T>
T bending_stored(const BendingSpring& spring, T kappa, const BendingState<T>& s) {
  const T elastic = T(0.5 * spring.rigidity) * kappa * kappa;
  if (spring.friction <= 0) return elastic;
  const T stuck = kappa - s.slip;
  return elastic + T(0.5 * spring.friction / spring.curvature) * stuck * stuck;
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::fabric
