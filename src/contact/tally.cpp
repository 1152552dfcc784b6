#include "contact/tally.hpp"

#include <algorithm>

namespace fabricsh::contact {
namespace {

// For one point.
class Tally {
 public:
  Tally(const Scene& scene, std::span<const Vec3> x, std::int32_t point)
      : scene_(scene), x_(x), point_(point) {}

  // Whether facet t counts its side k, and its corner k: 0 to 2.
  bool side(std::int32_t t, std::size_t k) const {
    const auto at = scene_.triangles_at_edge(row(t).edge_row[k]);
    const std::int32_t other = at[0] == t ? at[1] : at[0];
    const auto j = side_of(other, row(t).edge_row[k]);
    const int mine = claim(t, k), its = claim(other, j);
    return mine != its ? mine > its : t < other;
  }
  bool corner(std::int32_t t, std::size_t k) const {
    const std::int32_t c = row(t).nodes[k];
    const auto around = scene_.triangles_at_point(c);
    if (t != around.front() && !begins(t, k)) return false;
    const auto first = std::find_if(around.begin(), around.end(), [&](auto r) {
      return row(r).surface == row(t).surface && begins(r, corner_of(r, c));
    });
    return t == (first == around.end() ? around.front() : *first);
  }

 private:
  const TriangleRow& row(std::int32_t t) const { return scene_.triangles()[std::size_t(t)]; }
  const Vec3& at(std::int32_t p) const { return x_[std::size_t(p)]; }
  std::size_t part(std::int32_t t) const {
    const Triangle& n = row(t).nodes;
    return nearest_part(at(point_), at(n[0]), at(n[1]), at(n[2]));
  }
  std::size_t side_of(std::int32_t t, std::int32_t edge) const {
    const auto& rows = row(t).edge_row;
    return std::size_t(std::find(rows.begin(), rows.end(), edge) - rows.begin());
  }
  std::size_t corner_of(std::int32_t t, std::int32_t node) const {
    const auto& nodes = row(t).nodes;
    return std::size_t(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
  }
  // Of the facets about a corner that is the nearest of them, each counts the side that begins there; the
  // first of them counts the corner and the side that ends there, too.
  int claim(std::int32_t t, std::size_t k) const {
    const std::size_t p = part(t), begin = (k + 1) % 3, end = (k + 2) % 3;
    return p == 1 + k || p == 4 + begin ? 2 : p == 4 + end ? 1 : 0;
  }
  bool begins(std::int32_t t, std::size_t corner) const {
    if (part(t) != 4 + corner) return false;
    const std::size_t k = (corner + 1) % 3;  // the side that ends at the corner
    const std::int32_t edge = row(t).edge_row[k];
    const auto pair = scene_.triangles_at_edge(edge);
    const std::int32_t before = pair[0] == t ? pair[1] : pair[0];
    return part(before) != 4 + corner_of(before, row(t).nodes[corner]);
  }

  const Scene& scene_;
  const std::span<const Vec3> x_;
  const std::int32_t point_;
};

// m: how far p is on the side of `a` to which `towards` points.
double beyond(const Vec3& p, const Vec3& a, const Vec3& towards) {
  const double length = towards.norm();
  return length > 0 ? towards.dot(p - a) / length : 0;
}

}  // namespace

void tally(const Scene& scene, std::span<const Vec3> x, Candidate& candidate) {
  if (candidate.shared == 0) return;
  const std::int32_t t = candidate.facet;
  const Tally tally(scene, x, candidate.point[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    if ((candidate.shared >> k & 1) != 0) candidate.pair.edge[k] = tally.side(t, k) ? -1 : 0;
    if ((candidate.shared >> (3 + k) & 1) != 0) candidate.pair.corner[k] = tally.corner(t, k) ? 1 : 0;
  }
}

double nothing_counts_for(const Pair& facet, const Corners& x) {
  const std::size_t part = nearest_part(x[0], x[1], x[2], x[3]);
  if (part == 0) return 0;
  const std::size_t k = (part - 1) % 3, i = (k + 1) % 3, j = (k + 2) % 3;  // the side from i to j
  const Vec3 &a = x[1 + i], &b = x[1 + j], &c = x[1 + k];
  const Vec3 across = (b - a).cross(c - a);
  double room = 0;
  if (part <= 3) {
    if (facet.edge[k] != -1 || facet.edge[i] != 0 || facet.edge[j] != 0 || facet.corner[0] != 0 ||
        facet.corner[1] != 0 || facet.corner[2] != 0)
      return 0;
    room = std::min({beyond(x[0], a, (b - a).cross(across)), beyond(x[0], a, b - a), beyond(x[0], b, a - b)});
  } else {
    if (1 + facet.edge[i] + facet.edge[j] + facet.corner[k] != 0 || facet.edge[k] != 0 ||
        facet.corner[i] != 0 || facet.corner[j] != 0)
      return 0;
    room = std::min(beyond(x[0], c, c - a), beyond(x[0], c, c - b));
  }
  // The parts' borders turn with the facet, the more the smaller it is.
  const double longest = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()}),
               height = across.norm() / std::sqrt(longest),
               away = std::sqrt(squared_point_triangle(x[0], x[1], x[2], x[3]));
  return std::max(0.0, room) / (2 + 4 * away / height);
}

}  // namespace fabricsh::contact
