#include "format/table.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "format/plain_text.hpp"
#include "format/source.hpp"
#include "format/table_line.hpp"

namespace fabricsh::format {

namespace {

using Cells = std::vector<std::string_view>;

bool carries_data(std::string_view line) { return !trimmed(line).empty() && !is_comment(line); }

// Splits a row; if it has one cell less than `columns` and ends with the separator, the last cell is empty.
void split_row(std::string_view line, char separator, std::size_t columns, Cells& cells) {
  split_line(line, separator, cells);
  if (cells.size() + 1 == columns && separator != ' ' && line.find_last_of(separator) != line.npos &&
      trimmed(line.substr(line.find_last_of(separator) + 1)).empty())
    cells.emplace_back();
}

struct Reading {  // one way to read the file, and where its numbers then begin
  TableForm form;
  std::size_t columns = 0;
  std::size_t place = 0;  // byte of the first line of numbers
};

// The next line with data; empty at the end of the file.
std::string_view next_data_line(Source& source) {
  std::string_view line;
  while (source.next_line(line))
    if (carries_data(line)) return line;
  return {};
}

// The number of columns if the lines from here (at most four) are rows with equally
// many cells; the cells must be numbers, or with `text` at least two columns must be.
std::size_t columns_from(Source source, const TableForm& form, bool text) {
  Cells cells;
  std::vector<char> numeric;
  double value = 0;
  for (int i = 0; i < 4; ++i) {
    const auto line = next_data_line(source);
    if (line.empty()) break;
    split_row(line, form.separator, numeric.size(), cells);
    if (numeric.empty()) numeric.assign(cells.size(), 1);
    if (cells.size() != numeric.size()) return 0;
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (!parse_cell(cells[c], form.decimal, value)) numeric[c] = 0;
  }
  const auto count = static_cast<std::size_t>(std::count(numeric.begin(), numeric.end(), 1));
  return count == numeric.size() || (text && count >= 2) ? numeric.size() : 0;
}

// Finds where the numbers begin in this form; columns is 0 if they do not within the first 200 lines.
Reading try_form(Source source, const TableForm& form, bool text) {
  for (int i = 0; i < 200 && !source.ended(); ++i) {
    Reading reading{form, 0, source.place()};
    reading.columns = columns_from(source, form, text);
    std::string_view line;
    source.next_line(line);
    if (reading.columns != 0 && carries_data(line)) return reading;
  }
  return {};
}

// Among the forms that fit, those whose numbers begin first and that have the most columns.
// There are two if the first rows do not determine the decimal sign, and none if no form fits.
std::vector<Reading> find_readings(const Source& source, const TableForm& given, bool text) {
  std::vector<Reading> best;
  for (const char separator : {'\t', ';', ',', ' '}) {
    if (given.separator != 0 && given.separator != separator) continue;
    for (const char decimal : {'.', ','}) {
      if (given.decimal != 0 && given.decimal != decimal) continue;
      const Reading reading = try_form(source, {separator, decimal}, text);
      if (reading.columns == 0) continue;
      const auto rank = [](const Reading& r) {
        return std::pair(r.place, std::numeric_limits<std::size_t>::max() - r.columns);
      };
      if (!best.empty() && rank(reading) > rank(best[0])) continue;
      const bool tie = !best.empty() && rank(reading) == rank(best[0]);
      if (tie && separator != best[0].form.separator) continue;
      if (!tie) best.clear();
      best.push_back(reading);
    }
  }
  return best;
}

// A line with as many cells as the table, none with a digit: names or units.
bool is_heading(std::string_view line, const Reading& reading, Cells& cells) {
  split_line(line, reading.form.separator, cells);
  double value = 0;
  return cells.size() == reading.columns && std::none_of(cells.begin(), cells.end(), [&](auto cell) {
           return parse_cell(cell, reading.form.decimal, value);
         });
}

std::string_view bare(std::string_view cell) {
  if (cell.size() > 2 && std::string_view("([<{").find(cell.front()) != std::string_view::npos)
    return trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

void name_columns(Table& table, const std::vector<std::string_view>& above, const Reading& reading) {
  table.columns.resize(reading.columns);
  for (std::size_t i = 0; i < reading.columns; ++i) table.columns[i].name = std::to_string(i + 1);
  Cells cells, below;
  std::size_t last = above.size();  // index after the lowest heading line
  while (last > 0 && !is_heading(above[last - 1], reading, cells)) --last;
  if (last == 0) return;
  table.header = true;
  // Of two heading lines the lower one holds units; it may have gaps.
  const bool units = last > 1 && is_heading(above[last - 2], reading, below);
  const Cells& names = units ? below : cells;
  for (std::size_t i = 0; i < reading.columns; ++i) {
    table.columns[i] = heading(names[i]);
    if (units && table.columns[i].unit.empty()) table.columns[i].unit = bare(cells[i]);
  }
}

// Searches upwards from the first rows of numbers for rows in which some cell is not a number, until
// a line has no number at all (nor only missing values). Returns the position of the highest row.
std::size_t first_row(const std::vector<std::string_view>& above, const std::vector<std::size_t>& places,
                      const Reading& reading) {
  Cells cells;
  double value = 0;
  std::size_t first = reading.place;
  for (std::size_t i = above.size(); i-- > 0;) {
    split_row(above[i], reading.form.separator, reading.columns, cells);
    const bool some = std::any_of(cells.begin(), cells.end(),
                                  [&](auto cell) { return parse_cell(cell, reading.form.decimal, value); });
    if (!some && !(cells.size() == reading.columns && std::all_of(cells.begin(), cells.end(), is_missing))) {
      // What stands between the heading and the rows is a row, with too few cells or too many.
      if (cells.size() == reading.columns && i + 1 < above.size()) first = places[i + 1];
      break;
    }
    if (cells.size() == reading.columns) first = places[i];
  }
  return first;
}

// Names the columns from the lines above the rows; returns the position of the first row.
std::size_t read_preamble(Table& table, Source source, const Reading& reading) {
  std::vector<std::string_view> above;
  std::vector<std::size_t> places;
  std::string_view line;
  while (source.place() < reading.place) {
    const std::size_t place = source.place();
    source.next_line(line);
    if (!carries_data(line)) continue;
    above.push_back(line);
    places.push_back(place);
  }
  const std::size_t begin = first_row(above, places, reading);
  while (!places.empty() && places.back() >= begin) places.pop_back();
  above.resize(places.size());
  name_columns(table, above, reading);
  source.move_to(0);
  while (source.place() < begin) {
    source.next_line(line);
    if (!trimmed(line).empty()) table.preamble.emplace_back(trimmed(line));
  }
  return begin;
}

// Error message, with file and line, for a cell that is not a number.
std::string trouble_of(const Source& source, const TableForm& form, const std::string& column,
                       std::string_view cell) {
  const bool unclear = form.separator == ',' && may_be_thousands(cell);
  try {
    source.fail("column '" + column + "': expected a finite number" +
                (form.decimal == ',' && !unclear ? " with a decimal comma" : "") + ", got " +
                in_quotes(cell) +
                (unclear ? ": its comma may be a decimal sign or stand between thousands; give decimal=',', "
                           "or write such numbers without it"
                         : ""));
  } catch (const Error& error) {
    return error.what();
  }
}

// The heading above the rows: a line of names, perhaps with a line of units below; empty if there is none.
std::vector<std::string_view> heading_lines(Source source, const Reading& reading, std::size_t begin) {
  Cells cells;
  std::vector<std::string_view> lines;
  std::string_view line;
  source.move_to(0);
  while (source.place() < begin && source.next_line(line)) {
    if (!carries_data(line)) continue;
    if (is_heading(line, reading, cells))
      lines.push_back(trimmed(line));
    else
      lines.clear();
  }
  if (lines.size() > 2) lines.erase(lines.begin(), lines.end() - 2);
  return lines;
}

// Testing machines that write in blocks (MTS) repeat the heading above each block, below some lines
// of text. True: `line` is the first of these lines, and the source now stands after the heading.
bool pass_block_head(Source& source, std::string_view line, const std::vector<std::string_view>& heading) {
  constexpr int most = 20;  // lines of text between two blocks
  if (heading.empty()) return false;
  Source ahead = source;
  for (int i = 0; trimmed(line) != heading.front(); ++i)
    if (i == most || !ahead.next_line(line)) return false;
  for (std::size_t i = 1; i < heading.size(); ++i) {
    Source below = ahead;
    if (!below.next_line(line) || trimmed(line) != heading[i]) break;
    ahead = below;
  }
  source = ahead;
  return true;
}

// Whether a line may separate two blocks: no cell is a number, or the number of cells is not that of a row.
bool between_blocks(const Cells& cells, const Table& table) {
  double value = 0;
  return cells.size() != table.columns.size() || std::none_of(cells.begin(), cells.end(), [&](auto cell) {
           return parse_cell(cell, table.form.decimal, value);
         });
}

// Whether `line` and all lines below it are words: what a testing machine writes under the last row. A line
// with a number in one of its cells is a row that is cut short.
bool only_words_follow(Source ahead, std::string_view line, const Table& table) {
  constexpr int most = 20;
  Cells cells;
  double value = 0;
  for (int i = 0; i < most; ++i) {
    if (carries_data(line)) {
      split_row(line, table.form.separator, table.columns.size(), cells);
      for (const auto cell : cells)
        if (parse_cell(cell, table.form.decimal, value)) return false;
      if (std::none_of(line.begin(), line.end(), [](unsigned char c) { return std::isalpha(c) != 0; }))
        return false;
    }
    if (!ahead.next_line(line)) return true;
  }
  return false;
}

// Numbers in quotes of a file with commas between the cells have a decimal comma, unless none of them shows
// that its comma does not stand between thousands: then they are no numbers.
class CommaCells {
 public:
  explicit CommaCells(const TableForm& form) : counts_(form.separator == ',' && form.decimal == ',') {}

  void take(std::string_view cell, std::size_t column, std::size_t row, const std::string& name,
            const Source& source, const TableForm& form) {
    if (!counts_ || decided_ || cell.find(',') == cell.npos) return;
    decided_ = !may_be_thousands(cell);
    if (decided_) return;
    unclear_.push_back({column, row,
                        unclear_.empty() || unclear_.back().column != column
                            ? trouble_of(source, form, name, cell)
                            : std::string()});
  }

  // Returns the number of cells taken back.
  std::size_t settle(Table& table) const {
    if (decided_) return 0;
    for (const Cell& cell : unclear_) {
      TableColumn& column = table.columns[cell.column];
      column.values[cell.row] = std::numeric_limits<double>::quiet_NaN();
      if (!column.trouble.empty() && column.trouble_row < cell.row) continue;
      if (cell.trouble.empty()) continue;
      column.trouble = cell.trouble;
      column.trouble_row = cell.row;
    }
    return unclear_.size();
  }

 private:
  struct Cell {
    std::size_t column, row;
    std::string trouble;
  };
  bool counts_, decided_ = false;
  std::vector<Cell> unclear_;
};

// Reads the rows; returns the number of cells that are not numbers.
std::size_t read_rows(Table& table, Source& source, const std::vector<std::string_view>& heading,
                      const TableForm& asked) {
  Cells cells;
  std::string_view line;
  std::size_t bad = 0;
  CommaCells commas(table.form);
  while (source.next_line(line)) {
    if (!carries_data(line)) continue;
    split_row(line, table.form.separator, table.columns.size(), cells);
    if (between_blocks(cells, table) && pass_block_head(source, line, heading)) continue;
    if (cells.size() != table.columns.size() && !table.columns.front().values.empty() &&
        only_words_follow(source, line, table))
      break;
    if (cells.size() != table.columns.size())
      source.fail("expected " + std::to_string(table.columns.size()) + " cells, got " +
                  std::to_string(cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      TableColumn& column = table.columns[i];
      double value = 0;
      if (parse_cell(cells[i], table.form.decimal, value)) {
        column.text = false;
        commas.take(cells[i], i, column.values.size(), column.name, source, table.form);
      } else {
        value = std::numeric_limits<double>::quiet_NaN();
        ++bad;
        if (column.trouble.empty()) {
          column.trouble = trouble_of(source, table.form, column.name, cells[i]);
          column.trouble_row = column.values.size();
        }
      }
      column.values.push_back(value);
    }
  }
  return asked.decimal == 0 ? bad + commas.settle(table) : bad;
}

// Reads the table in one form; bad: number of cells that are not numbers.
Table read_as(Source source, const Reading& reading, const TableForm& asked, std::size_t& bad) {
  Table table;
  table.form = reading.form;
  const std::size_t begin = read_preamble(table, source, reading);
  const auto heading = heading_lines(source, reading, begin);
  source.move_to(begin);
  bad = read_rows(table, source, heading, asked);
  return table;
}

}  // namespace

Table parse_table(const std::string& name, std::string_view bytes, const TableForm& form) {
  std::string made;
  const Source source(name, plain_text(name, bytes, made));
  // Reads rows of numbers only, unless rows with text or gaps of the same form begin earlier.
  auto readings = find_readings(source, form, false);
  auto wider = find_readings(source, form, true);
  if (readings.empty() ||
      (!wider.empty() && wider[0].place < readings[0].place && wider[0].columns >= readings[0].columns &&
       wider[0].form.separator == readings[0].form.separator))
    readings = std::move(wider);
  if (readings.empty())
    throw Error(source.name() +
                ":1: expected lines of numbers (columns parted by comma, semicolon, tab or "
                "blanks; decimal point or comma), found none in the first 200 lines");
  std::size_t bad = 0;
  Table table = read_as(source, readings[0], form, bad);
  if (bad > 0 && readings.size() > 1) {  // later rows determine the decimal sign
    std::size_t other = 0;
    Table comma = read_as(source, readings[1], form, other);
    if (other < bad) table = std::move(comma);
  }
  if (!form.lenient) check(table);
  return table;
}

void check(const Table& table) {
  const TableColumn* first = nullptr;
  for (const TableColumn& column : table.columns)
    if (!column.text && !column.trouble.empty() && (!first || column.trouble_row < first->trouble_row))
      first = &column;
  if (first) throw Error(first->trouble);
}

Table read_table(const std::string& path, const TableForm& form) {
  return parse_table(path, read_file(path), form);
}

}  // namespace fabricsh::format
