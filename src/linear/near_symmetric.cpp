// Matrices that are symmetric but for a few entries, as sliding friction makes them. The factors of the
// symmetric part, which Cholesky's method finds in a fraction of the time of others, precondition GMRES
// [saad1986]: with parts of few unknowns that are not symmetric it ends after few iterations. What a matrix
// keeps apart is not in that part: half of it would often make it indefinite.
#include "linear/near_symmetric.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "linear/supernodal/factors.hpp"
#include "linear/vector.hpp"

namespace fabricsh::linear {

namespace {

constexpr double kEnough = 1e-6;         // of the right-hand side, left of it
constexpr double kRounded = 1e-12;       // of two opposite entries: they differ by rounding alone
constexpr Index kMost = 40;              // iterations, beyond which the whole matrix is factorised
constexpr double kHalfWay = 0.05;        // left after half of them, with which they do not lead there
constexpr std::size_t kTogether = 8192;  // entries that one thread takes together
constexpr std::size_t kAtOnce = 32;      // entries that are looked at together: most have nothing to find

class NearSymmetric final : public LinearSolver {
 public:
  bool analyse(const Matrix& A) override {
    whole_.reset();
    if (A.pattern->upper) return half_->prepare(A);
    const Pattern& pattern = *A.pattern;
    std::vector<Index> starts{0}, rows;
    std::vector<Index> next;  // of a column: its entry below the diagonal whose turn it is
    above_.clear();
    below_.clear();
    for (Index c = 0; c < pattern.size; ++c) {
      Index k = pattern.column[c];
      for (; k < pattern.column[c + 1] && pattern.row[k] <= c; ++k) {
        const Index r = pattern.row[k], opposite = r == c ? k : next[r]++;
        const bool there = opposite < pattern.column[r + 1] && pattern.row[opposite] == c;
        above_.push_back(k);
        below_.push_back(there ? opposite : pattern.slot(c, r));
        rows.push_back(r);
      }
      next.push_back(k);
      starts.push_back(static_cast<Index>(rows.size()));
    }
    Pattern upper(std::move(starts), std::move(rows));
    upper.upper = true;
    S_ = Matrix(std::make_shared<const Pattern>(std::move(upper)));
    return half_->prepare(S_);
  }

  bool factorise_numbers(const Matrix& A) override {
    by_whole_ = false;
    rest_.clear();
    if (A.pattern->upper) return half_->factorise(A) || by_whole(A);
    const std::size_t parts = (above_.size() + kTogether - 1) / kTogether;
    rests_.resize(parts);
#pragma omp parallel for schedule(static) if (parts > 1)
    for (std::size_t p = 0; p < parts; ++p) {
      rests_[p].clear();
      take_mean(A, p * kTogether, std::min((p + 1) * kTogether, above_.size()), rests_[p]);
    }
    for (const auto& part : rests_) rest_.insert(rest_.end(), part.begin(), part.end());
    take_apart(A);
    return half_->factorise(S_) || by_whole(A);
  }

  bool solve(const Matrix& A, std::span<const double> b, std::span<double> x) override {
    if (by_whole_) return whole_->solve(A, b, x);
    const bool solved = A.pattern->upper ? half_->solve(A, b, x)
                        : rest_.empty()  ? half_->solve(S_, b, x)
                                         : gmres(b, x);
    return solved || (by_whole(A) && whole_->solve(A, b, x));
  }

  // Where the half is singular that of the whole.
  LinearReport report() const override {
    return half_->report().singular ? whole_->report() : half_->report();
  }

 private:
  struct Entry {
    Index row, column;
    double value;
  };

  // Entries of S from `from` on; `rest` gets what A has beyond them.
  void take_mean(const Matrix& A, std::size_t from, std::size_t to, std::vector<Entry>& rest) {
    const double* const value = A.value.data();
    double* const mean = S_.value.data();
    const auto differ = [&](std::size_t i) {
      const double a = value[above_[i]], b = value[below_[i]];
      return std::abs(a - b) > kRounded * std::abs(a + b);
    };
    for (std::size_t end = from; from < to; from = end) {
      end = std::min(from + kAtOnce, to);
      bool any = false;
      for (std::size_t i = from; i < end; ++i) {
        mean[i] = (value[above_[i]] + value[below_[i]]) / 2;
        any |= differ(i);
      }
      for (std::size_t i = from; any && i < end; ++i) {
        if (!differ(i)) continue;
        const double a = value[above_[i]], b = value[below_[i]];
        const auto& starts = S_.pattern->column;
        const auto next = std::upper_bound(starts.begin(), starts.end(), static_cast<Index>(i));
        const Index row = S_.pattern->row[i], column = next - starts.begin() - 1;
        rest.push_back({row, column, (a - b) / 2});
        rest.push_back({column, row, (b - a) / 2});
      }
    }
  }

