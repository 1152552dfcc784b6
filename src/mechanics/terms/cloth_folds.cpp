// Differences between elements of one card: their extent along the yarns, and the compression at which the
// cloth within them folds (share/doc/folds.md).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanics/terms/cloth.hpp"

namespace fabricsh::mechanics {

namespace {

double extent(const Vec3* corners, int count, const Vec3& axis) {
  double low = axis.dot(corners[0]), high = low;
  for (int a = 1; a < count; ++a) {
    low = std::min(low, axis.dot(corners[a]));
    high = std::max(high, axis.dot(corners[a]));
  }
  return high - low;
}

// N.m, along warp or weft of the section: its own, or that of the points through the thickness.
double rigidity(const section::Section& section, std::size_t yarn) {
  if (section.bends_apart) return section.bending[yarn].rigidity;
  double sum = 0;
  const double half = section.thickness / 2;
  for (const auto& point : section.points) {
    const double z = half * (point.zeta - section.offset);
    const auto modulus = [&](std::size_t axis) {
      return law::backbone_modulus(*point.law, static_cast<int>(axis) + 1, 0);
    };
    // Along the section's yarn, which a ply may have at an angle.
    const double c = std::pow(std::cos(point.angle), 2), n = 1 - c;
    sum += half * point.weight * z * z *
           (c * c * modulus(yarn) + n * n * modulus(1 - yarn) + 4 * c * n * modulus(2));
  }
  return sum;
}

}  // namespace

// Extent of an element along warp and weft, m; its strength, as the model declares it.
law::Site Cloth::site_of(Index element) const {
  const RestShape::Outline c = rest_.outline(element);
  law::Site site;
  for (std::size_t i = 0; i < 2; ++i) site.size[i] = extent(c.at, c.count, c.axes[i]);
  return site;
}

// A mesh shows waves whose halves are two elements long; what is shorter has to fold within them, at the load
// of Euler, pi^2 B / (2 h)^2. h: how far the nodes are apart along the yarn, which is the area of a
// quadrilateral, or twice that of a triangle, over its extent across.
std::array<double, 2> ClothReadings::fold_tensions(Index element) const {
  constexpr double elements_of_half_a_wave = 2;
  const auto& section =
      cloth_.model().sections()[static_cast<std::size_t>(cloth_.model().region_of(element))];
  if (cloth_.model().membrane()) return {0, 0};
  const RestShape::Outline c = cloth_.rest().outline(element);
  std::array<double, 2> out{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double apart = (c.count == 3 ? 2 : 1) * c.area / extent(c.at, c.count, c.axes[1 - i]);
    const double wave = std::numbers::pi / (elements_of_half_a_wave * apart);
    out[i] = rigidity(section, i) * wave * wave;
  }
  return out;
}

}  // namespace fabricsh::mechanics
