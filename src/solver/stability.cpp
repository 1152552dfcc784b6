#include "solver/stability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fabricsh::solver {

using linear::dot;

namespace {

constexpr int kSteps = 60;            // of Lanczos' method at most
constexpr double kFound = 1e-6;       // residual over eigenvalue at which one has converged
constexpr double kSymmetric = 1e-12;  // of entries above and below the diagonal: their rounding

// An eigenvalue over the sums of the absolute entries. A stiffness that is nothing, as of yarns that are
// slack or of what moves freely, comes out as some units of 1e-16 of that, times the some hundred terms that
// an element adds up. The lowest bending stiffness of cloth is above 1e-11.
constexpr double kNothing = 1e-13;

// Numbers without pattern that are always the same.
void fill(linear::Vector& v) {
  std::uint32_t number = 1;
  for (double& d : v) d = ((number = 1664525u * number + 1013904223u) >> 8) / 16777216.0 - 0.5;
}

class Lanczos {
 public:
  Lanczos(std::span<const double> D, const Solve& solve) : solve_(solve), root_(D.size()), b_(D.size()) {
    for (std::size_t i = 0; i < D.size(); ++i) root_[i] = std::sqrt(D[i]);
  }
  // The vector of the eigenvalue 1 / theta of K that is the lowest negative one of those that have converged;
  // or, where none has, that of the least theta.
  linear::Vector run() {
    linear::Vector v(root_.size());
    fill(v);
    if (!apply(v)) return {};
    const int most = static_cast<int>(std::min<std::size_t>(kSteps, v.size()));
    for (int k = 1; k <= most; ++k) {
      const double size = std::sqrt(dot(v, v));
      if (!(size > 0) || !std::isfinite(size)) break;
      if (k > 1) below_.push_back(size);
      if (k > 1 && size < 1e-14 * scale_) break;
      for (double& x : v) x /= size;
      basis_.push_back(v);
      if (!apply(v)) return {};
      orthogonalise(v);
      if (k % 10 == 0 && k >= 20 && separate(std::sqrt(dot(v, v)))) return found();
    }
    separate(0);
    return found();
  }

 private:
  bool apply(linear::Vector& v) {
    for (std::size_t i = 0; i < v.size(); ++i) b_[i] = root_[i] * v[i];
    if (!solve_(b_, v)) return false;
    for (std::size_t i = 0; i < v.size(); ++i) v[i] *= root_[i];
    return linear::all_finite(v);
  }
  // Against all of the basis, twice, since rounding would let vectors that have converged come again.
  void orthogonalise(linear::Vector& v) {
    double along = 0;
    for (int twice = 0; twice < 2; ++twice)
      for (std::size_t j = basis_.size(); j-- > 0;) {
        const double c = dot(basis_[j], v);
        if (j + 1 == basis_.size()) along += c;
        for (std::size_t i = 0; i < v.size(); ++i) v[i] -= c * basis_[j][i];
      }
    diagonal_.push_back(along);
    scale_ = std::max(scale_, std::abs(along));
  }
  // Whether all negative values that matter have converged. rest: the next entry below the diagonal.
  bool separate(double rest) {
    const auto n = static_cast<Eigen::Index>(diagonal_.size());
    if (n == 0) return false;
    Eigen::VectorXd d(n), e(std::max<Eigen::Index>(n - 1, 1));
    for (Eigen::Index i = 0; i < n; ++i) d[i] = diagonal_[static_cast<std::size_t>(i)];
    for (Eigen::Index i = 0; i + 1 < n; ++i) e[i] = below_[static_cast<std::size_t>(i)];
    ritz_.computeFromTridiagonal(d, e.head(n - 1));
    const auto& values = ritz_.eigenvalues();
    const auto& vectors = ritz_.eigenvectors();
    if (ritz_.info() != Eigen::Success || !(values[0] < 0)) return false;
    chosen_ = 0;
    for (Eigen::Index i = 0; i < n && values[i] < 0; ++i)
      if (std::abs(rest * vectors(n - 1, i)) < kFound * std::abs(values[i])) chosen_ = i;
    return std::abs(rest * vectors(n - 1, chosen_)) < kFound * std::abs(values[chosen_]);
  }
  linear::Vector found() const {
    linear::Vector v(root_.size(), 0.0);
    if (chosen_ < 0) return {};
    for (std::size_t j = 0; j < basis_.size() && j < diagonal_.size(); ++j)
      for (std::size_t i = 0; i < v.size(); ++i)
        v[i] += ritz_.eigenvectors()(static_cast<Eigen::Index>(j), chosen_) * basis_[j][i];
    for (std::size_t i = 0; i < v.size(); ++i) v[i] /= root_[i];
    return v;
  }

