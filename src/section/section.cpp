#include "section/section.hpp"

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace fabricsh::section {

namespace {

// Legendre polynomial P_n(x) and its derivative, by the three-term recurrence.
std::pair<double, double> legendre(int n, double x) {
  double p0 = 1, p1 = x;
  for (int k = 2; k <= n; ++k) {
    const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
    p0 = p1;
    p1 = p2;
  }
  return {p1, n * (x * p1 - p0) / (x * x - 1)};
}

}  // namespace

std::vector<std::pair<double, double>> gauss_legendre(int n) {
  if (n < 1 || n > 9) throw Error("points: expected 1 to 9 thickness points, got " + std::to_string(n));
  if (n == 1) return {{0.0, 2.0}};
  std::vector<std::pair<double, double>> rule(n);
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    if (2 * i + 1 == n) x = 0;
    for (int newton = 0; newton < 8; ++newton) {
      const auto [p, dp] = legendre(n, x);
      x -= p / dp;
    }
    const double dp = legendre(n, x).second;
    rule[i] = {x, 2 / ((1 - x * x) * dp * dp)};
  }
  return rule;
}

Section integrated(const card::Card& card, double thickness, int points, double offset) {
  if (!(thickness > 0) || !std::isfinite(thickness))
    throw Error("thickness: expected a positive length in m, got " + std::to_string(thickness));
  if (!(std::abs(offset) <= 1))
    throw Error("offset: expected a number from -1 to 1, got " + std::to_string(offset));
  Section s;
  s.thickness = thickness;
  s.offset = offset;
  s.density = card.density;
  s.areal_mass = card.density * thickness;
  s.bending = card.bending;
  const auto law = fabric::compile(card);
  s.symmetric = fabric::symmetric(*law);
  const auto rule = gauss_legendre(card.bending ? 1 : points);
  for (const auto& [zeta, weight] : rule) {
    s.points.push_back({zeta, weight, law, s.state_size});
    s.state_size += fabric::state_size(*law);
  }
  return s;
}

}  // namespace fabricsh::section
