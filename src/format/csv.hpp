// A table that grows by rows and is a complete file after each of them.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "system/descriptor.hpp"

namespace fabricsh::format {

// How far a table has come, for a program that continues it.
struct CsvPlace {
  std::vector<std::int64_t> ends;  // bytes up to the end of the header and of each row
  std::uint32_t sum = 0;           // checksum of these bytes
  void keep(Archive& archive) { archive(ends, sum); }
};

class CsvWriter {
 public:
  // Replaces the file with one header line; its folder is made when missing. Error: no columns, two of one
  // name, or a file that cannot be written.
  CsvWriter(const std::string& path, const std::vector<std::string>& columns);
  // Goes on with the table that another program has left: what lies behind the place is cut off. Error: the
  // file is not there, has other columns, or begins otherwise than it did.
  CsvWriter(const std::string& path, const std::vector<std::string>& columns, const CsvPlace& place);
  // One value per column, 17 significant digits. After an error the file still ends with its last whole row.
  // A row is one write: a program that is killed leaves it whole, but for the rare one that lies across a
  // page of memory. Taken away, the file is made again with all its rows. Error: its folder is gone, another
  // file is there.
  void row(std::span<const double> values);
  // Takes off all rows but the first n.
  void keep(std::size_t n);
  void sync();  // to the disk
  const CsvPlace& place() const { return place_; }
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
  bool regular_ = true;  // not a pipe or device
  CsvPlace place_;
};

}  // namespace fabricsh::format
