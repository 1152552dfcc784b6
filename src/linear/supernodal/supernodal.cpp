// A = L S L^T with signs S, supernode by supernode [chen2008]; CHOLMOD finds ordering and supernodes. For the
// small supernodes of some thousand unknowns the kernels here take a third of the time of those of a BLAS.
#include "linear/supernodal/supernodal.hpp"

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "linear/suitesparse/ordering.hpp"
#include "linear/supernodal/dense.hpp"
#include "linear/vector.hpp"
#include "simd/aligned.hpp"
#include "simd/copies.hpp"

namespace fabricsh::linear {

FABRICSH_DECLARE_COPIES(DenseKernels dense_kernels_of_isa();)

namespace {

constexpr double kMeaningless = 1e-13;  // of the largest diagonal entry: a pivot that means nothing
constexpr double kLeft = 1e-8;          // of the right-hand side, left of it
constexpr long up_to(long n, long multiple) { return (n + multiple - 1) / multiple * multiple; }

class Supernodal final : public LinearSolver {
 public:
  bool analyse(const Matrix& A) override {
    cholmod_common common;
    cholmod_l_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = use_metis(Ordering::automatic, A.size()) ? CHOLMOD_METIS : CHOLMOD_AMD;
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
    return by_general(A);
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
      if (refined) return by_general(A) && general_->solve(A, b, x);
      substitute(left_, left_);
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += left_[i];
    }
  }

  LinearReport report() const override { return report_; }

 private:
  struct Node {
    Index first, row, value;  // column, of rows_, of value_
    long rows, columns, stride;
    std::size_t entries, updates;  // where its lists end
  };
  struct Run {
    long from, to;
    Index at;
  };
  struct Update {
    Index node;
    long from, to;  // the rows of that node that are columns of this one
  };

  bool by_general(const Matrix& A) {
    if (!general_) general_ = make_unsymmetric_solver();
    by_general_ = true;
    const bool done = general_->factorise(A);
    report_ = general_->report();
    return done;
  }

  // x = A^-1 b by the factors; both may be the same.
  void substitute(std::span<const double> b, std::span<double> x) {
    const DenseKernels& k = kernels_;
    for (std::size_t i = 0; i < b.size(); ++i) y_[place_of_[i]] = b[i];
    for (const Node& s : nodes_) {
      k.forward(value_.data() + s.value, s.stride, s.rows, s.columns, y_.data() + s.first, below_.data());
      const Index* const row = rows_.data() + s.row;
      for (long i = s.columns; i < s.rows; ++i) y_[row[i]] -= below_[i - s.columns];
    }
    for (std::size_t i = 0; i < b.size(); ++i) y_[i] *= sign_[i];
    for (std::size_t n = nodes_.size(); n-- > 0;) {
      const Node& s = nodes_[n];
      const Index* const row = rows_.data() + s.row;
      for (long i = s.columns; i < s.rows; ++i) below_[i - s.columns] = y_[row[i]];
      k.backward(value_.data() + s.value, s.stride, s.rows, s.columns, y_.data() + s.first, below_.data());
    }
    for (std::size_t i = 0; i < b.size(); ++i) x[i] = y_[place_of_[i]];
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
    long most = 0, widest = 0;
    for (std::size_t s = 0; s < L.nsuper; ++s) {
      Node n{starts[s], rows[s], values, rows[s + 1] - rows[s], starts[s + 1] - starts[s], 0, 0, 0};
      n.stride = up_to(n.rows, kRows);
      values += n.stride * n.columns;
      most = std::max(most, n.stride + kRows);
      widest = std::max(widest, up_to(n.columns, kColumns));
      nodes_.push_back(n);
    }
    value_.resize(static_cast<std::size_t>(values + kRows));
    y_.assign(static_cast<std::size_t>(size), 0);
    sign_.assign(static_cast<std::size_t>(size), 1);
    below_.assign(static_cast<std::size_t>(most), 0);
    product_.resize(static_cast<std::size_t>(most * widest));
    packed_.resize(static_cast<std::size_t>(widest * kColumns));
    local_.resize(static_cast<std::size_t>(size));
    run_.resize(static_cast<std::size_t>(most));
  }

