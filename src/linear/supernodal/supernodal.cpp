// A = L S L^T with signs S, supernode by supernode [chen2008]; CHOLMOD finds ordering and supernodes. For the
// small supernodes of some thousand unknowns the kernels here take a third of the time of those of a BLAS.
//
// Threads share the work in two phases: first parts, subtrees of the elimination tree, each by one thread,
// which also sums what a part takes from the rows above it, its border; then the nodes above all parts one
// after another, each by blocks of rows. Parts and blocks do not depend on the number of threads, nor does
// the order of any sum.
#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>
#include <numeric>
#include <utility>

#include "linear/linear_solver.hpp"
#include "linear/suitesparse/ordering.hpp"
#include "linear/supernodal/dense.hpp"
#include "linear/supernodal/factors.hpp"
#include "linear/vector.hpp"
#include "simd/aligned.hpp"
#include "simd/copies.hpp"

namespace fabricsh::linear {

FABRICSH_DECLARE_COPIES(DenseKernels dense_kernels_of_isa();)

namespace {

constexpr double kMeaningless = 1e-13;      // of its diagonal entry: a pivot that means nothing
constexpr double kLeft = 1e-8;              // of the right-hand side, left of it
constexpr double kSharedFrom = 4e6;         // multiplications, from which threads share them
constexpr double kWideFrom = 1e6;           // multiplications of one node, likewise
constexpr std::size_t kSolvedFrom = 80000;  // entries of L, from which threads share its solutions
constexpr double kPart = 1.0 / 8;           // of all multiplications: those of a part at most
constexpr std::size_t kBordered = 4;        // nodes of a part from which it sums its border
constexpr long kBlock = 96, kWide = 48;  // rows and columns of a node above the parts that are done at once
constexpr long up_to(long n, long multiple) { return (n + multiple - 1) / multiple * multiple; }

class Supernodal final : public LinearSolver {
 public:
  explicit Supernodal(Ordering ordering, bool alone = false) : ordering_(ordering), alone_(alone) {}

  bool analyse(const Matrix& A) override {
    cholmod_common common;
    cholmod_l_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = use_metis(ordering_, A.size()) ? CHOLMOD_METIS : CHOLMOD_AMD;
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(A.size());
    view.nzmax = A.pattern->row.size();
    view.p = const_cast<Index*>(A.pattern->column.data());
    view.i = const_cast<Index*>(A.pattern->row.data());
    view.stype = 1;
    view.itype = CHOLMOD_LONG;
    view.xtype = CHOLMOD_PATTERN;
    view.sorted = view.packed = 1;
    cholmod_factor* L = cholmod_l_analyze(&view, &common);
    const bool out_of_memory = common.status == CHOLMOD_OUT_OF_MEMORY, found = L != nullptr;
    if (found) take(*L, A.size());
    cholmod_l_free_factor(&L, &common);
    cholmod_l_finish(&common);
    if (out_of_memory) throw std::bad_alloc();
    general_.reset();
    if (!found) return false;
    std::vector<std::size_t> node_of(place_of_.size());  // of a column
    for (std::size_t s = 0; s < nodes_.size(); ++s)
      std::fill_n(node_of.begin() + nodes_[s].first, nodes_[s].columns, s);
    divide(node_of);
    list_entries(A, node_of);
    list_updates(node_of);
    return true;
  }

  bool factorise_numbers(const Matrix& A) override {
    by_general_ = false;
    report_ = {};
    report_.fill = static_cast<Index>(value_.size());
    if (factors(A)) {
      for (const double s : sign_) report_.negative_pivots += s < 0;
      return true;
    }
    report_.singular = alone_;
    return !alone_ && by_general(A);
  }

