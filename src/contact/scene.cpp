#include "contact/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/box.hpp"

namespace fabricsh::contact {
namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error("contact: " + what); }

void check_radius(const char* what, double radius) {
  if (!(radius > 0) || !std::isfinite(radius))
    refuse(std::string(what) + ": radius: expected a positive length in m, got " + number(radius));
}

double area_of(const std::vector<Vec3>& x, const Triangle& t) {
  const Vec3& a = x[std::size_t(t[0])];
  return 0.5 * (x[std::size_t(t[1])] - a).cross(x[std::size_t(t[2])] - a).norm();
}

std::int8_t small(std::ptrdiff_t count) {
  return static_cast<std::int8_t>(std::clamp<std::ptrdiff_t>(count, -127, 127));
}

// Whether a quadrilateral with equal diagonals is cut along that from its first corner: the one that does not
// point to the centre. All points but the centre then have six triangles. `otherwise`: neither points there.
bool along_first(const std::array<Vec3, 4>& x, const Vec3& centre, bool otherwise) {
  const Vec3 from = (x[0] + x[1] + x[2] + x[3]) / 4 - centre;
  const double first = std::abs(from.dot(x[2] - x[0])), second = std::abs(from.dot(x[3] - x[1]));
  return std::abs(first - second) <= 1e-6 * (first + second) ? otherwise : first < second;
}

// Whether a sheet lies in a plane, however that lies in space: the plane of its largest element.
bool is_flat(std::span<const Vec3> nodes, std::span<const std::array<mesh::Index, 4>> elements) {
  std::vector<Vec3> used;
  Vec3 normal = Vec3::Zero();
  for (const auto& e : elements) {
    const auto at = [&](std::size_t i) -> const Vec3& { return nodes[std::size_t(e[i])]; };
    for (const mesh::Index n : e)
      if (n >= 0) used.push_back(nodes[std::size_t(n)]);
    const Vec3 across = (at(2) - at(0)).cross(at(e[3] < 0 ? 0 : 3) - at(1));
    if (across.squaredNorm() > normal.squaredNorm()) normal = across;
  }
  if (!(normal.norm() > 0)) return false;
  normal.normalize();
  const double thin = 1e-6 * box_of(used).size().maxCoeff();
  return std::all_of(used.begin(), used.end(),
                     [&](const Vec3& x) { return std::abs((x - used.front()).dot(normal)) <= thin; });
}

}  // namespace

Split split(std::span<const Vec3> nodes, std::span<const std::array<mesh::Index, 4>> elements,
            const std::optional<Vec3>& centre) {
  const bool mirrors = centre && is_flat(nodes, elements);
  Split out;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto& id = elements[e];
    const auto at = [&](std::size_t i) -> const Vec3& { return nodes[std::size_t(id[i])]; };
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      out.triangles.push_back({std::int32_t(id[a]), std::int32_t(id[b]), std::int32_t(id[c])});
      out.element.push_back(std::int32_t(e));
    };
    if (id[3] < 0) {
      add(0, 1, 2);
      continue;
    }
    const double first = (at(2) - at(0)).norm(), second = (at(3) - at(1)).norm();
    const bool tie = std::fabs(first - second) <= 1e-9 * (first + second);
    const bool even = e % 2 == 0;
    const bool tied = mirrors ? along_first({at(0), at(1), at(2), at(3)}, *centre, even) : even;
    if (tie ? tied : first < second) {
      add(0, 1, 2);
      add(0, 2, 3);
    } else {
      add(0, 1, 3);
      add(1, 2, 3);
    }
  }
  return out;
}

Scene::Scene(std::vector<Vec3> nodes) : nodes_(nodes.size()), reference_(std::move(nodes)) {
  area_.resize(nodes_);
  at_point_.resize(nodes_);
}

int Scene::add_cloth(std::span<const std::array<mesh::Index, 4>> elements,
                     const std::optional<Vec3>& centre) {
  for (const auto& element : elements)
    for (std::size_t i = 0; i < 4; ++i)
      if (element[i] >= mesh::Index(nodes_) || (element[i] < 0 && i < 3))
        refuse("cloth: expected nodes from 0 to " + std::to_string(nodes_) + ", got " +
               std::to_string(element[i]));
  const Split cut = split(std::span(reference_).first(nodes_), elements, centre);
  return add_triangles({}, cut.triangles, cut.element);
}

