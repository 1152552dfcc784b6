// A hole along the grid of a mesh.
#pragma once
#include <functional>

#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// Leaves out the elements whose middle, the mean of their corners (m), is inside, and the nodes that no
// element has any more; sets keep the others, and one that loses all its nodes goes. A set boundary that had
// the nodes of all free edges has them again. Returns the nodes of the rim, which elements on both sides of
// it had, ascending. Errors: no element inside, or all of them; a mesh of several parts
// or in use.
NodeSet hole(Mesh& mesh, const std::function<bool(const Vec3&)>& inside);

}  // namespace fabricsh::mesh
