#include "files/csv.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <set>

#include "base/error.hpp"
#include "files/atomic.hpp"
#include "files/gate.hpp"
#include "files/number.hpp"

namespace fabricsh::files {

namespace {

// A name with a comma, quote or line end goes between quotes, its quotes doubled (RFC 4180).
std::string cell(const std::string& name) {
  if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

void check_columns(const std::string& path, const std::vector<std::string>& columns) {
  if (columns.empty()) throw Error("table '" + path + "': expected at least one column");
  std::set<std::string> seen;
  for (const std::string& name : columns) {
    if (name.empty()) throw Error("table '" + path + "': a column has no name");
    if (!seen.insert(name).second) throw Error("table '" + path + "': two columns are named '" + name + "'");
  }
}

template <class Items, class Text>
std::string line_of(const Items& items, Text text) {
  std::string line;
  for (const auto& item : items) line += text(item) + ",";
  line.back() = '\n';
  return line;
}

}  // namespace

CsvWriter::CsvWriter(const std::string& path, const std::vector<std::string>& columns)
    : path_(path), columns_(columns.size()) {
  check_columns(path, columns);
  make_folder_for(path);
  file_ = Gate::of_process().open_to_write(path, O_WRONLY | O_CREAT | O_TRUNC);
  append(line_of(columns, cell));
}

void CsvWriter::row(std::span<const double> values) {
  if (values.size() != columns_)
    throw Error("table '" + path_ + "': expected " + std::to_string(columns_) + " values in a row, got " +
                std::to_string(values.size()));
  append(line_of(values, number));
}

void CsvWriter::keep(std::size_t n) {
  if (n >= rows()) return;
  ends_.resize(n + 1);
  cut();
}

// Back to the end of the last whole line (a pipe or device has no length to cut).
void CsvWriter::cut() {
  const std::int64_t length = ends_.empty() ? 0 : ends_.back();
  [[maybe_unused]] const int cut = ftruncate(file_.number(), length);
  lseek(file_.number(), length, SEEK_SET);
}

// One line by one write; what a full disk took of it is cut off again.
void CsvWriter::append(const std::string& line) {
  if (const int reason = file_.write(line)) {
    cut();
    cannot_write(path_, reason);
  }
  ends_.push_back((ends_.empty() ? 0 : ends_.back()) + static_cast<std::int64_t>(line.size()));
}

}  // namespace fabricsh::files
