// Builds a surface mesh from a file: nodes with the numbers of the file, elements, sets.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <unordered_map>

#include "format/source.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::format {

class MeshBuilder {
 public:
  // most_members: limit on the total number of members of all sets.
  explicit MeshBuilder(const Source& source, std::size_t most_members = static_cast<std::size_t>(-1))
      : source_(source), members_left_(most_members) {}

  // Error: a number that is already used, or a coordinate that is not finite.
  void add_node(std::int64_t number, const Vec3& position);
  // To another place. The node must exist. Error: a coordinate that is not finite.
  void move_node(std::int64_t number, const Vec3& position);
  // Of a node that must exist.
  const Vec3& position(std::int64_t number) const {
    return mesh_.nodes[static_cast<std::size_t>(places_.at(number))];
  }
  bool has_node(std::int64_t number) const { return places_.contains(number); }
  std::size_t nodes() const { return mesh_.nodes.size(); }
  std::size_t elements() const { return mesh_.elements.size(); }
  // Takes 3 or 4 node numbers. Error, naming the element: an unknown node, or a repeated one.
  void add_element(std::int64_t number, std::span<const std::int64_t> corners);
  // A face of more corners, as triangles at its first one. Error: it is not convex.
  void add_polygon(std::span<const std::int64_t> corners);
  void add_to_set(const std::string& name, std::span<const std::int64_t> numbers);

  // Drops nodes that no element uses, and sets that contain only such nodes. Adds the
  // sets all and boundary unless the file has sets of these names. Error: no elements.
  mesh::Mesh finish();

 private:
  mesh::Index place(std::int64_t number, const std::string& who) const;
  void drop_unused();

  const Source& source_;
  std::size_t members_left_;
  mesh::Mesh mesh_;
  std::unordered_map<std::int64_t, mesh::Index> places_;
  std::map<std::string, mesh::NodeSet> sets_;
};

}  // namespace fabricsh::format
