// Symmetry of a section about a plane across the surface.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "section/section.hpp"

namespace fabricsh::section {

namespace {

constexpr double kAngle = 1e-4;  // rad, up to which directions are the same
constexpr double kSame = 1e-9;   // of the largest stress: response and mirror image differ by rounding alone

bool lies_at(double angle, double multiple_of) {
  return std::abs(std::remainder(angle, multiple_of)) < kAngle;
}

// Components 11, 22, 23, 13, 12 of a tensor after reflection at the normal n in the surface; those of strains
// have doubled shears.
void reflect(const double n[2], bool doubled, double v[5]) {
  const double q[2][2] = {{1 - 2 * n[0] * n[0], -2 * n[0] * n[1]}, {-2 * n[0] * n[1], 1 - 2 * n[1] * n[1]}};
  const double shear = doubled ? v[4] / 2 : v[4], in[2][2] = {{v[0], shear}, {shear, v[1]}};
  double out[2][2] = {};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l) out[i][j] += q[i][k] * in[k][l] * q[l][j];
  const double across[2] = {v[3], v[2]};
  v[0] = out[0][0];
  v[1] = out[1][1];
  v[2] = q[1][0] * across[0] + q[1][1] * across[1];
  v[3] = q[0][0] * across[0] + q[0][1] * across[1];
  v[4] = doubled ? 2 * out[0][1] : out[0][1];
}

// Compares what virgin cloth answers to two strains, one after the other, and to their mirror images.
bool mirrored(const law::Law& law, double angle) {
  constexpr double path[2][5] = {{0.021, 0.012, 0.002, 0.003, 0.034}, {0.013, 0.017, -0.001, 0.002, 0.011}};
  const double n[2] = {std::cos(angle), std::sin(angle)};
  std::vector<double> state(static_cast<std::size_t>(law::state_size(law)), 0.0), next = state, image = state;
  for (const auto& strain : path) {
    double E[5], S[5], of_image[5];
    std::copy_n(strain, 5, E);
    law::evaluate(law, law::Step{}, E, state.data(), next.data(), S, nullptr);
    state = next;
    reflect(n, true, E);
    law::evaluate(law, law::Step{}, E, image.data(), next.data(), of_image, nullptr);
    image = next;
    reflect(n, false, S);
    const double most =
        std::abs(*std::max_element(S, S + 5, [](double a, double b) { return std::abs(a) < std::abs(b); }));
    for (int i = 0; i < 5; ++i)
      if (std::abs(S[i] - of_image[i]) > kSame * most) return false;
  }
  return true;
}

bool alike(const law::BendingSpring& a, const law::BendingSpring& b) {
  for (const double kappa : {0.0, 40.0, 300.0})
    if (law::elastic_moment(a, kappa).M != law::elastic_moment(b, kappa).M) return false;
  return a.rigidity == b.rigidity && a.friction == b.friction && a.curvature == b.curvature &&
         a.fading == b.fading;
}

// Between warp and weft if both bend alike; anywhere if bending is the same in all directions.
bool bends_mirrored(const std::array<law::BendingSpring, 3>& springs, double angle) {
  if (!alike(springs[0], springs[1])) return false;
  const bool linear = std::all_of(springs.begin(), springs.end(),
                                  [](const auto& s) { return s.friction == 0 && s.curve == nullptr; });
  const double odd = std::abs(2 * springs[2].rigidity - springs[0].rigidity);
  return lies_at(2 * angle + std::numbers::pi / 2, std::numbers::pi) ||
         (linear && odd <= kSame * springs[0].rigidity);
}

}  // namespace

bool mirrored(const Section& section, double angle) {
  const auto symmetric = [&](const Point& point) {
    const double from_warp = angle - point.angle;
    return lies_at(from_warp, std::numbers::pi / 2) || mirrored(*point.law, from_warp);
  };
  if (!std::all_of(section.points.begin(), section.points.end(), symmetric)) return false;
  return !section.bends_apart || lies_at(angle, std::numbers::pi / 2) ||
         bends_mirrored(section.bending, angle);
}

}  // namespace fabricsh::section
