// Meshes in which some elements have nodes of their own at their corners, so that they can come apart there.
#pragma once
#include <memory>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// The mesh in which each corner of these elements (ascending) has a node of its own, at the same place. Nodes
// and elements keep their numbers, and the further nodes follow in the order of the elements; at a place
// where only such elements meet, the first of them keeps the node that is there. The elements that are not
// listed go on sharing theirs. Sets have all nodes at the places that they name.
std::shared_ptr<Mesh> split_corners(std::shared_ptr<const Mesh> whole, const std::vector<Index>& elements);

}  // namespace fabricsh::mesh
