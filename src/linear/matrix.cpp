#include "linear/matrix.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>

#include "base/shares.hpp"
#include "linear/vector.hpp"

namespace fabricsh::linear {

namespace {

constexpr Index kShared = 50000;  // entries from which threads share them

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
  Pattern made(std::move(starts), std::move(rows));
  made.upper = upper;
  return made;
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

void Matrix::clear() {
  const Index n = static_cast<Index>(value.size());
  for_each_index(n, n > kShared, [&](Index i) { value[static_cast<std::size_t>(i)] = 0; });
  apart.clear();
  ranks = {};
}

void Matrix::scale(double factor) {
  const Index n = static_cast<Index>(value.size());
#pragma omp parallel for schedule(static) if (n > kShared)
  for (Index i = 0; i < n; ++i) value[static_cast<std::size_t>(i)] *= factor;
  for (double& v : apart) v *= factor;
  if (!ranks.empty()) ranks.core *= factor;
}

void Matrix::follow(const std::shared_ptr<const Pattern>& p) {
  if (p->version == pattern->version) return;
  pattern = p;
  value.assign(static_cast<std::size_t>(pattern->entries()), 0.0);
  apart.clear();
}

void Matrix::change_pattern(const std::shared_ptr<const Pattern>& p) {
  if (p->version == pattern->version) return;
  for (auto* const entries : {&value, &apart}) {
    if (entries->empty()) continue;
    std::vector<double> moved(static_cast<std::size_t>(p->entries()), 0.0);
    for (Index c = 0; c < size(); ++c)
      for (Index k = pattern->column[c]; k < pattern->column[c + 1]; ++k)
        if (const double v = (*entries)[static_cast<std::size_t>(k)]; v != 0)
          moved[static_cast<std::size_t>(p->slot(pattern->row[k], c))] = v;
    *entries = std::move(moved);
  }
  pattern = p;
}

Matrix without_zeros(const Matrix& A) {
  std::vector<Index> starts{0}, rows;
  std::vector<double> value;
  for (Index c = 0; c < A.size(); ++c) {
    for (Index k = A.pattern->column[c]; k < A.pattern->column[c + 1]; ++k) {
      const double v = A.value[static_cast<std::size_t>(k)];
      if (v == 0) continue;
      rows.push_back(A.pattern->row[k]);
      value.push_back(v);
    }
    starts.push_back(static_cast<Index>(rows.size()));
  }
  Pattern few(std::move(starts), std::move(rows));
  few.upper = A.pattern->upper;
  Matrix out(std::make_shared<const Pattern>(std::move(few)));
  out.value = std::move(value);
  return out;
}

namespace {

// Both triangles of an upper pattern. Columns are visited in ascending order, so that rows are.
Pattern both_triangles(const Pattern& upper) {
  std::vector<Index> starts(static_cast<std::size_t>(upper.size) + 1, 0);
  const auto each = [&](auto visit) {
    for (Index c = 0; c < upper.size; ++c)
      for (Index k = upper.column[c]; k < upper.column[c + 1] && upper.row[k] <= c; ++k)
        visit(upper.row[k], c);
  };
  each([&](Index r, Index c) {
    ++starts[c + 1];
    if (r != c) ++starts[r + 1];
  });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<Index> rows(static_cast<std::size_t>(starts.back())), next(starts.begin(), starts.end() - 1);
  each([&](Index r, Index c) { rows[next[c]++] = r; });
  each([&](Index r, Index c) {
    if (r != c) rows[next[r]++] = c;
  });
  return {std::move(starts), std::move(rows)};
}

// The sums of the absolute entries of columns. Those of a node are as long, and each addition has to wait for
// the one before: four are done at once.
void add_columns(const Matrix& A, std::vector<double>& sums) {
  constexpr Index group = 4;
  const Index size = A.size();
  const std::vector<Index>& start = A.pattern->column;
#pragma omp parallel for schedule(static) if (A.pattern->entries() > kShared)
  for (Index first = 0; first < size; first += group) {
    const Index n = std::min(group, size - first);
    double sum[group] = {};
    Index common = start[first + 1] - start[first];
    for (Index c = first + 1; c < first + n; ++c) common = std::min(common, start[c + 1] - start[c]);
    for (Index k = 0; k < common; ++k)
      for (Index c = 0; c < n; ++c) sum[c] += std::abs(A.entry(start[first + c] + k));
    for (Index c = 0; c < n; ++c) {
      for (Index k = start[first + c] + common; k < start[first + c + 1]; ++k) sum[c] += std::abs(A.entry(k));
      sums[static_cast<std::size_t>(first + c)] = sum[c];
    }
  }
}

// The sums of the absolute entries of the ranks, or more where several cancel.
void add_absolute(const FewRanks& ranks, std::vector<double>& sums) {
  std::vector<double> whole;
  for (const auto& u : ranks.columns)
    whole.push_back(
        std::accumulate(u.begin(), u.end(), 0.0, [](double s, double v) { return s + std::abs(v); }));
  for (std::size_t i = 0; i < ranks.columns.size(); ++i)
    for (std::size_t j = 0; j < ranks.columns.size(); ++j) {
      const double c = std::abs(ranks.core(static_cast<Index>(i), static_cast<Index>(j))) * whole[i];
      for (std::size_t n = 0; c > 0 && n < sums.size(); ++n) sums[n] += c * std::abs(ranks.columns[j][n]);
    }
}

// y += U C U^T x.
void multiply(const FewRanks& ranks, std::span<const double> x, std::span<double> y) {
  const auto k = static_cast<Index>(ranks.columns.size());
  Eigen::VectorXd along(k);
  for (Index i = 0; i < k; ++i) along[i] = dot(ranks.columns[static_cast<std::size_t>(i)], x);
  const Eigen::VectorXd weight = ranks.core * along;
  for (Index i = 0; i < k; ++i)
    for (std::size_t n = 0; n < y.size(); ++n)
      y[n] += weight[i] * ranks.columns[static_cast<std::size_t>(i)][n];
}

}  // namespace

// Either way the entries of a column are added in the order of its rows.
void absolute_sums(const Matrix& A, std::vector<double>& sums) {
  const Pattern& pattern = *A.pattern;
  sums.assign(static_cast<std::size_t>(A.size()), 0.0);
  if (!pattern.upper) {
    add_columns(A, sums);
  } else {
    for (Index c = 0; c < A.size(); ++c)
      for (Index k = pattern.column[c]; k < pattern.column[c + 1] && pattern.row[k] <= c; ++k) {
        const Index r = pattern.row[k];
        const double a = std::abs(A.entry(k));
        sums[static_cast<std::size_t>(c)] += a;
        if (r < c) sums[static_cast<std::size_t>(r)] += a;
      }
  }
  if (!A.ranks.empty()) add_absolute(A.ranks, sums);
  const double largest = sums.empty() ? 0 : *std::max_element(sums.begin(), sums.end());
  for (double& s : sums) s = std::max(s, 1e-12 * largest);
}

void add_diagonal(const Matrix& K, double m, std::span<const double> D, Matrix& A) {
  A = K;
  for (Index c = 0; m > 0 && c < K.size(); ++c) A.add(c, c, m * D[c]);
}

void multiply(const Matrix& A, std::span<const double> x, std::span<double> y) {
  const Pattern& pattern = *A.pattern;
  std::fill(y.begin(), y.end(), 0.0);
  for (Index c = 0; c < A.size(); ++c)
    for (Index k = pattern.column[c]; k < pattern.column[c + 1]; ++k) {
      const Index r = pattern.row[k];
      if (pattern.upper && r > c) break;
      const double a = A.entry(k);
      y[r] += a * x[c];
      if (pattern.upper && r < c) y[c] += a * x[r];
    }
  if (!A.ranks.empty()) multiply(A.ranks, x, y);
}

double symmetric_part(const Matrix& K, std::span<const double> D, Matrix& S) {
  S = K;
  S.apart.clear();
  if (!S.ranks.empty()) S.ranks.core = ((K.ranks.core + K.ranks.core.transpose()) / 2).eval();
  const Pattern& pattern = *K.pattern;
  double most = 0;
  for (Index c = 0; c < K.size() && !pattern.upper; ++c)
    for (Index k = pattern.column[c]; k < pattern.column[c + 1] && pattern.row[k] <= c; ++k) {
      const Index r = pattern.row[k], opposite = pattern.slot(c, r);
      const double above = K.entry(k), below = K.entry(opposite);
      S.value[static_cast<std::size_t>(k)] = S.value[static_cast<std::size_t>(opposite)] =
          (above + below) / 2;
      most = std::max(most, std::abs(above - below) / std::max(D[r], D[c]));
    }
  return most;
}

void mirror(const Matrix& A, std::uint64_t& of, Matrix& K) {
  const Pattern& upper = *A.pattern;
  if (of != upper.version) K = Matrix(std::make_shared<const Pattern>(both_triangles(upper)));
  of = upper.version;
  // The rows of column r beyond the diagonal are the columns c with an entry (r, c), in their order.
  const Pattern& both = *K.pattern;
  std::vector<Index> next(both.column.begin(), both.column.end() - 1);
  for (Index c = 0; c < upper.size; ++c)
    for (Index k = upper.column[c]; k < upper.column[c + 1] && upper.row[k] <= c; ++k)
      K.value[static_cast<std::size_t>(next[c]++)] = A.value[static_cast<std::size_t>(k)];
  for (Index c = 0; c < upper.size; ++c)
    for (Index k = upper.column[c]; k < upper.column[c + 1] && upper.row[k] < c; ++k)
      K.value[static_cast<std::size_t>(next[upper.row[k]]++)] = A.value[static_cast<std::size_t>(k)];
}

}  // namespace fabricsh::linear
