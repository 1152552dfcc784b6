// A mesh from lists, and several meshes as one.
#include <algorithm>
#include <numeric>

#include "base/error.hpp"
#include "geometry/box.hpp"
#include "mesh/edges.hpp"
#include "mesh/generators.hpp"

namespace fabricsh::mesh {

namespace {

std::string element_words(std::size_t element) { return "element " + std::to_string(element + 1); }

void check_corners(const std::array<Index, 4>& ids, std::size_t element, Index nodes) {
  const std::size_t n = ids[3] < 0 ? 3 : 4;
  for (std::size_t i = 0; i < n; ++i) {
    if (ids[i] < 0 || ids[i] >= nodes)
      throw Error(element_words(element) + ": expected node numbers from 1 to " + std::to_string(nodes) +
                  ", got " + std::to_string(ids[i] + 1));
    for (std::size_t j = 0; j < i; ++j)
      if (ids[i] == ids[j])
        throw Error(element_words(element) + ": expected different nodes, got node " +
                    std::to_string(ids[i] + 1) + " twice");
  }
}

// For each node the first within the distance that it may join, or itself; by a sweep along the axis.
template <class MayJoin>
std::vector<Index> partners(const std::vector<Vec3>& nodes, double distance, Eigen::Index axis,
                            const MayJoin& may_join) {
  std::vector<Index> order(nodes.size()), partner(nodes.size());
  std::iota(order.begin(), order.end(), Index{0});
  partner = order;
  const auto at = [](auto& list, Index i) -> auto& { return list[static_cast<std::size_t>(i)]; };
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return at(nodes, a)[axis] < at(nodes, b)[axis]; });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const auto [a, b] = std::minmax(order[i], order[j]);
      if (at(nodes, order[j])[axis] - at(nodes, order[i])[axis] > distance) break;
      if (may_join(a, b) && (at(nodes, a) - at(nodes, b)).norm() <= distance)
        at(partner, b) = std::min(at(partner, b), a);
    }
  for (Index& p : partner) p = at(partner, p);  // in ascending order, so that the partner's own is final
  return partner;
}

// Of nodes of different meshes.
std::vector<Index> partners(const Mesh& joined, double distance) {
  std::vector<Index> owner(joined.nodes.size());
  for (std::size_t p = 0; p < joined.parts.size(); ++p)
    std::fill(owner.begin() + joined.parts[p].first_node, owner.end(), static_cast<Index>(p));
  return partners(joined.nodes, distance, 0, [&](Index a, Index b) {
    return owner[static_cast<std::size_t>(a)] != owner[static_cast<std::size_t>(b)];
  });
}

// Numbers of the nodes that stay, by those of all nodes.
std::vector<Index> renumber(const std::vector<Index>& partner, Mesh& mesh) {
  std::vector<Index> place(partner.size());
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < partner.size(); ++i) {
    const auto p = static_cast<std::size_t>(partner[i]);
    place[i] = p == i ? static_cast<Index>(kept.size()) : place[p];
    if (p == i) kept.push_back(mesh.nodes[i]);
  }
  mesh.nodes = std::move(kept);
  return place;
}

}  // namespace

Index join_nodes(Mesh& mesh) {
  const auto before = static_cast<Index>(mesh.nodes.size());
  const auto boundary = mesh.sets.find("boundary");
  if (boundary != mesh.sets.end() && boundary->second == free_nodes(mesh)) mesh.sets.erase(boundary);
  mesh.sets.erase("all");
  Eigen::Index longest = 0;
  const Vec3 size = box_of(mesh.nodes).size();
  size.maxCoeff(&longest);
  const auto all = [](Index, Index) { return true; };
  const std::vector<Index> place =
      renumber(partners(mesh.nodes, one_place * size.norm(), longest, all), mesh);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (Index& id : mesh.elements[e])
      if (id >= 0) id = place[static_cast<std::size_t>(id)];
    check_corners(mesh.elements[e], e, static_cast<Index>(mesh.nodes.size()));
  }
  auto sets = std::move(mesh.sets);
  mesh.sets.clear();
  for (auto& [name, ids] : sets) {
    for (Index& id : ids) id = place[static_cast<std::size_t>(id)];
    mesh.define(name, std::move(ids));
  }
  add_usual_sets(mesh);
  return before - static_cast<Index>(mesh.nodes.size());
}

void add_usual_sets(Mesh& mesh) {
  if (!mesh.sets.contains("all")) {
    NodeSet all(mesh.nodes.size());
    std::iota(all.begin(), all.end(), Index{0});
    mesh.define("all", std::move(all));
  }
  NodeSet boundary = free_nodes(mesh);
  if (!mesh.sets.contains("boundary") && !boundary.empty()) mesh.define("boundary", std::move(boundary));
}

Mesh from_lists(std::vector<Vec3> nodes, std::vector<std::array<Index, 4>> elements) {
  if (elements.empty()) throw Error("expected at least one element, got none");
  std::vector<char> used(nodes.size(), 0);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    check_corners(elements[e], e, static_cast<Index>(nodes.size()));
    for (const Index id : elements[e])
      if (id >= 0) used[static_cast<std::size_t>(id)] = 1;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].allFinite()) throw Error("node " + std::to_string(i + 1) + ": expected finite coordinates");
    if (used[i] == 0) throw Error("node " + std::to_string(i + 1) + " is in no element");
  }
  Mesh mesh;
  mesh.nodes = std::move(nodes);
  mesh.elements = std::move(elements);
  mesh.origin = "lists";
  add_usual_sets(mesh);
  return mesh;
}

Mesh merge(const std::vector<std::shared_ptr<const Mesh>>& meshes, double distance) {
  std::vector<std::pair<std::string, std::shared_ptr<const Mesh>>> named;
  for (const auto& mesh : meshes) named.emplace_back(std::to_string(named.size() + 1), mesh);
  Mesh merged = join(named);
  const std::vector<Index> place = renumber(partners(merged, distance), merged);
  const auto placed = [&place](Index id) { return place[static_cast<std::size_t>(id)]; };
  for (std::size_t e = 0; e < merged.elements.size(); ++e) {
    for (Index& id : merged.elements[e])
      if (id >= 0) id = placed(id);
    check_corners(merged.elements[e], e, static_cast<Index>(merged.nodes.size()));
  }
  std::map<std::string, NodeSet> sets;
  for (const Mesh::Part& part : merged.parts)
    for (const auto& [name, ids] : part.mesh->sets)
      for (const Index id : ids) sets[name].push_back(placed(part.first_node + id));
  merged.parts.clear();
  merged.sets.clear();
  for (auto& [name, ids] : sets)
    if (name != "all" && name != "boundary") merged.define(name, std::move(ids));
  add_usual_sets(merged);
  return merged;
}

}  // namespace fabricsh::mesh
