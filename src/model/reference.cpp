#include "model/reference.hpp"

#include <algorithm>
#include <map>
#include <numbers>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/box.hpp"
#include "mesh/edges.hpp"
#include "model/model.hpp"
#include "model/rest_mesh.hpp"

namespace fabricsh::model {

namespace {

using Edge = std::pair<Index, Index>;

// With the number of elements of each.
std::map<Edge, int> edges_between(const mesh::Mesh& mesh, const std::vector<bool>& on) {
  std::map<Edge, int> edges;
  for (const auto& e : mesh.elements)
    for (int a = 0, n = e[3] < 0 ? 3 : 4; a < n; ++a) {
      const Index i = e[static_cast<std::size_t>(a)], j = e[static_cast<std::size_t>((a + 1) % n)];
      if (on[static_cast<std::size_t>(i)] && on[static_cast<std::size_t>(j)]) ++edges[std::minmax(i, j)];
    }
  return edges;
}

// m, from a place to a line of straight pieces.
double distance(const Vec3& x, const std::vector<Vec3>& line) {
  double least = (x - line.front()).norm();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec3 way = line[i + 1] - line[i];
    const double share = std::clamp(way.dot(x - line[i]) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (x - line[i] - share * way).norm());
  }
  return least;
}

std::string place_text(const Vec3& x) {
  return "(" + number(x.x()) + ", " + number(x.y()) + ", " + number(x.z()) + ") m";
}

}  // namespace

std::string rest_text(const ReferenceGiven& given) {
  std::string text;
  if (given.mesh) text += "free of stress as " + given.mesh->origin + "; ";
  if (given.rest != Rest::own)
    text += "rests " + std::string(rest_words[static_cast<int>(given.rest)]) + "; ";
  if (given.prestress)
    text += "prestress " + number((*given.prestress)[0]) + " N/m in warp, " + number((*given.prestress)[1]) +
            " N/m in weft; ";
  return text;
}

void check_reference(const std::string& of, const mesh::Mesh& mesh, const mesh::Mesh& reference) {
  const std::string expected = "model: " + of + "field 'reference': expected the elements of the mesh, " +
                               std::to_string(mesh.elements.size()) + " on " +
                               std::to_string(mesh.nodes.size()) + " nodes, in another shape; got ";
  if (reference.elements.size() != mesh.elements.size() || reference.nodes.size() != mesh.nodes.size())
    throw Error(expected + std::to_string(reference.elements.size()) + " on " +
                std::to_string(reference.nodes.size()));
  const auto differ = std::mismatch(mesh.elements.begin(), mesh.elements.end(), reference.elements.begin());
  if (differ.first != mesh.elements.end())
    throw Error(expected + "element " + std::to_string(differ.first - mesh.elements.begin() + 1) +
                " on other nodes");
}

std::vector<CreaseEdge> edges_of(const Model& model, const CreaseGiven& crease) {
  constexpr double near = 1e-3;  // of the edge, by which nodes may lie beside the line
  const mesh::Mesh& mesh = model.mesh().uncut();
  std::vector<bool> on(mesh.nodes.size(), crease.set.empty());
  if (!crease.set.empty())
    for (const Index n : mesh.set(crease.set)) on[static_cast<std::size_t>(n)] = true;
  std::vector<CreaseEdge> found;
  std::map<Index, int> count;
  for (const auto& [edge, elements] : edges_between(mesh, on)) {
    const auto [i, j] = edge;
    const Vec3 &a = model.rest_node(i), &b = model.rest_node(j);
    const double tolerance = near * (b - a).norm();
    if (!crease.line.empty() && std::max({distance(a, crease.line), distance(b, crease.line),
                                          distance((a + b) / 2, crease.line)}) > tolerance)
      continue;
    if (elements < 2)
      throw Error("crease: the edge between nodes " + std::to_string(i + 1) + " and " +
                  std::to_string(j + 1) + " is one of the boundary: expected edges with cloth on both sides");
    found.push_back({i, j, crease.angle * std::numbers::pi / 180, crease.stiffness});
    for (const Index n : {i, j})
      if (++count[n] > 2)
        throw Error("crease: " + (crease.set.empty() ? "the line" : "set '" + crease.set + "'") +
                    ": expected edges in one line, got three at node " + std::to_string(n + 1) + " at " +
                    place_text(model.rest_node(n)));
  }
  if (found.empty())
    throw Error("crease: " +
                (crease.set.empty()
                     ? "no edge of the mesh lies on the line from " + place_text(crease.line.front()) +
                           " to " + place_text(crease.line.back()) +
                           ": expected a line along edges of the stress-free shape"
                     : "set '" + crease.set + "': expected nodes along edges of the mesh, got " +
                           std::to_string(mesh.set(crease.set).size()) + " without an edge"));
  return found;
}

