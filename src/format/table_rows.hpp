// The rows of a table and what ends them: the end of the file, words or totals below them, or the
// heading of the next table.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "format/source.hpp"
#include "format/table.hpp"

namespace fabricsh::format {

using Cells = std::vector<std::string_view>;

// Whether a line is neither empty nor a comment.
bool carries_data(std::string_view line);
// Whether a line has cells that are all empty: separators alone, as spreadsheets write empty rows.
bool is_blank_row(std::string_view line, char separator);
// Splits a row; if it has one cell less than `columns` and ends with the separator, the last cell is empty.
void split_row(std::string_view line, char separator, std::size_t columns, Cells& cells);
// Error message, with file and line, for a cell that is not a number.
std::string cell_error(const Source& source, const TableForm& form, const std::string& column,
                       std::string_view cell);

// The heading of a further table.
struct TableHeading {
  std::vector<std::string_view>
      above;             // lines with data from the end of the rows before; the last are the heading
  std::size_t text = 0;  // byte where these lines begin
  std::size_t columns = 0;
  std::size_t rows = 0;  // byte of the first row
};

// Reads the rows from the source's place into a table whose columns are named; adds the number of cells that
// are not numbers to `bad`. Returns the heading that ends them, none at the end of the file. `asked` is the
// form that was asked for, in which the decimal sign may be open.
std::optional<TableHeading> read_rows(Table& table, Source& source, const TableForm& asked, std::size_t& bad);

}  // namespace fabricsh::format