  // Without an exchange of rows an indefinite matrix may be solved badly: what is left is looked at.
  bool solve(const Matrix& A, std::span<const double> b, std::span<double> x) override {
    if (by_general_) return general_->solve(A, b, x);
    substitute(b, x);
    if (report_.negative_pivots == 0) return true;
    const double enough = kLeft * std::sqrt(dot(b, b));
    for (bool refined = false;; refined = true) {
      left_of(A, b, x);
      if (std::sqrt(dot(left_, left_)) <= enough) return true;
      if (refined) return !alone_ && by_general(A) && general_->solve(A, b, x);
      substitute(left_, left_);
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += left_[i];
    }
  }

  LinearReport report() const override { return report_; }

 private:
  struct Node {
    Index first, row, value;  // column, of rows_, of value_
    long rows, columns, stride;
    std::size_t entries, updates, borders;  // where its lists end
  };
  struct Run {
    long from, to;
    Index at;
  };
  struct Update {
    std::size_t from_node;  // or part
    long from, to;          // the rows of that node, or border, that are columns of this one
  };
  struct Part {
    std::size_t begin, end;  // nodes
    Index row, edge,
        value;  // of its border: of rows_, of edge_, of border_; -1: its nodes update those above
    long rows, stride;
  };
  struct Workspace {  // of a thread
    std::vector<double> product, packed, below, far;
    std::vector<Index> local;  // of a row, its number in the node at work
    std::vector<Run> run;
  };

  bool by_general(const Matrix& A) {
    if (!general_) general_ = make_unsymmetric_solver(ordering_);
    by_general_ = true;
    const bool done = general_->factorise(A);
    report_ = general_->report();
    return done;
  }

  // x = A^-1 b by the factors; both may be the same.
  void substitute(std::span<const double> b, std::span<double> x) {
    for (std::size_t i = 0; i < b.size(); ++i) y_[place_of_[i]] = b[i];
    const auto parts = static_cast<Index>(parts_.size());
    make_workspaces();
    const bool by_all = shared_ && value_.size() >= kSolvedFrom;
#pragma omp parallel for schedule(dynamic, 1) if (by_all)
    for (Index p = 0; p < parts; ++p) {
      const Part& part = parts_[order_[p]];
      Workspace& work = workspaces_[omp_get_thread_num()];
      for (std::size_t s = part.begin; s < part.end; ++s) forward(nodes_[s], nodes_[part.end - 1], work);
      for (long i = 0; i < part.rows; ++i)
        edge_[part.edge + i] = std::exchange(work.far[rows_[part.row + i]], 0.0);
    }
    for (const Part& part : parts_)
      for (long i = 0; i < part.rows; ++i) y_[rows_[part.row + i]] += edge_[part.edge + i];
    for (const std::size_t s : top_) forward(nodes_[s], nodes_.back(), workspaces_[0]);
    for (std::size_t i = 0; i < b.size(); ++i) y_[i] *= sign_[i];
    for (std::size_t n = top_.size(); n-- > 0;) backward(nodes_[top_[n]], workspaces_[0]);
#pragma omp parallel for schedule(dynamic, 1) if (by_all)
    for (Index p = 0; p < parts; ++p) {
      const Part& part = parts_[order_[p]];
      for (std::size_t s = part.end; s-- > part.begin;)
        backward(nodes_[s], workspaces_[omp_get_thread_num()]);
    }
    for (std::size_t i = 0; i < b.size(); ++i) x[i] = y_[place_of_[i]];
  }

  // Rows beyond the columns of `last` are those of work.far.
  void forward(const Node& s, const Node& last, Workspace& work) {
    double* const below = work.below.data();
    kernels_.forward(value_.data() + s.value, s.stride, s.rows, s.columns, y_.data() + s.first, below);
    const Index* const row = rows_.data() + s.row;
    const Index beyond = last.first + last.columns;
    long i = s.columns;
    for (; i < s.rows && row[i] < beyond; ++i) y_[row[i]] -= below[i - s.columns];
    for (; i < s.rows; ++i) work.far[row[i]] -= below[i - s.columns];
  }

