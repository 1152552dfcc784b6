// Meshes in which some elements have nodes of their own at their corners, so that they can come apart there,
// or turn against each other.
#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// The mesh in which each corner of these elements (ascending) has a node of its own, at the same place. Nodes
// and elements keep their numbers, and the further nodes follow in the order of the elements; at a place
// where only such elements meet, the first of them keeps the node that is there. The elements that are not
// listed go on sharing theirs. Sets have all nodes at the places that they name.
std::shared_ptr<Mesh> split_corners(std::shared_ptr<const Mesh> whole, const std::vector<Index>& elements);

// The mesh in which each side of these edges has nodes of its own, at the same place: at an end of an edge,
// as many as the edges divide the elements around it into sectors. Where an edge ends within the sheet there
// is one sector, which keeps the node. Further nodes and sets as above.
std::shared_ptr<Mesh> split_sides(std::shared_ptr<const Mesh> whole,
                                  const std::vector<std::pair<Index, Index>>& edges);

// The node of an element at this place of the mesh without further nodes; -1: none.
Index node_at(const Mesh& mesh, Index element, Index place);

}  // namespace fabricsh::mesh
