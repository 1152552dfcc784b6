// One update of any law over a number type T: selects the kernel by the kind of law.
#pragma once
#include "law/folds.hpp"
#include "law/laws.hpp"
#include "law/potential.hpp"
#include "law/response.hpp"

namespace fabricsh::law {

inline namespace FABRICSH_ISA {

template <class T>
Response<T> elastic_update(const ElasticData& law, const T E[5]) {
  Response<T> out;
  out.C11 = T(law.C11);
  out.C22 = T(law.C22);
  out.C12 = out.C21 = T(law.C12);
  out.C55 = T(law.G12);
  out.S[0] = out.C11 * E[0] + out.C12 * E[1];
  out.S[1] = out.C12 * E[0] + out.C22 * E[1];
  out.S[4] = out.C55 * E[4];
  transverse_elastic(T(law.G23), T(law.G13), E, out);
  return out;
}

}  // namespace FABRICSH_ISA

inline namespace FABRICSH_ISA {

// Law "potential" with the rheological elements that act in parallel to its springs, and on them if factored.
template <bool rubs, Yarns yarns, class T>
Response<T> parallel_update(const WovenData& law, const Step& step, const T E[5], const T* s0, T* s1) {
  Response<T> out = potential_update<rubs, yarns>(law, step.at, E, s0, s1);
  const int slot = elements_slot(law);
  rheology::add_stresses(law.elements, step.dt, E, s0 + slot, s1 + slot, out);
  return out;
}

// Selects the kernel of law "potential" by the features used.
template <bool rubs, class T>
Response<T> woven_update(const WovenData& law, const Step& step, const T E[5], const T* s0, T* s1) {
  if (rheology::any_on_springs(law.elements))
    return parallel_update<rubs, Yarns::factored>(law, step, E, s0, s1);
  const bool curved = is_curved(law);
  if (rheology::any(law.elements))
    return curved ? parallel_update<rubs, Yarns::curved>(law, step, E, s0, s1)
                  : parallel_update<rubs, Yarns::straight>(law, step, E, s0, s1);
  return curved ? potential_update<rubs, Yarns::curved>(law, step.at, E, s0, s1)
                : potential_update<rubs, Yarns::straight>(law, step.at, E, s0, s1);
}

// Of the cloth itself, without folds.
template <class T>
Response<T> cloth_update(const Law& law, const Step& step, const T E[5], const T* s0, T* s1) {
  switch (law.kind) {
    case CompiledKind::potential:
      return law.woven.friction.on ? woven_update<true>(law.woven, step, E, s0, s1)
                                   : woven_update<false>(law.woven, step, E, s0, s1);
#define FABRICSH_CASE(name) \
  case CompiledKind::name:  \
    return name::update(law.woven, step, E, s0, s1);
      FABRICSH_WOVEN_LAWS(FABRICSH_CASE)
#undef FABRICSH_CASE
    default:
      return elastic_update(law.elastic, E);
  }
}

template <class T>
Response<T> update(const Law& law, const Step& step, const T E[5], const T* s0, T* s1) {
  if (!has_folds(law)) return cloth_update(law, step, E, s0, s1);
  const auto cloth = [&](const T* e, const T* old, T* now) { return cloth_update(law, step, e, old, now); };
  return folded_update(cloth, fold_slot(law), E, s0, s1);
}

// Passes the entries of the row-major 5x5 tangent to put(e, value).
template <class T, class Put>
void put_tangent(const Response<T>& out, Put put) {
  const T nought(0.0);
  for (int e = 0; e < 25; ++e) put(e, nought);
  put(0, out.C11);
  put(1, out.C12);
  put(4, out.C15);
  put(5, out.C21);
  put(6, out.C22);
  put(9, out.C25);
  put(12, out.C33);
  put(14, out.C35);
  put(18, out.C44);
  put(19, out.C45);
  put(20, out.C15);
  put(21, out.C25);
  put(24, out.C55);
}

}  // namespace FABRICSH_ISA

}  // namespace fabricsh::law