  void backward(const Node& s, Workspace& work) {
    double* const below = work.below.data();
    const Index* const row = rows_.data() + s.row;
    for (long i = s.columns; i < s.rows; ++i) below[i - s.columns] = y_[row[i]];
    kernels_.backward(value_.data() + s.value, s.stride, s.rows, s.columns, y_.data() + s.first, below);
  }

  // b - A x, of the upper half of A.
  void left_of(const Matrix& A, std::span<const double> b, std::span<const double> x) {
    left_.assign(b.begin(), b.end());
    const Pattern& pattern = *A.pattern;
    for (Index c = 0; c < pattern.size; ++c)
      for (Index k = pattern.column[c]; k < pattern.column[c + 1] && pattern.row[k] <= c; ++k) {
        const Index r = pattern.row[k];
        left_[r] -= A.value[k] * x[c];
        if (r != c) left_[c] -= A.value[k] * x[r];
      }
  }

  void take(const cholmod_factor& L, Index size) {
    const auto *starts = static_cast<const Index*>(L.super), *rows = static_cast<const Index*>(L.pi),
               *row = static_cast<const Index*>(L.s), *order = static_cast<const Index*>(L.Perm);
    nodes_.clear();
    rows_.assign(row, row + L.ssize);
    place_of_.resize(static_cast<std::size_t>(size));
    for (Index i = 0; i < size; ++i) place_of_[order[i]] = i;
    Index values = 0;
    most_ = widest_ = 0;
    for (std::size_t s = 0; s < L.nsuper; ++s) {
      Node n{starts[s], rows[s], values, rows[s + 1] - rows[s], starts[s + 1] - starts[s], 0, 0, 0, 0};
      n.stride = up_to(n.rows, kRows);
      values += n.stride * n.columns;
      most_ = std::max(most_, n.stride + kRows);
      widest_ = std::max(widest_, n.columns);
      nodes_.push_back(n);
    }
    value_.resize(static_cast<std::size_t>(values + kRows));
    y_.assign(static_cast<std::size_t>(size), 0);
    sign_.assign(static_cast<std::size_t>(size), 1);
    least_.resize(static_cast<std::size_t>(size));
    workspaces_.clear();
  }

  void make_workspaces() {
    const auto threads = static_cast<std::size_t>(shared_ ? omp_get_max_threads() : 1);
    if (workspaces_.size() >= threads) return;
    workspaces_.resize(threads);
    for (Workspace& work : workspaces_) {
      work.below.resize(static_cast<std::size_t>(most_));
      work.product.resize(static_cast<std::size_t>(most_ * up_to(kWide, kColumns)));
      work.packed.resize(static_cast<std::size_t>(widest_ * kColumns + kRows));
      work.local.resize(place_of_.size());
      work.far.resize(place_of_.size());
      work.run.resize(static_cast<std::size_t>(most_));
    }
  }

