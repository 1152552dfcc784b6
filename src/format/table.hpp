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
  char decimal = 0;      // '.' or ','; 0: found from the file; '?': every column by itself (table_signs.hpp)
  bool lenient = false;  // a cell that is not a number is recorded in its column instead of an exception
  char thousands = 0;    // '.' or ',': this sign stands between thousands wherever it occurs; 'n': none does
};

struct TableColumn {
  std::string name;  // from the header, without the unit; "1", "2", ... without a header
  // As written: in brackets after the name, or in a line of units; may be empty.
  std::string unit;
  std::vector<double> values;  // finite, or NaN where the cell is not a number
  bool text = true;            // no cell is a number (dates, labels)
  std::string error;           // message for the first cell that is not a number; empty: none
  std::size_t error_row = 0;   // the row of that cell
  std::vector<std::string>
      words;          // every cell as written, in a column with a cell that is no number; else empty
  std::string doubt;  // what else its numbers may mean; empty: nothing
  // Its cells in the lines of headings, from above, where there are three lines or more; else empty.
  std::vector<std::string> heads;
};

// A line below the rows that is none of them: words, or totals (mean, maximum) behind words or without a
// time.
struct LeftOut {
  std::size_t line;
  std::string text;
  bool numbers;  // whether it has any
};

struct Table {
  std::vector<TableColumn> columns;   // all of the same length
  std::vector<std::string> preamble;  // lines before the header, comments among them
  TableForm form;
  bool header = false;
  std::string name;                // of the file, and of the sheet if it is a spreadsheet: "pull.csv"
  std::string sheet;               // of a spreadsheet; empty of a text
  std::vector<std::size_t> lines;  // of the file, counted from 1, for each row
  std::vector<LeftOut> left_out;
};

// Reads the whole file. Error: "pull.csv:12: column 'force': expected a number, got 'abc'", a row with
// another number of cells, or no numbers at all. A column that has only text is no error: its values are NaN.
// A file in which a heading occurs again holds several tables: each with the lines above it as its
// preamble. A spreadsheet (.xlsx) has one or more on each sheet that has numbers; it is read by openpyxl, a
// module of Python.
std::vector<Table> read_tables(const std::string& path, const TableForm& form = {});
// Reads tables from bytes in memory; name is used in errors in place of the path.
std::vector<Table> parse_tables(const std::string& name, std::string_view bytes, const TableForm& form = {});
// The same of a file with one table. Tables under equal headings whose first column goes on from each to the
// next are one, as testing machines write that repeat the heading above each block. Error: there are several.
Table read_table(const std::string& path, const TableForm& form = {});
Table parse_table(const std::string& name, std::string_view bytes, const TableForm& form = {});
// Throws the error for the first cell that is not a number in a column of numbers.
void check(const Table& table);

}  // namespace fabricsh::format
