#include "format/table_line.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "format/source.hpp"
#include "format/table_signs.hpp"

namespace fabricsh::format {

std::string_view trimmed(std::string_view words) {
  const auto blank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  while (!words.empty() && blank(words.front())) words.remove_prefix(1);
  while (!words.empty() && blank(words.back())) words.remove_suffix(1);
  return words;
}

// A cell "%" or "#" alone at the beginning is a unit or the name of a counter.
bool is_comment(std::string_view line) {
  line = trimmed(line);
  if (line.size() > 1 && (line[0] == '%' || line[0] == '#') &&
      (line[1] == ',' || line[1] == ';' || line[1] == '\t'))
    return false;
  return line.starts_with('#') || line.starts_with('%') || line.starts_with("//") || line.starts_with('!');
}

namespace {

// The end of the cell that begins at `from`; a quoted cell may contain the separator.
std::size_t cell_end(std::string_view line, std::size_t from, char separator) {
  const auto word = line.find_first_not_of(" \t", from);
  if (word != line.npos && line[word] == '"') {
    auto quote = line.find('"', word + 1);
    while (quote != line.npos && quote + 1 < line.size() && line[quote + 1] == '"')  // two stand for one
      quote = line.find('"', quote + 2);
    if (quote != line.npos) from = quote + 1;
  }
  return std::min(line.find(separator, from), line.size());
}

std::string_view unquoted(std::string_view cell) {
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
  return trimmed(cell);
}

void split_blanks(std::string_view line, std::vector<std::string_view>& cells) {
  for (std::size_t at = line.find_first_not_of(" \t"); at < line.size();) {
    const auto end = std::min(line.find_first_of(" \t", at), line.size());
    cells.push_back(unquoted(line.substr(at, end - at)));
    at = line.find_first_not_of(" \t", end);
  }
}

}  // namespace

void split_line(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  if (separator == ' ') return split_blanks(line, cells);
  for (std::size_t at = 0; at < line.size();) {
    const auto end = cell_end(line, at, separator);
    cells.push_back(unquoted(trimmed(line.substr(at, end - at))));
    at = end + 1;
  }
}

bool is_missing(std::string_view cell) {
  std::string word(cell);
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  if (word.starts_with('-') || word.starts_with('+')) word.erase(0, 1);
  for (const char* known : {"", "-", "nan", "inf", "infinity", "na", "n/a", "null"})
    if (word == known) return true;
  return false;
}

namespace {

// Removes the thousands separators; empty if they are not in their places. single: 1,234 counts too.
std::string without_thousands(std::string_view cell, char decimal, char mark, bool single) {
  const auto point = std::min(cell.find(decimal), cell.size());
  const auto first = cell.find(mark);
  if (first >= point) return {};
  const auto whole = cell.substr(0, point);
  const auto digits = whole.find_first_of("0123456789");
  if (digits == whole.npos || digits > 1 || first - digits > 3 || first == digits) return {};
  std::string out(whole.substr(0, first));
  std::size_t groups = 0;
  for (std::size_t at = first; at < whole.size(); at += 4, ++groups) {
    const auto group = whole.substr(at + 1, 3);
    if (whole[at] != mark || group.size() != 3 || group.find_first_not_of("0123456789") != group.npos)
      return {};
    out += group;
  }
  if (groups == 1 && point == cell.size() && !single) return {};  // 1,234 may have a decimal comma
  return out.append(cell.substr(point));
}

bool parse_plain(std::string_view cell, char decimal, double& value) {
  char copy[64];
  if (decimal != '.') {
    if (cell.size() >= sizeof copy || cell.find('.') != cell.npos || cell.ends_with(decimal)) return false;
    std::replace_copy(cell.begin(), cell.end(), copy, decimal, '.');
    cell = std::string_view(copy, cell.size());
  }
  return parse(cell, value) && std::isfinite(value);
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// The cell with the signs of a keyboard: a hyphen for the minus sign, an apostrophe for every other mark
// between thousands, none at the ends.
std::string with_plain_signs(std::string_view cell) {
  std::string out(cell);
  replace_all(out, "\u2212", "-");
  for (const char* mark : {"\u00a0", "\u202f", "\u2009", "\u2007", "\u2019", "\xa0", " "})
    replace_all(out, mark, "'");
  const auto first = out.find_first_not_of('\'');
  if (first == out.npos) return {};
  out = out.substr(first, out.find_last_not_of('\'') - first + 1);
  if (out.starts_with("-'")) out.erase(1, 1);
  return out;
}

bool has_other_signs(std::string_view cell) {
  return std::any_of(cell.begin(), cell.end(), [](char c) { return c == ' ' || c == '\'' || (c & 0x80); });
}

bool parse_grouped(std::string_view cell, char decimal, char mark, bool single, double& value) {
  if (cell.size() < 5 || cell.find(mark) == cell.npos) return false;
  const std::string joined = without_thousands(cell, decimal, mark, single);
  return !joined.empty() && parse_plain(joined, decimal, value);
}

}  // namespace

bool parse_cell(std::string_view cell, const TableForm& form, double& value) {
  if (form.decimal == kEitherSign) {  // the value is settled with the whole column
    value = 0;
    return is_number_in_either_sign(cell);
  }
  const char mark = form.decimal == '.' ? ',' : '.';
  if (form.thousands == mark && parse_grouped(cell, form.decimal, mark, true, value)) return true;
  if (parse_plain(cell, form.decimal, value)) return true;
  if (parse_grouped(cell, form.decimal, mark, false, value)) return true;
  if (cell.empty() || cell.size() > 60 || !has_other_signs(cell)) return false;
  const std::string plain = with_plain_signs(cell);
  return parse_plain(plain, form.decimal, value) ||
         parse_grouped(plain, form.decimal, mark, form.thousands == mark, value) ||
         parse_grouped(plain, form.decimal, '\'', true, value);
}

bool has_letter(std::string_view words) {
  return std::any_of(words.begin(), words.end(),
                     [](char c) { return std::isalpha(static_cast<unsigned char>(c)) || (c & 0x80); });
}

bool is_total(std::string_view cell) {
  std::string word(cell);
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const char* known : {"mean",
                            "average",
                            "avg",
                            "std",
                            "standard d",
                            "s.d.",
                            "c.v.",
                            "coefficient",
                            "varia",
                            "max",
                            "min",
                            "median",
                            "range",
                            "total",
                            "sum",
                            "count",
                            "peak",
                            "result",
                            "mittel",
                            "mw",
                            "standarda",
                            "spannw",
                            "anzahl",
                            "moyenne",
                            "\u00e9cart",
                            "ecart",
                            "media",
                            "m\u00e9dia",
                            "promedio",
                            "desv",
                            "gemiddelde",
                            "ortalama",
                            "fmax",
                            "fmin",
                            "f max",
                            "f min",
                            "x\u0304",
                            "\u015brednia",
                            "srednia",
                            "odch",
                            "\u0441\u0440\u0435\u0434\u043d",
                            "\u5e73\u5747",
                            "\u6807\u51c6",
                            "\u6a19\u6e96",
                            "\u6700\u5927",
                            "\u6700\u5c0f",
                            "\ud3c9\uade0",
                            "\ucd5c\ub300",
                            "\ucd5c\uc18c"})
    if (word.starts_with(known)) return true;
  for (const char* whole : {"sd", "cv", "n", "s", "v", "dev", "dev."})
    if (word == whole) return true;
  return false;
}

bool may_be_group(std::string_view cell, char mark) {
  const auto place = cell.find(mark);
  if (place == cell.npos) return false;
  const auto digits = cell.find_first_of("0123456789");
  const bool group = cell.size() == place + 4 && cell.find_first_not_of("0123456789", place + 1) == cell.npos;
  return group && digits <= 1 && place > digits && place - digits <= 3 && cell[digits] != '0';
}

bool may_be_thousands(std::string_view cell) { return may_be_group(cell, ','); }

TableColumn heading(std::string_view cell) {
  std::string once(trimmed(cell));
  replace_all(once, "\uff08", "(");  // the brackets of Chinese and Japanese text
  replace_all(once, "\uff09", ")");
  replace_all(once, "\u00a0", " ");
  replace_all(once, "\u202f", " ");
  for (auto at = once.find("\"\""); at != once.npos; at = once.find("\"\"", at + 1)) once.erase(at, 1);
  cell = once;
  TableColumn column;
  for (const auto& [open, close] : {std::pair{'(', ')'}, {'[', ']'}, {'<', '>'}, {'{', '}'}}) {
    const auto at = cell.rfind(open);
    if (!cell.ends_with(close) || at == cell.npos) continue;
    column.name = trimmed(cell.substr(0, at));
    column.unit = trimmed(cell.substr(at + 1, cell.size() - at - 2));
    return column;
  }
  const auto slash = cell.rfind(" / ");
  column.name = trimmed(cell.substr(0, slash));
  if (slash != cell.npos) column.unit = trimmed(cell.substr(slash + 3));
  return column;
}

}  // namespace fabricsh::format
