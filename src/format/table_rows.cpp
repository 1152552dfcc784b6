#include "format/table_rows.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "base/error.hpp"
#include "format/table_line.hpp"
#include "format/table_signs.hpp"

namespace fabricsh::format {

bool carries_data(std::string_view line) { return !trimmed(line).empty() && !is_comment(line); }

bool is_blank_row(std::string_view line, char separator) {
  if (line.find(separator) == line.npos) return false;
  return std::all_of(line.begin(), line.end(), [&](char c) {
    return c == separator || c == ' ' || c == '\t' || c == '\r' || c == '"';
  });
}

void split_row(std::string_view line, char separator, std::size_t columns, Cells& cells) {
  split_line(line, separator, cells);
  if (cells.size() + 1 == columns && separator != ' ' && line.find_last_of(separator) != line.npos &&
      trimmed(line.substr(line.find_last_of(separator) + 1)).empty())
    cells.emplace_back();
}

namespace {

// Advice for a cell that is a number if the sign that is not the decimal one stands between thousands.
std::string thousands_advice(std::string_view cell, TableForm form) {
  form.thousands = form.decimal == ',' ? '.' : ',';
  double value = 0;
  if (!parse_cell(cell, form, value)) return {};
  return std::string("; if its ") + (form.thousands == '.' ? "point" : "comma") +
         " stands between thousands, give thousands='" + form.thousands + "'";
}

}  // namespace

std::string cell_error(const Source& source, const TableForm& form, const std::string& column,
                       std::string_view cell) {
  const bool unclear = form.separator == ',' && may_be_thousands(cell);
  return source.at_place("column '" + column + "': expected a finite number" +
                         (form.decimal == ',' && !unclear ? " with a decimal comma" : "") + ", got " +
                         in_quotes(cell) +
                         (unclear ? ": its comma may be a decimal sign or stand between thousands; give "
                                    "decimal=',', or write such numbers without it"
                                  : thousands_advice(cell, form)));
}

namespace {

std::size_t count_numbers(const Cells& cells, const TableForm& form) {
  double value = 0;
  return static_cast<std::size_t>(std::count_if(
      cells.begin(), cells.end(), [&](std::string_view cell) { return parse_cell(cell, form, value); }));
}

// Names or units: at least two cells that have a letter (or are a sign of a unit), no number, no name twice.
bool may_be_heading(const Cells& cells, const TableForm& form) {
  std::set<std::string_view> names;
  std::size_t filled = 0;
  for (const auto cell : cells) {
    if (cell.empty()) continue;
    if (!has_letter(cell) && cell != "%" && cell != "#") return false;
    ++filled;
    names.insert(cell);
  }
  return filled >= 2 && names.size() == filled && count_numbers(cells, form) == 0;
}

// Units below a heading may repeat, and the last ones may be missing.
bool may_be_units(const Cells& cells, std::size_t columns, const TableForm& form) {
  return cells.size() <= columns && count_numbers(cells, form) == 0 &&
         std::any_of(cells.begin(), cells.end(), [](std::string_view cell) { return !cell.empty(); });
}

bool is_row(std::string_view line, std::size_t columns, const TableForm& form) {
  Cells cells;
  split_row(line, form.separator, columns, cells);
  return cells.size() == columns && count_numbers(cells, form) >= std::min<std::size_t>(2, columns);
}

bool next_data(Source& source, std::string_view& line) {
  while (source.next_line(line))
    if (carries_data(line)) return true;
  return false;
}

// If `line`, after which the source continues, is a heading above rows: their columns and first byte.
bool heads_rows(Source source, std::string_view line, const TableForm& form, TableHeading& head) {
  Cells cells;
  split_line(line, form.separator, cells);
  if (!may_be_heading(cells, form)) return false;
  head.columns = cells.size();
  head.above.push_back(line);
  std::string_view below;
  for (int i = 0; i < 2; ++i) {
    head.rows = source.place();
    if (!next_data(source, below)) break;
    if (is_row(below, head.columns, form)) return true;
    split_line(below, form.separator, cells);
    if (!may_be_units(cells, head.columns, form)) break;
    head.above.push_back(below);
  }
  head.above.pop_back();
  return false;
}

// A heading without the number of a specimen at its end: "Load" of "Load 2".
std::string_view without_number(std::string_view name) {
  return name.substr(0, name.find_last_not_of("0123456789 _.-#()[]") + 1);
}

// The rows of one table being read.
class TableRowReader {
 public:
  TableRowReader(Table& table, Source& source) : table_(table), source_(source) {
    const TableColumn& first = table.columns.front();
    beside_ = std::any_of(table.columns.begin() + 1, table.columns.end(), [&](const TableColumn& other) {
      return table.header && !first.name.empty() && without_number(other.name) == without_number(first.name);
    });
  }

