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
  bool flat = false;  // generated in the x-y plane and not mapped since: the warp direction may default to +x
  bool in_use = false;  // a compiled model refers to it: nodes, elements and named sets stay as they are
  std::string origin;   // "rectangle 3x9", "file disc.msh": for messages and the printed model

  // Of a mesh that was joined from others: where their nodes and elements are. A set of a part goes by
  // "part.set", also one that is made later.
  struct Part {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
    Index first_node = 0, first_element = 0;
  };
  std::vector<Part> parts;

  // The named set. Error: unknown name, with the nearest known one and the list.
  const NodeSet& set(std::string_view name) const;
  std::vector<std::string> set_names() const;  // ascending, those of the parts too
  // Elements all of whose nodes are in the set.
  std::vector<Index> elements_in(const NodeSet& nodes) const;
  // New or replaced set; error on an id outside the mesh or an empty list, and on other ids under a known
  // name once the mesh is in use.
  void define(const std::string& name, NodeSet ids);
  void define(const std::string& name, const std::function<bool(const Vec3&)>& inside);
  // Move every node; error if a position is not finite or the mesh in use. Clears `flat`. On error nothing is
  // moved.
  void map(const std::function<Vec3(const Vec3&)>& f);

 private:
  struct FromPart {  // a part's set as it was when it was last asked for, and with the joined mesh's ids
    NodeSet own, joined;
  };
  const NodeSet* set_of_part(std::string_view name) const;
  mutable std::map<std::string, FromPart, std::less<>> of_parts_;
};

// One mesh of several, part after part; each named set of a part is there as "part.set", and "all". Nodes are
// not shared between parts. Error: two parts of one name, or one without a name.
Mesh join(const std::vector<std::pair<std::string, std::shared_ptr<const Mesh>>>& parts);

// Error when the mesh is in use: a call that would change it.
void check_unused(const Mesh& mesh, const char* call);

// Every quadrilateral becomes two triangles: cut along the diagonal from its first corner, or in every other
// cell of a lattice of `across` columns from its second, so that the cuts make a union jack.
void split(Mesh& mesh, Index across);

// Structured rectangle in the x-y plane, normal +z, nodes row-major from the origin corner.
// Sets: left right bottom top boundary corners all. Errors: sizes not positive and finite, cells < 1.
Mesh rectangle(double width, double height, Index nx, Index ny, const Vec3& origin = Vec3::Zero());

// Shortest edge of an element, or its smallest height where it is skewed, m: the h of the explicit step.
double smallest_length(const Mesh& mesh, Index element);

}  // namespace fabricsh::mesh
