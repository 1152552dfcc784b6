// Law "incremental" of the woven card: the published law with the mean modulus of each step (rate_laws.hpp).
#pragma once
#include "law/incremental/rate_laws.hpp"

namespace fabricsh::law::incremental {

using Kind = RateKind;

inline namespace FABRICSH_ISA {

template <class T>
Response<T> update(const WovenData& w, const Step& step, const T E[5], const T* s0, T* s1) {
  return rate_update<true>(w, step.at, E, s0, s1);
}

using rate::energy;
using rate::internal;
using rate::peaks;

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law::incremental
