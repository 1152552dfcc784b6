// A square sparse matrix in compressed columns, and what factorises it.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace fabricsh::solver {

using Index = std::int64_t;

struct SparseMatrix {
  Index size = 0;
  std::vector<Index> column;  // size + 1 starts
  std::vector<Index> row;     // ascending in each column
  std::vector<double> value;
};

struct LinearReport {
  bool singular = false;
  double reciprocal_condition = 0;  // rough estimate: smallest over largest pivot
  Index fill = 0;                   // entries of the factors
  Index negative_pivots = 0;  // of a symmetric matrix: its negative eigenvalues (Sylvester's law of inertia)
};

// Direct solver. The symbolic phase runs once per pattern (analyse), the numeric one per matrix (factorise).
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  virtual bool analyse(
      const SparseMatrix& A) = 0;  // false: the pattern is structurally singular or memory ran out
  virtual bool factorise(const SparseMatrix& A) = 0;  // false: singular; needs analyse() of the same pattern
  virtual bool solve(const SparseMatrix& A, std::span<const double> b, std::span<double> x) = 0;
  virtual LinearReport report() const = 0;
  // Does the way that the next matrix is factorised hang on the last one? To be kept with a run's state, so
  // that it continues with the same bits.
  virtual bool doubtful() const { return false; }
  virtual void set_doubtful(bool) {}
};

// What keeps the factors sparse. automatic: AMD for small matrices, METIS for large ones, by measurement
// (tests/bench/bench_solver.cpp).
enum class Ordering { automatic, amd, metis };

// UMFPACK with the symmetric-pattern strategy: unsymmetric values. BLAS is held to one thread.
std::unique_ptr<LinearSolver> make_unsymmetric_solver(Ordering ordering = Ordering::automatic);

// Supernodal Cholesky (CHOLMOD), which reads the upper triangle alone. A matrix that is not positive definite
// goes to the unsymmetric solver, which counts its negative pivots; so do the ones after it, until one has
// none.
std::unique_ptr<LinearSolver> make_symmetric_solver(Ordering ordering = Ordering::automatic);

}  // namespace fabricsh::solver