std::vector<CreaseEdge> crease_edges(const Model& model) {
  std::vector<CreaseEdge> all;
  std::map<Index, int> count, plain;  // of the edges at a place, and of those that are no hinges
  std::map<Edge, int> seen;
  for (const CreaseGiven& crease : model.all<CreaseGiven>())
    for (const CreaseEdge& edge : edges_of(model, crease)) {
      if (++seen[{edge.from, edge.to}] > 1)
        throw Error("crease: the edge between nodes " + std::to_string(edge.from + 1) + " and " +
                    std::to_string(edge.to + 1) + " is in two creases: expected one angle");
      for (const Index n : {edge.from, edge.to}) {
        plain[n] += edge.stiffness ? 0 : 1;
        if (++count[n] > 2 && plain[n] > 0)
          throw Error("crease: creases meet at node " + std::to_string(n + 1) + " at " +
                      place_text(model.rest_node(n)) +
                      ": expected creases that do not cross, or that all have a 'stiffness', since without "
                      "it a node has one director");
      }
      all.push_back(edge);
    }
  return all;
}

std::vector<std::pair<Index, Index>> hinge_edges(const Model& model) {
  std::vector<std::pair<Index, Index>> hinges;
  for (const CreaseEdge& edge : crease_edges(model))
    if (edge.stiffness) hinges.emplace_back(edge.from, edge.to);
  return hinges;
}

namespace {

[[noreturn]] void refuse_hinge(const std::string& why) {
  throw Error("crease: field 'stiffness': expected a model " + why);
}

}  // namespace

void check_hinges(const Model& model) {
  const auto hinges = hinge_edges(model);
  if (hinges.empty()) return;
  if (model.membrane()) refuse_hinge("whose cloth bends, got a membrane");
  if (!model.all<Zone>().empty()) refuse_hinge("without tearable zones");
  const mesh::Mesh& mesh = model.mesh().uncut();
  std::map<Index, bool> at;
  std::map<Edge, bool> sides;
  for (const auto& edge : hinges) {
    sides[edge] = true;
    at[edge.first] = at[edge.second] = true;
  }
  const auto check = [&](const std::string& set, const std::string& what) {
    for (const Index n : mesh.set(set))
      if (at.contains(n))
        refuse_hinge("whose hinges stay away from " + what + ", got node " + std::to_string(n + 1) + " at " +
                     place_text(model.rest_node(n)) + " of set '" + set + "'");
  };
  for (const auto& seam : model.all<Seam>())
    for (const std::string& set : {seam.first, seam.second}) check(set, "seams");
  for (const auto& tie : model.all<Tie>())
    if (tie.kind == TieKind::periodic)
      for (const std::string& set : {tie.set, tie.partner}) check(set, "periodic ties");
  mesh::for_each_edge(mesh::edges(mesh), [&](const mesh::Edge* begin, const mesh::Edge* end) {
    if (!sides.contains({begin->first, begin->second})) return;
    if (end - begin != 2 || begin[0].forward == begin[1].forward)
      refuse_hinge("whose hinges have two sides with normals on one side of the sheet, got " +
                   std::to_string(end - begin) + " elements at the edge between nodes " +
                   std::to_string(begin->first + 1) + " and " + std::to_string(begin->second + 1));
  });
}

mesh::Mesh rest_mesh(const Model& model) {
  mesh::Mesh mesh = model.mesh().uncut();
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) mesh.nodes[n] = model.rest_node(static_cast<Index>(n));
  return mesh;
}

bool Model::has_rest() const {
  return !all<CreaseGiven>().empty() ||
         std::any_of(bodies().begin(), bodies().end(), [](const auto& body) { return body.reference.any(); });
}

}  // namespace fabricsh::model