  // Finds the parts: the largest subtrees of few enough multiplications.
  void divide(const std::vector<std::size_t>& node_of) {
    std::vector<double> work(nodes_.size(), 0.0);  // of a node and those that lead to it
    std::vector<std::size_t> begin(nodes_.size());
    double all = 0;
    for (std::size_t s = 0; s < nodes_.size(); ++s) begin[s] = s;
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      const Node& n = nodes_[s];
      const auto rows = static_cast<double>(n.rows);
      work[s] += rows * rows * static_cast<double>(n.columns);
      if (n.rows == n.columns) {
        all += work[s];
        continue;
      }
      const std::size_t next = node_of[rows_[n.row + n.columns]];
      work[next] += work[s];
      begin[next] = std::min(begin[next], begin[s]);
    }
    parts_.clear();
    top_.clear();
    shared_ = all >= kSharedFrom;
    part_of_.assign(nodes_.size(), -1);
    Index values = 0, edges = 0;
    const auto add = [&](std::size_t from, std::size_t to, long columns) {
      const Node& last = nodes_[to - 1];
      Part part{from, to, last.row + last.columns, edges, -1, last.rows - columns, 0};
      part.stride = up_to(part.rows, kRows);
      edges += part.rows;
      if (to - from >= kBordered && part.rows > 0) {
        part.value = values;
        values += part.stride * part.rows;
      }
      std::fill(part_of_.begin() + static_cast<Index>(from), part_of_.begin() + static_cast<Index>(to),
                static_cast<Index>(parts_.size()));
      parts_.push_back(part);
    };
    if (!shared_) {
      if (!nodes_.empty()) add(0, nodes_.size(), nodes_.back().rows);
    } else {
      std::vector<std::size_t> ends;
      for (std::size_t end = nodes_.size(); end > 0;)
        if (work[end - 1] > kPart * all) {
          top_.push_back(--end);
        } else {
          ends.push_back(end);
          end = begin[end - 1];
        }
      std::reverse(top_.begin(), top_.end());
      for (std::size_t p = ends.size(); p-- > 0;)
        add(begin[ends[p] - 1], ends[p], nodes_[ends[p] - 1].columns);
    }
    list_waves(node_of);
    border_.resize(static_cast<std::size_t>(values + kRows));
    edge_.resize(static_cast<std::size_t>(edges));
    order_.resize(parts_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return work[parts_[a].end - 1] > work[parts_[b].end - 1];
    });
  }

  // The nodes above all parts by their height: those of the same one do not need each other.
  void list_waves(const std::vector<std::size_t>& node_of) {
    std::vector<long> height(nodes_.size(), 0);
    waves_.clear();
    for (const std::size_t s : top_) {
      waves_.emplace_back(height[s], s);
      const Node& n = nodes_[s];
      if (n.rows == n.columns) continue;
      long& next = height[node_of[rows_[n.row + n.columns]]];
      next = std::max(next, height[s] + 1);
    }
    std::stable_sort(waves_.begin(), waves_.end());
  }

