// A table that grows row by row and is a complete file after each row.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "system/gate.hpp"

namespace fabricsh::format {

// The state of a table, for a program that continues it after a restart.
struct CsvPlace {
  std::vector<std::int64_t> ends;  // bytes up to the end of the header and of each row
  std::uint32_t sum = 0;           // checksum of these bytes
  void keep(Archive& archive) { archive(ends, sum); }
};

class CsvWriter {
 public:
  // Replaces the file by one with a header line; a missing folder is created. Error:
  // no columns, two columns of the same name, or a file that cannot be written.
  CsvWriter(const std::string& path, const std::vector<std::string>& columns);
  // Continues the table of an earlier program: what lies behind `place` is cut off. Error:
  // the file does not exist, has other columns, or its content before `place` has changed.
  CsvWriter(const std::string& path, const std::vector<std::string>& columns, const CsvPlace& place);
  // Appends one value per column, with 17 significant digits. After an error the file still ends
  // with its last whole row. A row is one write call, so that killing the program leaves whole rows,
  // except rarely for a row that crosses a page of memory. A file that was removed is written again
  // with all its rows. Error: its folder has disappeared, or another file has taken its place.
  void row(std::span<const double> values);
  // Removes all rows but the first n.
  void keep(std::size_t n);
  void sync();  // forces the rows to the disk
  const CsvPlace& place() const { return place_; }
  CsvPlace place(std::size_t rows) const;  // as if there were only the first ones
  std::size_t rows() const { return place_.ends.size() - 1; }
  const std::string& path() const { return path_; }
  std::size_t columns() const { return columns_; }

 private:
  void append(const std::string& line);
  void cut();
  void check_place();
  void move_back();

  std::string path_;
  std::size_t columns_;
  system::Descriptor file_;
  bool regular_ = true;  // neither a pipe nor a device
  CsvPlace place_;
};

}  // namespace fabricsh::format
