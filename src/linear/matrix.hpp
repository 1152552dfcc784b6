// A square sparse matrix in compressed columns: a pattern, which may be shared by several
// matrices and is replaced when entries are added, and the values of its entries.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace fabricsh::linear {

using Index = std::int64_t;

// The positions of the possible entries of a matrix. A pattern never changes: where other
// unknowns couple, a new pattern is made, and its version makes the solver analyse again.
class Pattern {
 public:
  Pattern() : Pattern(std::vector<std::vector<Index>>{}) {}
  // columns[c]: the rows of column c, in any order, possibly repeated. The argument is left empty.
  explicit Pattern(std::vector<std::vector<Index>>&& columns);
  // From finished arrays: size + 1 column starts, and the rows in ascending order in each column.
  Pattern(std::vector<Index> column, std::vector<Index> row);

  Index size = 0;
  std::vector<Index> column;  // size + 1 starts
  std::vector<Index> row;     // ascending in each column
  std::uint64_t version = 0;  // unique among all patterns of the program
  // Of a symmetric matrix whose upper triangle is kept: entries below the diagonal are absent or mean
  // nothing.
  bool upper = false;

  Index entries() const { return static_cast<Index>(row.size()); }
  // The index of an entry in the array of values. An entry outside the pattern is a
  // bug: debug builds assert, release builds throw, rather than change another entry.
  Index slot(Index r, Index c) const;
  // This pattern with additional entries, not below the diagonal if this one is upper; columns as in the
  // constructor.
  Pattern with(std::vector<std::vector<Index>>&& further) const;
};

// Part of a sparse matrix by few quantities that depend on all unknowns: U C U^T with the columns U, one per
// quantity, and a small matrix C. Such a part of a few ranks would fill a pattern.
struct FewRanks {
  std::vector<std::vector<double>> columns;
  Eigen::MatrixXd core;
  bool empty() const { return columns.empty(); }
};

struct Matrix {
  Matrix() : Matrix(std::make_shared<const Pattern>()) {}
  explicit Matrix(std::shared_ptr<const Pattern> p)
      : pattern(std::move(p)), value(static_cast<std::size_t>(pattern->entries()), 0.0) {}
  std::shared_ptr<const Pattern> pattern;
  std::vector<double> value;
  // Added to the entries: what is not symmetric of a matrix whose other entries are, as friction's dependence
  // on the pressure. make_near_symmetric_solver() has the factors of the others. Empty: there is none.
  std::vector<double> apart = {};
  FewRanks ranks =
      {};  // added to the entries; only solvers made by with_ranks() and the functions below know

  Index size() const { return pattern->size; }
  void add(Index r, Index c, double v) {
    if (!pattern->upper || r <= c) value[static_cast<std::size_t>(pattern->slot(r, c))] += v;
  }
  double entry(Index slot) const {
    const auto s = static_cast<std::size_t>(slot);
    return apart.empty() ? value[s] : value[s] + apart[s];
  }
  void clear();  // sets all entries to zero, without ranks and what is apart
  void scale(double factor);
  // Takes over another pattern if its version differs; the values are then zero.
  void follow(const std::shared_ptr<const Pattern>& p);
  // Takes over another pattern with all values. A nonzero one outside of it is a bug, as in add().
  void change_pattern(const std::shared_ptr<const Pattern>& p);
};

// The same matrix in a pattern of its own, which has the entries that are not zero; without what is apart.
Matrix without_zeros(const Matrix& A);

// For each column the sum of its entries' absolute values, those below the diagonal included also where A
// keeps its upper triangle; none smaller than 1e-12 times the largest.
void absolute_sums(const Matrix& A, std::vector<double>& sums);

// A = K + m D with the diagonal matrix of the numbers D; takes over K's pattern.
void add_diagonal(const Matrix& K, double m, std::span<const double> D, Matrix& A);

// y = A x, also where A keeps its upper triangle.
void multiply(const Matrix& A, std::span<const double> x, std::span<double> y);

// S = (K + K^T) / 2 in K's pattern; returns the largest |K_rc - K_cr| over the larger of D_r and D_c. A
// matrix that keeps its upper triangle is symmetric.
double symmetric_part(const Matrix& K, std::span<const double> D, Matrix& S);

// The symmetric matrix whose upper triangle A keeps, with both triangles; K follows its pattern, which is
// made anew if `of`, the version of the pattern of which it was made, is another one.
void mirror(const Matrix& A, std::uint64_t& of, Matrix& K);

}  // namespace fabricsh::linear
