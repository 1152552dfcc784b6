// Spreadsheets (.xlsx) as text. They are read by openpyxl, a module of Python (Debian: python3-openpyxl), in
// a process of its own.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace fabricsh::format {

struct Worksheet {
  std::string name;
  std::string text;  // a line per row, cells separated by tabs, numbers as they are stored
};

// Whether these bytes are an archive with a spreadsheet of this kind.
bool is_spreadsheet(std::string_view bytes);
// All sheets, in their order. Error: no Python with openpyxl is installed, or it cannot read the file.
std::vector<Worksheet> sheets_of(const std::string& name, std::string_view bytes);

}  // namespace fabricsh::format
