#include "linear/matrix.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <stdexcept>

namespace fabricsh::linear {

namespace {

std::uint64_t next_version() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

Pattern::Pattern(std::vector<std::vector<Index>>&& columns)
    : size(static_cast<Index>(columns.size())), version(next_version()) {
  column.assign(1, 0);
  for (auto& rows : columns) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    row.insert(row.end(), rows.begin(), rows.end());
    column.push_back(static_cast<Index>(row.size()));
    std::vector<Index>().swap(rows);
  }
}

Pattern::Pattern(std::vector<Index> starts, std::vector<Index> rows)
    : size(static_cast<Index>(starts.size()) - 1),
      column(std::move(starts)),
      row(std::move(rows)),
      version(next_version()) {}

Pattern Pattern::with(std::vector<std::vector<Index>>&& further) const {
  std::vector<Index> starts{0}, rows;
  rows.reserve(row.size());
  for (Index c = 0; c < size; ++c) {
    auto& more = further[static_cast<std::size_t>(c)];
    std::sort(more.begin(), more.end());
    more.erase(std::unique(more.begin(), more.end()), more.end());
    std::set_union(row.begin() + column[c], row.begin() + column[c + 1], more.begin(), more.end(),
                   std::back_inserter(rows));
    starts.push_back(static_cast<Index>(rows.size()));
    std::vector<Index>().swap(more);
  }
  return {std::move(starts), std::move(rows)};
}

Index Pattern::slot(Index r, Index c) const {
  const auto first = row.begin() + column[c], last = row.begin() + column[c + 1];
  const auto found = std::lower_bound(first, last, r);
  if (found == last || *found != r) {
    assert(!"an entry outside the pattern of a matrix");
    throw std::logic_error("an entry outside the pattern of a matrix: row " + std::to_string(r) +
                           ", column " + std::to_string(c));
  }
  return found - row.begin();
}

void Matrix::clear() { std::fill(value.begin(), value.end(), 0.0); }

void Matrix::follow(const std::shared_ptr<const Pattern>& p) {
  if (p->version == pattern->version) return;
  pattern = p;
  value.assign(static_cast<std::size_t>(pattern->entries()), 0.0);
}

void Matrix::carry(const std::shared_ptr<const Pattern>& p) {
  if (p->version == pattern->version) return;
  std::vector<double> carried(static_cast<std::size_t>(p->entries()), 0.0);
  for (Index c = 0; c < size(); ++c)
    for (Index k = pattern->column[c]; k < pattern->column[c + 1]; ++k)
      if (const double v = value[static_cast<std::size_t>(k)]; v != 0)
        carried[static_cast<std::size_t>(p->slot(pattern->row[k], c))] = v;
  pattern = p;
  value = std::move(carried);
}

}  // namespace fabricsh::linear
