// The area of a mesh, as its check measures it.
#pragma once
#include "mesh/check.hpp"

namespace fabricsh::mesh {

inline double area(const Mesh& mesh) { return check(mesh).measures.area; }

}  // namespace fabricsh::mesh
