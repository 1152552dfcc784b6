// Tables of numbers as laboratories write them: cells separated by commas,
// semicolons, tabs or blanks; decimal point or comma; with or without a header
// line, a line of units, comments, text above the table and a byte-order mark.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace fabricsh::format {

struct TableForm {
  char separator = 0;    // ',' ';' '\t' or ' ' (any run of blanks); 0: found from the file
  char decimal = 0;      // '.' or ','; 0: found from the file
  bool lenient = false;  // a cell that is not a number is recorded in its column instead of an exception
};

struct TableColumn {
  std::string name;  // from the header, without the unit; "1", "2", ... without a header
  // As written: in brackets after the name, or in a line of units; may be empty.
  std::string unit;
  std::vector<double> values;   // finite, or NaN where the cell is not a number
  bool text = true;             // no cell is a number (dates, labels)
  std::string trouble;          // message for the first cell that is not a number; empty: none
  std::size_t trouble_row = 0;  // the row of that cell
};

struct Table {
  std::vector<TableColumn> columns;   // all of the same length
  std::vector<std::string> preamble;  // lines before the header, comments among them
  TableForm form;
  bool header = false;
};

// Reads the whole file. Error: "pull.csv:12: column 'force': expected a number, got 'abc'", a row with
// another number of cells, or no numbers at all. A column that has only text is no error: its values are NaN.
Table read_table(const std::string& path, const TableForm& form = {});
// Reads a table from bytes in memory; name is used in errors in place of the path.
Table parse_table(const std::string& name, std::string_view bytes, const TableForm& form = {});
// Throws the error for the first cell that is not a number in a column of numbers.
void check(const Table& table);

}  // namespace fabricsh::format