  const Solve& solve_;
  linear::Vector root_, b_;  // square roots of D
  std::vector<linear::Vector> basis_;
  std::vector<double> diagonal_, below_;
  double scale_ = 0;
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz_;
  Eigen::Index chosen_ = -1;
};

// Whether 1 + M, with which M v = apply(v), has no negative eigenvalue: by the eigenvalues of its part in a
// Krylov space that solves (1 + M) x = b for some b [saad1986]. False: it has, or the space does not suffice.
bool turns_nothing(std::size_t size, const Solve& apply) {
  constexpr int most = 40, each = 5;
  constexpr double enough = 1e-6;  // of b
  std::vector<linear::Vector> basis{linear::Vector(size)};
  fill(basis[0]);
  const double length = std::sqrt(dot(basis[0], basis[0]));
  for (double& v : basis[0]) v /= length;
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(most + 1, most);
  for (int k = 0; k < most; ++k) {
    linear::Vector w(size);
    if (!apply(basis.back(), w)) return false;
    for (std::size_t i = 0; i < size; ++i) w[i] += basis.back()[i];
    for (int j = 0; j <= k; ++j) {
      H(j, k) = dot(basis[static_cast<std::size_t>(j)], w);
      for (std::size_t i = 0; i < size; ++i) w[i] -= H(j, k) * basis[static_cast<std::size_t>(j)][i];
    }
    H(k + 1, k) = std::sqrt(dot(w, w));
    if (!std::isfinite(H(k + 1, k))) return false;
    const bool whole = H(k + 1, k) < enough;
    if (whole || (k + 1) % each == 0) {
      const Eigen::MatrixXd part = H.topLeftCorner(k + 2, k + 1);
      const Eigen::VectorXd b = Eigen::VectorXd::Unit(k + 2, 0);
      if (whole || (b - part * part.householderQr().solve(b)).norm() < enough) {
        const Eigen::VectorXcd values = part.topRows(k + 1).eigenvalues();
        return std::none_of(values.begin(), values.end(),
                            [](const auto& v) { return v.imag() == 0 && !(v.real() > 0); });
      }
    }
    for (double& v : w) v /= H(k + 1, k);
    basis.push_back(std::move(w));
  }
  return false;
}

}  // namespace

Mode lowest_mode(const linear::Matrix& K, std::span<const double> D, double, const Solve& solve) {
  Mode mode;
  mode.shape = Lanczos(D, solve).run();
  if (mode.shape.empty()) return mode;
  linear::Vector b(mode.shape.size());
  linear::multiply(K, mode.shape, b);
  double norm = 0;
  for (std::size_t i = 0; i < b.size(); ++i) norm += D[i] * mode.shape[i] * mode.shape[i];
  mode.value = dot(mode.shape, b) / norm;
  for (double& v : mode.shape) v /= std::sqrt(norm);
  return mode;
}

bool StabilityCheck::definite(const linear::Matrix& K, linear::LinearSolver& linear) {
  ++factorisations_;
  const bool done = linear.factorise(K);
  negative_ = linear.report().negative_pivots;
  return done && negative_ == 0;
}

Stability StabilityCheck::by_symmetric_part(const linear::Matrix& S, std::span<const double> D,
                                            linear::LinearSolver& linear) {
  if (definite(S, linear)) return Stability::stable;
  linear::add_diagonal(S, kNothing, D, A_);
  if (definite(A_, linear)) return Stability::stable;
  mode_ = lowest_mode(S, D, kNothing, [&](std::span<const double> b, std::span<double> x) {
    return linear.solve(A_, b, x) && linear::all_finite(x);
  });
  return Stability::unstable;
}

Stability StabilityCheck::of(const linear::Matrix& K, std::span<const double> D) {
  factorisations_ = 0;
  negative_ = 0;
  mode_ = {};
  if (judge_ == Judge::never) return Stability::unchecked;
  if (K.size() == 0) return Stability::stable;
  if (symmetric_ && K.apart.empty()) return by_symmetric_part(K, D, linear_);
  const bool unsymmetric = linear::symmetric_part(K, D, S_) > kSymmetric;
  if (!own_) own_ = linear::with_ranks(linear::make_symmetric_solver());
  if (unsymmetric && !K.apart.empty()) return with_friction(K, D);
  const Stability part = by_symmetric_part(S_, D, *own_);
  if (!unsymmetric || (judge_ == Judge::work && part == Stability::stable)) return part;
  // A negative determinant means a direction in which the shape leaves its place by itself.
  ++factorisations_;
  linear_.factorise(K);
  negative_ = linear_.report().negative_pivots;
  if (negative_ == 0 || part == Stability::stable) return Stability::unchecked;
  return Stability::unstable;
}

// The rest is the tangent while the bounds of friction stay, and its lowest mode is that of the shape. What
// the bounds add as they follow the pressure may still turn a direction; then the whole is asked, as any
// matrix.
Stability StabilityCheck::with_friction(const linear::Matrix& K, std::span<const double> D) {
  linear::Matrix rest, friction;
  rest.pattern = friction.pattern = K.pattern;
  rest.value = K.value;
  rest.ranks = K.ranks;
  friction.value = K.apart;
  const Stability part = by_symmetric_part(rest, D, *own_);
  const linear::Matrix& factorised = factorisations_ > 1 ? A_ : rest;
  const auto follow = [&](std::span<const double> v, std::span<double> w) {
    linear::Vector moved(v.size());
    if (!own_->solve(factorised, v, moved)) return false;
    linear::multiply(friction, moved, w);
    return true;
  };
  if (part == Stability::stable && turns_nothing(static_cast<std::size_t>(K.size()), follow))
    return Stability::unchecked;
  if (!whole_) whole_ = linear::with_ranks(linear::make_unsymmetric_solver());
  ++factorisations_;
  whole_->factorise(K);
  const Index negative = whole_->report().negative_pivots;
  const bool stays =
      negative == 0 || (part == Stability::stable && by_symmetric_part(S_, D, *own_) == Stability::stable);
  negative_ = negative;
  return stays ? Stability::unchecked : Stability::unstable;
}

}  // namespace fabricsh::solver
