// Splits one line of a table into its cells.
#pragma once
#include <string_view>
#include <vector>

#include "format/table.hpp"

namespace fabricsh::format {

std::string_view trimmed(std::string_view words);
bool is_comment(std::string_view line);
// Cells without surrounding blanks and quotes; a separator at the end of the line closes the last cell.
void split_line(std::string_view line, char separator, std::vector<std::string_view>& cells);
// A cell that marks a missing value: empty, nan, inf, n/a, a dash.
bool is_missing(std::string_view cell);
// Reads a whole cell as a finite number with this decimal sign. The other sign may separate
// thousands if it cannot be meant as the decimal sign: 1,234.5 and 1,234,567, but not 1,234 unless
// form.thousands says so. A blank, a no-break or narrow blank and an apostrophe may separate
// them too, and the minus sign may be the typographic one.
bool parse_cell(std::string_view cell, const TableForm& form, double& value);
// Words that begin a row of totals below a record: mean, std. dev., maximum, and those of other languages.
bool is_total(std::string_view cell);
// Whether the words contain a letter, of whatever alphabet.
bool has_letter(std::string_view words);
// Whether a number with a comma may be one without decimals: 1,234, but not 0,5 or 0,123.
bool may_be_thousands(std::string_view cell);
// Whether a number has this sign once, as it would stand between thousands: 1.234, but not 0.123 or 1.23.
bool may_be_group(std::string_view cell, char mark);
// Name and unit of a heading: "Load [N]", "load (N)", "load / N".
TableColumn heading(std::string_view cell);

}  // namespace fabricsh::format
