// Which elements are connected, and which of them turn the other way.
#pragma once
#include "mesh/edges.hpp"

namespace fabricsh::mesh {

struct Orientation {
  std::vector<Index> part;      // of each element: elements that share edges, number from 0
  std::vector<char> turned;     // 1: against most of its part
  std::vector<char> one_sided;  // of each part: no choice of turned makes all neighbours agree
  Index parts() const { return static_cast<Index>(one_sided.size()); }
};

// sorted: edges(mesh). Edges of three elements and more connect nothing.
Orientation orientation(const Mesh& mesh, const std::vector<Edge>& sorted);

}  // namespace fabricsh::mesh
