#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "linear/linear_solver.hpp"
#include "linear/vector.hpp"

namespace fabricsh::linear {

namespace {

constexpr double kNothing = 1e-14;  // of the largest eigenvalue of a core: below, it has none there

// With K = the sparse part, Z = K^-1 U and the core C: (K + U C U^T)^-1 b = z - Z (1 + C U^T Z)^-1 C U^T z
// where z = K^-1 b. Where K alone is singular, as of a mechanism that nothing but a gas holds, some of its
// freedoms get a stiffness of their own, which the ranks take away again.
class WithRanks final : public LinearSolver {
 public:
  explicit WithRanks(std::unique_ptr<LinearSolver> sparse) : sparse_(std::move(sparse)) {}

  bool analyse(const Matrix& A) override { return sparse_->prepare(A); }
  bool factorise_numbers(const Matrix& A) override {
    extra_ = 0;
    is_held_ = false;
    if (sparse_->factorise(A)) return A.ranks.empty() || close(A);
    is_held_ = !A.ranks.empty() && hold(A);
    return is_held_ && close(held_);
  }
  bool solve(const Matrix& A, std::span<const double> b, std::span<double> x) override {
    if (!sparse_->solve(is_held_ ? held_ : A, b, x)) return false;
    if (A.ranks.empty()) return true;
    const FewRanks& ranks = is_held_ ? held_.ranks : A.ranks;
    const Eigen::VectorXd w = small_.solve(ranks.core * along(ranks, x));
    for (std::size_t j = 0; j < Z_.size(); ++j)
      for (std::size_t i = 0; i < x.size(); ++i) x[i] -= w[static_cast<Index>(j)] * Z_[j][i];
    return true;
  }
  LinearReport report() const override {
    LinearReport whole = sparse_->report();
    whole.negative_pivots = std::max<Index>(0, whole.negative_pivots + extra_);
    return whole;
  }

 private:
  static Eigen::VectorXd along(const FewRanks& ranks, std::span<const double> x) {
    Eigen::VectorXd all(static_cast<Index>(ranks.columns.size()));
    for (std::size_t i = 0; i < ranks.columns.size(); ++i)
      all[static_cast<Index>(i)] = dot(ranks.columns[i], x);
    return all;
  }

  // As few freedoms as the ranks are many at most, those that go farthest under them.
  bool hold(const Matrix& A) {
    constexpr double share = 1e-6;  // of the sums of entries, with which K has factors
    Vector sums;
    absolute_sums(A, sums);
    held_ = A;
    held_.ranks = {};
    Matrix near = held_;
    for (Index i = 0; i < A.size(); ++i) near.add(i, i, share * sums[static_cast<std::size_t>(i)]);
    if (!sparse_->factorise(near)) return false;
    std::vector<Vector> ways(A.ranks.columns.size(), Vector(sums.size()));
    for (std::size_t j = 0; j < ways.size(); ++j) {
      if (!sparse_->solve(near, A.ranks.columns[j], ways[j]) || !all_finite(ways[j])) return false;
      for (std::size_t i = 0; i < sums.size(); ++i) ways[j][i] *= std::sqrt(sums[i]);
    }
    std::vector<std::pair<Index, double>> held;
    while (!ways.empty()) {
      const std::size_t at = farthest(ways);
      held.emplace_back(static_cast<Index>(at), sums[at]);
      held_.add(held.back().first, held.back().first, sums[at]);
      if (sparse_->factorise(held_)) {
        take_away(A.ranks, held);
        return true;
      }
    }
    return false;
  }

