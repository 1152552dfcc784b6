#include "law/peaks.hpp"

#include <cmath>

#include "law/data.hpp"

namespace fabricsh::law {

// The copies compiled by peaks_isa.cpp.
namespace avx2 {
double largest_strain_ratio(const Law&, const double*, const double*, long, int);
}
namespace avx512 {
double largest_strain_ratio(const Law&, const double*, const double*, long, int);
}
inline namespace baseline {
double largest_strain_ratio(const Law&, const double*, const double*, long, int);
}

StrainRatioFunction strain_ratio_function(Isa isa) {
  switch (isa) {
    case Isa::avx512:
      return avx512::largest_strain_ratio;
    case Isa::avx2:
      return avx2::largest_strain_ratio;
    default:
      return baseline::largest_strain_ratio;
  }
}

namespace {

double tested(double stated, const card::Curve& curve) {
  if (stated > 0 || curve.points.empty()) return stated;
  return curve.points.back().first;
}

}  // namespace

std::array<double, 3> tested_strains(const card::Card& card) {
  const auto* woven = std::get_if<card::Woven>(&card.law);
  if (woven == nullptr) return {};
  const double half =
      woven->shear.measure == card::StrainMeasure::engineering && woven->tested.shear <= 0 ? 0.5 : 1;
  return {tested(woven->tested.warp, woven->warp.loading), tested(woven->tested.weft, woven->weft.loading),
          half * tested(woven->tested.shear, woven->shear.loading)};
}

std::array<double, 3> peak_strains(const Law& law, const double* s, int stride) {
  const auto entry = [=](int i) { return s[i * stride]; };
  if (law.kind == CompiledKind::elastic) return {};
  if (law.kind != CompiledKind::potential)
    return {entry(rate_state::E), entry(rate_state::E + 1), 0.5 * std::abs(entry(rate_state::E + 4))};
  namespace at = potential_state;
  const double sign = entry(at::sg) < 0 ? -1 : 1;
  return {entry(at::m1), entry(at::m2), 0.5 * std::abs(entry(at::g0) + sign * entry(at::gp))};
}

}  // namespace fabricsh::law
