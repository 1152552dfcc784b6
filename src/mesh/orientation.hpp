// Connected parts of a mesh, and the elements whose orientation differs from the others.
#pragma once
#include "mesh/edges.hpp"

namespace fabricsh::mesh {

struct Orientation {
  std::vector<Index> part;      // of each element: its connected part (through shared edges), numbered from 0
  std::vector<char> turned;     // of each element: 1 if oriented against the majority of its part
  std::vector<char> one_sided;  // of each part: no choice of turned makes all neighbours agree
  Index parts() const { return static_cast<Index>(one_sided.size()); }
};

// sorted: edges(mesh). Edges shared by three or more elements do not connect.
Orientation orientation(const Mesh& mesh, const std::vector<Edge>& sorted);

}  // namespace fabricsh::mesh
