// A surface mesh: nodes, quadrilaterals and triangles, named node sets.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/vec.hpp"

namespace fabricsh::mesh {

using Index = std::int64_t;
using NodeSet = std::vector<Index>;  // ids from 0, ascending, each once

struct Mesh {
  std::vector<Vec3> nodes;                     // reference positions, m, global
  std::vector<std::array<Index, 4>> elements;  // node ids from 0, counter-clockwise about the shell normal;
                                               // a triangle has -1 in the last place
  std::map<std::string, NodeSet, std::less<>> sets;
  // The warp direction of each element, global, of unit length, which map() takes along. Empty: the mesh has
  // none; zero for the elements of a part that has none.
  std::vector<Vec3> warp;
  bool flat = false;  // generated in the x-y plane and not mapped since: the warp direction may default to +x
  bool in_use = false;   // by a compiled model: nodes, elements and named sets must not change any more
  Index slit_parts = 0;  // by how many more parts slit() has made of it
  std::string origin;    // "rectangle 3x9", "file disc.msh": used in messages and in the printed model
  // Content of its file beside a mesh, as materials, loads and steps: each statement once, by the first line.
  struct PassedOver {
    std::string statement;  // "*MATERIAL"
    Index line = 0, count = 0;
  };
  std::vector<PassedOver> passed_over;

  // For a mesh joined from others: where the nodes and elements of each part are.
  // A set of a part is found as "part.set", even if it is defined after the join.
  struct Part {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
    Index first_node = 0, first_element = 0;
  };
  std::vector<Part> parts;

  // For a mesh made by split_corners() or split_sides() (corners.hpp): the mesh without its further nodes,
  // whose sets it has; and for each node the one of that mesh at the same place.
  std::shared_ptr<const Mesh> whole;
  bool hinged = false;  // made by split_sides(): each side of a hinge has normals of its own
  std::vector<Index> place;
  const Mesh& uncut() const { return whole ? *whole : *this; }
  Index place_of(Index node) const { return place.empty() ? node : place[static_cast<std::size_t>(node)]; }

  // The named set. Error: unknown name; the message has the nearest name and the list of names.
  const NodeSet& set(std::string_view name) const;
  std::vector<std::string> set_names() const;  // ascending, including those of the parts
  // Elements all of whose nodes are in the set.
  std::vector<Index> elements_in(const NodeSet& nodes) const;
  // Defines or replaces a set. Error: an id outside the mesh, an empty
  // list, or other ids for an existing name while the mesh is in use.
  void define(const std::string& name, NodeSet ids);
  void define(const std::string& name, const std::function<bool(const Vec3&)>& inside);
  bool has_warp() const;  // of every element
  // Moves every node and clears `flat`; the warp goes with the elements. Error: a position that
  // is not finite, or a mesh in use; then no node is moved.
  void map(const std::function<Vec3(const Vec3&)>& f);

 private:
  // A set of a part, or of the whole mesh, when last looked up, and the same set in the ids of this mesh.
  struct Borrowed {
    NodeSet own, here;
  };
  Vec3 moved_warp(std::size_t element, const std::vector<Vec3>& moved) const;
  const NodeSet* set_of_part(std::string_view name) const;
  const NodeSet& set_of_whole(std::string_view name) const;
  mutable std::map<std::string, Borrowed, std::less<>> borrowed_;
};

// Nodes nearer than this part of the mesh's size are at one place: about what single precision leaves in
// files.
inline constexpr double one_place = 1e-6;

// Joins several meshes into one, part after part. The named sets of a part are available as "part.set"; there
// is also "all". The parts share no nodes. Error: two parts of the same name, or a part without a name.
Mesh join(const std::vector<std::pair<std::string, std::shared_ptr<const Mesh>>>& parts);

// Error if the mesh is in use and `call` would change it.
void check_unused(const Mesh& mesh, const char* call);

// Cuts every quadrilateral into two triangles along the diagonal from its first corner; with `across`
// (columns of a lattice), in every other cell from its second corner, which gives a union jack pattern.
void split(Mesh& mesh, Index across);

// Structured rectangle in the x-y plane, normal +z, nodes row-major from the origin corner.
// Sets: left right bottom top boundary corners all. Errors: sizes not positive and finite, cells < 1.
Mesh rectangle(double width, double height, Index nx, Index ny, const Vec3& origin = Vec3::Zero());
// The same with lines of nodes at these positions, m from the origin corner. Errors: positions that do not
// ascend, or do not run from 0 to the size.
struct Grading {
  std::vector<double> x, y;
};
Mesh rectangle(double width, double height, const Grading& lines, const Vec3& origin = Vec3::Zero());

}  // namespace fabricsh::mesh
