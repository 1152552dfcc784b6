// Which triangles of a mesh become one quadrilateral, so that as few as possible are left.
#pragma once
#include <cstdint>
#include <functional>

#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// Two triangles that share a side, and the quadrilateral of both.
struct TrianglePair {
  std::int64_t rank;  // how good the quadrilateral is; an integer, so that rounding does not decide
  std::size_t first, second;
  std::array<Index, 4> ids;
};
using RankOf = std::function<std::int64_t(const std::array<Index, 4>&)>;  // 0: never to be joined

// Pairs without a common triangle, the best first. Then others take their place where that joins two more
// triangles: by at most so many new pairs, those that lose least, and then by any number of them (Edmonds'
// matching, in which a search ends after 3000 triangles). With 0 none takes the place of another.
std::vector<TrianglePair> match_triangles(const Mesh& mesh, const RankOf& rank, int most_new);

}  // namespace fabricsh::mesh
