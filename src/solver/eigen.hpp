// The largest eigenvalues of A x = theta B x with symmetric A and positive definite B, both sparse, with the
// factors of B: frequencies, and critical factors of loads, are their reciprocals.
#pragma once
#include <functional>
#include <vector>

#include "linear/linear_solver.hpp"
#include "linear/vector.hpp"

namespace fabricsh::solver {

struct Eigenpairs {
  std::vector<double> value;          // theta, descending
  std::vector<linear::Vector> shape;  // x^T B x = 1
  bool converged = false;             // whether all have; else those that have come first
  int iterations = 0;                 // solves of a block
};

// Lanczos' method in blocks [grimes1994] with all of the basis orthogonalised, by Rayleigh and Ritz,
// restarted with the best vectors [wu2000]. Blocks find eigenvalues that are the same, as of a free body or a
// square; the numbers with which they begin are always the same. linear: has the factors of B. poll: called
// between solves; may throw.
Eigenpairs largest_eigenpairs(const linear::Matrix& A, const linear::Matrix& B, linear::LinearSolver& linear,
                              int count, const std::function<void()>& poll = {});

}  // namespace fabricsh::solver
