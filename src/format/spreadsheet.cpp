#include "format/spreadsheet.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "system/child.hpp"

namespace fabricsh::format {

namespace {

// Run in isolation (-I), so that no module of the present folder takes part. Writes each sheet behind a line
// that begins with the byte 1 and has its name. A formula counts by the value that was last computed;
// columns without any content are left out, rows are kept as blank lines.
constexpr const char* script = R"(
import datetime, io, sys
try:
    import openpyxl
except ImportError:
    sys.exit(9)
def plain(value):
    if value is None:
        return ''
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return repr(value)
    if isinstance(value, datetime.timedelta):
        return repr(value.total_seconds())
    if isinstance(value, datetime.time):
        return value.isoformat()
    return ' '.join(str(value).split())
book = openpyxl.load_workbook(io.BytesIO(open(0, 'rb').read()), data_only=True)
out = open(1, 'w', encoding='utf-8')
for sheet in book.worksheets:
    rows = [row if any(cell is not None for cell in row) else None for row in sheet.iter_rows(values_only=True)]
    while rows and rows[-1] is None:
        rows.pop()
    used = [i for i in range(sheet.max_column or 0) if any(row and row[i] is not None for row in rows)]
    out.write('\x01' + plain(sheet.title) + '\n')
    for row in rows:
        out.write('\t'.join(plain(row[i]) for i in used if row) + '\n')
out.flush()
)";

// Python's last line says what went wrong.
std::string last_line(const std::string& said) {
  const auto end = said.find_last_of('\n');
  return end == said.npos ? said : said.substr(end + 1);
}

std::vector<Worksheet> split(const std::string& text) {
  std::vector<Worksheet> sheets;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find('\n', at), text.size());
    if (text[at] == '\x01')
      sheets.push_back({text.substr(at + 1, end - at - 1), {}});
    else if (!sheets.empty())
      sheets.back().text += text.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return sheets;
}

}  // namespace

bool is_spreadsheet(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") && bytes.find("xl/workbook") != bytes.npos;
}

std::vector<Worksheet> sheets_of(const std::string& name, std::string_view bytes) {
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    const auto result = system::run_child({python, "-I", "-c", script}, std::string(bytes), name);
    if (result.good) return split(result.out);
    if (result.found && !result.said.empty())
      throw Error(name + ": openpyxl cannot read this spreadsheet: " + last_line(result.said));
  }
  throw Error(name +
              ": a spreadsheet (.xlsx) is read by openpyxl, a module of Python, which is not installed: "
              "apt install python3-openpyxl, or save each sheet as CSV");
}

}  // namespace fabricsh::format
