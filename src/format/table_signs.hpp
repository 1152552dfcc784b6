// The decimal sign of each column by itself, and units in the cells: for files whose columns do not agree.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "format/source.hpp"
#include "format/table.hpp"

namespace fabricsh::format {

// The decimal sign of a form in which every column has its own, and numbers may carry their unit.
constexpr char kEitherSign = '?';
// The sign between thousands of a form in which none stands there.
constexpr char kNoThousands = 'n';

// A cell "12,5 N" as its number and its unit; the unit is empty if there is none. A unit is one short word
// without a separator in it.
struct Measured {
  std::string_view number, unit;
};
Measured measured(std::string_view cell);
// Whether the cell is a number with a decimal point or a decimal comma, and perhaps its unit.
bool is_number_in_either_sign(std::string_view cell);

// Evidence of a column's signs in its numbers, counted while the rows are read.
class ColumnSigns {
 public:
  void take(std::string_view cell, std::size_t row);
  // Whether some number shows that this sign is the decimal one: 0.25 and 1.5, but not 1.250.
  bool shows(char sign) const { return sign == '.' ? point_.clear > 0 : comma_.clear > 0; }
  // Numbers in which this sign may as well stand between thousands.
  std::size_t groups(char sign) const { return sign == '.' ? point_.groups : comma_.groups; }
  // An example with this sign.
  std::string_view example(char sign) const;
  // Whether numbers without a sign stand beside groups in a way that no one writes decimals: 0 beside 4.300,
  // 825 beside 1.075.
  bool looks_like_thousands(char sign) const;
  bool has_integers() const { return integers_ > 0; }
  std::string_view integer() const { return integer_; }

 private:
  struct Sign {
    std::size_t clear = 0, groups = 0;
    bool trailing_zero = false;
    std::string_view clear_example, group_example;
  };
  Sign point_, comma_;
  std::size_t integers_ = 0;
  bool large_integer_ = false;
  std::string_view integer_;
};

// The cells of a table that is read in the form with either sign; settle() gives every column its sign and
// its values, and its unit if the cells have one.
class EitherCells {
 public:
  explicit EitherCells(std::size_t columns) : columns_(columns) {}
  void take(const std::vector<std::string_view>& cells, std::size_t place);
  // Returns the number of cells that are no numbers. `source` is for the lines in messages.
  std::size_t settle(Table& table, const Source& source, const TableForm& asked) const;

 private:
  struct Column {
    std::vector<std::string_view> cells;
    ColumnSigns signs;
  };
  std::vector<Column> columns_;
  std::vector<std::size_t> places_;
};

// Says of a column that is read with the one decimal sign of its file where that sign may stand between
// thousands; empty if it does not look so.
std::string doubt_of(const ColumnSigns& signs, char decimal);

}  // namespace fabricsh::format
