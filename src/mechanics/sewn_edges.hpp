// How the edges of a seam lie to each other, and what follows for their directors.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/seams.hpp"

namespace fabricsh::mechanics {

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