int Scene::add_rigid(Surface surface, std::span<const Vec3> vertices) {
  surface.first_vertex = std::int32_t(reference_.size());
  surface.vertices = std::int32_t(vertices.size());
  for (const Vec3& v : vertices) {
    if (!v.allFinite()) refuse("a rigid surface has a vertex that is not finite");
    surface.points.push_back(std::int32_t(reference_.size()));
    reference_.push_back(v);
  }
  area_.resize(reference_.size());
  at_point_.resize(reference_.size());
  surface.first_edge = std::int32_t(edges_.size());
  surface.first_triangle = std::int32_t(triangles_.size());
  surfaces_.push_back(std::move(surface));
  return int(surfaces_.size()) - 1;
}

int Scene::add_solid(std::span<const Vec3> vertices, std::span<const Triangle> triangles, double radius,
                     bool changes_shape) {
  if (!(radius >= 0) || !std::isfinite(radius))
    refuse("solid: radius: expected 0 or a positive length in m, got " + number(radius));
  const auto first = std::int32_t(reference_.size()), count = std::int32_t(vertices.size());
  for (const Vec3& v : vertices) {
    if (!v.allFinite()) refuse("solid: expected finite vertices");
    reference_.push_back(v);
  }
  area_.resize(reference_.size());
  at_point_.resize(reference_.size());
  std::vector<Triangle> moved(triangles.begin(), triangles.end());
  for (Triangle& t : moved)
    for (std::int32_t& id : t) {
      if (id < 0 || id >= count)
        refuse("solid: expected vertices from 0 to " + std::to_string(count - 1) + ", got " +
               std::to_string(id));
      id += first;
    }
  Surface surface;
  surface.changes_shape = changes_shape;
  surface.shape = Shape::solid;
  surface.radius = radius;
  surface.first_vertex = first;
  surface.vertices = count;
  const std::vector<std::int32_t> element(moved.size(), -1);
  return add_triangles(std::move(surface), moved, element);
}

int Scene::add_ball(const Vec3& centre, double radius) {
  check_radius("ball", radius);
  Surface surface;
  surface.shape = Shape::ball;
  surface.radius = radius;
  return add_rigid(std::move(surface), std::array<Vec3, 1>{centre});
}

int Scene::add_rod(const Vec3& from, const Vec3& to, double radius) {
  check_radius("rod", radius);
  if (!((to - from).norm() > 0)) refuse("rod: expected two different ends");
  Surface surface;
  surface.shape = Shape::rod;
  surface.radius = radius;
  const int number = add_rigid(std::move(surface), std::array<Vec3, 2>{from, to});
  EdgeRow row;
  row.a = surfaces_.back().first_vertex;
  row.b = row.a + 1;
  row.surface = number;
  row.length = (to - from).norm();
  edges_.push_back(row);
  at_edge_.emplace_back();
  surfaces_.back().edges = 1;
  return number;
}

int Scene::add_wall(const Vec3& point, const Vec3& normal) {
  if (!(normal.norm() > 0) || !normal.allFinite()) refuse("wall: expected a normal that is not zero");
  const Vec3 n = normal.normalized(), u = n.unitOrthogonal(), v = n.cross(u);
  Surface surface;
  surface.shape = Shape::wall;
  return add_rigid(std::move(surface), std::array<Vec3, 3>{point, point + u, point + v});
}

void Scene::add_followers(std::span<const Vec3> points) {
  reference_.insert(reference_.end(), points.begin(), points.end());
  area_.resize(reference_.size());
  at_point_.resize(reference_.size());
  surfaces_.back().followers += std::int32_t(points.size());
}

