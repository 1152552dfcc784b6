// Relative peak strains for a whole batch: compiled once per
// instruction set, selected at run time by strain_ratio_function().
#include "law/data.hpp"
#include "law/laws.hpp"
#include "simd/pack.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

namespace {

// For law "potential": the state has the largest strains of the yarns and the origin
// and peak of the present shear branch, which together give its largest shear strain.
Pack potential_ratio(const Pack inverse[3], const double* s) {
  namespace at = potential_state;
  const auto entry = [s](int i) { return load(s + i * lanes); };
  const Pack sign = select(entry(at::sg) < Pack(0.0), Pack(-1.0), Pack(1.0));
  const Pack gamma = abs(entry(at::g0) + sign * entry(at::gp));
  return max(max(inverse[0] * entry(at::m1), inverse[1] * entry(at::m2)), inverse[2] * gamma);
}

// For the other laws of woven cards.
#define FABRICSH_RATIO(name)                                                           \
  Pack name##_ratio(const Pack inverse[3], const double* s) {                          \
    const auto peak = name::peaks([s](int i) { return load(s + i * lanes); });         \
    return max(max(inverse[0] * peak[0], inverse[1] * peak[1]), inverse[2] * peak[2]); \
  }
FABRICSH_WOVEN_LAWS(FABRICSH_RATIO)
#undef FABRICSH_RATIO

// The result stays in registers: an array of a caller that has just been cleared in small pieces would be
// waited for until all stores before it are done.
template <class Ratio>
double largest(const double inverse[3], const double* s, long stride, int count, Ratio of) {
  const Pack scale[3] = {Pack(inverse[0]), Pack(inverse[1]), Pack(0.5 * inverse[2])};  // shear is in 2 E12
  Pack most(0.0);
  for (int first = 0; first < lanes; first += pack_width)
    for (int i = 0; i < count; ++i) most = max(of(scale, s + i * stride + first), most);
  double strain_ratio = most[0];
  for (int lane = 1; lane < pack_width; ++lane) strain_ratio = max(strain_ratio, most[lane]);
  return strain_ratio;
}

}  // namespace

double largest_strain_ratio(const Law& law, const double inverse[3], const double* s, long stride,
                            int count) {
  switch (law.kind) {
    case CompiledKind::potential:
      return largest(inverse, s, stride, count, potential_ratio);
#define FABRICSH_CASE(name) \
  case CompiledKind::name:  \
    return largest(inverse, s, stride, count, name##_ratio);
      FABRICSH_WOVEN_LAWS(FABRICSH_CASE)
#undef FABRICSH_CASE
    default:
      return 0;
  }
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
