// Sharp folds of cloth under contact, which a mesh cannot show.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "mechanics/terms/contact.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::run {

// Between neighbouring elements the sheet of a coarse mesh turns at once, as at a hinge. Where a body or
// other cloth presses on such a hinge its forces go to two rows of nodes whose places depend on the mesh: the
// pull of cloth over a sharp edge can come out half or twice.
class Folds {
 public:
  explicit Folds(const mesh::Mesh& mesh);

  struct Fold {
    mesh::Index element, other;  // on both sides of the edge
    double angle;                // rad, between their normals
    Vec3 place;                  // m, the middle of the edge
    double size;                 // m, mean extent of the two elements across the edge
  };
  // The sharpest fold with contact pressure at both ends of its edge; empty: none is sharper than 40 degrees.
  // x: positions of the nodes, m.
  std::optional<Fold> sharpest(std::span<const double> x, const mechanics::ContactReadings& contacts) const;

 private:
  struct Hinge {
    mesh::Index element, other;
    mesh::Index ends[2], other_ends[2];  // the same two places; other nodes where a zone may open
  };
  const mesh::Mesh& mesh_;
  std::vector<Hinge> hinges_;
};

}  // namespace fabricsh::run
