#include "contact/intersect.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "contact/grid.hpp"

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

std::vector<Edge> open_edges(std::span<const Triangle> triangles) {
  std::map<Edge, std::array<int, 2>> walked;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = t[k], b = t[(k + 1) % 3];
      ++walked[{std::min(a, b), std::max(a, b)}][a < b ? 0 : 1];
    }
  std::vector<Edge> open;
  for (const auto& [edge, times] : walked)
    if (times[0] != times[1]) open.push_back(edge);
  return open;
}

// The sum of the solid angles of the triangles [vanoosterom1983] is 4 pi inside and 0 outside.
bool encloses(std::span<const Vec3> x, std::span<const Triangle> triangles, const Vec3& point) {
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Vec3 a = x[std::size_t(t[0])] - point, b = x[std::size_t(t[1])] - point,
               c = x[std::size_t(t[2])] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum > 2 * std::numbers::pi;
}

std::vector<std::pair<std::size_t, std::size_t>> intersections(std::span<const Vec3> x,
                                                               std::span<const Edge> edges,
                                                               std::span<const Triangle> triangles) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  const auto at = [&](std::int32_t node) -> const Vec3& { return x[std::size_t(node)]; };
  // Edges of nearly one length, within a factor of two, are sorted by their middles, and a triangle looks for
  // those within half of the longest one.
  const auto length = [&](std::size_t e) { return (at(edges[e][0]) - at(edges[e][1])).norm(); };
  std::map<int, std::vector<std::size_t>> of_length;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (const double l = length(e); l > 0) of_length[std::ilogb(l)].push_back(e);
  for (const auto& [exponent, own] : of_length) {
    Box room;
    double longest = 0, sum = 0;
    const auto middle = [&](std::size_t i) {
      return Vec3((at(edges[own[i]][0]) + at(edges[own[i]][1])) / 2);
    };
    for (std::size_t i = 0; i < own.size(); ++i) {
      room.add(middle(i));
      longest = std::max(longest, length(own[i]));
      sum += length(own[i]);
    }
    const Grid middles(room, sum / double(own.size()), own.size(), middle);
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const std::int32_t a = triangles[k][0], b = triangles[k][1], c = triangles[k][2];
      Box box;
      for (const std::int32_t corner : triangles[k]) box.add(at(corner));
      middles.in(box.grown(longest / 2), [&](std::int32_t number) {
        const auto e = own[std::size_t(number)];
        const auto [p, q] = edges[e];
        if (p == a || p == b || p == c || q == a || q == b || q == c) return;
        Box along;
        along.add(at(p));
        along.add(at(q));
        if (box.meets(along) && cuts(at(p), at(q), at(a), at(b), at(c))) found.emplace_back(e, k);
      });
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace fabricsh::contact
