#include "files/table.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "files/source.hpp"
#include "files/table_line.hpp"

namespace fabricsh::files {

namespace {

using Cells = std::vector<std::string_view>;

bool all_numbers(const Cells& cells, char decimal) {
  double value = 0;
  return !cells.empty() && std::all_of(cells.begin(), cells.end(), [&](std::string_view cell) {
    return parse_cell(cell, decimal, value);
  });
}

bool carries_data(std::string_view line) { return !trimmed(line).empty() && !is_comment(line); }

struct Reading {  // how a file can be read, and where its numbers begin
  TableForm form;
  std::size_t columns = 0;
  std::size_t place = 0;  // byte of the first line of numbers
};

// The next line that carries data, or an empty one at the end.
std::string_view next_data_line(Source& source) {
  std::string_view line;
  while (source.next_line(line))
    if (carries_data(line)) return line;
  return {};
}

// Whether the lines from here on (four at most) are numbers in equally many cells.
std::size_t columns_from(Source source, const TableForm& form) {
  Cells cells;
  std::size_t columns = 0;
  for (int i = 0; i < 4; ++i) {
    const auto line = next_data_line(source);
    if (line.empty()) return columns;
    split_line(line, form.separator, cells);
    if (!all_numbers(cells, form.decimal)) return 0;
    if (columns != 0 && cells.size() != columns) return 0;
    columns = cells.size();
  }
  return columns;
}

// Where numbers begin when the file is read in this form; columns 0 when nowhere in the first 200 lines.
Reading try_form(Source source, const TableForm& form) {
  for (int i = 0; i < 200 && !source.ended(); ++i) {
    Reading reading{form, 0, source.place()};
    reading.columns = columns_from(source, form);
    std::string_view line;
    source.next_line(line);
    if (reading.columns != 0 && carries_data(line)) return reading;
  }
  return {};
}

// Of the forms that fit, the one whose numbers begin first, and with most columns.
Reading find_reading(const Source& source, const TableForm& given) {
  Reading best;
  for (const char separator : {'\t', ';', ',', ' '}) {
    if (given.separator != 0 && given.separator != separator) continue;
    for (const char decimal : {'.', ','}) {
      if (given.decimal != 0 && given.decimal != decimal) continue;
      if (separator == decimal) continue;
      const Reading reading = try_form(source, {separator, decimal});
      if (reading.columns == 0) continue;
      const bool earlier =
          reading.place < best.place || (reading.place == best.place && reading.columns > best.columns);
      if (best.columns == 0 || earlier) best = reading;
    }
  }
  if (best.columns == 0)
    throw Error(source.name() +
                ":1: expected lines of numbers (columns parted by comma, semicolon, tab or "
                "blanks; decimal point or comma), found none in the first 200 lines");
  return best;
}

// A line without digits in any cell, as wide as the table: names, or units below them.
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
  std::size_t last = above.size();  // one behind the lowest heading line
  while (last > 0 && !is_heading(above[last - 1], reading, cells)) --last;
  if (last == 0) return;
  table.header = true;
  // Two heading lines: the lower one holds units (it may leave some out).
  const bool units = last > 1 && is_heading(above[last - 2], reading, below);
  const Cells& names = units ? below : cells;
  for (std::size_t i = 0; i < reading.columns; ++i) {
    table.columns[i] = heading(names[i]);
    if (units && table.columns[i].unit.empty()) table.columns[i].unit = bare(cells[i]);
  }
}

[[noreturn]] void bad_row(const Source& source, const Table& table, const Cells& cells) {
  if (cells.size() != table.columns.size())
    source.fail("expected " + std::to_string(table.columns.size()) + " cells, got " +
                std::to_string(cells.size()));
  double value = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!parse_cell(cells[i], table.form.decimal, value))
      source.fail("column '" + table.columns[i].name + "': expected a finite number" +
                  (table.form.decimal == ',' ? " with a decimal comma" : "") + ", got " +
                  in_quotes(cells[i]));
  source.fail("expected a row of numbers");
}

// A line above the numbers that is one of them but for a cell: a wrong row, not a preamble.
void check_above(const Source& source, const Table& table, std::string_view line, bool begun, bool last) {
  Cells cells;
  split_line(line, table.form.separator, cells);
  double value = 0;
  const bool some = std::any_of(cells.begin(), cells.end(),
                                [&](auto cell) { return parse_cell(cell, table.form.decimal, value); });
  if (begun || (last && some && cells.size() == table.columns.size())) bad_row(source, table, cells);
}

void read_preamble(Table& table, Source source, const Reading& reading) {
  std::vector<std::string_view> above;
  std::vector<std::size_t> places;
  std::string_view line;
  while (source.place() < reading.place) {
    const std::size_t place = source.place();
    source.next_line(line);
    if (trimmed(line).empty()) continue;
    table.preamble.emplace_back(trimmed(line));
    if (is_comment(line)) continue;
    above.push_back(line);
    places.push_back(place);
  }
  name_columns(table, above, reading);
  Cells cells;
  bool begun = false;
  for (std::size_t i = 0; i < above.size(); ++i) {
    split_line(above[i], reading.form.separator, cells);
    const bool numbers = cells.size() == reading.columns && all_numbers(cells, reading.form.decimal);
    source.move_to(places[i]);
    if (!numbers) check_above(source, table, above[i], begun, i + 1 == above.size());
    begun = begun || numbers;
  }
}

void read_rows(Table& table, Source& source) {
  Cells cells;
  std::string_view line;
  while (source.next_line(line)) {
    if (!carries_data(line)) continue;
    split_line(line, table.form.separator, cells);
    if (cells.size() != table.columns.size()) bad_row(source, table, cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      double value = 0;
      if (!parse_cell(cells[i], table.form.decimal, value)) bad_row(source, table, cells);
      table.columns[i].values.push_back(value);
    }
  }
}

}  // namespace

Table parse_table(const std::string& name, std::string_view bytes, const TableForm& form) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    throw Error(name + ":1: expected plain text (UTF-8), got UTF-16; save it as UTF-8");
  Source source(name, bytes);
  const Reading reading = find_reading(source, form);
  Table table;
  table.form = reading.form;
  read_preamble(table, source, reading);
  source.move_to(reading.place);
  read_rows(table, source);
  return table;
}

Table read_table(const std::string& path, const TableForm& form) {
  return parse_table(path, read_file(path), form);
}

}  // namespace fabricsh::files
