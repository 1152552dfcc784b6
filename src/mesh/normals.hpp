// The normal of a surface at its nodes.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// Unit normals: the mean of the corner normals of the elements at a node, weighted by their area. Zero where
// they cancel, since the elements have no area, or fold onto each other; and at nodes of no element.
std::vector<Vec3> node_normals(const Mesh& mesh);

// Whether the element with these nodes has a positive volume at all integration points of the shell elements,
// in its middle surface with these directors at the nodes.
bool spans_volume(const Mesh& mesh, const std::array<Index, 4>& element, const std::vector<Vec3>& directors);

}  // namespace fabricsh::mesh