  // For each node the entries of A in its columns, and where they go.
  void list_entries(const Matrix& A, const std::vector<std::size_t>& node_of) {
    const Pattern& pattern = *A.pattern;
    diagonal_.assign(place_of_.size(), -1);
    std::vector<std::vector<std::pair<Index, Index>>> lists(nodes_.size());
    for (Index c = 0; c < pattern.size; ++c)
      for (Index k = pattern.column[c]; k < pattern.column[c + 1] && pattern.row[k] <= c; ++k) {
        const Index a = place_of_[c], b = place_of_[pattern.row[k]];
        const Index column = std::min(a, b), row = std::max(a, b);
        const std::size_t s = node_of[column];
        const Node& n = nodes_[s];
        const auto rows = rows_.begin() + n.row;
        const Index place = std::lower_bound(rows, rows + n.rows, row) - rows;
        if (row == column) diagonal_[column] = k;
        lists[s].emplace_back(k, n.value + (column - n.first) * n.stride + place);
      }
    for (const std::size_t s : top_)  // by rows, for blocks of them
      std::sort(lists[s].begin(), lists[s].end(), [&](const auto& a, const auto& b) {
        return row_of(nodes_[s], a.second) < row_of(nodes_[s], b.second);
      });
    entries_.clear();
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      entries_.insert(entries_.end(), lists[s].begin(), lists[s].end());
      nodes_[s].entries = entries_.size();
    }
  }

  static long row_of(const Node& n, Index value) { return (value - n.value) % n.stride; }

  void list_updates(const std::vector<std::size_t>& node_of) {
    std::vector<std::vector<Update>> lists(nodes_.size()), borders(nodes_.size());
    const auto list = [&](std::size_t from, Index row, long begin, long rows, Index last,
                          std::vector<std::vector<Update>>& to) {
      std::size_t target = 0;
      for (long i = begin, end; i < rows && rows_[row + i] <= last; i = end) {
        target = node_of[rows_[row + i]];
        for (end = i + 1; end < rows && node_of[rows_[row + end]] == target;) ++end;
        to[target].push_back({from, i, end});
      }
    };
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      const Node& n = nodes_[s];
      Index last = static_cast<Index>(place_of_.size());
      if (part_of_[s] >= 0 && parts_[part_of_[s]].value >= 0) {
        const Node& end = nodes_[parts_[part_of_[s]].end - 1];
        last = end.first + end.columns - 1;
      }
      list(s, n.row, n.columns, n.rows, last, lists);
    }
    for (std::size_t p = 0; p < parts_.size(); ++p)
      if (parts_[p].value >= 0)
        list(p, parts_[p].row, 0, parts_[p].rows, static_cast<Index>(place_of_.size()), borders);
    taken_.assign(nodes_.size(), 0);
    updates_.clear();
    borders_.clear();
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      updates_.insert(updates_.end(), lists[s].begin(), lists[s].end());
      nodes_[s].updates = updates_.size();
      for (const Update& u : lists[s]) {
        const Node& from = nodes_[u.from_node];
        taken_[s] += static_cast<double>((from.rows - u.from) * (u.to - u.from) * from.columns);
      }
      taken_[s] += static_cast<double>(nodes_[s].rows * nodes_[s].columns * nodes_[s].columns);
      borders_.insert(borders_.end(), borders[s].begin(), borders[s].end());
      nodes_[s].borders = borders_.size();
    }
  }

  bool factors(const Matrix& A) {
    for (std::size_t i = 0; i < least_.size(); ++i)
      least_[i] = diagonal_[i] < 0 ? 0 : kMeaningless * std::abs(A.value[diagonal_[i]]);
    make_workspaces();
    std::atomic<bool> possible = true;
    const auto parts = static_cast<Index>(parts_.size());
#pragma omp parallel if (shared_)
    {
      Workspace& work = workspaces_[omp_get_thread_num()];
#pragma omp for schedule(dynamic, 1)
      for (Index p = 0; p < parts; ++p)
        if (!factors_of(parts_[order_[p]], A, work)) possible = false;
      // All threads come to the end of each loop, where they wait for each other, also when a node has
      // failed: one that reads so late could already see the failure of a node that others still work on.
      for (std::size_t t = 0; t < waves_.size();) {
        if (wide(waves_[t].second)) {
          share(waves_[t++].second, A, work, possible);
          continue;
        }
        const std::size_t begin = t;
        for (++t; t < waves_.size() && waves_[t].first == waves_[begin].first && !wide(waves_[t].second);)
          ++t;
#pragma omp for schedule(dynamic, 1)
        for (std::size_t w = begin; w < t; ++w)
          if (possible && !factors_of(waves_[w].second, A, work)) possible = false;
      }
    }
    return possible;
  }

  bool wide(std::size_t s) const { return taken_[s] > kWideFrom; }

  bool factors_of(std::size_t s, const Matrix& A, Workspace& work) {
    const Node& n = nodes_[s];
    number_rows(rows_.data() + n.row, n.rows, work);
    fill(s, A, 0, n.rows, work);
    return kernels_.factorise(value_.data() + n.value, n.stride, n.rows, 0, n.columns,
                              least_.data() + n.first, sign_.data() + n.first, work.packed.data());
  }

  // The same by all threads of a team, each of which gets blocks of rows.
  void share(std::size_t s, const Matrix& A, Workspace& work, std::atomic<bool>& possible) {
    const Node& n = nodes_[s];
    number_rows(rows_.data() + n.row, n.rows, work);
    const auto blocks = [](long rows) { return rows > 0 ? (rows + kBlock - 1) / kBlock : 0; };
    const long fills = blocks(n.rows);
#pragma omp for schedule(dynamic, 1)
    for (long b = 0; b < fills; ++b) {
      if (!possible) continue;
      fill(s, A, b * kBlock, std::min(n.rows, (b + 1) * kBlock), work);
      if (b == 0 && !pivots(n, 0, work)) possible = false;
    }
    for (long p = 0; p < n.columns; p += kWide) {
      const long end = std::min(p + kWide, n.columns), next = std::min(end + kWide, n.columns);
      const long first = up_to(end, kRows), rest = up_to(next, kRows), all = 1 + blocks(n.rows - rest);
#pragma omp for schedule(dynamic, 1)
      for (long b = 0; b < all; ++b) {
        if (!possible) continue;
        const long from = b == 0 ? first : rest + (b - 1) * kBlock;
        extend(n, p, end, from, std::min(b == 0 ? rest : from + kBlock, n.rows), work);
        if (b == 0 && end < n.columns && !pivots(n, end, work)) possible = false;
      }
    }
  }

  // Columns `first` and those that are done with it, of so many rows that blocks can follow.
  bool pivots(const Node& n, long first, Workspace& work) {
    const long end = std::min(first + kWide, n.columns);
    return kernels_.factorise(value_.data() + n.value, n.stride, std::min(up_to(end, kRows), n.rows), first,
                              end, least_.data() + n.first, sign_.data() + n.first, work.packed.data());
  }
  void extend(const Node& n, long first, long end, long from, long to, Workspace& work) {
    if (from < to)
      kernels_.extend(value_.data() + n.value, n.stride, from, to, first, end, sign_.data() + n.first,
                      work.packed.data());
  }

  static void number_rows(const Index* row, long rows, Workspace& work) {
    for (long i = 0; i < rows; ++i) work.local[row[i]] = i;
  }

  bool factors_of(const Part& part, const Matrix& A, Workspace& work) {
    for (std::size_t s = part.begin; s < part.end; ++s)
      if (!factors_of(s, A, work)) return false;
    if (part.value < 0) return true;
    double* const border = border_.data() + part.value;
    std::fill_n(border, part.stride * part.rows, 0.0);
    number_rows(rows_.data() + part.row, part.rows, work);
    for (std::size_t s = part.begin; s < part.end; ++s) {
      const Node& n = nodes_[s];
      const Index* const row = rows_.data() + n.row;
      const long from = std::lower_bound(row, row + n.rows, rows_[part.row]) - row;
      subtract({s, from, n.rows}, 0, part.rows, border, part.stride, work);
    }
    return true;
  }

  // Entries of A in rows `begin` to `end` of a node, and all that others take from them.
  void fill(std::size_t s, const Matrix& A, long begin, long end, Workspace& work) {
    const Node& n = nodes_[s];
    double* const values = value_.data() + n.value;
    for (long j = 0; j < n.columns; ++j)
      std::fill(values + j * n.stride + begin, values + j * n.stride + (end == n.rows ? n.stride : end), 0.0);
    const std::size_t entry = s == 0 ? 0 : nodes_[s - 1].entries;
    const auto entries = std::span(entries_).subspan(entry, n.entries - entry);
    auto e = entries.begin();
    if (begin > 0)
      e = std::lower_bound(e, entries.end(), begin,
                           [&](const auto& a, long row) { return row_of(n, a.second) < row; });
    const bool whole = end == n.rows;
    for (; e != entries.end() && (whole || row_of(n, e->second) < end); ++e)
      value_[e->second] = A.value[e->first];
    for (std::size_t u = s == 0 ? 0 : nodes_[s - 1].borders; u < n.borders; ++u)
      add_border(borders_[u], begin, end, values, n.stride, work);
    for (std::size_t u = s == 0 ? 0 : nodes_[s - 1].updates; u < n.updates; ++u)
      subtract(updates_[u], begin, end, values, n.stride, work);
  }

  // Runs of rows, from row[from] on, whose numbers follow each other within `begin` to `end`.
  std::span<const Run> runs(const Index* row, long from, long rows, long begin, long end, Workspace& work) {
    std::size_t count = 0;
    const auto before = [&](Index r, long number) { return work.local[r] < number; };
    if (begin > 0) from = std::lower_bound(row + from, row + rows, begin, before) - row;
    for (long i = from, next; i < rows; i = next) {
      const Index at = work.local[row[i]];
      if (at >= end) break;
      for (next = i + 1; next < rows && work.local[row[next]] == at + next - i && at + next - i < end;)
        ++next;
      work.run[count++] = {i, next, at};
    }
    return {work.run.data(), count};
  }

  void add_border(const Update& update, long begin, long end, double* values, long stride, Workspace& work) {
    const Part& part = parts_[update.from_node];
    const Index* const row = rows_.data() + part.row;
    const auto of = runs(row, update.from, part.rows, begin, end, work);
    if (of.empty()) return;
    for (long j = update.from; j < std::min(update.to, of.back().to); ++j) {
      double* const column = values + work.local[row[j]] * stride;
      const double* const c = border_.data() + part.value + j * part.stride;
      for (const auto [from, to, at] : of)
        for (long i = from; i < to; ++i) column[at + i - from] += c[i];
    }
  }

  // Rows `begin` to `end` of the target alone.
  void subtract(const Update& update, long begin, long end, double* values, long stride, Workspace& work) {
    const Node& from = nodes_[update.from_node];
    const Index* const row = rows_.data() + from.row;
    const auto of = runs(row, update.from, from.rows, begin, end, work);
    if (of.empty()) return;
    const double* const a = value_.data() + from.value;
    const long last = of.back().to;
    for (long j = update.from; j < std::min(update.to, last); j += kWide) {
      const long n = std::min({kWide, update.to - j, last - j}), first = std::max(of.front().from, j),
                 rows = last - first, ldc = up_to(rows, kRows);
      kernels_.product(a + first, from.stride, a + j, from.stride, sign_.data() + from.first, rows, n,
                       from.columns, work.product.data(), ldc, work.packed.data());
      for (long l = 0; l < n; ++l) {
        double* const column = values + work.local[row[j + l]] * stride;
        const double* const c = work.product.data() + l * ldc - first;
        for (const auto [begins, ends, at] : of) {
          double* const x = column + at - begins;
          for (long i = std::max(begins, first); i < ends; ++i) x[i] -= c[i];
        }
      }
    }
  }

  const Ordering ordering_;
  const bool alone_;  // without general_
  const DenseKernels kernels_ = FABRICSH_COPY_FOR(best_isa(), dense_kernels_of_isa)();
  std::vector<Node> nodes_;
  std::vector<Part> parts_;
  std::vector<std::size_t> top_, order_;             // nodes above all parts; parts, the longest first
  std::vector<std::pair<long, std::size_t>> waves_;  // heights and nodes above all parts
  std::vector<Index> part_of_;                       // of a node; -1: above all
  std::vector<double> taken_;                        // multiplications that a node takes
  bool shared_ = false;
  std::vector<Index> rows_, place_of_;  // rows of all nodes; of an unknown in the order of elimination
  std::vector<Index> diagonal_;         // entries of A
  std::vector<std::pair<Index, Index>> entries_;  // of A, and where in value_ they go
  std::vector<Update> updates_, borders_;
  LineVector value_, border_;  // of L; what parts take from the rows above them
  long most_ = 0, widest_ = 0;
  std::vector<double> sign_, least_, y_, edge_;
  std::vector<Workspace> workspaces_;
  Vector left_;
  std::unique_ptr<LinearSolver> general_;
  bool by_general_ = false;
  LinearReport report_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_symmetric_solver(Ordering ordering) {
  return std::make_unique<Supernodal>(ordering);
}

std::unique_ptr<LinearSolver> make_symmetric_factors() {
  return std::make_unique<Supernodal>(Ordering::automatic, true);
}

}  // namespace fabricsh::linear
