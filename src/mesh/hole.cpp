#include "mesh/hole.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "mesh/edges.hpp"

namespace fabricsh::mesh {

namespace {

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
