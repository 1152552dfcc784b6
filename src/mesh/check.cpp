#include "mesh/check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/box.hpp"
#include "mesh/edges.hpp"
#include "mesh/normals.hpp"

namespace fabricsh::mesh {

namespace {

// --- Connected parts of a mesh, and the elements whose orientation differs from the others.

struct Orientation {
  std::vector<Index> part;      // of each element: its connected part (through shared edges), numbered from 0
  std::vector<char> turned;     // of each element: 1 if oriented against the majority of its part
  std::vector<char> one_sided;  // of each part: no choice of turned makes all neighbours agree
  Index parts() const { return static_cast<Index>(one_sided.size()); }
};

struct Neighbour {
  Index element;
  bool agrees;  // the two elements run through their common edge in opposite directions, as they should
};

std::vector<std::vector<Neighbour>> neighbours(const Mesh& mesh, const std::vector<Edge>& sorted) {
  std::vector<std::vector<Neighbour>> list(mesh.elements.size());
  for_each_edge(sorted, [&list](const Edge* begin, const Edge* end) {
    if (end - begin != 2) return;
    const bool agrees = begin[0].forward != begin[1].forward;
    list[static_cast<std::size_t>(begin[0].element)].push_back({begin[1].element, agrees});
    list[static_cast<std::size_t>(begin[1].element)].push_back({begin[0].element, agrees});
  });
  return list;
}

// All elements connected with the first, each reversed if needed to agree with the one it was reached from.
std::vector<Index> spread(Orientation& result, const std::vector<std::vector<Neighbour>>& near, Index first) {
  std::vector<Index> reached{first};
  const Index part = result.parts();
  result.part[static_cast<std::size_t>(first)] = part;
  result.one_sided.push_back(0);
  for (std::size_t at = 0; at < reached.size(); ++at) {
    const auto e = static_cast<std::size_t>(reached[at]);
    for (const Neighbour& other : near[e]) {
      const auto o = static_cast<std::size_t>(other.element);
      const char turned = static_cast<char>(result.turned[e] ^ (other.agrees ? 0 : 1));
      if (result.part[o] < 0) {
        result.part[o] = part;
        result.turned[o] = turned;
        reached.push_back(other.element);
      } else if (result.turned[o] != turned) {
        result.one_sided.back() = 1;
      }
    }
  }
  return reached;
}

void keep_the_most(Orientation& result, const std::vector<Index>& part) {
  const auto turned = [&result](Index e) { return result.turned[static_cast<std::size_t>(e)] != 0; };
  if (2 * std::count_if(part.begin(), part.end(), turned) <= static_cast<std::ptrdiff_t>(part.size())) return;
  for (const Index e : part) result.turned[static_cast<std::size_t>(e)] ^= 1;
}

void turn(std::array<Index, 4>& element) { std::swap(element[1], element[element[3] < 0 ? 2 : 3]); }

// Twice the area times the normal. For a triangle the last corner is used twice.
Vec3 area_vector(const Mesh& mesh, const std::array<Index, 4>& ids) {
  const auto x = [&](std::size_t i) -> const Vec3& { return mesh.nodes[static_cast<std::size_t>(ids[i])]; };
  return (x(2) - x(0)).cross(x(ids[3] < 0 ? 2 : 3) - x(1));
}

// For each part 1 if its mean normal points against the direction, else 0.
std::vector<char> against(const Mesh& mesh, const Orientation& found, const Vec3& direction) {
  std::vector<Vec3> sum(found.one_sided.size(), Vec3::Zero());
  std::vector<double> size(found.one_sided.size(), 0.0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Vec3 area = area_vector(mesh, mesh.elements[e]);
    sum[static_cast<std::size_t>(found.part[e])] += found.turned[e] != 0 ? Vec3(-area) : area;
    size[static_cast<std::size_t>(found.part[e])] += area.norm();
  }
  std::vector<char> result(sum.size(), 0);
  for (std::size_t p = 0; p < sum.size(); ++p) {
    const double along = sum[p].dot(direction.normalized());
    if (std::abs(along) <= 1e-9 * size[p])
      throw Error("orient: the mean normal of part " + std::to_string(p + 1) +
                  " of the mesh is square to the direction");
    result[p] = along < 0 ? 1 : 0;
  }
  return result;
}

// sorted: edges(mesh). Edges shared by three or more elements do not connect.
Orientation orientation(const Mesh& mesh, const std::vector<Edge>& sorted) {
  const auto near = neighbours(mesh, sorted);
  Orientation result{
      std::vector<Index>(mesh.elements.size(), -1), std::vector<char>(mesh.elements.size(), 0), {}};
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (result.part[e] < 0) keep_the_most(result, spread(result, near, static_cast<Index>(e)));
  return result;
}

// --- Findings.

constexpr double most_aspect = 10, most_warping = 15, least_corner = 20, most_corner = 160,
                 least_taper = 0.25;

std::string shown(double x) { return number(x, 4); }

double degrees(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * (180 / std::numbers::pi);
}

// The geometry of one element.
struct ElementGeometry {
  std::size_t n;
  Vec3 x[4];
  ElementGeometry(const Mesh& mesh, const std::array<Index, 4>& ids) : n(ids[3] < 0 ? 3 : 4) {
    for (std::size_t i = 0; i < n; ++i) x[i] = mesh.nodes[static_cast<std::size_t>(ids[i])];
  }
  Vec3 side(std::size_t i) const { return x[(i + 1) % n] - x[i % n]; }
  // The corner's normal vector; its length is the area of the parallelogram that the corner spans.
  Vec3 corner(std::size_t i) const { return side(i + n - 1).cross(side(i)); }
  Vec3 area() const { return n == 4 ? Vec3(0.5 * (x[2] - x[0]).cross(x[3] - x[1])) : Vec3(0.5 * corner(1)); }
  double shortest() const {
    double length = side(0).norm();
    for (std::size_t i = 1; i < n; ++i) length = std::min(length, side(i).norm());
    return length;
  }
  double longest() const {
    double length = 0;
    for (std::size_t i = 0; i < n; ++i) length = std::max(length, side(i).norm());
    return length;
  }
  // Angle between the two triangles on either side of a diagonal, for the diagonal where it is larger.
  double warping() const {
    return n == 3 ? 0 : std::max(degrees(corner(0), corner(2)), degrees(corner(1), corner(3)));
  }
  double least_angle() const {
    double least = 180;
    for (std::size_t i = 0; i < n; ++i) least = std::min(least, degrees(side(i), -side(i + n - 1)));
    return least;
  }
  double largest_angle() const {
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, degrees(side(i), -side(i + n - 1)));
    return largest;
  }
  // The area that the narrowest corner spans over that of the widest: 1 for triangles and parallelograms.
  double taper() const {
    double least = corner(0).norm(), most = least;
    for (std::size_t i = 1; i < n; ++i) {
      least = std::min(least, corner(i).norm());
      most = std::max(most, corner(i).norm());
    }
    return n == 3 ? 1 : least / most;
  }
  bool inverted() const {
    for (std::size_t i = 0; i < n; ++i)
      if (corner(i).dot(area()) <= 0) return true;
    return false;
  }
};

// Whether x lies on the segment from a to b, away from its ends.
bool lies_between(const Vec3& x, const Vec3& a, const Vec3& b) {
  constexpr double near = 1e-6, end = 1e-3;  // of its length
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm(), fraction = (x - a).dot(along) / length2;
  return fraction > end && fraction < 1 - end &&
         (x - a - fraction * along).squaredNorm() < near * near * length2;
}

// Calls take(node, before) for each node nearer than `near` to one before it. Cells have twice that width, so
// that a near node lies in one of the eight cells around the nearest corner of its cell.
template <class Take>
void for_each_double(const Mesh& mesh, double near, const Take& take) {
  if (mesh.nodes.empty() || near == 0) return;
  const BoundingBox all = box_of(mesh.nodes);
  using Cell = std::array<std::int64_t, 3>;
  const auto hash = [](const Cell& b) {
    return static_cast<std::size_t>(b[0]) * 73856093u ^ static_cast<std::size_t>(b[1]) * 19349663u ^
           static_cast<std::size_t>(b[2]) * 83492791u;
  };
  std::unordered_map<Cell, Index, decltype(hash)> cells(mesh.nodes.size(), hash);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Vec3 place = (mesh.nodes[i] - all.low) / (2 * near);
    bool found = false;
    for (int corner = 0; corner < 8 && !found; ++corner) {
      Cell cell;
      for (std::size_t k = 0; k < 3; ++k)
        cell[k] = static_cast<std::int64_t>(
            std::floor(place[static_cast<int>(k)] + ((corner >> k & 1) != 0 ? 0.5 : -0.5)));
      const auto at = cells.find(cell);
      found = at != cells.end() &&
              (mesh.nodes[static_cast<std::size_t>(at->second)] - mesh.nodes[i]).norm() <= near;
      if (found) take(static_cast<Index>(i), at->second);
    }
    const Cell own{static_cast<std::int64_t>(std::floor(place[0])),
                   static_cast<std::int64_t>(std::floor(place[1])),
                   static_cast<std::int64_t>(std::floor(place[2]))};
    cells.emplace(own, static_cast<Index>(i));
  }
}