  // Few of them are not zero.
  void take_apart(const Matrix& A) {
    Index c = 0;
    for (std::size_t from = 0, end = 0; from < A.apart.size(); from = end) {
      end = std::min(from + kAtOnce, A.apart.size());
      std::uint64_t any = 0;
      for (std::size_t k = from; k < end; ++k) any |= std::bit_cast<std::uint64_t>(A.apart[k]) << 1;
      for (std::size_t k = from; any != 0 && k < end; ++k) {
        if (A.apart[k] == 0) continue;
        while (A.pattern->column[c + 1] <= static_cast<Index>(k)) ++c;
        rest_.push_back({A.pattern->row[k], c, A.apart[k]});
      }
    }
  }

  bool by_whole(const Matrix& A) {
    if (!whole_) whole_ = make_unsymmetric_solver();
    by_whole_ = whole_->factorise(A);
    return by_whole_;
  }

  // x = S^-1 u with (S + N) S^-1 u = b and N, the rest. Rotations turn the small least-squares
  // problem into a triangle as it grows.
  bool gmres(std::span<const double> b, std::span<double> x) {
    const double size = std::sqrt(dot(b, b));
    if (size == 0) {
      std::fill(x.begin(), x.end(), 0.0);
      return true;
    }
    if (!std::isfinite(size)) return false;
    const auto most = static_cast<std::size_t>(kMost);
    basis_.resize(most + 1);
    solved_.resize(most);
    basis_[0].assign(b.begin(), b.end());
    for (double& v : basis_[0]) v /= size;
    Vector rest{size}, cosine, sine;
    std::vector<Vector> R;  // columns
    while (std::abs(rest.back()) > kEnough * size) {
      const std::size_t k = R.size();
      if (k == most || (k == most / 2 && std::abs(rest.back()) > kHalfWay * size)) return false;
      Vector& along = solved_[k];
      along.resize(b.size());
      if (!half_->solve(S_, basis_[k], along)) return false;
      basis_[k + 1] = basis_[k];
      for (const Entry& n : rest_) basis_[k + 1][n.row] += n.value * along[n.column];
      R.push_back(orthogonal(k));
      turn(R.back(), cosine, sine, rest);
      if (!std::isfinite(rest.back())) return false;
    }
    combine(R, rest, x);
    return true;
  }

  // Takes from the vector after k its parts along those before; returns them, and what is left of it.
  Vector orthogonal(std::size_t k) {
    Vector part(k + 2);
    Vector& v = basis_[k + 1];
    for (std::size_t j = 0; j <= k; ++j) {
      part[j] = dot(basis_[j], v);
      for (std::size_t i = 0; i < v.size(); ++i) v[i] -= part[j] * basis_[j][i];
    }
    part[k + 1] = std::sqrt(dot(v, v));
    for (double& e : v) e /= part[k + 1] > 0 ? part[k + 1] : 1;
    return part;
  }

  static void turn(Vector& column, Vector& cosine, Vector& sine, Vector& rest) {
    const std::size_t k = column.size() - 2;
    for (std::size_t j = 0; j < k; ++j) {
      const double a = column[j], b = column[j + 1];
      column[j] = cosine[j] * a + sine[j] * b;
      column[j + 1] = cosine[j] * b - sine[j] * a;
    }
    const double length = std::hypot(column[k], column[k + 1]);
    cosine.push_back(column[k] / length);
    sine.push_back(column[k + 1] / length);
    column[k] = length;
    rest.push_back(-sine[k] * rest[k]);
    rest[k] *= cosine[k];
  }

  void combine(const std::vector<Vector>& R, const Vector& rest, std::span<double> x) const {
    Vector weight(rest.begin(), rest.end() - 1);
    for (std::size_t i = R.size(); i-- > 0;) {
      for (std::size_t j = i + 1; j < R.size(); ++j) weight[i] -= R[j][i] * weight[j];
      weight[i] /= R[i][i];
    }
    std::fill(x.begin(), x.end(), 0.0);
    for (std::size_t j = 0; j < R.size(); ++j)
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += weight[j] * solved_[j][i];
  }

  std::unique_ptr<LinearSolver> half_ = make_symmetric_factors(), whole_;
  Matrix S_;                          // the symmetric part
  std::vector<Index> above_, below_;  // for each entry of S its place in A, and that of the entry opposite
  std::vector<Entry> rest_;           // what A has beyond S
  std::vector<std::vector<Entry>> rests_;  // the same by parts
  bool by_whole_ = false;
  std::vector<Vector> basis_, solved_;  // S^-1 times the basis
};

}  // namespace

std::unique_ptr<LinearSolver> make_near_symmetric_solver() { return std::make_unique<NearSymmetric>(); }

}  // namespace fabricsh::linear
