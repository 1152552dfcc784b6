// Why a step could not be done: where, and which yarn.
#pragma once
#include <string>

#include "assembly/assembly.hpp"
#include "solver/newton.hpp"

namespace fabricsh::analysis {

// What carried the residual of a failed attempt; to be looked up before the state is rolled back.
struct Blame {
  mesh::Index node = -1, element = -1;
  std::string yarn;  // "warp", "weft", "shear" where its branch changes within the step; or empty
};

// Compares the failed iterate with the committed state, to which it then goes back. Of the elements about the
// node with the largest residual, the first that switches is named.
Blame find_blame(assembly::Assembly& assembly, const mesh::Mesh& mesh, const solver::NewtonResult& last);

// "; the residual 0.1 (tolerance 1e-10) sits at node 3, element 2, where the warp is switching"
std::string describe(const Blame& blame, const solver::NewtonResult& last, double tolerance);

}  // namespace fabricsh::analysis
