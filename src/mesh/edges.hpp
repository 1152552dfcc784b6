// The edges of a mesh, and what they say of it.
#pragma once
#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// An edge as one element has it; first < second.
struct Edge {
  Index first, second;
  Index element;
  bool forward;  // the element walks it from first to second
};

// Edges of all elements, those between the same two nodes side by side.
std::vector<Edge> edges(const Mesh& mesh);
// Calls visit(edges of the elements that share one edge).
void for_each_edge(const std::vector<Edge>& sorted,
                   const std::function<void(const Edge* begin, const Edge* end)>& visit);
// Nodes on the edges that one element alone has, ascending.
NodeSet free_nodes(const Mesh& mesh);

}  // namespace fabricsh::mesh
