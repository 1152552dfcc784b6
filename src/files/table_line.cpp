#include "files/table_line.hpp"

#include <algorithm>
#include <cmath>

#include "files/source.hpp"

namespace fabricsh::files {

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

// The end of the cell that begins at `from`; a quoted cell may hold the separator.
std::size_t cell_end(std::string_view line, std::size_t from, char separator) {
  const auto word = line.find_first_not_of(" \t", from);
  if (word != line.npos && line[word] == '"') {
    const auto quote = line.find('"', word + 1);
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

bool parse_cell(std::string_view cell, char decimal, double& value) {
  char copy[64];
  if (decimal != '.') {
    if (cell.size() >= sizeof copy || cell.find('.') != cell.npos) return false;
    std::replace_copy(cell.begin(), cell.end(), copy, decimal, '.');
    cell = std::string_view(copy, cell.size());
  }
  return parse(cell, value) && std::isfinite(value);
}

TableColumn heading(std::string_view cell) {
  cell = trimmed(cell);
  for (const auto& [open, close] : {std::pair{'(', ')'}, {'[', ']'}, {'<', '>'}, {'{', '}'}}) {
    const auto at = cell.rfind(open);
    if (!cell.ends_with(close) || at == cell.npos) continue;
    const auto unit = trimmed(cell.substr(at + 1, cell.size() - at - 2));
    return {std::string(trimmed(cell.substr(0, at))), std::string(unit), {}};
  }
  const auto slash = cell.rfind(" / ");
  if (slash == cell.npos) return {std::string(cell), "", {}};
  return {std::string(trimmed(cell.substr(0, slash))), std::string(trimmed(cell.substr(slash + 3))), {}};
}

}  // namespace fabricsh::files
