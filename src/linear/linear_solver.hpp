// What factorises a matrix and solves with it.
#pragma once
#include <memory>
#include <span>

#include "linear/matrix.hpp"

namespace fabricsh::linear {

struct LinearReport {
  bool singular = false;
  double reciprocal_condition = 0;  // rough estimate: smallest over largest pivot
  Index fill = 0;                   // entries of the factors
  Index negative_pivots = 0;  // of a symmetric matrix: its negative eigenvalues (Sylvester's law of inertia)
};

// Direct solver. The symbolic phase runs once per pattern, when a matrix with another version comes; the
// numeric one per matrix.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  // False: singular, structurally or by its numbers, or memory ran out.
  bool factorise(const Matrix& A) { return prepare(A) && factorise_numbers(A); }
  // The symbolic phase alone, where it is needed. False: structurally singular, or memory ran out.
  bool prepare(const Matrix& A) {
    if (analysed_ == A.pattern->version) return true;
    if (!analyse(A)) return false;
    analysed_ = A.pattern->version;
    ++analyses_;
    return true;
  }
  virtual bool solve(const Matrix& A, std::span<const double> b, std::span<double> x) = 0;
  virtual LinearReport report() const = 0;
  // Does the way that the next matrix is factorised hang on the last one? To be kept with a run's state, so
  // that it continues with the same bits.
  virtual bool doubtful() const { return false; }
  virtual void set_doubtful(bool) {}
  std::int64_t analyses() const { return analyses_; }  // symbolic phases so far

 protected:
  virtual bool analyse(const Matrix& A) = 0;
  virtual bool factorise_numbers(const Matrix& A) = 0;

 private:
  std::uint64_t analysed_ = 0;  // version of the pattern
  std::int64_t analyses_ = 0;
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

}  // namespace fabricsh::linear
