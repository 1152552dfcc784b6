// A square sparse matrix in compressed columns: a pattern, which may be shared and grows by being made anew,
// and the values of its entries.
#pragma once
#include <cassert>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace fabricsh::linear {

using Index = std::int64_t;

// Where a matrix may have entries. Made once, never changed: what couples otherwise gets a pattern of its
// own, with another version, which tells a solver to analyse anew.
class Pattern {
 public:
  Pattern() : Pattern(std::vector<std::vector<Index>>{}) {}
  // columns[c]: the rows of column c, in any order, repeated or not; emptied on the way.
  explicit Pattern(std::vector<std::vector<Index>>&& columns);
  // Ready arrays: size + 1 starts, and the rows ascending in each column.
  Pattern(std::vector<Index> column, std::vector<Index> row);

  Index size = 0;
  std::vector<Index> column;  // size + 1 starts
  std::vector<Index> row;     // ascending in each column
  std::uint64_t version = 0;  // no two patterns of a program have the same

  Index entries() const { return static_cast<Index>(row.size()); }
  // The place of an entry among the values. An entry outside the pattern is a bug: asserted in debug builds,
  // and in release builds an exception rather than a neighbour's entry.
  Index slot(Index r, Index c) const;
  // This pattern with further entries, columns as in the constructor.
  Pattern with(std::vector<std::vector<Index>>&& further) const;
};

struct Matrix {
  Matrix() : Matrix(std::make_shared<const Pattern>()) {}
  explicit Matrix(std::shared_ptr<const Pattern> p)
      : pattern(std::move(p)), value(static_cast<std::size_t>(pattern->entries()), 0.0) {}
  std::shared_ptr<const Pattern> pattern;
  std::vector<double> value;

  Index size() const { return pattern->size; }
  void add(Index r, Index c, double v) { value[static_cast<std::size_t>(pattern->slot(r, c))] += v; }
  void clear();  // all entries zero
  // Takes another pattern where its version differs; the values are then zero.
  void follow(const std::shared_ptr<const Pattern>& p);
  // Takes another pattern with all values. One outside of it must be zero: a bug otherwise, as in add().
  void carry(const std::shared_ptr<const Pattern>& p);
};

}  // namespace fabricsh::linear
