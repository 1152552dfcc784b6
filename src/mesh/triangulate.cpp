#include "mesh/triangulate.hpp"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <deque>
#include <unordered_map>

namespace fabricsh::mesh {

namespace {

int sign(std::int64_t x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// Whether c, on the line through a and b, lies between them.
bool between(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return std::min(a[0], b[0]) <= c[0] && c[0] <= std::max(a[0], b[0]) && std::min(a[1], b[1]) <= c[1] &&
         c[1] <= std::max(a[1], b[1]);
}

// Triangles by their directed edges, which allows to exchange the diagonal of two of them.
class Triangles {
 public:
  explicit Triangles(const std::vector<GridPoint>& points) : points_(points) { delaunay(); }

  // Sloan's way: edges that cross the wanted one are exchanged until none does.
  void force(const Segment& wanted) {
    if (left(wanted[0], wanted[1]) != none) return;
    std::deque<Segment> rest = crossing(wanted);
    const std::size_t most = 16 + 8 * rest.size() * rest.size();
    for (std::size_t i = 0; !rest.empty() && i < most; ++i) {
      const Segment edge = rest.front();
      rest.pop_front();
      Segment now{};
      if (!flip(edge, now))
        rest.push_back(edge);
      else if (crosses(wanted, now[0], now[1]))
        rest.push_back(now);
    }
  }

  // Spreads from the triangles to the left of the border over edges that are not of the border.
  std::vector<Corners> inside(const std::vector<Segment>& border) const {
    std::vector<char> in(triangles_.size(), 0);
    std::unordered_map<std::uint64_t, char> closed;
    std::vector<std::size_t> reached;
    const auto take = [&](std::size_t triangle) {
      if (triangle == none || in[triangle] != 0) return;
      in[triangle] = 1;
      reached.push_back(triangle);
    };
    for (const auto& [a, b] : border) closed[key(a, b)] = closed[key(b, a)] = 1;
    for (const auto& [a, b] : border) take(left(a, b));
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const Corners t = triangles_[reached[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = t[k], b = t[(k + 1) % 3];
        if (!closed.contains(key(a, b))) take(left(b, a));
      }
    }
    std::vector<Corners> found;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      if (in[i] == 0) continue;
      Corners t = triangles_[i];
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      found.push_back(t);
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  // The sites around each vertex of the Voronoi diagram are the corners of a convex polygon, a triangle if no
  // more than three of them lie on one circle.
  void delaunay() {
    std::vector<boost::polygon::point_data<int>> sites;
    sites.reserve(points_.size());
    for (const GridPoint& p : points_) sites.emplace_back(static_cast<int>(p[0]), static_cast<int>(p[1]));
    boost::polygon::voronoi_diagram<double> diagram;
    boost::polygon::construct_voronoi(sites.begin(), sites.end(), &diagram);
    std::vector<Index> around;
    for (const auto& vertex : diagram.vertices()) {
      around.clear();
      const auto* edge = vertex.incident_edge();
      do {
        around.push_back(static_cast<Index>(edge->cell()->source_index()));
        edge = edge->rot_next();
      } while (edge != vertex.incident_edge());
      std::rotate(around.begin(), std::min_element(around.begin(), around.end()), around.end());
      for (std::size_t i = 1; i + 1 < around.size(); ++i) add(around[0], around[i], around[i + 1]);
    }
  }

  void add(Index a, Index b, Index c) {
    const int turn = side(a, b, c);
    if (turn == 0) return;
    triangles_.emplace_back();
    set(triangles_.size() - 1, a, turn > 0 ? b : c, turn > 0 ? c : b);
  }
  void set(std::size_t triangle, Index a, Index b, Index c) {
    triangles_[triangle] = {a, b, c};
    left_[key(a, b)] = left_[key(b, c)] = left_[key(c, a)] = triangle;
  }
  // The triangle to the left of the edge from a to b, or none.
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t left(Index a, Index b) const {
    const auto found = left_.find(key(a, b));
    return found == left_.end() ? none : found->second;
  }
  Index opposite(std::size_t triangle, Index a, Index b) const {
    for (const Index c : triangles_[triangle])
      if (c != a && c != b) return c;
    return -1;
  }
  std::uint64_t key(Index a, Index b) const {
    return static_cast<std::uint64_t>(a) * points_.size() + static_cast<std::uint64_t>(b);
  }
  int side(Index a, Index b, Index c) const { return sign(doubled_area(at(a), at(b), at(c))); }
  bool crosses(const Segment& s, Index a, Index b) const {
    return side(s[0], s[1], a) * side(s[0], s[1], b) < 0 && side(a, b, s[0]) * side(a, b, s[1]) < 0;
  }
  std::deque<Segment> crossing(const Segment& wanted) const {
    std::deque<Segment> found;
    for (const Corners& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = t[i], b = t[(i + 1) % 3];
        if (a < b && crosses(wanted, a, b)) found.push_back({a, b});
      }
    return found;
  }

  // Exchanges the edge for the other diagonal of its two triangles, if these form a convex quadrilateral.
  bool flip(const Segment& edge, Segment& now) {
    const auto [a, b] = edge;
    const std::size_t one = left(a, b), other = left(b, a);
    if (one == none || other == none) return false;
    const Index c = opposite(one, a, b), d = opposite(other, a, b);
    if (side(c, d, a) * side(c, d, b) >= 0) return false;
    left_.erase(key(a, b));
    left_.erase(key(b, a));
    set(one, c, a, d);
    set(other, d, b, c);
    now = {std::min(c, d), std::max(c, d)};
    return true;
  }

  const GridPoint& at(Index i) const { return points_[static_cast<std::size_t>(i)]; }

  const std::vector<GridPoint>& points_;
  std::vector<Corners> triangles_;
  std::unordered_map<std::uint64_t, std::size_t> left_;
};

}  // namespace

std::int64_t doubled_area(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool touch(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  const int abc = sign(doubled_area(a, b, c)), abd = sign(doubled_area(a, b, d));
  const int cda = sign(doubled_area(c, d, a)), cdb = sign(doubled_area(c, d, b));
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) || (cda == 0 && between(c, d, a)) ||
         (cdb == 0 && between(c, d, b));
}

std::vector<Corners> triangulate(const std::vector<GridPoint>& points, const std::vector<Segment>& border) {
  Triangles triangles(points);
  for (const Segment& segment : border) triangles.force(segment);
  return triangles.inside(border);
}

}  // namespace fabricsh::mesh
