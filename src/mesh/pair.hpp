// Joins triangles in pairs to quadrilaterals, which yarns do not lock where they cross them obliquely.
#pragma once
#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// Joins neighbours where the four corners form a convex and nearly flat quadrilateral whose corners are 30 to
// 150 degrees: the best pairs first, then others in their place where that leaves fewer triangles. Nodes and
// sets stay, elements are numbered anew in the order of the first of their triangles. Returns how many
// triangles are left. Error: a mesh in use.
Index pair_triangles(Mesh& mesh);

}  // namespace fabricsh::mesh