int Scene::add_triangles(Surface surface, std::span<const Triangle> triangles,
                         std::span<const std::int32_t> element) {
  surface.first_triangle = std::int32_t(triangles_.size());
  surface.triangles = std::int32_t(triangles.size());
  const auto number = std::int32_t(surfaces_.size());
  double total = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    TriangleRow row;
    row.nodes = triangles[i];
    row.surface = number;
    row.element = element[i];
    row.area = area_of(reference_, row.nodes);
    if (!(row.area > 0)) refuse("triangle " + std::to_string(i + 1) + " of a surface has no area");
    total += row.area;
    for (const std::int32_t node : row.nodes) {
      at_point_[std::size_t(node)].push_back(std::int32_t(triangles_.size()));
      surface.points.push_back(node);
    }
    triangles_.push_back(row);
  }
  share_areas(surface, element);
  std::sort(surface.points.begin(), surface.points.end());
  surface.points.erase(std::unique(surface.points.begin(), surface.points.end()), surface.points.end());
  surface.mean_area = surface.points.empty() ? 0 : total / double(surface.points.size());
  add_edges(surface);
  count_places(surface);
  find_sheets(surface);
  if (surface.shape == Shape::solid && !surface.changes_shape) find_flat_parts(surface);
  surfaces_.push_back(std::move(surface));
  return number;
}

// The corners of an element have the parts of its area that its shape functions have, as of its mass and
// loads, however a quadrilateral is cut: so cloth at rest on a floor is pressed alike everywhere. A corner
// has a sixth of the area, and a sixth of the triangle of this corner and its neighbours.
void Scene::share_areas(const Surface& surface, std::span<const std::int32_t> element) {
  const auto row = [&](std::size_t i) -> const TriangleRow& {
    return triangles_[std::size_t(surface.first_triangle) + i];
  };
  const auto add = [&](std::int32_t node, double area) { area_[std::size_t(node)] += area; };
  const auto apex = [](const Triangle& of, const Triangle& other) {
    return *std::find_if(of.begin(), of.end(), [&](std::int32_t node) {
      return std::find(other.begin(), other.end(), node) == other.end();
    });
  };
  for (std::size_t i = 0; i < element.size(); ++i) {
    const auto& first = row(i);
    if (element[i] < 0 || i + 1 == element.size() || element[i + 1] != element[i]) {
      for (const std::int32_t node : first.nodes) add(node, first.area / 3);
      continue;
    }
    const auto& second = row(++i);
    const double whole = first.area + second.area;
    const std::int32_t p = apex(first.nodes, second.nodes), q = apex(second.nodes, first.nodes);
    add(p, (whole + first.area) / 6);
    add(q, (whole + second.area) / 6);
    for (const std::int32_t node : first.nodes)
      if (node != p) add(node, (whole + area_of(reference_, {p, node, q})) / 6);
  }
}

// Adds the edges of a surface, in ascending order of their ends.
void Scene::add_edges(Surface& surface) {
  struct TriangleSide {
    Edge ends;
    std::int32_t triangle, corner;
  };
  std::vector<TriangleSide> sides;
  for (std::int32_t t = surface.first_triangle; t < surface.first_triangle + surface.triangles; ++t)
    for (std::int32_t k = 0; k < 3; ++k) {
      const Triangle& n = triangles_[std::size_t(t)].nodes;
      const auto [a, b] = std::minmax(n[std::size_t((k + 1) % 3)], n[std::size_t((k + 2) % 3)]);
      sides.push_back({{a, b}, t, k});
    }
  std::stable_sort(sides.begin(), sides.end(),
                   [](const TriangleSide& a, const TriangleSide& b) { return a.ends < b.ends; });
  surface.first_edge = std::int32_t(edges_.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i == 0 || sides[i].ends != sides[i - 1].ends) {
      EdgeRow row;
      row.a = sides[i].ends[0];
      row.b = sides[i].ends[1];
      row.surface = std::int32_t(surfaces_.size());
      row.length = (reference_[std::size_t(row.a)] - reference_[std::size_t(row.b)]).norm();
      edges_.push_back(row);
      at_edge_.emplace_back();
    }
    TriangleRow& t = triangles_[std::size_t(sides[i].triangle)];
    t.edge_row[std::size_t(sides[i].corner)] = std::int32_t(edges_.size()) - 1;
    edges_.back().area += t.area / 3;
    at_edge_.back().push_back(sides[i].triangle);
  }
  surface.edges = std::int32_t(edges_.size()) - surface.first_edge;
}

