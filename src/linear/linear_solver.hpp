// Interface of the direct solvers, which factorise a matrix and solve with the factors.
#pragma once
#include <memory>
#include <span>

#include "linear/matrix.hpp"

namespace fabricsh::linear {

struct LinearReport {
  bool singular = false;
  Index fill = 0;             // entries of the factors
  Index negative_pivots = 0;  // of a symmetric matrix: its negative eigenvalues (Sylvester's law of inertia)
};

// A direct solver. The symbolic phase runs only when a matrix with another
// pattern version arrives; the numerical phase runs for every matrix.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  // False: the matrix is singular (structurally or numerically), or memory ran out.
  bool factorise(const Matrix& A) { return prepare(A) && factorise_numbers(A); }
  // The symbolic phase alone, if it is needed. False: structurally singular, or memory ran out.
  bool prepare(const Matrix& A) {
    if (analysed_ == A.pattern->version) return true;
    if (!analyse(A)) return false;
    analysed_ = A.pattern->version;
    ++analyses_;
    return true;
  }
  virtual bool solve(const Matrix& A, std::span<const double> b, std::span<double> x) = 0;
  virtual LinearReport report() const = 0;
  std::int64_t analyses() const { return analyses_; }  // symbolic phases so far

 protected:
  virtual bool analyse(const Matrix& A) = 0;
  virtual bool factorise_numbers(const Matrix& A) = 0;

 private:
  std::uint64_t analysed_ = 0;  // version of the pattern analysed last
  std::int64_t analyses_ = 0;
};

// The fill-reducing ordering. automatic: AMD for small matrices, METIS
// for large ones, as measured with tests/bench/bench_solver.cpp.
enum class Ordering { automatic, amd, metis };

// UMFPACK with the symmetric-pattern strategy, for matrices with unsymmetric values (an upper
// triangle is mirrored first). BLAS uses one thread.
std::unique_ptr<LinearSolver> make_unsymmetric_solver(Ordering ordering = Ordering::automatic);

// Factors L S L^T with signs S, which reads the upper triangle only. No pivots are looked for: one that means
// nothing leaves the matrix to the unsymmetric solver, as does an indefinite matrix that is not solved well.
// All threads share large matrices; no bit depends on their number.
std::unique_ptr<LinearSolver> make_symmetric_solver(Ordering ordering = Ordering::automatic);

// A solver that takes the ranks of a matrix (FewRanks) into account, around one that does not: with the
// factors of the sparse part, after Sherman, Morrison and Woodbury [hager1989]. Its negative pivots are those
// of the whole matrix.
std::unique_ptr<LinearSolver> with_ranks(std::unique_ptr<LinearSolver> sparse);

}  // namespace fabricsh::linear
