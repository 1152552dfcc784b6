// One line of a table taken apart.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "format/table.hpp"

namespace fabricsh::format {

std::string_view trimmed(std::string_view words);
bool is_comment(std::string_view line);
// The cells of a line without blanks and quotes around them; a separator at the end closes the last cell.
void split_line(std::string_view line, char separator, std::vector<std::string_view>& cells);
// A cell where a number was not to be had: empty, nan, inf, n/a, a dash.
bool is_missing(std::string_view cell);
// The whole of a cell as a finite number with this decimal sign. Thousands may be parted by the other sign
// where that cannot be the decimal one: 1,234.5 or 1,234,567, not 1,234.
bool parse_cell(std::string_view cell, char decimal, double& value);
// Name and unit of a heading: "Load [N]", "load (N)", "load / N".
TableColumn heading(std::string_view cell);

}  // namespace fabricsh::format
