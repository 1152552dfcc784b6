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
  const std::string& path() const { return path_; }
  std::size_t columns() const { return columns_; }

 private:
  void append(const std::string& line);

  std::string path_;
  std::size_t columns_;
  Descriptor file_;
  std::int64_t length_ = 0;  // bytes of whole lines
};

}  // namespace fabricsh::files
