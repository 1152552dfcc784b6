#include "format/csv.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <set>

#include "base/error.hpp"
#include "base/number.hpp"
#include "format/source.hpp"
#include "system/atomic.hpp"
#include "system/gate.hpp"

namespace fabricsh::format {

namespace {

// A name with a comma, quote or line end is enclosed in quotes, and its quotes are doubled (RFC 4180).
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

bool is_regular(const system::Descriptor& file, struct stat& about) {
  return fstat(file.number(), &about) == 0 && S_ISREG(about.st_mode);
}

// The first bytes of a file; fewer where it ends.
std::string beginning(const system::Descriptor& file, std::int64_t size) {
  std::string bytes(static_cast<std::size_t>(size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n =
        pread(file.number(), bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    done += static_cast<std::size_t>(n);
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace

CsvWriter::CsvWriter(const std::string& path, const std::vector<std::string>& columns)
    : path_(path), columns_(columns.size()) {
  check_columns(path, columns);
  system::make_folder_for(path);
  system::remove_leftovers(path);
  const std::string header = line_of(columns, cell);
  struct stat about {};
  const system::Gate& gate = system::Gate::of_process();
  regular_ = gate.closed() || stat(path.c_str(), &about) != 0 || S_ISREG(about.st_mode);
  // The header is written with the file at once, so that the file never lacks it.
  if (regular_) system::write_file(path, header, system::Sync::no);
  file_ = gate.open_to_write(path, regular_ ? O_RDWR | O_APPEND : O_WRONLY);
  if (regular_)
    place_ = {{static_cast<std::int64_t>(header.size())}, checksum(header)};
  else
    append(header);
}

CsvWriter::CsvWriter(const std::string& path, const std::vector<std::string>& columns, const CsvPlace& place)
    : path_(path), columns_(columns.size()), place_(place) {
  check_columns(path, columns);
  system::remove_leftovers(path);
  if (!system::Gate::of_process().exists(path))
    throw Error("cannot go on with '" + path +
                "': the table that the run left is gone; put it back, or run the deck "
                "without --restart");
  file_ = system::Gate::of_process().open_to_write(path, O_RDWR | O_APPEND);
  struct stat about {};
  regular_ = is_regular(file_, about);
  if (!regular_) return;
  const std::string header = line_of(columns, cell);
  const auto end = place.ends.empty() ? 0 : place.ends.back();
  if (end < 0 || end > about.st_size || !std::is_sorted(place.ends.begin(), place.ends.end()) ||
      checksum(beginning(file_, end)) != place.sum)
    throw Error("cannot go on with '" + path + "': it is not as the run left it");
  if (beginning(file_, place.ends.front()) != header)
    throw Error("cannot go on with '" + path +
                "': its columns are not these: " + header.substr(0, header.size() - 1));
  cut();
}

void CsvWriter::row(std::span<const double> values) {
  if (values.size() != columns_)
    throw Error("table '" + path_ + "': expected " + std::to_string(columns_) + " values in a row, got " +
                std::to_string(values.size()));
  check_place();
  append(line_of(values, full_number));
}

CsvPlace CsvWriter::place(std::size_t n) const {
  CsvPlace place = place_;
  if (n >= rows()) return place;
  place.ends.resize(n + 1);
  if (regular_) place.sum = checksum(beginning(file_, place.ends.back()));
  return place;
}

void CsvWriter::keep(std::size_t n) {
  if (n >= rows()) return;
  place_ = place(n);
  cut();
}

void CsvWriter::sync() {
  if (!regular_) return;
  check_place();
  if (fdatasync(file_.number()) != 0) system::cannot_write(path_, errno);
}

// Cuts the file back to the end of its last whole line (a pipe or device has no length to cut).
void CsvWriter::cut() {
  const std::int64_t length = place_.ends.empty() ? 0 : place_.ends.back();
  [[maybe_unused]] const int cut = ftruncate(file_.number(), length);
}

// Writes one line by one write call; after an error, for example a full disk, the partial line is cut off.
void CsvWriter::append(const std::string& line) {
  if (const int reason = file_.write(line)) {
    cut();
    system::cannot_write(path_, reason);
  }
  const auto size = static_cast<std::int64_t>(line.size());
  place_.ends.push_back((place_.ends.empty() ? 0 : place_.ends.back()) + size);
  place_.sum = checksum(line, place_.sum);
}

// Checks that the path still leads to the open file.
void CsvWriter::check_place() {
  struct stat here {
  }, there{};
  if (!regular_ || system::Gate::of_process().closed()) return;
  if (stat(path_.c_str(), &there) != 0) {
    if (errno != ENOENT) system::cannot_write(path_, errno);
    return move_back();
  }
  if (fstat(file_.number(), &here) == 0 && here.st_ino == there.st_ino && here.st_dev == there.st_dev) return;
  throw Error("cannot write '" + path_ + "': another file has taken its place");
}

// The file was removed: it is written again with the content of the one that is still open.
void CsvWriter::move_back() {
  system::write_file(path_, beginning(file_, place_.ends.back()), system::Sync::no, system::Folder::expect);
  file_ = system::Gate::of_process().open_to_write(path_, O_RDWR | O_APPEND);
}

}  // namespace fabricsh::format