  // The freedom that goes farthest along one of the ways; that way is taken out of the others.
  static std::size_t farthest(std::vector<Vector>& ways) {
    const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto most = [&](const Vector& way) {
      return std::abs(*std::max_element(way.begin(), way.end(), less));
    };
    auto longest = std::max_element(ways.begin(), ways.end(),
                                    [&](const Vector& a, const Vector& b) { return most(a) < most(b); });
    const Vector way = *longest;
    ways.erase(longest);
    const auto at = static_cast<std::size_t>(std::max_element(way.begin(), way.end(), less) - way.begin());
    for (Vector& other : ways) {
      const double factor = way[at] == 0 ? 0 : other[at] / way[at];
      for (std::size_t i = 0; i < other.size(); ++i) other[i] -= factor * way[i];
    }
    return at;
  }

  void take_away(const FewRanks& ranks, const std::vector<std::pair<Index, double>>& held) {
    const auto k = static_cast<Index>(ranks.columns.size()), more = static_cast<Index>(held.size());
    held_.ranks = ranks;
    held_.ranks.core = Eigen::MatrixXd::Zero(k + more, k + more);
    held_.ranks.core.topLeftCorner(k, k) = ranks.core;
    for (Index j = 0; j < more; ++j) {
      const auto [at, stiffness] = held[static_cast<std::size_t>(j)];
      held_.ranks.columns.emplace_back(static_cast<std::size_t>(held_.size()), 0.0);
      held_.ranks.columns.back()[static_cast<std::size_t>(at)] = 1;
      held_.ranks.core(k + j, k + j) = -stiffness;
    }
  }

  bool close(const Matrix& A) {
    const auto& ranks = A.ranks;
    const auto k = static_cast<Index>(ranks.columns.size());
    Z_.assign(ranks.columns.size(), Vector(static_cast<std::size_t>(A.size())));
    Eigen::MatrixXd within(k, k);  // U^T Z
    for (Index j = 0; j < k; ++j) {
      auto& z = Z_[static_cast<std::size_t>(j)];
      if (!sparse_->solve(A, ranks.columns[static_cast<std::size_t>(j)], z) || !all_finite(z)) return false;
      within.col(j) = along(ranks, z);
    }
    small_.compute(Eigen::MatrixXd::Identity(k, k) + ranks.core * within);
    extra_ = extra_negative(ranks.core, within);
    return std::abs(small_.determinant()) > 0;
  }

  // By how many the negative eigenvalues of the whole differ from those of the sparse part. The matrix
  // (K, U; U^T, -1/C) has both those of K with those of -1/C - U^T Z, and those of the whole with those of
  // -1/C [haynsworth1968]; in the directions in which the core is something.
  static Index extra_negative(const Eigen::MatrixXd& core, const Eigen::MatrixXd& within) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of((core + core.transpose()) / 2);
    const double least = kNothing * of.eigenvalues().cwiseAbs().maxCoeff();
    std::vector<Index> kept;
    for (Index i = 0; i < core.rows(); ++i)
      if (std::abs(of.eigenvalues()[i]) > least) kept.push_back(i);
    const auto m = static_cast<Index>(kept.size());
    Eigen::MatrixXd Q(core.rows(), m);
    Eigen::VectorXd values(m);
    for (Index i = 0; i < m; ++i) {
      Q.col(i) = of.eigenvectors().col(kept[static_cast<std::size_t>(i)]);
      values[i] = of.eigenvalues()[kept[static_cast<std::size_t>(i)]];
    }
    if (m == 0) return 0;
    Eigen::MatrixXd inner = Q.transpose() * (within + within.transpose()) / 2 * Q;
    inner.diagonal() += values.cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> bordered(inner, Eigen::EigenvaluesOnly);
    return (bordered.eigenvalues().array() > 0).count() - (values.array() > 0).count();
  }

  std::unique_ptr<LinearSolver> sparse_;
  Matrix held_;  // in the place of A
  bool is_held_ = false;
  std::vector<Vector> Z_;
  Eigen::PartialPivLU<Eigen::MatrixXd> small_;
  Index extra_ = 0;
};

}  // namespace

std::unique_ptr<LinearSolver> with_ranks(std::unique_ptr<LinearSolver> sparse) {
  return std::make_unique<WithRanks>(std::move(sparse));
}

}  // namespace fabricsh::linear
