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
  // Whether the directors of both edges become one as the seam closes: those of a seam that is no hinge, by
  // default where the sheets lie on either side of it, so that one continues the other, and their normals are
  // no more than 60 degrees apart. Error: they are to, and their normals are farther apart.
  std::uint8_t turning(const model::Seam& seam, std::size_t number) const;

 private:
  bool continues(std::size_t seam) const;
  mesh::Index disagree(std::size_t seam) const;  // a node at which the normals do; -1: none
};

}  // namespace fabricsh::mechanics
