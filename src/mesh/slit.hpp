// A slit along a line of edges.
#pragma once
#include <functional>

#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// The nodes of the two sides, ascending; at an end inside the mesh, where the sides stay together, both have
// its node.
struct CrackFaces {
  NodeSet left, right;  // as seen from the start of the slit, against the normal
};

// Cuts the mesh along the edges on the straight line between two points (m): the nodes there are doubled
// except at an end inside the mesh. The left side keeps them; the new ones follow all others, and are in the
// sets of those at their places. A set boundary that has the nodes of all free edges has them again. Errors,
// with the place: no node at an end; a part of the line without an edge, or along an edge that is free; a
// slit of one edge inside the mesh, which would not open; a mesh of several parts or in use.
CrackFaces slit(Mesh& mesh, const Vec3& from, const Vec3& to);

// --- A hole along the grid of a mesh.

// Leaves out the elements whose middle, the mean of their corners (m), is inside, and the nodes that no
// element has any more; sets keep the others, and one that loses all its nodes goes. A set boundary that had
// the nodes of all free edges has them again. Returns the nodes of the rim, which elements on both sides of
// it had, ascending. Errors: no element inside, or all of them; a mesh of several parts
// or in use.
NodeSet hole(Mesh& mesh, const std::function<bool(const Vec3&)>& inside);

}  // namespace fabricsh::mesh
