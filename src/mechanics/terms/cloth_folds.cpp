// What distinguishes the elements of one card: their extent along the yarns, and the compression at which the
// cloth within them folds (share/doc/folds.md).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanics/terms/cloth.hpp"

namespace fabricsh::mechanics {

Cloth::Corners Cloth::corners_of(Index element) const {
  const auto& nodes = model_.mesh().elements[static_cast<std::size_t>(element)];
  Corners out{{}, {}, nodes[3] < 0 ? 3 : 4, 0};
  Vec3 middle = Vec3::Zero();
  for (int a = 0; a < out.count; ++a) middle += out.at[a] = rest_.X(element, a);
  const Vec3* const x = out.at;
  const Vec3 normal = out.count == 3 ? (x[1] - x[0]).cross(x[2] - x[0]) : (x[2] - x[0]).cross(x[3] - x[1]);
  const Vec3 n = normal.normalized(), w = rest_.warp(element, middle / out.count, n);
  out.axes[0] = (w - w.dot(n) * n).normalized();
  out.axes[1] = n.cross(out.axes[0]);
  out.area = 0.5 * normal.norm();
  return out;
}

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
  const Corners c = corners_of(element);
  law::Site site;
  for (std::size_t i = 0; i < 2; ++i) site.size[i] = extent(c.at, c.count, c.axes[i]);
  return site;
}

// A mesh shows waves whose halves are two elements long; what is shorter has to fold within them, at the load
// of Euler, pi^2 B / (2 h)^2. h: how far the nodes are apart along the yarn, which is the area of a
// quadrilateral, or twice that of a triangle, over its extent across.
std::array<double, 2> Cloth::fold_tensions(Index element) const {
  constexpr double elements_of_half_a_wave = 2;
  const auto& section = model_.sections()[static_cast<std::size_t>(model_.region_of(element))];
  if (model_.membrane()) return {0, 0};
  const Corners c = corners_of(element);
  std::array<double, 2> out{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double apart = (c.count == 3 ? 2 : 1) * c.area / extent(c.at, c.count, c.axes[1 - i]);
    const double wave = std::numbers::pi / (elements_of_half_a_wave * apart);
    out[i] = rigidity(section, i) * wave * wave;
  }
  return out;
}

}  // namespace fabricsh::mechanics
