// A run as a table in CSV: one row per frame, with the time and the values of the columns.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "format/csv.hpp"
#include "run/series.hpp"

namespace fabricsh::run {

struct Column {
  std::string name;
  std::function<double(const Run&)> value;
  std::string unit = {};  // in the heading, after the name; empty: none
};

class TableSeries final : public Series {
 public:
  // Errors: a folder that cannot be written; two columns with the same name.
  TableSeries(const std::string& path, std::vector<Column> columns);
  // Continues the table of an earlier program. Error: it has been changed.
  TableSeries(const std::string& path, std::vector<Column> columns, Archive& from);
  void sync() override { writer_.sync(); }

 private:
  void write(const Run& run) override;
  void cut(std::size_t rows) override { writer_.keep(rows); }
  void keep_place(Archive& archive, std::size_t frames) override;
  format::CsvPlace place(Archive& from) const;
  std::vector<std::string> headings() const;

  std::vector<Column> columns_;
  format::CsvWriter writer_;
};

}  // namespace fabricsh::run