// The weights of facets, edges and corners: an edge shared by m facets counts 1 - m times,
// and corners make up the rest, so that a place counts once anywhere on a smooth surface.
// The weights of an edge or a corner are stored in the first triangle that has it.
void Scene::count_places(const Surface& surface) {
  for (std::int32_t t = surface.first_triangle; t < surface.first_triangle + surface.triangles; ++t) {
    TriangleRow& row = triangles_[std::size_t(t)];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& at_edge = at_edge_[std::size_t(row.edge_row[k])];
      if (at_edge.front() == t) row.edge[k] = small(1 - std::ptrdiff_t(at_edge.size()));
    }
  }
  for (std::int32_t t = surface.first_triangle; t < surface.first_triangle + surface.triangles; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t node = triangles_[std::size_t(t)].nodes[k];
      const auto& at = at_point_[std::size_t(node)];
      const auto first =
          std::lower_bound(at.begin(), at.end(), surface.first_triangle);  // for a node of two surfaces
      if (*first != t) continue;
      std::ptrdiff_t count = 1;
      for (auto other = first; other != at.end() && *other < surface.first_triangle + surface.triangles;
           ++other) {
        const TriangleRow& o = triangles_[std::size_t(*other)];
        --count;
        for (std::size_t j = 0; j < 3; ++j)
          if (o.nodes[j] != node) count -= o.edge[j];
      }
      triangles_[std::size_t(t)].corner[k] = small(count);
    }
  for (std::int32_t t = surface.first_triangle; t < surface.first_triangle + surface.triangles; ++t) {
    TriangleRow& row = triangles_[std::size_t(t)];
    const auto two = [&](std::int32_t edge) { return at_edge_[std::size_t(edge)].size() == 2; };
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& around = at_point_[std::size_t(row.nodes[k])];
      const bool closed = std::all_of(around.begin(), around.end(), [&](std::int32_t other) {
        const TriangleRow& o = triangles_[std::size_t(other)];
        for (std::size_t j = 0; j < 3; ++j)
          if (o.nodes[j] != row.nodes[k] && !two(o.edge_row[j])) return false;
        return o.surface == row.surface;
      });
      row.shared |= std::uint8_t((two(row.edge_row[k]) ? 1u << k : 0u) | (closed ? 8u << k : 0u));
    }
  }
}

void Scene::find_sheets(const Surface& surface) {
  auto& sheet = neighbours_.sheet_;
  sheet.resize(reference_.size(), -1);
  std::vector<std::int32_t> open;
  for (const std::int32_t first : surface.points) {
    if (sheet[std::size_t(first)] >= 0) continue;
    open.assign(1, first);
    sheet[std::size_t(first)] = first;
    while (!open.empty()) {
      const std::int32_t p = open.back();
      open.pop_back();
      for (const std::int32_t t : at_point_[std::size_t(p)])
        for (const std::int32_t q : triangles_[std::size_t(t)].nodes) {
          if (sheet[std::size_t(q)] >= 0) continue;
          sheet[std::size_t(q)] = first;
          open.push_back(q);
        }
    }
  }
}

// Edges between two facets in one plane, and vertices with such edges alone.
void Scene::find_flat_parts(Surface& surface) {
  constexpr double flat = 1e-4;  // rad; files round vertices to six digits
  std::vector<char> at_rim(reference_.size(), 0);
  for (std::int32_t e = surface.first_edge; e < surface.first_edge + surface.edges; ++e) {
    EdgeRow& row = edges_[std::size_t(e)];
    const Vec3 &from = reference_[std::size_t(row.a)], way = reference_[std::size_t(row.b)] - from;
    Vec3 sum = Vec3::Zero();  // of the directions from the edge into its triangles
    for (const std::int32_t t : triangles_at_edge(e)) {
      const TriangleRow& triangle = triangles_[std::size_t(t)];
      const auto k =
          std::find(triangle.edge_row.begin(), triangle.edge_row.end(), e) - triangle.edge_row.begin();
      const Vec3 to = reference_[std::size_t(triangle.nodes[std::size_t(k)])] - from;
      sum += (to - to.dot(way) / way.squaredNorm() * way).normalized();
    }
    row.inside_flat = triangles_at_edge(e).size() == 2 && sum.norm() <= flat;
    if (!row.inside_flat) at_rim[std::size_t(row.a)] = at_rim[std::size_t(row.b)] = 1;
  }
  std::erase_if(surface.points, [&](std::int32_t p) { return at_rim[std::size_t(p)] == 0; });
}

