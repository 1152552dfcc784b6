#include "run/table_series.hpp"

#include "base/error.hpp"

namespace fabricsh::run {

TableSeries::TableSeries(const std::string& path, std::vector<Column> columns)
    : columns_(std::move(columns)), writer_(path, headings()) {}

TableSeries::TableSeries(const std::string& path, std::vector<Column> columns, Archive& from)
    : Series(from), columns_(std::move(columns)), writer_(path, headings(), place(from)) {}

void TableSeries::write(const Run& run) {
  std::vector<double> values = {run.time()};
  for (const Column& column : columns_) values.push_back(column.value(run));
  writer_.row(values);
}

void TableSeries::keep_place(Archive& archive, std::size_t frames) {
  format::CsvPlace place = writer_.place(frames);
  archive(place);
}

format::CsvPlace TableSeries::place(Archive& from) const {
  format::CsvPlace place;
  from(place);
  if (place.ends.size() != frames() + 1)
    throw Error("the number of rows of a table differs from what was counted");
  return place;
}

std::vector<std::string> TableSeries::headings() const {
  std::vector<std::string> words = {"time (s)"};
  for (const Column& column : columns_)
    words.push_back(column.unit.empty() ? column.name : column.name + " (" + column.unit + ")");
  return words;
}

}  // namespace fabricsh::run
