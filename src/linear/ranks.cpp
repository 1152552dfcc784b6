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
// where z = K^-1 b.
class WithRanks final : public LinearSolver {
 public:
  explicit WithRanks(std::unique_ptr<LinearSolver> sparse) : sparse_(std::move(sparse)) {}

  bool analyse(const Matrix& A) override { return sparse_->prepare(A); }
  bool factorise_numbers(const Matrix& A) override {
    extra_ = 0;
    return sparse_->factorise(A) && (A.ranks.empty() || close(A));
  }
  bool solve(const Matrix& A, std::span<const double> b, std::span<double> x) override {
    if (!sparse_->solve(A, b, x)) return false;
    if (A.ranks.empty()) return true;
    const Eigen::VectorXd w = small_.solve(A.ranks.core * along(A.ranks, x));
    for (std::size_t j = 0; j < Z_.size(); ++j)
      for (std::size_t i = 0; i < x.size(); ++i) x[i] -= w[static_cast<Index>(j)] * Z_[j][i];
    return true;
  }
  LinearReport report() const override {
    LinearReport whole = sparse_->report();
    whole.negative_pivots = std::max<Index>(0, whole.negative_pivots + extra_);
    return whole;
  }
  bool doubtful() const override { return sparse_->doubtful(); }
  void set_doubtful(bool doubtful) override { sparse_->set_doubtful(doubtful); }

 private:
  static Eigen::VectorXd along(const FewRanks& ranks, std::span<const double> x) {
    Eigen::VectorXd all(static_cast<Index>(ranks.columns.size()));
    for (std::size_t i = 0; i < ranks.columns.size(); ++i)
      all[static_cast<Index>(i)] = dot(ranks.columns[i], x);
    return all;
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
  std::vector<Vector> Z_;
  Eigen::PartialPivLU<Eigen::MatrixXd> small_;
  Index extra_ = 0;
};

}  // namespace

std::unique_ptr<LinearSolver> with_ranks(std::unique_ptr<LinearSolver> sparse) {
  return std::make_unique<WithRanks>(std::move(sparse));
}

}  // namespace fabricsh::linear
