// For matrices of both triangles that are symmetric but for a few entries, as sliding friction makes them.
#pragma once
#include <memory>

#include "linear/linear_solver.hpp"

namespace fabricsh::linear {

// The factors of the symmetric part of the entries that are not apart (Matrix), and for the rest iterations
// to a relative residual of 1e-6, which Newton's iterations correct. Its negative pivots are those of that
// part.
std::unique_ptr<LinearSolver> make_near_symmetric_solver();

}  // namespace fabricsh::linear