  // Whether a line may be the first that is no row: another number of cells, a word where numbers stood, no
  // time.
  bool stands_out(const Cells& cells) const {
    if (cells.size() != table_.columns.size()) return true;
    double value = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (table_.columns[i].text) {
        if (has_letter(cells[i].substr(0, 1)) && is_total(cells[i])) return true;
      } else if (((i == 0 && !beside_) || !is_missing(cells[i])) &&
                 !parse_cell(cells[i], table_.form, value)) {
        return true;
      }
    }
    return false;
  }

  // Whether all lines from `line` to the next heading or to the end of the file are words and totals. Then
  // they are left out, or stand above the heading.
  bool end_at(std::string_view line, std::optional<TableHeading>& head) {
    constexpr int most = 60;  // lines between two tables
    Source ahead = source_;
    TableHeading found;
    found.text = static_cast<std::size_t>(line.data() - source_.bytes(0, source_.size()).data());
    std::vector<LeftOut> out;
    bool needs_heading = false;
    labels_.clear();
    for (int i = 0; i < most; ++i) {
      if (carries_data(line) && !is_blank_row(line, table_.form.separator)) {
        if (heads_rows(ahead, line, table_.form, found)) {
          keep(out, true);
          head = std::move(found);
          return true;
        }
        if (!is_no_row(line)) {
          if (!may_stand_above()) return false;
          needs_heading = true;
        }
        found.above.push_back(line);
        out.push_back({static_cast<std::size_t>(line.data() - whole().data()), std::string(trimmed(line)),
                       has_numbers(line)});
      }
      if (!ahead.next_line(line)) {
        if (!needs_heading) keep(out, false);
        return !needs_heading;
      }
    }
    return false;
  }

 private:
  std::string_view whole() const { return source_.bytes(0, source_.size()); }

  // Words without a number; words in front of numbers where numbers stood; totals by their word; numbers
  // without a time.
  bool is_no_row(std::string_view line) {
    split_row(line, table_.form.separator, table_.columns.size(), cells_);
    const std::size_t numbers = count_numbers(cells_, table_.form);
    if (numbers == 0) return has_letter(line);
    if (std::any_of(cells_.begin(), cells_.end(), [](auto cell) { return is_total(cell); })) return true;
    double value = 0;
    if (table_.columns.front().text || parse_cell(cells_[0], table_.form, value)) return false;
    if (cells_[0].empty()) return cells_.size() == table_.columns.size();
    return has_letter(cells_[0].substr(0, 1)) && labels_.insert(cells_[0]).second;
  }

  // Whether the line that was split last, which has numbers or no letter, can stand above a heading: a name
  // such as "1 _ 2", or numbers behind words, but not as many cells as a row has.
  bool may_stand_above() const {
    return cells_.size() != table_.columns.size() &&
           (cells_.size() == 1 || has_letter(cells_[0].substr(0, 1)));
  }

  // Whether the line that was split last has a number, or a total with its number and unit in one cell.
  bool has_numbers(std::string_view line) const {
    return count_numbers(cells_, table_.form) > 0 ||
           (line.find_first_of("0123456789") != line.npos &&
            std::any_of(cells_.begin(), cells_.end(), [](auto cell) { return is_total(cell); }));
  }

  // Above the next heading only totals are reported: the other lines describe what follows.
  void keep(std::vector<LeftOut>& out, bool above_heading) {
    for (LeftOut& one : out) {
      if (above_heading &&
          !(one.numbers && is_total(one.text.substr(one.text.find_first_not_of("\"',;\t ")))))
        continue;
      one.line = static_cast<std::size_t>(std::count(
                     whole().begin(), whole().begin() + static_cast<std::ptrdiff_t>(one.line), '\n')) +
                 1;
      table_.left_out.push_back(std::move(one));
    }
  }

  Table& table_;
  Source& source_;
  bool beside_;  // whether specimens stand side by side, of which the first may end before the others
  Cells cells_;
  std::set<std::string_view> labels_;
};

// Numbers in quotes of a file with commas between the cells have a decimal comma, unless none of them shows
// that its comma does not stand between thousands: then they are no numbers.
class CommaCells {
 public:
  explicit CommaCells(const TableForm& form)
      : counts_(form.separator == ',' && form.decimal == ',' && form.thousands == 0) {}

