// The factors of make_symmetric_solver() alone.
#pragma once
#include <memory>

#include "linear/linear_solver.hpp"

namespace fabricsh::linear {

// Leaves nothing to the unsymmetric solver: a pivot that means nothing makes the matrix singular, and an
// indefinite one that is not solved well has no solution.
std::unique_ptr<LinearSolver> make_symmetric_factors();

}  // namespace fabricsh::linear
