// The result of every law kernel, over a number type T (double or Pack).
#pragma once
#include "law/data.hpp"
#include "simd/pack.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

// S: 5-vector, Pa, material axes. C: the entries of dS/dE that are not zero in some law, Pa.
template <class T>
struct Response {
  T S[5];
  T C11, C12, C21, C22, C55;
  T C15{0.0}, C25{0.0};  // symmetric; of cloth with folds alone
  T C33, C35, C44, C45;
};

// Energies per reference volume, J/m^3: stored; dissipated, by rheology::dissipation_names; created by a law
// that is not dissipative.
template <class T>
struct EnergyOf {
  T stored{0.0};
  T dissipated[rheology::dissipations];
  T created{0.0};
  explicit EnergyOf(T stored_ = T(0.0)) : stored(stored_) {
    for (T& one : dissipated) one = T(0.0);
  }
};

template <class T>
void transverse_elastic(const T& G23, const T& G13, const T E[5], Response<T>& out) {
  out.S[2] = G23 * E[2];
  out.S[3] = G13 * E[3];
  out.C33 = G23;
  out.C44 = G13;
  out.C35 = out.C45 = T(0.0);
}

// Whether strain and stress are finite; the sum of all is enough to detect NaN and infinity.
template <class T>
auto healthy(const T E[5], const Response<T>& out) {
  T sum(0.0);
  for (int i = 0; i < 5; ++i) sum += (E[i] - E[i]) + (out.S[i] - out.S[i]);
  return sum == T(0.0);
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
