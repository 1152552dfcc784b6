// A mesh as other solvers write it: nodes, shells of 3 and 4 nodes, sets of nodes. Numbers count from 1 in
// the mesh's order. The rest of a deck (materials, supports, steps) surrounds these lines.
#pragma once
#include <string>

#include "mesh/mesh.hpp"

namespace fabricsh::format {

struct DeckForm {
  double length = 1;             // what a metre is in the deck
  bool membrane = false;         // Abaqus: M3D4R and M3D3 in the place of S4 and S3
  std::string elements = "all";  // Abaqus: name of the set of all elements
};

// Errors: a set's name that the format can't hold, a mesh too large for its columns.
std::string abaqus_lines(const mesh::Mesh& mesh, const DeckForm& form = {});
std::string dyna_lines(const mesh::Mesh& mesh,
                       const DeckForm& form = {});  // part 1; set k is the k-th by name
std::string radioss_lines(const mesh::Mesh& mesh, const DeckForm& form = {});  // part 1; group k as well

}  // namespace fabricsh::format
