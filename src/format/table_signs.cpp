#include "format/table_signs.hpp"

#include <algorithm>
#include <limits>

#include "format/table_line.hpp"
#include "format/table_rows.hpp"

namespace fabricsh::format {

namespace {

constexpr std::string_view digits = "0123456789";

bool is_digit(char c) { return digits.find(c) != digits.npos; }

char other_sign(char sign) { return sign == '.' ? ',' : '.'; }

// Bytes of a blank at `at`: a plain one, or one that does not break.
std::size_t blank_at(std::string_view cell, std::size_t at) {
  for (const std::string_view blank : {" ", "\u00a0", "\u202f", "\u2009"})
    if (cell.substr(at).starts_with(blank)) return blank.size();
  return 0;
}

// Whether the e at this place belongs to a power of ten.
bool is_power(std::string_view cell, std::size_t at) {
  if ((cell[at] != 'e' && cell[at] != 'E') || at == 0 || at + 1 == cell.size()) return false;
  const std::size_t next = cell[at + 1] == '+' || cell[at + 1] == '-' ? at + 2 : at + 1;
  return next < cell.size() && is_digit(cell[next]) && (is_digit(cell[at - 1]) || cell[at - 1] == '.');
}

bool may_be_unit(std::string_view unit) {
  constexpr std::size_t longest = 12;
  if (unit.empty() || unit.size() > longest || is_digit(unit.front())) return false;
  if (!has_letter(unit.substr(0, 1)) && unit.front() != '%' && unit.front() != '"') return false;
  return unit.find_first_of(" \t;,|:") == unit.npos;
}

}  // namespace

Measured measured(std::string_view cell) {
  std::size_t at = 0, end = 0;
  for (; at < cell.size(); ++at) {
    const char c = cell[at];
    if (const std::size_t blank = blank_at(cell, at)) {
      at += blank - 1;
      continue;
    }
    if (!is_digit(c) && std::string_view("+-.,'").find(c) == std::string_view::npos && !is_power(cell, at))
      break;
    end = at + 1;
  }
  const std::string_view unit = trimmed(cell.substr(at));
  if (end == 0 || !may_be_unit(unit)) return {cell, {}};
  return {trimmed(cell.substr(0, end)), unit};
}

bool is_number_in_either_sign(std::string_view cell) {
  double value = 0;
  const auto fits = [&](std::string_view number) {
    return parse_cell(number, {0, '.'}, value) || parse_cell(number, {0, ','}, value);
  };
  if (fits(cell)) return true;
  const Measured parts = measured(cell);
  return !parts.unit.empty() && fits(parts.number);
}

void ColumnSigns::take(std::string_view cell, std::size_t) {
  const bool point = cell.find('.') != cell.npos, comma = cell.find(',') != cell.npos;
  if (!point && !comma) {
    if (integers_++ == 0) integer_ = cell;
    const auto count = std::count_if(cell.begin(), cell.end(), is_digit);
    large_integer_ = large_integer_ || (count == 3 && cell.find_first_of("eE'") == cell.npos);
    return;
  }
  if (point && comma) {  // the last of the two is the decimal sign
    Sign& sign = cell.rfind('.') > cell.rfind(',') ? point_ : comma_;
    if (sign.clear++ == 0) sign.clear_example = cell;
    return;
  }
  Sign& sign = point ? point_ : comma_;
  const char mark = point ? '.' : ',';
  if (std::count(cell.begin(), cell.end(), mark) > 1) {  // 1.234.567: the other sign is the decimal one
    Sign& other = point ? comma_ : point_;
    if (other.clear++ == 0) other.clear_example = cell;
  } else if (may_be_group(cell, mark)) {
    if (sign.groups++ == 0) sign.group_example = cell;
    sign.trailing_zero = sign.trailing_zero || cell.ends_with('0');
  } else if (sign.clear++ == 0) {
    sign.clear_example = cell;
  }
}

std::string_view ColumnSigns::example(char sign) const {
  const Sign& one = sign == '.' ? point_ : comma_;
  return one.clear > 0 ? one.clear_example : one.group_example;
}

bool ColumnSigns::looks_like_thousands(char sign) const {
  const Sign& one = sign == '.' ? point_ : comma_;
  return one.groups > 0 && one.clear == 0 && integers_ > 0 && (one.trailing_zero || large_integer_);
}

std::string doubt_of(const ColumnSigns& signs, char decimal) {
  if (!signs.looks_like_thousands(decimal)) return {};
  const std::string example(signs.example(decimal));
  std::string without = example;
  without.erase(without.find(decimal), 1);
  std::string words = "'" + example + "' is read as a number with decimals";
  words += ", but '" + std::string(signs.integer()) + "' stands beside it without any: if its " +
           (decimal == '.' ? "point" : "comma") + " stands between thousands (" + without +
           "), give thousands='" + decimal + "', if not, thousands='none'";
  return words;
}

void EitherCells::take(const std::vector<std::string_view>& cells, std::size_t place) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    Column& column = columns_[i];
    if (is_number_in_either_sign(cells[i])) column.signs.take(measured(cells[i]).number, column.cells.size());
    column.cells.push_back(cells[i]);
  }
  places_.push_back(place);
}

