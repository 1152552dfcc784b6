// Seams as rows of the map from unknowns to nodes: a closed stitch makes a node of one edge follow the place
// on the other edge, with weights along that edge (model/seams.hpp).
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/archive.hpp"
#include "mesh/mesh.hpp"
#include "model/seams.hpp"

namespace fabricsh::mechanics {

struct NodeFreedoms;

// The state of all stitches.
struct Sewn {
  std::vector<std::uint8_t> closed;  // per stitch: its node follows
  std::vector<std::uint8_t>
      parted;  // per stitch: it has been opened, or has broken; it is not drawn together
  std::vector<std::uint8_t> turning;  // per seam: the directors of both edges move as one
  bool operator==(const Sewn&) const = default;
  void keep(Archive& archive) { archive(closed, parted, turning); }
};

// Nodes that follow where these stitches are closed; sorted by node, then component. `free` has the equations
// of all nodes without seams, 0 where a degree of freedom is unknown. Nodes that meet node to node are
// one joint, led by one of them, for each component by one that a support holds, if any. A degree of freedom
// that a support holds stays with the support. Errors: a node is held where what it is sewn to, between two
// nodes, is not; a node between nodes of two other edges; nodes held in oblique frames.
std::vector<model::Follower> sewn_followers(const std::vector<model::Stitch>& stitches, const Sewn& sewn,
                                            const std::vector<NodeFreedoms>& nodes,
                                            const std::vector<std::array<mesh::Index, 5>>& free);

// --- How the edges of a seam lie to each other, and what follows for their directors.

// Where nodes are, m, and their directors.
struct SewnEdges {
  const mesh::Mesh& mesh;
  const std::vector<model::Stitch>& stitches;
  std::function<Vec3(mesh::Index)> place, director;
  // 1 if the directors of both edges become one as the seam closes, so that it bends as one piece, else 0.
  // The deck says so (hinge); if it does not, they do where one sheet continues the other across the seam and
  // their normals are no more than 60 degrees apart. Error: hinge=false although they are farther apart.
  std::uint8_t turning(const model::Seam& seam, std::size_t number) const;

 private:
  bool continues(std::size_t seam) const;        // whether the sheets lie on either side of the seam
  mesh::Index disagree(std::size_t seam) const;  // a node where the normals are too far apart; -1: none
};

}  // namespace fabricsh::mechanics
