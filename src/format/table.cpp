#include "format/table.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "format/source.hpp"
#include "format/spreadsheet.hpp"
#include "format/table_line.hpp"
#include "format/table_rows.hpp"
#include "format/table_signs.hpp"

namespace fabricsh::format {

namespace {

// --- The bytes of a text file as UTF-8 or an older 8-bit alphabet, with lines that end with a line feed.

[[noreturn]] void refuse_text(const std::string& name, const std::string& got) {
  throw Error(name + ":1: expected plain text, got " + got);
}

void append_utf8(std::string& out, unsigned long code) {
  if (code < 0x80) {
    out += static_cast<char>(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  constexpr unsigned first[] = {0, 0xc0, 0xe0, 0xf0};
  out += static_cast<char>(first[more] | (code >> (6 * more)));
  for (int i = more; i-- > 0;) out += static_cast<char>(0x80 | ((code >> (6 * i)) & 0x3f));
}

// Half of a pair without its other half becomes the sign for an unknown character.
std::string from_utf16(std::string_view bytes, bool high_first) {
  const auto unit = [&](std::size_t at) {
    const auto a = static_cast<unsigned char>(bytes[at]), b = static_cast<unsigned char>(bytes[at + 1]);
    return high_first ? a * 256UL + b : b * 256UL + a;
  };
  std::string out;
  out.reserve(bytes.size() / 2);
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    unsigned long code = unit(at);
    if (code >= 0xd800 && code < 0xdc00 && at + 3 < bytes.size() && unit(at + 2) >= 0xdc00 &&
        unit(at + 2) < 0xe000) {
      code = 0x10000 + ((code - 0xd800) << 10) + (unit(at + 2) - 0xdc00);
      at += 2;
    } else if (code >= 0xd800 && code < 0xe000) {
      code = 0xfffd;
    }
    append_utf8(out, code);
  }
  return out;
}

// A line is split into cells in several ways, which takes many times its own memory.
void refuse_long_lines(const std::string& name, std::string_view bytes) {
  constexpr std::size_t most = std::size_t{16} << 20U;
  std::size_t number = 1;
  for (std::size_t at = 0; at < bytes.size(); ++number) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    if (end - at > most)
      throw Error(name + ":" + std::to_string(number) + ": expected a line of at most " +
                  std::to_string(most) + " bytes, got one of " + std::to_string(end - at));
    at = end + 1;
  }
}

// Removes a byte-order mark, and converts UTF-16 that begins with one and lines that end with carriage
// returns alone; `made` keeps converted text. Error, with the file's name: a spreadsheet, an archive, an
// empty file, a line of more than 16 MiB, or other bytes that no text has.
std::string_view plain_text(const std::string& name, std::string_view bytes, std::string& made) {
  if (bytes.starts_with("PK\x03\x04"))
    refuse_text(name, "a spreadsheet (.xlsx, .ods) or another archive; save the sheet as CSV");
  if (bytes.starts_with("\xD0\xCF\x11\xE0")) refuse_text(name, "a spreadsheet (.xls); save the sheet as CSV");
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    bytes = made = from_utf16(bytes.substr(2), bytes[0] == '\xFE');
  const std::string_view start = bytes.substr(0, 4096);
  if (start.find('\0') != start.npos)
    refuse_text(name,
                "bytes of value zero: a binary file, or UTF-16 without its mark; save it as text, UTF-8");
  if (bytes.find_first_not_of(" \t\r\n\f\v") == bytes.npos) refuse_text(name, "an empty file");
  if (bytes.find('\n') == bytes.npos && bytes.find('\r') != bytes.npos) {
    std::string lines(bytes);
    std::replace(lines.begin(), lines.end(), '\r', '\n');
    bytes = made = std::move(lines);
  }
  refuse_long_lines(name, bytes);
  return bytes;
}

// --- Ways to read a file.

struct TableReading {  // one way to read the file, and where its numbers then begin
  TableForm form;
  std::size_t columns = 0;
  std::size_t place = 0;  // byte of the first line of numbers
};

// The next line with data; empty at the end of the file.
std::string_view next_data_line(Source& source, char separator) {
  std::string_view line;
  while (source.next_line(line))
    if (carries_data(line) && !is_blank_row(line, separator)) return line;
  return {};
}

// Whether this line ends a short table: the heading of the next one after two rows at least, words or totals
// after three.
bool ends_rows(const Cells& cells, const std::vector<char>& numeric, const TableForm& form, int rows) {
  if (numeric.size() < 2 || rows < 2) return false;
  double value = 0;
  const auto words = std::count_if(cells.begin(), cells.end(), [&](auto cell) {
    return has_letter(cell) && !parse_cell(cell, form, value);
  });
  if (words == static_cast<std::ptrdiff_t>(cells.size())) return rows >= 3 || cells.size() == numeric.size();
  return rows >= 3 && numeric[0] && has_letter(cells[0].substr(0, 1));
}

// The number of columns if the lines from here (at most four) are rows with equally
// many cells; the cells must be numbers, or with `text` at least two columns must be.
std::size_t columns_from(Source source, const TableForm& form, bool text) {
  Cells cells;
  std::vector<char> numeric;
  double value = 0;
  for (int i = 0; i < 4; ++i) {
    const auto line = next_data_line(source, form.separator);
    if (line.empty()) break;
    split_row(line, form.separator, numeric.size(), cells);
    if (numeric.empty()) numeric.assign(cells.size(), 1);
    if (ends_rows(cells, numeric, form, i)) break;
    if (cells.size() != numeric.size()) return 0;
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (!parse_cell(cells[c], form, value)) numeric[c] = 0;
  }
  const auto count = static_cast<std::size_t>(std::count(numeric.begin(), numeric.end(), 1));
  return count == numeric.size() || (text && count >= 2) ? numeric.size() : 0;
}

// Finds where the numbers begin in this form; columns is 0 if they do not within the first 200 lines.
TableReading try_form(Source source, const TableForm& form, bool text) {
  for (int i = 0; i < 200 && !source.ended(); ++i) {
    TableReading reading{form, 0, source.place()};
    reading.columns = columns_from(source, form, text);
    std::string_view line;
    source.next_line(line);
    if (reading.columns != 0 && carries_data(line) && !is_blank_row(line, form.separator)) return reading;
  }
  return {};
}

// Among the forms that fit, those whose numbers begin first and that have the most columns.
// There are two if the first rows do not determine the decimal sign, and none if no form fits.
std::vector<TableReading> find_readings(const Source& source, const TableForm& given, bool text) {
  std::vector<TableReading> best;
  for (const char separator : {'\t', ';', ',', '|', ' '}) {
    if (given.separator != 0 && given.separator != separator) continue;
    for (const char decimal :
         given.decimal == 0 ? std::string_view(".,") : std::string_view(&given.decimal, 1)) {
      const TableReading reading =
          try_form(source, {separator, decimal, given.lenient, given.thousands}, text);
      if (reading.columns == 0) continue;
      const auto rank = [](const TableReading& r) {
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
bool is_heading(std::string_view line, const TableReading& reading, Cells& cells) {
  split_line(line, reading.form.separator, cells);
  double value = 0;
  return cells.size() == reading.columns && std::none_of(cells.begin(), cells.end(), [&](auto cell) {
           return parse_cell(cell, reading.form, value);
         });
}

std::string_view bare(std::string_view cell) {
  if (cell.size() > 2 && std::string_view("([<{").find(cell.front()) != std::string_view::npos)
    return trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

// The units below a heading: no number, the last ones may be missing.
bool is_units(std::string_view line, const TableReading& reading, Cells& cells) {
  split_line(line, reading.form.separator, cells);
  if (cells.size() < 2 || cells.size() > reading.columns) return false;
  double value = 0;
  for (const auto cell : cells)
    if (cell.size() > 12 || parse_cell(cell, reading.form, value)) return false;
  cells.resize(reading.columns);
  return std::any_of(cells.begin(), cells.end(), [](auto cell) { return !cell.empty(); });
}

// Three lines of headings and more are kept with the columns: which of them holds the names, the reader of
// the table decides by the words that it knows.
void keep_heads(Table& table, const std::vector<std::string_view>& above, const TableReading& reading) {
  constexpr std::size_t least = 3, most = 5;
  std::vector<Cells> lines;
  Cells cells;
  for (std::size_t i = above.size(); i-- > 0 && lines.size() < most;) {
    const bool lowest = i + 1 == above.size();
    if (!is_heading(above[i], reading, cells) && !(lowest && is_units(above[i], reading, cells))) break;
    lines.push_back(cells);
  }
  if (lines.size() < least) return;
  for (std::size_t c = 0; c < reading.columns; ++c)
    for (std::size_t i = lines.size(); i-- > 0;) table.columns[c].heads.emplace_back(lines[i][c]);
}

void name_columns(Table& table, const std::vector<std::string_view>& above, const TableReading& reading) {
  table.columns.resize(reading.columns);
  for (std::size_t i = 0; i < reading.columns; ++i) table.columns[i].name = std::to_string(i + 1);
  Cells cells, below;
  std::size_t last = above.size();  // index after the lowest heading line
  while (last > 0 && !is_heading(above[last - 1], reading, cells)) --last;
  if (last == 0) return;
  table.header = true;
  // Of two heading lines the lower one holds units; it may have gaps. Gaps in the upper one alone are those
  // between the names of specimens side by side.
  const auto filled = [](const Cells& row) {
    return std::count_if(row.begin(), row.end(), [](auto cell) { return !cell.empty(); });
  };
  bool units = last > 1 && is_heading(above[last - 2], reading, below) && filled(below) >= filled(cells);
  if (last < above.size() && is_units(above[last], reading, below)) {
    std::swap(cells, below);
    units = true;
  }
  keep_heads(table, above, reading);
  const Cells& names = units ? below : cells;
  for (std::size_t i = 0; i < reading.columns; ++i) {
    TableColumn column = heading(names[i]);
    column.heads = std::move(table.columns[i].heads);
    table.columns[i] = std::move(column);
    if (units && table.columns[i].unit.empty()) table.columns[i].unit = bare(cells[i]);
  }
}

// Searches upwards from the first rows of numbers for rows in which some cell is not a number, until
// a line has no number at all (nor only missing values). Returns the position of the highest row.
std::size_t first_row(const std::vector<std::string_view>& above, const std::vector<std::size_t>& places,
                      const TableReading& reading) {
  Cells cells;
  double value = 0;
  std::size_t first = reading.place;
  for (std::size_t i = above.size(); i-- > 0;) {
    split_row(above[i], reading.form.separator, reading.columns, cells);
    const bool some = std::any_of(cells.begin(), cells.end(),
                                  [&](auto cell) { return parse_cell(cell, reading.form, value); });
    if (!some && !(cells.size() == reading.columns && std::all_of(cells.begin(), cells.end(), is_missing))) {
      // Lines between the heading and the rows are rows with too few cells or too many.
      if (cells.size() == reading.columns && i + 1 < above.size()) first = places[i + 1];
      break;
    }
    if (cells.size() == reading.columns) first = places[i];
  }
  return first;
}

// Names the columns from the lines above the rows; returns the position of the first row.
std::size_t read_preamble(Table& table, Source source, const TableReading& reading) {
  std::vector<std::string_view> above;
  std::vector<std::size_t> places;
  std::string_view line;
  while (source.place() < reading.place) {
    const std::size_t place = source.place();
    source.next_line(line);
    if (!carries_data(line) || is_blank_row(line, reading.form.separator)) continue;
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

// If the first row ends with a separator and the heading above it has a cell more, the last column is empty.
void widen(Source source, TableReading& reading) {
  if (reading.form.separator == ' ') return;
  source.move_to(reading.place);
  std::string_view row, line;
  source.next_line(row);
  if (trimmed(row).empty() || !row.ends_with(reading.form.separator)) return;
  TableReading wide = reading;
  ++wide.columns;
  Cells cells;
  for (source.move_to(0); source.place() < reading.place && source.next_line(line);)
    if (carries_data(line) && is_heading(line, wide, cells) && !cells.back().empty()) reading = wide;
}

// Reads the tables of a text in one form; bad: number of cells that are not numbers.
std::vector<Table> read_as(Source source, const TableReading& reading, const TableForm& asked,
                           std::size_t& bad) {
  std::vector<Table> tables(1);
  tables[0].form = reading.form;
  source.move_to(read_preamble(tables[0], source, reading));
  while (const auto head = read_rows(tables.back(), source, asked, bad)) {
    Table& next = tables.emplace_back();
    next.form = reading.form;
    name_columns(next, head->above, {reading.form, head->columns, head->rows});
    for (const auto line : head->above) next.preamble.emplace_back(trimmed(line));
    source.move_to(head->rows);
  }
  for (Table& table : tables) table.name = source.name();
  return tables;
}

// How many lines have the commonest number of cells of two and more in this form, of how many; and that
// number.
struct Vote {
  std::size_t cells = 0, lines = 0, all = 0;
};
Vote count_cells(Source source, char separator) {
  Cells cells;
  std::vector<std::size_t> seen;
  std::size_t all = 0;
  std::string_view line;
  while (source.next_line(line)) {
    if (!carries_data(line)) continue;
    split_line(line, separator, cells);
    ++all;
    if (cells.size() >= seen.size()) seen.resize(cells.size() + 1);
    ++seen[cells.size()];
  }
  Vote vote{0, 0, all};
  for (std::size_t n = 2; n < seen.size(); ++n)
    if (seen[n] > vote.lines) vote = {n, seen[n], all};
  return vote;
}

// Cells in the line above the rows; 0 if there is none.
std::size_t cells_above(Source source, const TableReading& reading, char separator) {
  Cells cells;
  std::string_view line;
  std::size_t count = 0;
  for (source.move_to(0); source.place() < reading.place && source.next_line(line);)
    if (carries_data(line)) {
      split_line(line, separator, cells);
      count = cells.size();
    }
  return count;
}

// A single column of decimals may be two columns whose first rows are cut short: the whole file decides
// whether a separator is between cells.
char outvoted(Source source, const TableReading& reading) {
  source.move_to(reading.place);
  for (const char separator : {'\t', ';', ','}) {
    const Vote vote = count_cells(source, separator);
    const std::size_t above = cells_above(source, reading, separator);
    const double fraction =
        vote.all > 0 ? static_cast<double>(vote.lines) / static_cast<double>(vote.all) : 0;
    if (vote.cells >= 2 && (above == vote.cells ? fraction > 0.3 : above == 0 && fraction > 0.75))
      return separator;
  }
  return 0;
}

bool begins_earlier(const TableReading& wider, const TableReading& reading) {
  return wider.place < reading.place && wider.columns >= reading.columns &&
         wider.form.separator == reading.form.separator;
}

bool has_gaps(const TableReading& wider, const TableReading& reading) {
  return wider.place <= reading.place && wider.columns > reading.columns && reading.form.separator == ' ';
}

std::vector<TableReading> readings_of(const Source& source, const TableForm& form) {
  // Reads rows of numbers only, unless rows with text or gaps of the same form begin earlier, or what was
  // taken for blanks between numbers are tabs beside empty cells.
  auto readings = find_readings(source, form, false);
  auto wider = find_readings(source, form, true);
  if (readings.empty() ||
      (!wider.empty() && (begins_earlier(wider[0], readings[0]) || has_gaps(wider[0], readings[0]))))
    readings = std::move(wider);
  if (readings.empty() || readings[0].columns > 1 || form.separator != 0) return readings;
  TableForm voted = form;
  voted.separator = outvoted(source, readings[0]);
  if (voted.separator == 0) return readings;
  auto others = readings_of(source, voted);
  return others.empty() ? readings : others;
}

// Whether the signs of the file are open, so that each column may have its own.
bool is_open(const TableForm& form) {
  return form.decimal == 0 && (form.thousands == 0 || form.thousands == kNoThousands);
}

// The file with a decimal sign for each column by itself and with units in the cells; none if it is no table
// then either.
std::vector<Table> tables_with_either_sign(const Source& source, TableForm form, std::size_t& bad) {
  const TableForm asked = form;
  form.decimal = kEitherSign;
  auto readings = readings_of(source, form);
  if (readings.empty()) return {};
  widen(source, readings[0]);
  return read_as(source, readings[0], asked, bad);
}

// Whether a number has both signs, as 5.512,5: a sign, three digits, the decimal sign, a digit.
bool shows_thousands(std::string_view text, char thousands, char decimal) {
  const auto digits = [](std::string_view part) {
    return std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  for (auto i = text.find(thousands, 1); i != text.npos && i + 5 < text.size();
       i = text.find(thousands, i + 1))
    if (text[i + 4] == decimal && digits(text.substr(i - 1, 1)) && digits(text.substr(i + 1, 3)) &&
        digits(text.substr(i + 5, 1)))
      return true;
  return false;
}

// The file with a sign between thousands and the other one for decimals, where a number shows both; none if
// not every cell can be read so.
std::vector<Table> tables_with_thousands(const Source& source, std::string_view text, TableForm form) {
  for (const char thousands : {'.', ','}) {
    form.thousands = thousands;
    form.decimal = thousands == '.' ? ',' : '.';
    if (!shows_thousands(text, form.thousands, form.decimal)) continue;
    auto readings = readings_of(source, form);
    if (readings.empty()) continue;
    widen(source, readings[0]);
    std::size_t bad = 0;
    auto tables = read_as(source, readings[0], form, bad);
    if (bad == 0) return tables;
  }
  return {};
}

std::vector<Table> tables_in(const std::string& name, std::string_view bytes, TableForm form) {
  const Source source(name, bytes);
  if ((form.thousands == '.' || form.thousands == ',') && form.decimal == 0)
    form.decimal = form.thousands == '.' ? ',' : '.';
  auto readings = readings_of(source, form);
  std::size_t bad = 0;
  std::vector<Table> tables;
  if (readings.empty()) {
    if (is_open(form)) tables = tables_with_either_sign(source, form, bad);
    if (!tables.empty()) return tables;
    throw Error(source.name() +
                ":1: expected lines of numbers (columns parted by comma, semicolon, tab, | or "
                "blanks; decimal point or comma), found none in the first 200 lines");
  }
  for (TableReading& reading : readings) widen(source, reading);
  tables = read_as(source, readings[0], form, bad);
  if (bad > 0 && readings.size() > 1) {  // later rows determine the decimal sign
    std::size_t other = 0;
    auto comma = read_as(source, readings[1], form, other);
    if (other < bad) {
      tables = std::move(comma);
      bad = other;
    }
  }
  // or show that a sign before them stands between thousands, as 5.512,5 below 1.120 and 2.250
  if (bad > 0 && form.decimal == 0 && form.thousands == 0 && tables[0].form.separator != ',') {
    auto grouped = tables_with_thousands(source, bytes, form);
    if (!grouped.empty()) tables = std::move(grouped);
  }
  return tables;
}

bool has_numbers(const std::string& text, const TableForm& form) {
  const Source source("", text);
  return !readings_of(source, form).empty();
}

// Every sheet that has numbers.
std::vector<Table> tables_in_sheets(const std::string& name, std::string_view bytes, const TableForm& form) {
  std::vector<Table> tables;
  TableForm plain{'\t', '.', form.lenient};
  std::vector<LeftOut> empty;
  for (const Worksheet& sheet : sheets_of(name, bytes)) {
    // Cells of words may hold numbers with their unit, or with the sign of another country.
    plain.decimal = has_numbers(sheet.text, {'\t', '.'}) ? '.' : char{0};
    if (plain.decimal == 0 && !has_numbers(sheet.text, {'\t', kEitherSign})) {
      empty.push_back({0, "sheet '" + sheet.name + "', which has no rows of numbers", false});
      continue;
    }
    for (Table& table : tables_in(name + ", sheet '" + sheet.name + "'", sheet.text, plain)) {
      table.sheet = sheet.name;
      tables.push_back(std::move(table));
    }
  }
  if (tables.empty()) throw Error(name + ": expected a sheet with rows of numbers, found none");
  tables[0].left_out.insert(tables[0].left_out.end(), empty.begin(), empty.end());
  return tables;
}

// Whether a table continues the one before it, under the same heading.
bool goes_on(const Table& before, const Table& table) {
  if (before.sheet != table.sheet || before.columns.size() != table.columns.size()) return false;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (before.columns[i].name != table.columns[i].name || before.columns[i].unit != table.columns[i].unit)
      return false;
  const auto& one = before.columns.front();
  const auto& other = table.columns.front();
  return one.values.back() <= other.values.front();
}

void append(Table& table, const Table& more) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    TableColumn& column = table.columns[i];
    const TableColumn& other = more.columns[i];
    if (column.error.empty() && !other.error.empty()) {
      column.error = other.error;
      column.error_row = column.values.size() + other.error_row;
    }
    column.text = column.text && other.text;
    if (column.words.empty() != other.words.empty())
      column.words.clear();
    else
      column.words.insert(column.words.end(), other.words.begin(), other.words.end());
    column.values.insert(column.values.end(), other.values.begin(), other.values.end());
  }
  table.lines.insert(table.lines.end(), more.lines.begin(), more.lines.end());
  table.left_out.insert(table.left_out.end(), more.left_out.begin(), more.left_out.end());
}

// The tables as one.
Table joined(std::vector<Table> tables) {
  Table table = std::move(tables.front());
  for (std::size_t i = 1; i < tables.size(); ++i) {
    if (!goes_on(i == 1 ? table : tables[i - 1], tables[i]))
      throw Error(tables[i].name + ":" + std::to_string(tables[i].lines.front()) +
                  ": a further table begins here, table " + std::to_string(i + 1) + " of " +
                  std::to_string(tables.size()) + ": expected one table; blocks=true reads each");
    append(table, tables[i]);
  }
  return table;
}

}  // namespace

std::vector<Table> parse_tables(const std::string& name, std::string_view bytes, const TableForm& form) {
  std::string made;
  auto tables = is_spreadsheet(bytes) ? tables_in_sheets(name, bytes, form)
                                      : tables_in(name, plain_text(name, bytes, made), form);
  if (!form.lenient)
    for (const Table& table : tables) check(table);
  return tables;
}

Table parse_table(const std::string& name, std::string_view bytes, const TableForm& form) {
  return joined(parse_tables(name, bytes, form));
}

void check(const Table& table) {
  const TableColumn* first = nullptr;
  for (const TableColumn& column : table.columns)
    if (!column.text && !column.error.empty() && (!first || column.error_row < first->error_row))
      first = &column;
  if (first) throw Error(first->error);
}

std::vector<Table> read_tables(const std::string& path, const TableForm& form) {
  return parse_tables(path, read_file(path), form);
}

Table read_table(const std::string& path, const TableForm& form) {
  return parse_table(path, read_file(path), form);
}

}  // namespace fabricsh::format