class Checker {
 public:
  explicit Checker(const Mesh& mesh) : mesh_(mesh), edges_(edges(mesh)) { report_.mesh = mesh.origin; }

  Report run() {
    shapes();
    repeated();
    sides();
    folds();
    shared_edges();
    unused();
    duplicates();
    std::stable_sort(report_.items.begin(), report_.items.end(),
                     [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
    return std::move(report_);
  }

 private:
  void add(const char* key, Severity severity, std::string text, std::vector<Index> elements,
           std::vector<Index> nodes = {}) {
    report_.items.push_back({key, severity, std::move(text), std::move(elements), std::move(nodes)});
  }
  void add_elements(const char* key, Severity severity, const std::vector<Index>& ids,
                    const std::string& text) {
    if (!ids.empty()) add(key, severity, listed("element", ids) + ": " + text, ids);
  }

  bool degenerate(const ElementGeometry& shape, const std::array<Index, 4>& ids) const {
    for (std::size_t i = 0; i < shape.n; ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (ids[i] == ids[k]) return true;
    const double longest = shape.longest();
    return shape.shortest() <= 1e-12 * longest || shape.area().norm() <= 1e-12 * longest * longest;
  }

  void shapes() {
    Measures& m = report_.measures;
    m.shortest = std::numeric_limits<double>::infinity();
    m.least_angle = 180;
    std::vector<Index> degenerates, inverted, long_ones, warped, sharp, blunt, tapered;
    double widest = 0, narrowest = 1;  // degrees; fraction
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      const auto id = static_cast<Index>(e);
      const ElementGeometry shape(mesh_, mesh_.elements[e]);
      ++(shape.n == 3 ? m.triangles : m.quadrilaterals);
      m.area += shape.area().norm();
      m.shortest = std::min(m.shortest, shape.shortest());
      m.longest = std::max(m.longest, shape.longest());
      if (degenerate(shape, mesh_.elements[e])) {
        degenerates.push_back(id);
        continue;
      }
      if (shape.inverted()) inverted.push_back(id);
      const double aspect = shape.longest() / shape.shortest(), warping = shape.warping(),
                   least = shape.least_angle();
      if (aspect > most_aspect) long_ones.push_back(id);
      if (warping > most_warping && !shape.inverted()) warped.push_back(id);
      if (least < least_corner) sharp.push_back(id);
      if (!shape.inverted()) {
        const double corner = shape.largest_angle(), taper = shape.taper();
        if (shape.n == 4 && corner > most_corner) blunt.push_back(id);
        if (taper < least_taper) tapered.push_back(id);
        if (shape.n == 4) widest = std::max(widest, corner);
        narrowest = std::min(narrowest, taper);
      }
      m.aspect = std::max(m.aspect, aspect);
      m.warping = std::max(m.warping, warping);
      m.least_angle = std::min(m.least_angle, least);
    }
    add_elements("degenerate", Severity::error, degenerates,
                 "no area, an edge without length, or a node twice");
    add_elements(
        "inverted", Severity::error, inverted,
        "a corner turns the other way (nodes in the wrong order, or a corner of 180 degrees and more)");
    add_elements("aspect", Severity::warning, long_ones,
                 "the longest side is up to " + shown(m.aspect) + " times the shortest");
    add_elements(
        "warping", Severity::warning, warped,
        "out of plane, the halves of the quadrilateral meet at up to " + shown(m.warping) + " degrees");
    add_elements("angle", Severity::warning, sharp, "corners down to " + shown(m.least_angle) + " degrees");
    add_elements("wide", Severity::warning, blunt,
                 "corners of quadrilaterals up to " + shown(widest) +
                     " degrees, almost a straight line: strains there have no meaning (move the node, or two "
                     "triangles)");
    add_elements("taper", Severity::warning, tapered,
                 "the narrowest corner spans down to " + shown(narrowest) +
                     " of the area of the widest: strains differ much over the quadrilateral, its fields are "
                     "their means");
  }

  // The directors of a shell are the normals at its nodes, each the mean of its elements'. At a sharp fold
  // there is none, or it points against an element.
  void folds() {
    const std::vector<Vec3> normals = node_normals(mesh_);
    std::vector<char> used(mesh_.nodes.size(), 0);
    std::vector<Index> elements, nodes;
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      const auto& ids = mesh_.elements[e];
      for (const Index id : ids)
        if (id >= 0) used[static_cast<std::size_t>(id)] = 1;
      const ElementGeometry shape(mesh_, ids);
      if (!degenerate(shape, ids) && !shape.inverted() && !spans_volume(mesh_, ids, normals))
        elements.push_back(static_cast<Index>(e));
    }
    for (std::size_t i = 0; i < used.size(); ++i)
      if (used[i] == 1 && normals[i].norm() == 0) nodes.push_back(static_cast<Index>(i));
    if (elements.empty() && nodes.empty()) return;
    std::string text =
        elements.empty() ? "" : listed("element", elements) + ": against the mean normal at its nodes";
    if (!nodes.empty())
      text += (text.empty() ? "" : "; ") + listed("node", nodes) + ": no normal, its elements cancel";
    add("fold", Severity::error,
        text +
            " (a fold of more than 90 degrees: round it off by a few elements, or give its sides nodes of "
            "their own and join them by a tie)",
        std::move(elements), std::move(nodes));
  }

  void repeated() {
    add_elements("repeated", Severity::error, repeated_elements(mesh_),
                 "on the same nodes as an element before");
  }

  void sides() {
    const Orientation found = orientation(mesh_, edges_);
    report_.measures.parts = found.parts();
    std::vector<Index> turned, one_sided;
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      const bool moebius = found.one_sided[static_cast<std::size_t>(found.part[e])] != 0;
      if (moebius) one_sided.push_back(static_cast<Index>(e));
      if (!moebius && found.turned[e] != 0) turned.push_back(static_cast<Index>(e));
    }
    add_elements("orientation", Severity::error, turned,
                 "normal against that of the neighbours (mesh:orient() turns it)");
    add_elements("one_sided", Severity::error, one_sided,
                 "in a strip with one side only, no orientation exists");
  }

