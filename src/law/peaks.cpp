#include "law/peaks.hpp"

#include <cmath>

#include "law/data.hpp"
#include "law/laws.hpp"
#include "simd/copies.hpp"

namespace fabricsh::law {

// The copies compiled by peaks_isa.cpp.
FABRICSH_DECLARE_COPIES(double largest_strain_ratio(const Law&, const double*, const double*, long, int);)

StrainRatioFunction strain_ratio_function(Isa isa) { return FABRICSH_COPY_FOR(isa, largest_strain_ratio); }

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
  switch (law.kind) {
    case CompiledKind::potential: {
      namespace at = potential_state;
      const double sign = entry(at::sg) < 0 ? -1 : 1;
      return {entry(at::m1), entry(at::m2), 0.5 * std::abs(entry(at::g0) + sign * entry(at::gp))};
    }
#define FABRICSH_CASE(name)                   \
  case CompiledKind::name: {                  \
    const auto peak = name::peaks(entry);     \
    return {peak[0], peak[1], 0.5 * peak[2]}; \
  }
      FABRICSH_WOVEN_LAWS(FABRICSH_CASE)
#undef FABRICSH_CASE
    default:
      return {};
  }
}

}  // namespace fabricsh::law
