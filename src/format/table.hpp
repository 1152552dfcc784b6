// Tables of numbers as laboratories write them: comma, semicolon, tab or blanks between the cells, decimal
// point or comma, with or without a header line and a line of units, comments and a preamble above, a
// byte-order mark.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace fabricsh::format {

struct TableForm {
  char separator = 0;    // ',' ';' '\t' or ' ' (any run of blanks); 0: found from the file
  char decimal = 0;      // '.' or ','; 0: found from the file
  bool lenient = false;  // cells that are no numbers are told by column, not thrown
};

struct TableColumn {
  std::string name;  // of the header without its unit; "1", "2", ... when there is none
  std::string
      unit;  // as written: in brackets of any kind behind the name, or in a line of units; may be empty
  std::vector<double> values;   // finite, or not a number where the cell is none
  bool text = true;             // no cell is a number (dates, labels)
  std::string trouble;          // message of the first cell that is no number; empty: there is none
  std::size_t trouble_row = 0;  // its row
};

struct Table {
  std::vector<TableColumn> columns;   // of one length
  std::vector<std::string> preamble;  // lines before the header, comments among them
  TableForm form;
  bool header = false;
};

// The whole file. Error "pull.csv:12: column 'force': expected a number, got 'abc'", or the row's number of
// cells, or that there are no numbers at all. A column of text alone is no error: its values are not numbers.
Table read_table(const std::string& path, const TableForm& form = {});
// The same of bytes in memory; name stands for the path in errors.
Table parse_table(const std::string& name, std::string_view bytes, const TableForm& form = {});
// Throws the trouble of the highest cell that is no number in a column of numbers.
void check(const Table& table);

}  // namespace fabricsh::format