  void shared_edges() {
    std::vector<Edge> free;
    std::vector<Index> elements, nodes;
    Index count = 0;
    for_each_edge(edges_, [&](const Edge* begin, const Edge* end) {
      if (end - begin == 1) free.push_back(*begin);
      if (end - begin < 3) return;
      ++count;
      nodes.insert(nodes.end(), {begin->first, begin->second});
      for (const Edge* edge = begin; edge != end; ++edge) elements.push_back(edge->element);
    });
    for (auto* list : {&elements, &nodes}) {
      std::sort(list->begin(), list->end());
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    if (count > 0) {
      std::string text = listed("element", elements) + ": three or more of them meet at an edge, " +
                         std::to_string(count) + (count == 1 ? " edge" : " edges") + " in all";
      add("nonmanifold", Severity::warning, std::move(text), std::move(elements), std::move(nodes));
    }
    free_edges(free);
  }

  // Border lines are the connected pieces of the free edges.
  void free_edges(const std::vector<Edge>& free) {
    if (free.empty()) return;
    std::unordered_map<Index, Index> leader;
    const auto lead = [&leader](Index node) {
      leader.emplace(node, node);
      while (leader[node] != node) node = leader[node] = leader[leader[node]];
      return node;
    };
    for (const Edge& edge : free) leader[lead(edge.first)] = lead(edge.second);
    NodeSet nodes;
    Index borders = 0;
    for (const auto& [node, above] : leader) {
      nodes.push_back(node);
      borders += node == above ? 1 : 0;
    }
    std::sort(nodes.begin(), nodes.end());
    report_.measures.borders = borders;
    hanging(free, nodes);
    add("free", Severity::note,
        std::to_string(free.size()) + " free edges in " + std::to_string(borders) +
            (borders == 1 ? " border line" : " border lines"),
        {}, std::move(nodes));
  }

  // Nodes of the border on an edge of the border that does not end there: the edge opens beside them.
  void hanging(const std::vector<Edge>& free, const NodeSet& border) {
    const Vec3 size = box_of(mesh_.nodes).size();
    Eigen::Index axis = 0;
    size.maxCoeff(&axis);
    const auto x = [&](Index n) -> const Vec3& { return mesh_.nodes[static_cast<std::size_t>(n)]; };
    NodeSet sorted = border;
    std::sort(sorted.begin(), sorted.end(), [&](Index a, Index b) { return x(a)[axis] < x(b)[axis]; });
    std::vector<Index> elements, nodes;
    for (const Edge& edge : free) {
      const Vec3 &a = x(edge.first), &b = x(edge.second);
      const double low = std::min(a[axis], b[axis]), high = std::max(a[axis], b[axis]),
                   near = 1e-6 * (b - a).norm();
      auto at = std::lower_bound(sorted.begin(), sorted.end(), low - near,
                                 [&](Index n, double value) { return x(n)[axis] < value; });
      for (; at != sorted.end() && x(*at)[axis] <= high + near; ++at) {
        if (!lies_between(x(*at), a, b)) continue;
        nodes.push_back(*at);
        elements.push_back(edge.element);
      }
    }
    for (auto* list : {&elements, &nodes}) {
      std::sort(list->begin(), list->end());
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    if (nodes.empty()) return;
    std::string text =
        listed("node", nodes) + ": on the side of an element that has no node there, and not joined to it";
    add("hanging", Severity::warning, std::move(text), std::move(elements), std::move(nodes));
  }

  void unused() {
    std::vector<char> used(mesh_.nodes.size(), 0);
    for (const auto& ids : mesh_.elements)
      for (const Index id : ids)
        if (id >= 0) used[static_cast<std::size_t>(id)] = 1;
    std::vector<Index> nodes;
    for (std::size_t i = 0; i < used.size(); ++i)
      if (used[i] == 0) nodes.push_back(static_cast<Index>(i));
    if (!nodes.empty()) add("unused", Severity::error, listed("node", nodes) + ": in no element", {}, nodes);
  }

  void duplicates() {
    std::vector<Index> nodes;
    for_each_double(mesh_, one_place * box_of(mesh_.nodes).size().norm(),
                    [&nodes](Index node, Index) { nodes.push_back(node); });
    if (!nodes.empty())
      add("duplicate", Severity::warning,
          listed("node", nodes) + ": at the place of a node before, and not joined to it", {}, nodes);
    if (report_.measures.parts - mesh_.slit_parts < 2) return;
    nodes = meeting(mesh_, parts_of_nodes(mesh_));
    if (!nodes.empty())
      add("apart", Severity::error, words_of_parts(mesh_, report_.measures.parts, nodes), {}, nodes);
  }

  const Mesh& mesh_;
  std::vector<Edge> edges_;
  Report report_;
};

// A mesh that merge() made: its origin begins with its first part.
bool is_merged(const Mesh& mesh) { return mesh.origin.starts_with("1 (") && mesh.parts.empty(); }

}  // namespace

std::string listed(const char* noun, const std::vector<Index>& ids) {
  std::string text = std::string(noun) + (ids.size() > 1 ? "s " : " ");
  for (std::size_t i = 0; i < std::min<std::size_t>(ids.size(), 5); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(ids[i] + 1);
  return ids.size() > 5 ? text + " and " + std::to_string(ids.size() - 5) + " more" : text;
}

bool of_file(const Mesh& mesh) { return mesh.origin.starts_with("file ") && mesh.parts.empty(); }

std::vector<Index> parts_of_nodes(const Mesh& mesh) {
  const Orientation found = orientation(mesh, edges(mesh));
  std::vector<Index> part(mesh.nodes.size(), -1);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const Index id : mesh.elements[e])
      if (id >= 0) part[static_cast<std::size_t>(id)] = found.part[e];
  return part;
}

NodeSet meeting(const Mesh& mesh, const std::vector<Index>& part) {
  constexpr double near_misses = 1e-3;  // of the mean side: what merge() was not told to join
  double near = one_place * box_of(mesh.nodes).size().norm();
  if (is_merged(mesh)) {
    double sides = 0;
    const auto all = edges(mesh);
    for (const Edge& edge : all)
      sides += (mesh.nodes[static_cast<std::size_t>(edge.second)] -
                mesh.nodes[static_cast<std::size_t>(edge.first)])
                   .norm();
    near = std::max(near, near_misses * sides / static_cast<double>(all.size()));
  }
  NodeSet nodes;
  for_each_double(mesh, near, [&](Index node, Index before) {
    if (part[static_cast<std::size_t>(node)] != part[static_cast<std::size_t>(before)]) nodes.push_back(node);
  });
  return nodes;
}

std::string words_of_parts(const Mesh& mesh, Index parts, const NodeSet& meeting) {
  const std::string apart = "the sheet is in " + std::to_string(parts) + " parts that are not connected";
  if (meeting.empty()) return apart + "; seams and ties connect them";
  const Vec3& x = mesh.nodes[static_cast<std::size_t>(meeting.front())];
  return apart + ", though they share places (" + listed("node", meeting) + ", the first at {" + shown(x[0]) +
         ", " + shown(x[1]) + ", " + shown(x[2]) + "} m): " +
         (is_merged(mesh) ? "fabric.mesh.merge{ meshes=..., distance= } makes one node of those of different "
                            "meshes within the distance"
                          : std::string(of_file(mesh) ? "fabric.mesh.read{ file=..., join=true }"
                                                      : "fabric.mesh{ nodes=..., elements=..., join=true }") +
                                " makes one node of those at one place");
}

std::vector<Index> repeated_elements(const Mesh& mesh) {
  std::vector<std::pair<std::array<Index, 4>, Index>> keys;
  keys.reserve(mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    auto ids = mesh.elements[e];
    std::sort(ids.begin(), ids.end());
    keys.emplace_back(ids, static_cast<Index>(e));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Index> found;
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (keys[i].first == keys[i - 1].first) found.push_back(keys[i].second);
  std::sort(found.begin(), found.end());
  return found;
}

std::string doubt_about_units(const Mesh& mesh) {
  constexpr double most = 10, least = 1e-4;  // m
  const double extent = box_of(mesh.nodes).size().maxCoeff();
  if (extent > least && extent < most) return {};
  return "the mesh spans " + number(extent, 3) + " m, far from what cloth is: are its lengths in m?";
}

bool Report::ok() const {
  return std::none_of(items.begin(), items.end(),
                      [](const Finding& f) { return f.severity == Severity::error; });
}

const Finding* Report::find(const std::string& key) const {
  for (const Finding& item : items)
    if (item.key == key) return &item;
  return nullptr;
}

std::string Report::text() const {
  const Measures& m = measures;
  std::string text = mesh + ": " + std::to_string(m.quadrilaterals) + " quadrilaterals, " +
                     std::to_string(m.triangles) + " triangles, " + std::to_string(m.parts) +
                     (m.parts == 1 ? " part" : " parts") + ", area " + shown(m.area) + " m2\nedges " +
                     shown(m.shortest) + " to " + shown(m.longest) + " m, aspect up to " + shown(m.aspect) +
                     ", corners from " + shown(m.least_angle) + " degrees, warping up to " +
                     shown(m.warping) + " degrees\n";
  for (const Finding& item : items) text += std::string(name(item.severity)) + ": " + item.text + "\n";
  return text;
}

Report check(const Mesh& mesh) { return Checker(mesh).run(); }

Index orient(Mesh& mesh, const Vec3& direction) {
  check_unused(mesh, "orient");
  const Orientation found = orientation(mesh, edges(mesh));
  const auto one_sided = std::find(found.one_sided.begin(), found.one_sided.end(), 1);
  if (one_sided != found.one_sided.end())
    throw Error("orient: part " + std::to_string(one_sided - found.one_sided.begin() + 1) +
                " of the mesh has one side only (a Moebius strip), no orientation exists");
  std::vector<char> over(found.one_sided.size(), 0);
  if (direction != Vec3::Zero()) over = against(mesh, found, direction);
  Index count = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (found.turned[e] != over[static_cast<std::size_t>(found.part[e])]) {
      turn(mesh.elements[e]);
      ++count;
    }
  return count;
}

}  // namespace fabricsh::mesh
