// A mesh as Gmsh 4.1 text. In Gmsh a node belongs to one entity, while sets may overlap. So each set is
// written as a physical group of points: one entity per set, with a point element at each of its nodes. The
// surface is a group as well, since readers (meshio) want a group of all elements or of none.
#include "base/error.hpp"
#include "base/number.hpp"
#include "format/mesh_file.hpp"
#include "geometry/box.hpp"

namespace fabricsh::format {

namespace {

std::string line(std::initializer_list<std::int64_t> numbers) {
  std::string text;
  for (const std::int64_t number : numbers) text += (text.empty() ? "" : " ") + std::to_string(number);
  return text + "\n";
}

std::int64_t size_of(std::size_t count) { return static_cast<std::int64_t>(count); }

std::string node_line(const Vec3& x) {
  return exact_number(x.x()) + " " + exact_number(x.y()) + " " + exact_number(x.z());
}

// The group of the surface: read back, its nodes are the set of all nodes, which every mesh has.
std::string surface_name(const mesh::Mesh& mesh) {
  const auto all = mesh.sets.find("all");
  return all == mesh.sets.end() || all->second.size() == mesh.nodes.size() ? "all" : "surface";
}

std::string names(const mesh::Mesh& mesh) {
  std::string text = "$PhysicalNames\n" + line({size_of(mesh.sets.size()) + 1});
  std::int64_t group = 0;
  for (const auto& [name, ids] : mesh.sets) {
    if (name.find_first_of("\"\n\r") != std::string::npos)
      throw Error("set '" + name + "': a name with quotes or line ends does not go into a Gmsh file");
    text += "0 " + std::to_string(++group) + " \"" + name + "\"\n";
  }
  text += "2 " + std::to_string(group + 1) + " \"" + surface_name(mesh) + "\"\n";
  return text + "$EndPhysicalNames\n";
}

// Point entity g belongs to set g; surface entity 1 is the mesh.
std::string entities(const mesh::Mesh& mesh) {
  std::string text = "$Entities\n" + line({size_of(mesh.sets.size()), 0, 1, 0});
  std::int64_t group = 0;
  for (const auto& [name, ids] : mesh.sets) {
    ++group;
    text += std::to_string(group) + " " + node_line(mesh.nodes[static_cast<std::size_t>(ids.front())]) +
            " 1 " + std::to_string(group) + "\n";
  }
  const BoundingBox box = box_of(mesh.nodes);
  return text + "1 " + node_line(box.low) + " " + node_line(box.high) + " 1 " + std::to_string(group + 1) +
         " 0\n$EndEntities\n";
}

std::string nodes(const mesh::Mesh& mesh) {
  const auto n = size_of(mesh.nodes.size());
  std::string text = "$Nodes\n" + line({1, n, 1, n}) + line({2, 1, 0, n});
  for (std::int64_t i = 1; i <= n; ++i) text += std::to_string(i) + "\n";
  for (const Vec3& x : mesh.nodes) text += node_line(x) + "\n";
  return text + "$EndNodes\n";
}

struct GmshBlock {
  std::int64_t dimension, entity, type;
  std::string lines = {};
  std::int64_t count = 0;
  void add(std::string element) {
    lines += element;
    ++count;
  }
  std::string text() const { return count == 0 ? "" : line({dimension, entity, type, count}) + lines; }
};

// One block for each run of triangles or of quadrilaterals, so that the order of the elements is kept.
std::vector<GmshBlock> blocks(const mesh::Mesh& mesh, std::int64_t& number) {
  std::vector<GmshBlock> all;
  for (const auto& ids : mesh.elements) {
    const bool triangle = ids[3] < 0;
    if (all.empty() || all.back().type != (triangle ? 2 : 3)) all.push_back({2, 1, triangle ? 2 : 3});
    ++number;
    all.back().add(triangle ? line({number, ids[0] + 1, ids[1] + 1, ids[2] + 1})
                            : line({number, ids[0] + 1, ids[1] + 1, ids[2] + 1, ids[3] + 1}));
  }
  std::int64_t group = 0;
  for (const auto& [name, ids] : mesh.sets) {
    all.push_back({0, ++group, 15});
    for (const mesh::Index id : ids) all.back().add(line({++number, id + 1}));
  }
  return all;
}

}  // namespace

std::string gmsh_text(const mesh::Mesh& mesh) {
  std::int64_t count = 0;
  const auto all = blocks(mesh, count);
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + names(mesh) + entities(mesh) + nodes(mesh);
  text += "$Elements\n" + line({size_of(all.size()), count, 1, count});
  for (const GmshBlock& block : all) text += block.text();
  return text + "$EndElements\n";
}

}  // namespace fabricsh::format
