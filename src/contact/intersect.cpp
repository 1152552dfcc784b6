#include "contact/intersect.hpp"

#include <cmath>

namespace fabricsh::contact {

bool cuts(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  // [moller1997], with the border counted as inside.
  const Vec3 along = q - p, u = b - a, v = c - a, h = along.cross(v);
  const double det = u.dot(h), size = along.norm() * u.norm() * v.norm();
  if (std::fabs(det) <= 1e-15 * size) return false;  // parallel: ends and edges are found by other pairs
  const Vec3 s = p - a, w = s.cross(u);
  const double i = 1 / det, first = i * s.dot(h), second = i * along.dot(w), t = i * v.dot(w);
  return first >= 0 && second >= 0 && first + second <= 1 && t >= 0 && t <= 1;
}

std::vector<std::pair<std::size_t, std::size_t>> intersections(std::span<const Vec3> x,
                                                               std::span<const Edge> edges,
                                                               std::span<const Triangle> triangles) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  const auto at = [&](std::int32_t node) -> const Vec3& { return x[std::size_t(node)]; };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [p, q] = edges[e];
    const Vec3 low = at(p).cwiseMin(at(q)), high = at(p).cwiseMax(at(q));
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const auto [a, b, c] = triangles[k];
      if (p == a || p == b || p == c || q == a || q == b || q == c) continue;
      const Vec3 least = at(a).cwiseMin(at(b)).cwiseMin(at(c)), most = at(a).cwiseMax(at(b)).cwiseMax(at(c));
      if ((least.array() > high.array()).any() || (most.array() < low.array()).any()) continue;
      if (cuts(at(p), at(q), at(a), at(b), at(c))) found.emplace_back(e, k);
    }
  }
  return found;
}

}  // namespace fabricsh::contact