namespace {

// The signs of a column, a reason to doubt them, or why they cannot be told.
struct Verdict {
  TableForm form;
  std::string doubt, trouble;
};

std::string name_of(char sign) { return sign == '.' ? "point" : "comma"; }

// The decimal sign that other columns show, with the name of one of them; 0 if none does or both are shown.
struct Shown {
  char sign = 0;
  std::string column, example;
  std::size_t place = 0;
};

Verdict verdict_of(const ColumnSigns& signs, const Shown& file, std::size_t place, bool no_thousands) {
  for (const char sign : {'.', ','}) {
    if (!signs.shows(sign)) continue;
    const char other = other_sign(sign);
    if (signs.shows(other))
      return {{0, sign},
              {},
              "decimal points and decimal commas in one column: '" + std::string(signs.example('.')) +
                  "' and '" + std::string(signs.example(',')) + "'; write all with one sign"};
    Verdict out{{0, sign, false, signs.groups(other) > 0 ? other : char{0}}, {}, {}};
    if (file.sign != 0 && file.sign != sign && file.place < place)
      out.doubt = "'" + std::string(signs.example(sign)) + "' is read with a decimal " + name_of(sign) +
                  ", where column '" + file.column + "' has a decimal " + name_of(file.sign) + " ('" +
                  file.example + "')";
    return out;
  }
  if (signs.groups('.') > 0 && signs.groups(',') > 0)
    return {{0, '.'},
            {},
            "points and commas in one column: '" + std::string(signs.example('.')) + "' and '" +
                std::string(signs.example(',')) + "'; write all with one sign"};
  const char sign = signs.groups(',') > 0 ? ',' : '.';
  if (signs.groups(sign) == 0 || no_thousands || file.sign == 0 || file.sign == sign)
    return {{0, sign}, {}, {}};
  const std::string beside =
      "column '" + file.column + "' has a decimal " + name_of(file.sign) + " ('" + file.example + "')";
  const std::string example(signs.example(sign));
  std::string without = example;
  without.erase(without.find(sign), 1);
  if (signs.has_integers())
    return {{0, file.sign, false, sign},
            "'" + example + "' is read as " + without + ", its " + name_of(sign) +
                " between thousands, since " + beside + " and '" + std::string(signs.integer()) +
                "' has no decimals; thousands='none' reads it with decimals",
            {}};
  return {{0, file.sign},
          {},
          "'" + example + "' may be " + without + " or a number with decimals: " + beside +
              "; give thousands='" + sign + "' or thousands='none'"};
}

// The unit that the numbers of a column carry; empty if they carry none. Sets the trouble if they differ.
std::string_view unit_in(const std::vector<std::string_view>& cells, std::string_view of_heading,
                         std::string& trouble) {
  std::string_view unit;
  bool without = false;
  for (const auto cell : cells) {
    if (is_missing(cell) || !is_number_in_either_sign(cell)) continue;
    const std::string_view own = measured(cell).unit;
    if (!unit.empty() && !own.empty() && unit != own)
      trouble = "its numbers carry different units, " + in_quotes(unit) + " and " + in_quotes(own);
    if (unit.empty()) unit = own;
    without = without || own.empty();
  }
  if (trouble.empty() && !unit.empty() && of_heading.empty() && without)
    trouble = "some of its numbers carry the unit " + in_quotes(unit) + ", others none";
  if (trouble.empty() && !unit.empty() && !of_heading.empty() && unit != of_heading)
    trouble =
        "its numbers carry the unit " + in_quotes(unit) + ", its heading names " + in_quotes(of_heading);
  return unit;
}

// Parses the cells of a column in its form; returns how many are no numbers.
std::size_t fill(TableColumn& column, const std::vector<std::string_view>& cells, Verdict verdict,
                 const std::vector<std::size_t>& places, const Source& source) {
  const std::string_view unit = unit_in(cells, column.unit, verdict.trouble);
  if (column.unit.empty()) column.unit = unit;
  std::size_t bad = 0;
  const auto fail = [&](std::size_t row, const std::string& words) {
    if (!column.error.empty()) return;
    Source at = source;
    at.move_to(places[row]);
    std::string_view line;
    at.next_line(line);
    column.error = words.empty() ? cell_error(at, verdict.form, column.name, cells[row])
                                 : at.at_place("column '" + column.name + "': " + words);
    column.error_row = row;
  };
  for (std::size_t row = 0; row < cells.size(); ++row) {
    const std::string_view cell = unit.empty() ? cells[row] : measured(cells[row]).number;
    double value = 0;
    if (verdict.trouble.empty() && parse_cell(cell, verdict.form, value)) {
      column.text = false;
    } else {
      value = std::numeric_limits<double>::quiet_NaN();
      if (!is_missing(cell)) ++bad;
      fail(row, is_missing(cell) || !is_number_in_either_sign(cell) ? std::string() : verdict.trouble);
    }
    column.values.push_back(value);
  }
  return bad;
}

// The decimal sign that the columns but one show; none if they differ.
Shown shown_beside(const std::vector<TableColumn>& columns, const std::vector<const ColumnSigns*>& signs,
                   std::size_t but) {
  Shown shown;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (i == but) continue;
    for (const char sign : {'.', ','}) {
      if (!signs[i]->shows(sign)) continue;
      if (shown.sign != 0 && shown.sign != sign) return {};
      if (shown.sign == 0) shown = {sign, columns[i].name, std::string(signs[i]->example(sign)), i};
    }
  }
  return shown;
}

}  // namespace

std::size_t EitherCells::settle(Table& table, const Source& source, const TableForm& asked) const {
  std::vector<const ColumnSigns*> signs;
  for (const Column& column : columns_) signs.push_back(&column.signs);
  std::size_t bad = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Verdict verdict = verdict_of(columns_[i].signs, shown_beside(table.columns, signs, i), i,
                                       asked.thousands == kNoThousands);
    table.columns[i].doubt = verdict.doubt;
    bad += fill(table.columns[i], columns_[i].cells, verdict, places_, source);
  }
  return bad;
}

}  // namespace fabricsh::format
