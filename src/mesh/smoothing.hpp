// Moves nodes of a flat mesh of quadrilaterals so that these come closer to squares of one size.
#pragma once
#include <vector>

#include "mesh/curve.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// Moves the nodes of the list in turn, each to where the elements about it are best. For a corner with the
// sides a and b that is (a^2 + b^2) / (2 a x b), 1 in a square, and for an element the mean area over its
// own; the worst count most. An element that is not convex may become so.
void smooth(std::vector<Vec2>& nodes, const std::vector<std::array<Index, 4>>& elements,
            const std::vector<Index>& free);

}  // namespace fabricsh::mesh
