#include "format/mesh_builder.hpp"

#include <filesystem>

#include "base/error.hpp"
#include "base/utf8.hpp"
#include "mesh/generators.hpp"

namespace fabricsh::format {

using mesh::Index;
using mesh::Mesh;
using mesh::NodeSet;

void MeshBuilder::add_node(std::int64_t number, const Vec3& position) {
  if (!position.allFinite()) source_.fail("node " + std::to_string(number) + ": a coordinate is not finite");
  if (!places_.emplace(number, static_cast<Index>(mesh_.nodes.size())).second)
    source_.fail("node " + std::to_string(number) + " is defined twice");
  mesh_.nodes.push_back(position);
}

void MeshBuilder::move_node(std::int64_t number, const Vec3& position) {
  if (!position.allFinite()) source_.fail("node " + std::to_string(number) + ": a coordinate is not finite");
  mesh_.nodes[static_cast<std::size_t>(places_.at(number))] = position;
}

Index MeshBuilder::place(std::int64_t number, const std::string& who) const {
  const auto found = places_.find(number);
  if (found == places_.end())
    source_.fail(who + ": node " + std::to_string(number) + " is not in the file (it has " +
                 std::to_string(nodes()) + " nodes)");
  return found->second;
}

void MeshBuilder::add_element(std::int64_t number, std::span<const std::int64_t> corners) {
  const std::string who = "element " + std::to_string(number);
  std::array<Index, 4> ids{-1, -1, -1, -1};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    ids[i] = place(corners[i], who);
    for (std::size_t k = 0; k < i; ++k)
      if (ids[k] == ids[i]) source_.fail(who + ": node " + std::to_string(corners[i]) + " is in it twice");
  }
  mesh_.elements.push_back(ids);
}

void MeshBuilder::add_polygon(std::span<const std::int64_t> corners) {
  const std::string who = "a face of " + std::to_string(corners.size()) + " corners";
  std::vector<Vec3> x;
  for (const std::int64_t number : corners)
    x.push_back(mesh_.nodes[static_cast<std::size_t>(place(number, who))]);
  const auto normal = [&x](std::size_t i) { return Vec3((x[i] - x[0]).cross(x[i + 1] - x[0])); };
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < x.size(); ++i) sum += normal(i);
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    if (!(normal(i).dot(sum) > 0))
      source_.fail(who +
                   " that is not convex: cut it into triangles where the file was made (in Blender: "
                   "Triangulated Mesh)");
    add_element(static_cast<std::int64_t>(elements()) + 1,
                std::array{corners[0], corners[i], corners[i + 1]});
  }
}

void MeshBuilder::add_to_set(const std::string& name, std::span<const std::int64_t> numbers) {
  if (numbers.size() > members_left_)
    source_.fail("set " + in_quotes(name) + ": the sets have more members than a file of this size can name");
  members_left_ -= numbers.size();
  NodeSet& set = sets_[name];
  for (const std::int64_t number : numbers) set.push_back(place(number, "set " + in_quotes(name)));
}

void MeshBuilder::drop_unused() {
  std::vector<Index> place(mesh_.nodes.size(), -1);
  for (const auto& element : mesh_.elements)
    for (const Index id : element)
      if (id >= 0) place[static_cast<std::size_t>(id)] = 0;
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < place.size(); ++i)
    if (place[i] == 0) {
      place[i] = static_cast<Index>(kept.size());
      kept.push_back(mesh_.nodes[i]);
    }
  mesh_.nodes = std::move(kept);
  for (auto& element : mesh_.elements)
    for (Index& id : element)
      if (id >= 0) id = place[static_cast<std::size_t>(id)];
  for (auto& [name, set] : sets_) {
    for (Index& id : set) id = place[static_cast<std::size_t>(id)];
    std::erase(set, -1);
  }
}

Mesh MeshBuilder::finish() {
  const std::string file = std::filesystem::path(source_.name()).filename().string();
  if (mesh_.elements.empty())
    throw Error(source_.name() + ": no triangle or quadrilateral is in it (" + std::to_string(nodes()) +
                " nodes)");
  drop_unused();
  for (auto& [name, set] : sets_)
    if (!set.empty() && !name.empty()) mesh_.define(made_plain(name), std::move(set));
  mesh::add_usual_sets(mesh_);
  mesh_.origin = "file " + file;
  return std::move(mesh_);
}

}  // namespace fabricsh::format