Scene Scene::with_corners(const std::function<Triangle(const TriangleRow&)>& corners) const {
  Scene out(std::vector<Vec3>(reference_.begin(), reference_.begin() + std::ptrdiff_t(nodes_)));
  for (const Surface& from : surfaces_) {
    Surface surface;
    surface.shape = from.shape;
    surface.radius = from.radius;
    surface.changes_shape = from.changes_shape;
    const auto vertices =
        std::span(reference_).subspan(std::size_t(from.first_vertex), std::size_t(from.vertices));
    const auto followers =
        std::span(reference_)
            .subspan(std::size_t(from.first_vertex + from.vertices), std::size_t(from.followers));
    if (from.shape != Shape::cloth && from.shape != Shape::solid) {
      out.add_rigid(std::move(surface), vertices);
      Surface& added = out.surfaces_.back();
      added.edges = from.edges;
      for (std::int32_t e = from.first_edge; e < from.first_edge + from.edges; ++e) {
        out.edges_.push_back(edges_[std::size_t(e)]);
        out.at_edge_.emplace_back();
      }
      out.add_followers(followers);
      continue;
    }
    surface.first_vertex = from.first_vertex;
    surface.vertices = from.vertices;
    out.reference_.insert(out.reference_.end(), vertices.begin(), vertices.end());
    out.area_.resize(out.reference_.size());
    out.at_point_.resize(out.reference_.size());
    std::vector<Triangle> triangles;
    std::vector<std::int32_t> element;
    for (std::int32_t t = from.first_triangle; t < from.first_triangle + from.triangles; ++t) {
      const TriangleRow& row = triangles_[std::size_t(t)];
      triangles.push_back(from.shape == Shape::cloth ? corners(row) : row.nodes);
      element.push_back(row.element);
    }
    out.add_triangles(std::move(surface), triangles, element);
    // A former sheet still counts as one: its parts are not nearer to each other than before.
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        out.neighbours_.sheet_[std::size_t(triangles[i][k])] =
            neighbours_.sheet(triangles_[std::size_t(from.first_triangle) + i].nodes[k]);
    if (!followers.empty()) out.add_followers(followers);
  }
  out.interactions_ = interactions_;
  out.spots_ = spots_;
  out.neighbours_.partners_ = neighbours_.partners_;
  return out;
}

int Scene::interaction_number(std::int32_t first, std::int32_t second) const {
  for (std::size_t i = 0; i < interactions_.size(); ++i) {
    const Interaction& it = interactions_[i];
    if ((it.first == first && it.second == second) || (it.first == second && it.second == first))
      return int(i);
  }
  return -1;
}

const Interaction* Scene::between(std::int32_t first, std::int32_t second) const {
  const int number = interaction_number(first, second);
  return number < 0 ? nullptr : &interactions_[std::size_t(number)];
}

bool can_meet(Shape first, Shape second) {
  const auto is = [&](Shape a, Shape b) {
    return (first == a && second == b) || (first == b && second == a);
  };
  return (first == Shape::ball && second != Shape::cloth) ||
         (second == Shape::ball && first != Shape::cloth) || is(Shape::rod, Shape::wall);
}

namespace {

// Of two rigid shapes the first is the one whose points are looked at.
int points_first(Shape shape) { return shape == Shape::ball ? 0 : shape == Shape::rod ? 1 : 2; }

}  // namespace

void Scene::meet(int first, int second, const ContactLaw& law, double friction, double loss,
                 std::optional<double> sticking) {
  const int count = int(surfaces_.size());
  if (first < 0 || second < 0 || first >= count || second >= count)
    refuse("expected surfaces from 0 to " + std::to_string(count - 1) + ", got " + std::to_string(first) +
           " and " + std::to_string(second));
  const Shape a = surfaces_[std::size_t(first)].shape, b = surfaces_[std::size_t(second)].shape;
  const bool rigid = a != Shape::cloth && b != Shape::cloth;
  if (rigid && (first == second || !can_meet(a, b)))
    refuse("expected two rigid shapes of which one is a ball, or a rod and a wall");
  if (rigid && std::max(friction, sticking.value_or(0)) > 0)
    refuse("friction: expected 0 between two rigid shapes, got " + number(friction));
  if (!(friction >= 0) || !std::isfinite(friction))
    refuse("friction: expected a number from 0 on, got " + number(friction));
  if (!(loss >= 0) || !std::isfinite(loss)) refuse("loss: expected a number from 0 on, got " + number(loss));
  if (between(first, second) != nullptr) refuse("the two surfaces are in contact already");
  Interaction it{first, second, law, friction, sticking.value_or(friction), loss};
  if (!(it.sticking >= friction) || !std::isfinite(it.sticking))
    refuse("friction: expected a static one of at least the kinetic one of " + number(friction) + ", got " +
           number(it.sticking));
  it.rigid = rigid;
  it.cloths = a == Shape::cloth && b == Shape::cloth;
  if (rigid ? points_first(b) < points_first(a) : a != Shape::cloth) std::swap(it.first, it.second);
  interactions_.push_back(std::move(it));
}

