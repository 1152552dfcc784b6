#include "mechanics/mesh_tools.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "base/error.hpp"
#include "mesh/normals.hpp"

namespace fabricsh::mechanics {

std::vector<Vec3> reference_directors(const mesh::Mesh& mesh) {
  std::vector<Vec3> normals = mesh::node_normals(mesh);
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (!(normals[i].norm() > 0))
      throw Error("mesh: node " + std::to_string(i + 1) +
                  " has no normal: its elements are degenerate, or fold onto each other (mesh:check() names "
                  "all such nodes)");
  return normals;
}

std::vector<int> colour(const mesh::Mesh& given) {
  const mesh::Mesh& mesh = given.uncut();                  // nodes at one place can have unknowns in common
  std::vector<std::uint64_t> taken(mesh.nodes.size(), 0);  // bit c: an element of colour c has this node
  std::vector<int> colours;
  for (const auto& e : mesh.elements) {
    std::uint64_t used = 0;
    for (const auto n : e)
      if (n >= 0) used |= taken[n];
    int c = 0;
    while (c < 63 && (used >> c & 1) != 0) ++c;
    if (c == 63) throw Error("mesh: more than 62 elements meet at one node");
    for (const auto n : e)
      if (n >= 0) taken[n] |= std::uint64_t{1} << c;
    colours.push_back(c);
  }
  return colours;
}

int corners(const std::array<Index, 4>& element) { return element[3] < 0 ? 3 : 4; }

double area(const std::array<Index, 4>& e, std::span<const Vec3> X) {
  if (corners(e) == 3) return (X[e[1]] - X[e[0]]).cross(X[e[2]] - X[e[0]]).norm() / 2;
  return (X[e[2]] - X[e[0]]).cross(X[e[3]] - X[e[1]]).norm() / 2;
}

double size(const std::array<Index, 4>& e, std::span<const Vec3> X) {
  const int n = corners(e);
  double longest = 0;
  for (int c = 0; c < n; ++c) longest = std::max(longest, (X[e[(c + 1) % n]] - X[e[c]]).norm());
  return (n == 3 ? 2 : 1) * area(e, X) / longest;
}

namespace {

// How many nodes a place has, and how many edges two places have between them: in tearable zones several.
class Alike {
 public:
  explicit Alike(const mesh::Mesh& mesh) : mesh_(mesh) {
    if (!mesh.whole) return;
    for (const auto place : mesh.place) ++nodes_[place];
    std::set<std::pair<mesh::Index, mesh::Index>> seen;
    for (const auto& e : mesh.elements)
      for (int a = 0, n = corners(e); a < n; ++a)
        if (seen.insert(std::minmax({e[a], e[(a + 1) % n]})).second)
          ++edges_[of_places(e[a], e[(a + 1) % n])];
  }
  double nodes(mesh::Index n) const { return mesh_.whole ? nodes_.at(mesh_.place_of(n)) : 1; }
  double edges(mesh::Index i, mesh::Index j) const { return mesh_.whole ? edges_.at(of_places(i, j)) : 1; }

 private:
  std::pair<mesh::Index, mesh::Index> of_places(mesh::Index i, mesh::Index j) const {
    return std::minmax({mesh_.place_of(i), mesh_.place_of(j)});
  }
  const mesh::Mesh& mesh_;
  std::map<mesh::Index, int> nodes_;
  std::map<std::pair<mesh::Index, mesh::Index>, int> edges_;
};

}  // namespace

Tributary tributary(const mesh::Mesh& mesh, const mesh::NodeSet& nodes) {
  std::map<mesh::Index, std::size_t> where;
  for (std::size_t i = 0; i < nodes.size(); ++i) where[nodes[i]] = i;
  std::vector<double> by_area(nodes.size(), 0.0), by_length(nodes.size(), 0.0);
  bool has_area = false, has_edges = false;
  std::map<std::pair<mesh::Index, mesh::Index>, bool> seen;
  const Alike alike(mesh);
  for (const auto& e : mesh.elements) {
    const int n = e[3] < 0 ? 3 : 4;
    if (std::all_of(e.begin(), e.begin() + n, [&](mesh::Index i) { return where.contains(i); })) {
      has_area = true;
      const Vec3 area =
          n == 3 ? (mesh.nodes[e[1]] - mesh.nodes[e[0]]).cross(mesh.nodes[e[2]] - mesh.nodes[e[0]])
                 : (mesh.nodes[e[2]] - mesh.nodes[e[0]]).cross(mesh.nodes[e[3]] - mesh.nodes[e[1]]);
      for (int a = 0; a < n; ++a) by_area[where[e[a]]] += area.norm() / 2 / n;
    }
    for (int a = 0; a < n; ++a) {
      const auto [i, j] = std::minmax(e[a], e[(a + 1) % n]);
      if (!where.contains(i) || !where.contains(j) || seen[{i, j}]) continue;
      seen[{i, j}] = has_edges = true;
      const double length = (mesh.nodes[i] - mesh.nodes[j]).norm() / alike.edges(i, j);
      by_length[where[i]] += length;
      by_length[where[j]] += length;
    }
  }
  Tributary t;
  if (has_area) {
    t.measure = std::move(by_area);
  } else if (has_edges) {
    t.measure = std::move(by_length);
    for (double& length : t.measure) length /= 2;
  } else {
    for (const auto n : nodes) t.measure.push_back(1.0 / alike.nodes(n));
  }
  t.total = std::accumulate(t.measure.begin(), t.measure.end(), 0.0);
  t.kind = has_area    ? Tributary::MeasureKind::area
           : has_edges ? Tributary::MeasureKind::length
                       : Tributary::MeasureKind::count;
  return t;
}

}  // namespace fabricsh::mechanics