  // For each node the entries of A in its columns, and where they go.
  void list_entries(const Matrix& A, const std::vector<std::size_t>& node_of) {
    const Pattern& pattern = *A.pattern;
    diagonal_.clear();
    std::vector<std::vector<std::pair<Index, Index>>> lists(nodes_.size());
    for (Index c = 0; c < pattern.size; ++c)
      for (Index k = pattern.column[c]; k < pattern.column[c + 1] && pattern.row[k] <= c; ++k) {
        const Index a = place_of_[c], b = place_of_[pattern.row[k]];
        const Index column = std::min(a, b), row = std::max(a, b);
        const std::size_t s = node_of[column];
        const Node& n = nodes_[s];
        const auto rows = rows_.begin() + n.row;
        const Index place = std::lower_bound(rows, rows + n.rows, row) - rows;
        if (row == column) diagonal_.push_back(k);
        lists[s].emplace_back(k, n.value + (column - n.first) * n.stride + place);
      }
    entries_.clear();
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      entries_.insert(entries_.end(), lists[s].begin(), lists[s].end());
      nodes_[s].entries = entries_.size();
    }
  }

  void list_updates(const std::vector<std::size_t>& node_of) {
    std::vector<std::vector<Update>> lists(nodes_.size());
    std::size_t target = 0;
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      const Node& n = nodes_[s];
      for (long i = n.columns, end; i < n.rows; i = end) {
        target = node_of[rows_[n.row + i]];
        for (end = i + 1; end < n.rows && node_of[rows_[n.row + end]] == target;) ++end;
        lists[target].push_back({static_cast<Index>(s), i, end});
      }
    }
    updates_.clear();
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      updates_.insert(updates_.end(), lists[s].begin(), lists[s].end());
      nodes_[s].updates = updates_.size();
    }
  }

  bool factors(const Matrix& A) {
    const DenseKernels& k = kernels_;
    double largest = 0;
    for (const Index d : diagonal_) largest = std::max(largest, std::abs(A.value[d]));
    std::size_t entry = 0, update = 0;
    for (const Node& n : nodes_) {
      double* const values = value_.data() + n.value;
      std::fill_n(values, n.stride * n.columns, 0.0);
      for (; entry < n.entries; ++entry) value_[entries_[entry].second] = A.value[entries_[entry].first];
      const Index* const row = rows_.data() + n.row;
      for (long i = 0; i < n.rows; ++i) local_[row[i]] = i;
      for (; update < n.updates; ++update) subtract(updates_[update], n, values);
      if (!k.factorise(values, n.stride, n.rows, n.columns, kMeaningless * largest, sign_.data() + n.first,
                       packed_.data()))
        return false;
    }
    return true;
  }

  void subtract(const Update& update, const Node& to, double* values) {
    const Node& from = nodes_[update.node];
    const double* const a = value_.data() + from.value + update.from;
    const long m = from.rows - update.from, n = update.to - update.from, stride = up_to(m, kRows);
    kernels_.product(a, from.stride, a, from.stride, sign_.data() + from.first, m, n, from.columns,
                     product_.data(), stride, packed_.data());
    const Index* const row = rows_.data() + from.row + update.from;
    // Rows that follow each other in both nodes.
    std::size_t runs = 0;
    for (long i = 0, end; i < m; i = end) {
      const Index at = local_[row[i]];
      for (end = i + 1; end < m && local_[row[end]] == at + end - i;) ++end;
      run_[runs++] = {i, end, at};
    }
    for (long j = 0; j < n; ++j) {
      double* const column = values + (row[j] - to.first) * to.stride;
      const double* const c = product_.data() + j * stride;
      for (std::size_t r = 0; r < runs; ++r) {
        const auto [i, end, at] = run_[r];
        double* const x = column + at - i;
        for (long l = i; l < end; ++l) x[l] -= c[l];
      }
    }
  }

  const DenseKernels kernels_ = FABRICSH_COPY_FOR(best_isa(), dense_kernels_of_isa)();
  std::vector<Node> nodes_;
  std::vector<Index> rows_, place_of_;  // rows of all nodes; of an unknown in the order of elimination
  std::vector<Index> diagonal_;         // entries of A
  std::vector<std::pair<Index, Index>> entries_;  // of A, and where in value_ they go
  std::vector<Update> updates_;
  LineVector value_;  // of L
  std::vector<double> sign_, y_, below_, product_, packed_;
  Vector left_;
  std::vector<Index> local_;  // of a row, its number in the node at work
  std::vector<Run> run_;
  std::unique_ptr<LinearSolver> general_;
  bool by_general_ = false;
  LinearReport report_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_signed_solver() { return std::make_unique<Supernodal>(); }

}  // namespace fabricsh::linear
