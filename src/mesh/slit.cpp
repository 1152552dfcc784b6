#include <algorithm>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/check.hpp"
#include "mesh/edges.hpp"
#include "mesh/generators.hpp"

namespace fabricsh::mesh {

namespace {

constexpr double kOnLine = 0.01;  // of an edge's length: how far from the line its ends may be

std::string point_text(const Vec3& p) {
  return "(" + number(p.x()) + ", " + number(p.y()) + ", " + number(p.z()) + ")";
}

// An edge on the line, from the end nearer to the start of the slit; s: shares of the way there and beyond.
struct Cut {
  Index a, b, left, right;  // nodes; elements
  double from, to;
};

// The edges on the line, sorted by their places along it.
std::vector<Cut> edges_on(const Mesh& mesh, const Vec3& start, const Vec3& way) {
  std::vector<Cut> found;
  const auto share = [&](Index n) {
    return (mesh.nodes[static_cast<std::size_t>(n)] - start).dot(way) / way.squaredNorm();
  };
  const auto off = [&](Index n) {
    const double s = std::clamp(share(n), 0.0, 1.0);
    return (mesh.nodes[static_cast<std::size_t>(n)] - start - s * way).norm();
  };
  for_each_edge(edges(mesh), [&](const Edge* begin, const Edge* end) {
    const Vec3 along = mesh.nodes[static_cast<std::size_t>(begin->second)] -
                       mesh.nodes[static_cast<std::size_t>(begin->first)];
    const double near = kOnLine * along.norm();
    if (off(begin->first) > near || off(begin->second) > near) return;
    const bool ahead = along.dot(way) > 0;
    Cut cut{begin->first, begin->second, -1, -1, 0, 0};
    if (!ahead) std::swap(cut.a, cut.b);
    for (const Edge* e = begin; e != end; ++e) (e->forward == ahead ? cut.left : cut.right) = e->element;
    cut.from = share(cut.a);
    cut.to = share(cut.b);
    found.push_back(cut);
  });
  std::sort(found.begin(), found.end(), [](const Cut& a, const Cut& b) { return a.from < b.from; });
  return found;
}

// The edges must cover the line without a gap, each between two elements.
void check_line(const std::vector<Cut>& line, const Vec3& from, const Vec3& to) {
  const auto refuse = [&](double share, const std::string& why) {
    throw Error("slit: the line from " + point_text(from) + " to " + point_text(to) + " m " + why + " at " +
                point_text(from + share * (to - from)) + " m: expected a line of edges between nodes");
  };
  if (line.empty()) refuse(0, "has no edge");
  double reached = 0;
  for (const Cut& cut : line) {
    const double near = kOnLine * (cut.to - cut.from);
    if (std::abs(cut.from - reached) > near) refuse(reached, "leaves the edges");
    if (cut.left < 0 || cut.right < 0) refuse(cut.from, "follows a free edge");
    reached = cut.to;
  }
  if (std::abs(reached - 1) > kOnLine * (line.back().to - line.back().from))
    refuse(reached, "leaves the edges");
}

// Of each node of the line: the elements around it, and the ends of the cut edges there.
using Around = std::map<Index, std::vector<Index>>;

Around around(const Mesh& mesh, const std::vector<Cut>& line) {
  Around elements;
  for (const Cut& cut : line) elements[cut.a], elements[cut.b];
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const Index n : mesh.elements[e])
      if (const auto at = elements.find(n); n >= 0 && at != elements.end())
        at->second.push_back(static_cast<Index>(e));
  return elements;
}

// Of the elements around a node those that are connected with one of them by edges that stay.
std::set<Index> connected(const Mesh& mesh, Index node, const std::vector<Index>& elements, Index with,
                          const std::set<Index>& cut_to) {
  const auto stays = [&](Index e, Index f) {
    const auto &a = mesh.elements[static_cast<std::size_t>(e)],
               &b = mesh.elements[static_cast<std::size_t>(f)];
    return std::any_of(a.begin(), a.end(), [&](Index n) {
      return n >= 0 && n != node && !cut_to.contains(n) && std::find(b.begin(), b.end(), n) != b.end();
    });
  };
  std::set<Index> side{with};
  for (bool grows = true; grows;) {
    grows = false;
    for (const Index e : elements)
      if (!side.contains(e) && std::any_of(side.begin(), side.end(), [&](Index f) { return stays(e, f); }))
        grows = side.insert(e).second;
  }
  return side;
}

void follow_sets(Mesh& mesh, const std::map<Index, Index>& twin) {
  for (auto& [name, ids] : mesh.sets)
    for (const auto& [node, added] : twin)
      if (added != node && std::binary_search(ids.begin(), ids.end(), node)) ids.push_back(added);
  for (auto& [name, ids] : mesh.sets) std::sort(ids.begin(), ids.end());
}

// Doubles the nodes of the line at which its two sides come apart. Returns each node with the one that the
// right side has then.
std::map<Index, Index> divide(Mesh& mesh, const std::vector<Cut>& line) {
  std::map<Index, std::set<Index>> cut_to;
  std::map<Index, Cut> at;
  for (const Cut& cut : line)
    for (const auto& [node, other] : {std::pair{cut.a, cut.b}, std::pair{cut.b, cut.a}}) {
      cut_to[node].insert(other);
      at.emplace(node, cut);
    }
  const Mesh before = mesh;  // by whose numbers the edges are known
  std::map<Index, Index> twin;
  for (const auto& [node, elements] : around(before, line)) {
    const Cut& cut = at.at(node);
    const std::set<Index> right = connected(before, node, elements, cut.right, cut_to.at(node));
    twin[node] = right.contains(cut.left) ? node : static_cast<Index>(mesh.nodes.size());
    if (twin[node] == node) continue;
    mesh.nodes.push_back(before.nodes[static_cast<std::size_t>(node)]);
    for (const Index e : right) {
      auto& corners = mesh.elements[static_cast<std::size_t>(e)];
      std::replace(corners.begin(), corners.end(), node, twin[node]);
    }
  }
  return twin;
}

Vec3 middle(const Mesh& mesh, const std::array<Index, 4>& element) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const Index n : element)
    if (n >= 0) sum += mesh.nodes[static_cast<std::size_t>(n)], ++count;
  return sum / count;
}

