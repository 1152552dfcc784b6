// The edges of a mesh, and what follows from them.
#pragma once
#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// The number of corners of an element: 4, or 3 for a triangle.
inline std::size_t corner_count(const std::array<Index, 4>& element) { return element[3] < 0 ? 3 : 4; }

// An edge as seen by one element; first < second.
struct Edge {
  Index first, second;
  Index element;
  bool forward;  // in the order of the element's nodes the edge runs from first to second
};

// The edges of all elements, sorted so that those between the same two nodes are adjacent.
std::vector<Edge> edges(const Mesh& mesh);
// Calls visit once for each edge of the mesh, with the entries of all elements that share it.
void for_each_edge(const std::vector<Edge>& sorted,
                   const std::function<void(const Edge* begin, const Edge* end)>& visit);
// Nodes on the edges that belong to only one element, ascending.
NodeSet free_nodes(const Mesh& mesh);

}  // namespace fabricsh::mesh
