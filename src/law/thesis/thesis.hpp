// Law "thesis" of the woven card: the published law with the modulus at the end of each step, which depends
// on the steps (rate_laws.hpp).
#pragma once
#include "law/incremental/rate_laws.hpp"

namespace fabricsh::law::thesis {

struct Kind {
  static constexpr int numbers = rate_state::count;
  static constexpr bool symmetric = false;
  static constexpr int stored_stress = rate_state::S;
  static Bound bound(const WovenData& w) { return rate_bound(w); }
};

inline namespace FABRICSH_ISA {

template <class T>
Response<T> update(const WovenData& w, const Step& step, const T E[5], const T* s0, T* s1) {
  return rate_update<false>(w, step.at, E, s0, s1);
}

template <class T>
EnergyOf<T> energy(const WovenData& w, const T*, const T* s) {
  return rate_energy(w, s);
}

inline Internal internal(const WovenData& w, const double E[5], const double* s) {
  return rate_internal(w, E, s);
}

template <class Entry>
auto peaks(Entry s) {
  return std::array{s(rate_state::E), s(rate_state::E + 1), abs(s(rate_state::E + 4))};
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law::thesis