// The new number of each node, -1: it goes; and their number.
std::pair<std::vector<Index>, Index> numbers(const Mesh& mesh,
                                             const std::vector<std::array<Index, 4>>& elements) {
  std::vector<Index> now(mesh.nodes.size(), -1);
  for (const auto& element : elements)
    for (const Index n : element)
      if (n >= 0) now[static_cast<std::size_t>(n)] = 0;
  Index count = 0;
  for (Index& n : now)
    if (n == 0) n = count++;
  return {now, count};
}

NodeSet renumbered(const NodeSet& set, const std::vector<Index>& now) {
  NodeSet out;
  for (const Index n : set)
    if (now[static_cast<std::size_t>(n)] >= 0) out.push_back(now[static_cast<std::size_t>(n)]);
  return out;
}

}  // namespace

CrackFaces slit(Mesh& mesh, const Vec3& from, const Vec3& to) {
  check_unused(mesh, "slit");
  if (!mesh.parts.empty()) throw Error("slit: expected a mesh of one part: slit that of the body first");
  if (!((to - from).norm() > 0))
    throw Error("slit: expected two points, got " + point_text(from) + " m twice");
  const std::vector<Cut> line = edges_on(mesh, from, to - from);
  check_line(line, from, to);
  const bool whole_boundary = mesh.sets.contains("boundary") && mesh.set("boundary") == free_nodes(mesh);
  const std::size_t before = mesh.nodes.size();
  const auto parts = [&mesh] { return std::ranges::max(parts_of_nodes(mesh)); };
  mesh.slit_parts -= parts();
  const auto twin = divide(mesh, line);
  if (mesh.nodes.size() == before)
    throw Error(
        "slit: the line from " + point_text(from) + " to " + point_text(to) +
        " m is one edge inside the mesh, which cannot open: expected two edges, or an end at the boundary");
  mesh.slit_parts += parts();
  follow_sets(mesh, twin);
  if (whole_boundary) mesh.sets["boundary"] = free_nodes(mesh);
  if (mesh.origin.find(" slit") == std::string::npos) mesh.origin += " slit";
  CrackFaces crack_faces;
  for (const auto& [node, added] : twin) {
    crack_faces.left.push_back(node);
    crack_faces.right.push_back(added);
  }
  std::sort(crack_faces.right.begin(), crack_faces.right.end());
  return crack_faces;
}

NodeSet hole(Mesh& mesh, const std::function<bool(const Vec3&)>& inside) {
  check_unused(mesh, "hole");
  if (!mesh.parts.empty()) throw Error("hole: expected a mesh of one part");
  std::vector<std::array<Index, 4>> elements, gone;
  std::vector<Vec3> warp;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const bool goes = inside(middle(mesh, mesh.elements[e]));
    (goes ? gone : elements).push_back(mesh.elements[e]);
    if (!goes && !mesh.warp.empty()) warp.push_back(mesh.warp[e]);
  }
  if (gone.empty()) throw Error("hole: no element has its middle inside");
  if (elements.empty()) throw Error("hole: every element has its middle inside");
  const NodeSet free_before = free_nodes(mesh);
  const auto boundary = mesh.sets.find("boundary");
  const bool bounds = boundary != mesh.sets.end() && boundary->second == free_before;
  const auto [now, count] = numbers(mesh, elements);
  NodeSet lost;
  for (const auto& element : gone)
    for (const Index n : element)
      if (n >= 0) lost.push_back(n);
  std::sort(lost.begin(), lost.end());
  lost.erase(std::unique(lost.begin(), lost.end()), lost.end());
  std::vector<Vec3> nodes(static_cast<std::size_t>(count));
  for (std::size_t n = 0; n < now.size(); ++n)
    if (now[n] >= 0) nodes[static_cast<std::size_t>(now[n])] = mesh.nodes[n];
  mesh.nodes = std::move(nodes);
  for (auto& element : elements)
    for (Index& n : element)
      if (n >= 0) n = now[static_cast<std::size_t>(n)];
  mesh.elements = std::move(elements);
  mesh.warp = std::move(warp);
  for (auto& [name, set] : mesh.sets) set = renumbered(set, now);
  std::erase_if(mesh.sets, [](const auto& named) { return named.second.empty(); });
  if (bounds) mesh.sets["boundary"] = free_nodes(mesh);
  mesh.origin += " with a hole";
  return renumbered(lost, now);
}

}  // namespace fabricsh::mesh