void Scene::spread(std::size_t interaction, std::vector<std::int8_t> parts) {
  for (const std::int8_t n : parts) spots_ = std::max(spots_, std::int32_t(n) * n);
  const auto room = std::numeric_limits<std::int32_t>::max() - std::int64_t(reference_.size());
  if (std::int64_t(triangles_.size()) * spots_ > room)
    refuse("too many triangles for contact points inside them: " + std::to_string(triangles_.size()) +
           " with " + std::to_string(spots_) + " each");
  interactions_[interaction].parts = std::move(parts);
}

// The middles of the parts: those with an edge on the same side as the triangle first, row by row, and then
// those between them.
Spot Spots::at(std::int32_t triangle, int parts, int k) const {
  const int upright = parts * (parts + 1) / 2;
  const bool between = k >= upright;
  int left = between ? k - upright : k, row = 0;
  for (int width = between ? parts - 1 : parts; left >= width; --width, ++row) left -= width;
  const int add = between ? 2 : 1, i = 3 * left + add, j = 3 * row + add;
  return {triangles_[std::size_t(triangle)].nodes,
          {std::int16_t(3 * parts - i - j), std::int16_t(i), std::int16_t(j)}};
}

std::array<std::int32_t, 4> Spots::with_nodes(const std::array<std::int32_t, 4>& points) const {
  if (!is(points[0])) return points;
  const Triangle& nodes = triangles_[std::size_t(triangle_of(points[0]))].nodes;
  return {nodes[0], nodes[1], nodes[2], points[1]};
}

int add_disc(Scene& scene, const Vec3& centre, const Vec3& normal, double radius, double edge, int sides) {
  check_radius("disc", radius);
  if (!(edge >= 0 && edge < radius))
    refuse("disc: edge: expected from 0 to less than the radius of " + number(radius) + " m, got " +
           number(edge));
  if (!(normal.norm() > 0)) refuse("disc: expected a normal that is not zero");
  if (sides < 3) refuse("disc: expected at least 3 sides, got " + std::to_string(sides));
  const Vec3 n = normal.normalized(), u = n.unitOrthogonal(), v = n.cross(u);
  std::vector<Vec3> vertices = {centre};
  std::vector<Triangle> triangles;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    vertices.push_back(centre + (radius - edge) * (std::cos(angle) * u + std::sin(angle) * v));
    triangles.push_back({0, i + 1, (i + 1) % sides + 1});
  }
  return scene.add_solid(vertices, triangles, edge);
}

Vec3 warp_at(const Scene& scene, const Interaction& it, const std::array<std::int32_t, 4>& points,
             std::span<const Vec3> x) {
  const auto& own = scene.surfaces()[std::size_t(it.first)].points;
  const auto warp = [&](std::int32_t t) {
    const auto& corner = scene.triangles()[std::size_t(t)].nodes;
    const auto& [a, b] = it.warp[std::size_t(t)];
    const Vec3& from = x[std::size_t(corner[0])];
    return Vec3(a * (x[std::size_t(corner[1])] - from) + b * (x[std::size_t(corner[2])] - from));
  };
  if (scene.spots().is(points[0])) return warp(scene.spots().triangle_of(points[0]));
  for (const std::int32_t p : points) {
    if (p < 0 || !std::binary_search(own.begin(), own.end(), p)) continue;
    for (const std::int32_t t : scene.triangles_at_point(p))
      if (scene.triangles()[std::size_t(t)].surface == it.first) return warp(t);
  }
  return Vec3::Zero();
}

}  // namespace fabricsh::contact
