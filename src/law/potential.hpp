// The woven law "potential": a convex potential with a constant coupling and one-dimensional hysteretic
// springs. S11 = H1(E11) + c E22, S22 = H2(E22) + c E11, S12 its own spring, transverse shear elastic.
#pragma once
#include "law/response.hpp"
#include "law/springs.hpp"
#include "law/yarn_loop.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

template <class Curve, class T>
ShearState<T> load_shear(const ShearOf<Curve>& shear, const T* s0) {
  using namespace potential_state;
  return {s0[g0], s0[gp], s0[sg], s0[lost], fades(shear) ? s0[count] : T(0.0)};
}

template <class Curve, class T>
void save_shear(const ShearOf<Curve>& shear, const ShearState<T>& s, T* s1) {
  using namespace potential_state;
  s1[g0] = s.origin;
  s1[gp] = s.peak;
  s1[sg] = s.sign;
  s1[lost] = s.lost;
  if (fades(shear)) s1[count] = s.faded;
}

// Index of the biaxial peak in the state, if it has one.
inline int biaxial_slot(const WovenData& law) {
  return potential_state::count + (law.shear.fading || law.friction.on ? 1 : 0);
}

// Index at which the states of the rheological elements begin, if there are any.
inline int elements_slot(const WovenData& law) { return biaxial_slot(law) + (law.biaxial.on ? 1 : 0); }

// Index at which the state of a yarn's loop begins, if it has one.
inline int loop_slot(const WovenData& law, int axis) {
  return elements_slot(law) + rheology::numbers(law.elements) +
         (axis == 1 && law.loop[0].on ? loop_state::count : 0);
}

// Features that a kernel is compiled for, beside straight unloading and hysteretic shear.
enum class Yarns {
  straight,
  curved,
  factored
};  // curved: a yarn has a loop; factored: elements on the springs

// One yarn; s1 holds its committed largest strain on entry.
template <Yarns yarns, class Woven, class T>
SpringValue<T> yarn_of(const Woven& law, int i, AtSwitch at, T E, const T* s0, T* s1) {
  if constexpr (yarns == Yarns::factored) {
    const int slot = elements_slot(law);
    const auto factor =
        rheology::yarn_factors(law.elements, i, at == AtSwitch::loading, E, s0 + slot, s1 + slot);
    return factored_yarn(law.axis[i], law.coupling, at, factor, E, s1[i]);
  }
  if constexpr (yarns == Yarns::curved) {
    const int slot = loop_slot(law, i);
    if (law.loop[i].on)
      return looped_yarn(law.axis[i], law.loop[i], law.coupling, at, E, s0 + slot, s1 + slot, s1[i]);
  }
  return yarn_spring(law.axis[i], law.coupling, at, E, s1[i]);
}

template <class T>
void add_biaxial(const WovenData& law, AtSwitch at, const T E[5], const T* s0, T* s1, Response<T>& out) {
  if (!law.biaxial.on) return;
  const int slot = biaxial_slot(law);
  const T alpha(law.biaxial.alpha);
  s1[slot] = s0[slot];
  const auto t = biaxial_spring(law.biaxial, at, E[0] + alpha * E[1] - T(law.biaxial.offset), s1[slot]);
  out.S[0] += t.S;
  out.S[1] += alpha * t.S;
  out.C11 += t.C;
  out.C12 += alpha * t.C;
  out.C21 = out.C12;
  out.C22 += alpha * alpha * t.C;
}

template <class T>
void add_biaxial(const PlainWoven&, AtSwitch, const T*, const T*, T*, Response<T>&) {}

// In-plane shear: a hysteretic spring, or an elastic one with parallel friction.
template <class Woven, class T>
SpringValue<T> hysteretic_shear(const Woven& law, AtSwitch at, T gamma, const T* s0, T* s1) {
  auto branch = load_shear(law.shear, s0);
  const auto shear = shear_spring(law.shear, at, gamma, branch);
  save_shear(law.shear, branch, s1);
  return shear;
}

template <class T>
SpringValue<T> rubbing_shear(const WovenData& law, AtSwitch at, T gamma, const T* s0, T* s1) {
  using namespace potential_state;
  const T size = abs(gamma), side = select(gamma < T(0.0), T(-1.0), T(1.0));
  const auto elastic = backbone_at(law.shear.curve, size);
  s1[g0] = T(0.0);
  s1[sg] = select(size >= s0[gp], side, s0[sg]);
  s1[gp] = max(size, s0[gp]);
  s1[lost] = s0[lost];
  s1[count] = s0[count];
  const auto rubs = shear_friction(law.friction, at, gamma, s1[count], s1[lost]);
  return {side * elastic.P + rubs.S, elastic.D + rubs.C};
}

// Woven: WovenData, or PlainWoven for a plain law; rubs: shear has friction.
template <bool rubs = false, Yarns yarns = Yarns::straight, class Woven, class T>
Response<T> potential_update(const Woven& law, AtSwitch at, const T E[5], const T* s0, T* s1) {
  using namespace potential_state;
  Response<T> out;
  const T c(law.coupling);
  s1[m1] = s0[m1];
  s1[m2] = s0[m2];
  const auto warp = yarn_of<yarns>(law, m1, at, E[0], s0, s1);
  const auto weft = yarn_of<yarns>(law, m2, at, E[1], s0, s1);
  SpringValue<T> shear;
  if constexpr (rubs)
    shear = rubbing_shear(law, at, E[4], s0, s1);
  else
    shear = hysteretic_shear(law, at, E[4], s0, s1);
  out.S[0] = warp.S + c * E[1];
  out.S[1] = weft.S + c * E[0];
  out.S[4] = shear.S;
  out.C11 = warp.C;
  out.C22 = weft.C;
  out.C12 = out.C21 = c;
  out.C55 = shear.C;
  transverse_elastic(T(law.transverse), T(law.transverse), E, out);
  add_biaxial(law, at, E, s0, s1, out);
  return out;
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