  void take(std::string_view cell, std::size_t column, std::size_t row, const std::string& name,
            const Source& source, const TableForm& form) {
    if (!counts_ || decided_ || cell.find(',') == cell.npos) return;
    decided_ = !may_be_thousands(cell);
    if (decided_) return;
    unclear_.push_back({column, row,
                        unclear_.empty() || unclear_.back().column != column
                            ? cell_error(source, form, name, cell)
                            : std::string()});
  }

  // Returns the number of cells taken back.
  std::size_t settle(Table& table) const {
    if (decided_) return 0;
    for (const Cell& cell : unclear_) {
      TableColumn& column = table.columns[cell.column];
      column.values[cell.row] = std::numeric_limits<double>::quiet_NaN();
      if (!column.error.empty() && column.error_row < cell.row) continue;
      if (cell.error.empty()) continue;
      column.error = cell.error;
      column.error_row = cell.row;
    }
    return unclear_.size();
  }

 private:
  struct Cell {
    std::size_t column, row;
    std::string error;
  };
  bool counts_, decided_ = false;
  std::vector<Cell> unclear_;
};

// The signs of all columns, while they are read.
using Signs = std::vector<ColumnSigns>;

// Appends a row; returns the number of its cells that hold something else than a number.
std::size_t append(Table& table, const Cells& cells, const Source& source, CommaCells& commas, Signs& signs) {
  std::size_t bad = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    TableColumn& column = table.columns[i];
    double value = 0;
    if (parse_cell(cells[i], table.form, value)) {
      column.text = false;
      commas.take(cells[i], i, column.values.size(), column.name, source, table.form);
      if (!signs.empty()) signs[i].take(cells[i], column.values.size());
    } else {
      value = std::numeric_limits<double>::quiet_NaN();
      if (!is_missing(cells[i])) ++bad;
      if (column.error.empty()) {
        column.error = cell_error(source, table.form, column.name, cells[i]);
        column.error_row = column.values.size();
      }
    }
    column.values.push_back(value);
  }
  return bad;
}

// The lines of the rows, and the words of the columns that have some, once all rows are known.
void look_back(Table& table, const Source& source, const std::vector<std::size_t>& places) {
  const std::string_view all = source.bytes(0, source.size());
  const bool words = std::any_of(table.columns.begin(), table.columns.end(),
                                 [](const TableColumn& column) { return !column.error.empty(); });
  Cells cells;
  std::size_t at = 0, line = 1;
  table.lines.reserve(places.size());
  for (const std::size_t place : places) {
    line += static_cast<std::size_t>(std::count(all.begin() + static_cast<std::ptrdiff_t>(at),
                                                all.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
    at = place;
    table.lines.push_back(line);
    if (!words) continue;
    Source row = source;
    row.move_to(place);
    std::string_view text;
    row.next_line(text);
    split_row(text, table.form.separator, table.columns.size(), cells);
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (!table.columns[i].error.empty()) table.columns[i].words.emplace_back(cells[i]);
  }
}

}  // namespace

std::optional<TableHeading> read_rows(Table& table, Source& source, const TableForm& asked,
                                      std::size_t& bad) {
  Cells cells;
  std::string_view line;
  std::vector<std::size_t> places;
  std::optional<TableHeading> head;
  TableRowReader rows(table, source);
  CommaCells commas(table.form);
  const bool either = table.form.decimal == kEitherSign;
  EitherCells columns(either ? table.columns.size() : 0);
  Signs signs(asked.decimal == 0 && asked.thousands == 0 && !either ? table.columns.size() : 0);
  for (std::size_t place = source.place(); source.next_line(line); place = source.place()) {
    if (!carries_data(line) || is_blank_row(line, table.form.separator)) continue;
    split_row(line, table.form.separator, table.columns.size(), cells);
    if (!places.empty() && rows.stands_out(cells) && rows.end_at(line, head)) break;
    if (cells.size() != table.columns.size())
      source.fail("expected " + std::to_string(table.columns.size()) + " cells, got " +
                  std::to_string(cells.size()));
    if (either)
      columns.take(cells, place);
    else
      bad += append(table, cells, source, commas, signs);
    places.push_back(place);
  }
  if (either) bad += columns.settle(table, source, asked);
  for (std::size_t i = 0; i < signs.size(); ++i)
    table.columns[i].doubt = doubt_of(signs[i], table.form.decimal);
  if (asked.decimal == 0) bad += commas.settle(table);
  look_back(table, source, places);
  return head;
}

}  // namespace fabricsh::format
