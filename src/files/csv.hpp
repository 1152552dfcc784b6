// A table that grows by rows and is a complete file after each of them.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "files/descriptor.hpp"

namespace fabricsh::files {

class CsvWriter {
 public:
  // Replaces the file with one header line; its folder is made when missing. Error: no columns, two of one
  // name, or a file that cannot be written.
  CsvWriter(const std::string& path, const std::vector<std::string>& columns);
  // One value per column, 17 significant digits. After an error the file still ends with its last whole row.
  void row(std::span<const double> values);
  // Takes off all rows but the first n.
  void keep(std::size_t n);
  std::size_t rows() const { return ends_.size() - 1; }
  const std::string& path() const { return path_; }
  std::size_t columns() const { return columns_; }

 private:
  void append(const std::string& line);
  void cut();

  std::string path_;
  std::size_t columns_;
  Descriptor file_;
  std::vector<std::int64_t> ends_;  // bytes up to the end of the header and of each row
};

}  // namespace fabricsh::files
