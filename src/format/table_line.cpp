#include "format/table_line.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "format/source.hpp"

namespace fabricsh::format {

std::string_view trimmed(std::string_view words) {
  constexpr const char* blanks = " \t\r\n\f\v";
  const auto first = words.find_first_not_of(blanks);
  if (first == words.npos) return {};
  return words.substr(first, words.find_last_not_of(blanks) - first + 1);
}

bool is_comment(std::string_view line) {
  line = trimmed(line);
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

// Removes the thousands separators; empty if they are not in their places.
std::string without_thousands(std::string_view cell, char decimal) {
  const char mark = decimal == '.' ? ',' : '.';
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
  if (groups == 1 && point == cell.size()) return {};  // 1,234 may have a decimal comma
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

}  // namespace

bool parse_cell(std::string_view cell, char decimal, double& value) {
  if (parse_plain(cell, decimal, value)) return true;
  if (cell.size() < 6 || cell.find(decimal == '.' ? ',' : '.') == cell.npos) return false;
  const std::string joined = without_thousands(cell, decimal);
  return !joined.empty() && parse_plain(joined, decimal, value);
}

bool may_be_thousands(std::string_view cell) {
  const auto comma = cell.find(',');
  if (comma == cell.npos) return false;
  const auto digits = cell.find_first_of("0123456789");
  const bool group = cell.size() == comma + 4 && cell.find_first_not_of("0123456789", comma + 1) == cell.npos;
  return group && digits <= 1 && comma > digits && comma - digits <= 3 && cell[digits] != '0';
}

TableColumn heading(std::string_view cell) {
  std::string once(trimmed(cell));
  for (auto at = once.find("\"\""); at != once.npos; at = once.find("\"\"", at + 1)) once.erase(at, 1);
  cell = once;
  for (const auto& [open, close] : {std::pair{'(', ')'}, {'[', ']'}, {'<', '>'}, {'{', '}'}}) {
    const auto at = cell.rfind(open);
    if (!cell.ends_with(close) || at == cell.npos) continue;
    const auto unit = trimmed(cell.substr(at + 1, cell.size() - at - 2));
    return {std::string(trimmed(cell.substr(0, at))), std::string(unit), {}, true, {}, 0};
  }
  const auto slash = cell.rfind(" / ");
  if (slash == cell.npos) return {std::string(cell), "", {}, true, {}, 0};
  return {std::string(trimmed(cell.substr(0, slash))),
          std::string(trimmed(cell.substr(slash + 3))),
          {},
          true,
          {},
          0};
}

}  // namespace fabricsh::format
