#include "base/error.hpp"
#include "format/csv.hpp"
#include "run/series.hpp"

namespace fabricsh::run {

namespace {

std::vector<std::string> headings(const std::vector<RecordColumn>& columns) {
  std::vector<std::string> words = {"time (s)"};
  for (const RecordColumn& column : columns)
    words.push_back(column.unit.empty() ? column.name : column.name + " (" + column.unit + ")");
  return words;
}

format::CsvPlace place_in(Archive& from, std::size_t frames) {
  format::CsvPlace place;
  from(place);
  if (place.ends.size() != frames + 1)
    throw Error("the number of rows of a table differs from what was counted");
  return place;
}

class TableSeries final : public Series {
 public:
  TableSeries(const std::string& path, std::vector<RecordColumn> columns, Archive* from)
      : Series(from),
        columns_(std::move(columns)),
        writer_(from == nullptr ? format::CsvWriter(path, headings(columns_))
                                : format::CsvWriter(path, headings(columns_), place_in(*from, frames()))) {}
  void sync() override { writer_.sync(); }

 private:
  void write(const Run& run) override {
    std::vector<double> values = {run.time()};
    for (const RecordColumn& column : columns_) values.push_back(column.value(run));
    writer_.row(values);
  }
  void cut(std::size_t rows) override { writer_.keep(rows); }
  void keep_place(Archive& archive, std::size_t frames) override {
    format::CsvPlace place = writer_.place(frames);
    archive(place);
  }

  std::vector<RecordColumn> columns_;
  format::CsvWriter writer_;
};

}  // namespace

std::shared_ptr<Series> make_table(const std::string& path, std::vector<RecordColumn> columns,
                                   Archive* from) {
  return std::make_shared<TableSeries>(path, std::move(columns), from);
}

}  // namespace fabricsh::run
