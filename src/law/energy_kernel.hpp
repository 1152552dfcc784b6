// Stored and dissipated energy per reference volume as functions of
// strain and state only (share/doc/theory.md, 4), over a number type T.
#pragma once
#include "law/folds.hpp"
#include "law/laws.hpp"
#include "law/potential.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

// Stored energy of one yarn, including its part c nu E^2 / 2 of the coupling.
template <class Curve, class T>
T yarn_stored(const AxisOf<Curve>& axis, double coupling, T E, T residual) {
  const T cross(coupling * axis.poisson), half(0.5), x = E - residual;
  const T taut = half * T(axis.unloading) * x * x + half * cross * E * E;
  const T slack = cross * residual * (half * residual + x) + half * T(axis.slack) * x * x;
  return select(x >= T(0.0), taut, slack);
}

template <class T>
struct YarnPoint {
  T stored, dissipated, residual;
};

// Energy dissipated by one yarn; m: its largest strain so far.
template <class Curve, class T>
YarnPoint<T> yarn_point(const AxisOf<Curve>& axis, double coupling, T E, T m) {
  const T peak = max(E, m);
  const auto curve = backbone_at(axis.curve, peak);
  const T residual = peak - curve.P * T(axis.softness);
  return {yarn_stored(axis, coupling, E, residual), branch_loss(curve, T(axis.unloading)), residual};
}

// The same of a yarn on whose spring elements act; s: the whole state.
template <class T>
YarnPoint<T> factored_point(const WovenData& w, int i, T E, const T* s) {
  const T largest = s[i], factor = rheology::yarn_factors_at(w.elements, i, s + elements_slot(w));
  const auto curve = backbone_at(w.axis[i].curve, largest);
  const T residual = largest - curve.P * T(w.axis[i].softness), x = E - residual;
  const T lost = T(0.5 * w.axis[i].unloading) * x * x * (T(1.0) - factor);
  return {yarn_stored(w.axis[i], w.coupling, E, residual) - select(x >= T(0.0), lost, T(0.0)),
          branch_loss(curve, T(w.axis[i].unloading)), residual};
}

// The same of any yarn.
template <class T>
YarnPoint<T> yarn_point(const WovenData& w, int i, T E, const T* s) {
  if (rheology::any_on_springs(w.elements)) return factored_point(w, i, E, s);
  auto out = yarn_point(w.axis[i], w.coupling, E, s[i]);
  if (!w.loop[i].on) return out;
  const auto loop = loop_energy(w.axis[i], w.loop[i], E, s[i], s + loop_slot(w, i));
  const T cross(0.5 * w.coupling * w.axis[i].poisson);
  out.stored = select(E >= out.residual, loop.stored + cross * E * E, out.stored);
  out.dissipated = loop.dissipated;
  return out;
}

template <class T>
void add_biaxial_energy(const WovenData& w, const T E[5], const T* s, EnergyOf<T>& out) {
  T m = s[biaxial_slot(w)];
  const double alpha = w.biaxial.alpha;
  const auto t =
      biaxial_spring(w.biaxial, AtSwitch::loading, E[0] + T(alpha) * E[1] - T(w.biaxial.offset), m);
  const T unloading(w.biaxial.unloading), lost = branch_loss(backbone_at(w.biaxial.curve, m), unloading);
  out.stored += t.S * t.S / (T(2.0) * unloading);
  out.dissipated[0] += lost / T(1 + alpha);
  out.dissipated[1] += lost * T(alpha) / T(1 + alpha);
}

template <class T>
struct ShearPoint {
  T stored, dissipated;
};

template <class Woven, class T>
ShearPoint<T> hysteretic_point(const Woven& w, T gamma, const T* s) {
  auto branch = load_shear(w.shear, s);
  const auto shear = shear_spring(w.shear, AtSwitch::loading, gamma, branch);
  const T Gu(w.shear.unloading);
  return {shear.S * shear.S / (T(2.0) * Gu),
          branch.lost + branch_loss(backbone_at(w.shear.curve, branch.peak), Gu)};
}

template <class T>
ShearPoint<T> rubbing_point(const WovenData& w, T gamma, const T* s) {
  using namespace potential_state;
  T slip = s[count], gone = s[lost];
  const T held = shear_friction(w.friction, AtSwitch::loading, gamma, slip, gone).S;
  return {backbone_at(w.shear.curve, abs(gamma)).U + held * held / T(2 * w.friction.stiffness), gone};
}

template <class Woven, class T>
EnergyOf<T> sum_of_parts(const Woven& w, const T E[5], const YarnPoint<T>& warp, const YarnPoint<T>& weft,
                         const ShearPoint<T>& shear) {
  EnergyOf<T> out;
  out.stored = warp.stored + weft.stored + T(w.coupling) * E[0] * E[1];
  out.stored += shear.stored;
  out.stored += T(0.5 * w.transverse) * (E[2] * E[2] + E[3] * E[3]);
  out.dissipated[0] = warp.dissipated;
  out.dissipated[1] = weft.dissipated;
  out.dissipated[2] = shear.dissipated;
  return out;
}

template <class T>
EnergyOf<T> potential_energy(const WovenData& w, const T E[5], const T* s) {
  using namespace potential_state;
  const auto shear = w.friction.on ? rubbing_point(w, E[4], s) : hysteretic_point(w, E[4], s);
  auto out = sum_of_parts(w, E, yarn_point(w, m1, E[0], s), yarn_point(w, m2, E[1], s), shear);
  if (w.biaxial.on) add_biaxial_energy(w, E, s, out);
  rheology::add_energies(w.elements, s + elements_slot(w), out.stored, out.dissipated);
  return out;
}

template <class T>
EnergyOf<T> plain_energy(const PlainWoven& w, const T E[5], const T* s) {
  using namespace potential_state;
  return sum_of_parts(w, E, yarn_point(w.axis[m1], w.coupling, E[0], s[m1]),
                      yarn_point(w.axis[m2], w.coupling, E[1], s[m2]), hysteretic_point(w, E[4], s));
}

template <class T>
EnergyOf<T> elastic_energy(const ElasticData& e, const T E[5]) {
  const T half(0.5);
  return EnergyOf<T>(half * (T(e.C11) * E[0] * E[0] + T(e.C22) * E[1] * E[1]) + T(e.C12) * E[0] * E[1] +
                     half * (T(e.G23) * E[2] * E[2] + T(e.G13) * E[3] * E[3] + T(e.G12) * E[4] * E[4]));
}

template <class T>
EnergyOf<T> cloth_energy(const Law& law, const T E[5], const T* s) {
  switch (law.kind) {
    case CompiledKind::potential:
      return potential_energy(law.woven, E, s);
#define FABRICSH_CASE(name) \
  case CompiledKind::name:  \
    return name::energy(law.woven, E, s);
      FABRICSH_WOVEN_LAWS(FABRICSH_CASE)
#undef FABRICSH_CASE
    default:
      return elastic_energy(law.elastic, E);
  }
}

template <class T>
EnergyOf<T> energy_at(const Law& law, const T E[5], const T* s) {
  if (!has_folds(law)) return cloth_energy(law, E, s);
  T e[5];
  const T folds = fold_energy(fold_slot(law), s, E, e);
  EnergyOf<T> out = cloth_energy(law, e, s);
  out.stored += folds;
  return out;
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
