#include "format/spreadsheet.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "system/child.hpp"

namespace fabricsh::format {

namespace {

// Run in isolation (-I), so that no module of the present folder takes part. Writes each sheet behind a line
// that begins with the byte 1 and has its name. A formula counts by the value that was last computed;
// columns without any content are left out, rows are kept as blank lines. The unpacked size, the number of
// cells with content, the ranges that are spread over single cells (merged ones, links), memory and time
// are bounded: a small file may name a cell far away, and an archive may unpack to anything.
constexpr const char* script = R"PY(
import datetime, io, re, resource, signal, sys, zipfile
MOST_BYTES, MOST_CELLS, MOST_MEMORY, MOST_SECONDS = 1000000000, 8000000, 6000000000, 300
def too_long(*_):
    sys.exit('it takes more than %d s of computing time' % MOST_SECONDS)
def lower(which, most):
    soft, hard = resource.getrlimit(which)
    if hard != resource.RLIM_INFINITY: most = min(most, hard)
    if soft == resource.RLIM_INFINITY or soft > most: resource.setrlimit(which, (most, hard))
lower(resource.RLIMIT_AS, MOST_MEMORY)
lower(resource.RLIMIT_CPU, MOST_SECONDS)
signal.signal(signal.SIGXCPU, too_long)
try:
    import openpyxl
    from openpyxl.utils.cell import range_boundaries
except ImportError:
    sys.exit(9)
def check_cells(count, what='cells'):
    if count > MOST_CELLS:
        sys.exit('expected at most %d %s, got %d' % (MOST_CELLS, what, count))
def check(data):
    unpacked = cells = 0
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        for entry in archive.infolist():
            tail = b''
            with archive.open(entry) as file:
                while True:
                    part = file.read(1 << 20)
                    if not part: break
                    unpacked += len(part)
                    if unpacked > MOST_BYTES:
                        sys.exit('it unpacks to more than %d bytes' % MOST_BYTES)
                    text = tail + part
                    whole = text.rfind(b'>') + 1
                    tail, text = text[whole:][-65536:], text[:whole]
                    if not entry.filename.startswith('xl/worksheets/'): continue
                    cells += len(re.findall(rb'<(?:\w+:)?c[ >/]', text))
                    for area in re.findall(rb'<(?:\w+:)?(?:mergeCell|hyperlink)\s[^>]*?ref="([A-Za-z0-9:$]+)"', text):
                        try: left, top, right, bottom = range_boundaries(area.decode())
                        except ValueError: continue
                        cells += (right - left + 1) * (bottom - top + 1)
                    check_cells(cells)
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
def main():
    data = open(0, 'rb').read()
    check(data)
    book = openpyxl.load_workbook(io.BytesIO(data), data_only=True)
    out = open(1, 'w', encoding='utf-8')
    lines = 0
    for sheet in book.worksheets:
        rows, columns = {}, set()
        for (row, column), cell in sheet._cells.items():
            if cell.value is not None:
                rows.setdefault(row, {})[column] = cell.value
                columns.add(column)
        used, last = sorted(columns), max(rows, default=0)
        lines += last
        check_cells(len(used) * len(rows), 'cells in the rows and columns that are used')
        check_cells(lines, 'rows')
        out.write('\x01' + plain(sheet.title) + '\n')
        before = 0
        for row in sorted(rows):
            out.write('\n' * (row - before - 1))
            out.write('\t'.join(plain(rows[row].get(column)) for column in used) + '\n')
            before = row
    out.flush()
try:
    main()
except MemoryError:
    sys.exit('it needs more than %d bytes of memory' % MOST_MEMORY)
)PY";

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
    if (result.found && result.signal != 0)
      throw Error(name + ": the reader of this spreadsheet was ended by signal " +
                  std::to_string(result.signal) + ", as by a limit of memory or time");
  }
  throw Error(name +
              ": a spreadsheet (.xlsx) is read by openpyxl, a module of Python, which is not installed: "
              "apt install python3-openpyxl, or save each sheet as CSV");
}

}  // namespace fabricsh::format
