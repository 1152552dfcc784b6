// Relative peak strains for a whole batch: compiled once per
// instruction set, selected at run time by shares_function().
#include "law/data.hpp"
#include "simd/pack.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

namespace {

// For law "potential": the state has the largest strains of the yarns and the origin
// and peak of the present shear branch, which together give its largest shear strain.
Pack potential_share(const Pack inverse[3], const double* s) {
  namespace at = potential_state;
  const auto entry = [s](int i) { return load(s + i * lanes); };
  const Pack sign = select(entry(at::sg) < Pack(0.0), Pack(-1.0), Pack(1.0));
  const Pack gamma = abs(entry(at::g0) + sign * entry(at::gp));
  return max(max(inverse[0] * entry(at::m1), inverse[1] * entry(at::m2)), inverse[2] * gamma);
}

Pack rate_share(const Pack inverse[3], const double* s) {
  const double* E = s + rate_state::E * lanes;
  return max(max(inverse[0] * load(E), inverse[1] * load(E + lanes)), inverse[2] * abs(load(E + 4 * lanes)));
}

template <class Share>
void largest(const double inverse[3], const double* s, long stride, int count, double* share, Share of) {
  const Pack scale[3] = {Pack(inverse[0]), Pack(inverse[1]), Pack(0.5 * inverse[2])};  // shear is in 2 E12
  for (int first = 0; first < lanes; first += pack_width) {
    Pack most = load(share + first);
    for (int i = 0; i < count; ++i) most = max(of(scale, s + i * stride + first), most);
    store(share + first, most);
  }
}

}  // namespace

void shares(const Law& law, const double inverse[3], const double* s, long stride, int count, double* share) {
  if (law.kind == Kind::potential)
    largest(inverse, s, stride, count, share, potential_share);
  else if (law.kind != Kind::elastic)
    largest(inverse, s, stride, count, share, rate_share);
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
