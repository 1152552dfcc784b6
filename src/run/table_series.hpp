// A run as a table: one row a frame, the time and what the columns say, as CSV.
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
  std::string unit = {};  // in the heading, behind the name; empty: none
};

class TableSeries final : public Series {
 public:
  // Errors: a folder that can't be written; a column that comes twice.
  TableSeries(const std::string& path, std::vector<Column> columns);
  // Goes on with a table that another program has left. Error: it is not as it was kept.
  TableSeries(const std::string& path, std::vector<Column> columns, Archive& from);
  void sync() override { writer_.sync(); }

 private:
  void write(const Run& run) override;
  void cut(std::size_t rows) override { writer_.keep(rows); }
  void keep_place(Archive& archive) override;
  format::CsvPlace place(Archive& from) const;
  std::vector<std::string> headings() const;

  std::vector<Column> columns_;
  format::CsvWriter writer_;
};

}  // namespace fabricsh::run
