#include "mechanics/terms/bulges.hpp"

#include <algorithm>

#include "element/shell3.hpp"
#include "geometry/node_view.hpp"
#include "geometry/turning.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kHeld = 3;  // p h^3 / B at the limit, h the longest edge: an edge would turn by a quarter

Vec3 mean(std::span<const double> of_nodes, const Bulge& bulge) {
  const auto& [a, b, c] = bulge.nodes;
  return (at(of_nodes, a) + at(of_nodes, b) + at(of_nodes, c)) / 3;
}

}  // namespace

std::optional<Bulge> bulge_of(const model::Model& model, const RestShape& rest, Index element) {
  const auto& nodes = model.mesh().elements[static_cast<std::size_t>(element)];
  if (corners(nodes) == 4) return {};
  element::Placed<3> at;
  double longest = 0;
  for (int a = 0; a < 3; ++a) {
    at.X[static_cast<std::size_t>(a)] = rest.X(element, a);
    at.D[static_cast<std::size_t>(a)] = rest.D(element, a);
    longest = std::max(longest, (rest.X(element, a) - rest.X(element, (a + 1) % 3)).norm());
  }
  const auto& section = model.sections()[static_cast<std::size_t>(model.region_of(element))];
  const double B = element::shell3_rigidity(
      section, at.X, at.D, [&](const Vec3& X, const Vec3& normal) { return rest.warp(element, X, normal); });
  if (!(B > 0)) return {};
  return Bulge{{nodes[0], nodes[1], nodes[2]}, rest.area(element), kHeld * B / (longest * longest * longest)};
}

void add_pressure(std::span<const Bulge> bulges, double pressure, const Configuration& now,
                  std::span<double> on_x, std::span<double> on_d) {
  const auto x = now.x(), d = now.d();
  for (const Bulge& bulge : bulges) {
    const Vec3 middle = mean(x, bulge), director = mean(d, bulge);
    const double f = bulge.force_per_length(pressure);
    for (const Index n : bulge.nodes) {
      at(on_x, n) += f * (at(d, n) - director);
      at(on_d, n) += f * (at(x, n) - middle);
    }
  }
}

void add_pressure_tangent(std::span<const Bulge> bulges, double pressure, const Configuration& now,
                          TangentSink& sink) {
  const auto x = now.x(), d = now.d(), b1 = now.b1();
  for (const Bulge& bulge : bulges) {
    const auto& nodes = bulge.nodes;
    const Vec3 middle = mean(x, bulge);
    const double f = bulge.force_per_length(pressure);
    Eigen::Matrix<double, 3, 2> turn[3];  // of the directors, by their rotations
    for (std::size_t a = 0; a < 3; ++a) turn[a] = turning_axes(at(d, nodes[a]), at(b1, nodes[a]));
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) {
        const double share = f * ((a == b ? 1 : 0) - 1.0 / 3);
        Eigen::Matrix<double, 5, 5> k = Eigen::Matrix<double, 5, 5>::Zero();
        k.topRightCorner<3, 2>() = -share * turn[b];
        k.bottomLeftCorner<2, 3>() = -share * turn[a].transpose();
        if (a == b)  // the second variation of the director
          k.diagonal().tail<2>().setConstant(f * (at(x, nodes[a]) - middle).dot(at(d, nodes[a])));
        sink.on_nodes(nodes[a], nodes[b], k);
      }
  }
}

}  // namespace fabricsh::mechanics
