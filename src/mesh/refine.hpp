// Cuts all elements of a mesh into quadrilaterals of half their size.
#pragma once
#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// Cuts every element from its middle to the middles of its sides: a quadrilateral into four, a triangle into
// three. So no triangle is left. New nodes lie on the sides and in the middles, hence the surface and its
// border stay as they are, with their corners. They have the highest numbers: first the sides, in the order
// of their ends, then the elements. A set takes the middle of a side whose ends it has, of an inner side only
// if it has inner nodes, and the middle of an element all of whose corners it has. The warp goes with the
// elements. Errors: a mesh in use or of several parts.
void refine(Mesh& mesh);

// --- Joins triangles in pairs to quadrilaterals, which yarns do not lock where they cross them obliquely.

// Joins neighbours where the four corners form a convex and nearly flat quadrilateral whose corners are 30 to
// 150 degrees: the best pairs first, then others in their place where that leaves fewer triangles. Nodes and
// sets stay, elements are numbered anew in the order of the first of their triangles. Returns how many
// triangles are left. Error: a mesh in use.
Index pair_triangles(Mesh& mesh);

}  // namespace fabricsh::mesh
