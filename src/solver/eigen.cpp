#include "solver/eigen.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fabricsh::solver {

namespace {

using Block = Eigen::MatrixXd;
constexpr int kBlockWidth = 8;              // of a block: a free body has six equal eigenvalues
constexpr int kMostBlocks = 400;            // at most
constexpr double kResidualOfPairs = 1e-10;  // residual over eigenvalue at which one has converged

// Sums of products must not depend on the number of threads.
class OneEigenThread {
 public:
  OneEigenThread() { Eigen::setNbThreads(1); }
  OneEigenThread(const OneEigenThread&) = delete;
  OneEigenThread& operator=(const OneEigenThread&) = delete;
  ~OneEigenThread() { Eigen::setNbThreads(threads_); }

 private:
  int threads_ = Eigen::nbThreads();
};

class BlockLanczos {
 public:
  BlockLanczos(const linear::Matrix& A, const linear::Matrix& B, linear::LinearSolver& linear, int count)
      : A_(A),
        B_(B),
        linear_(linear),
        size_(static_cast<Eigen::Index>(A.size())),
        wanted_(std::min<Eigen::Index>(count, size_)),
        width_(std::min<Eigen::Index>(kBlockWidth, size_)),
        room_(std::min(size_, 2 * wanted_ + 6 * width_)),
        basis_(size_, 0),
        b_basis_(size_, 0),
        a_basis_(size_, 0) {}

  Eigenpairs run(const std::function<void()>& poll) {
    Block next = first();
    for (int i = 1; i <= kMostBlocks; ++i) {
      if (poll) poll();
      append(next);
      const Block coupling = advance(next);
      const bool whole = basis_.cols() >= size_;
      ritz();
      found_ = converged(coupling);
      iterations_ = i;
      if (whole) found_ = wanted_;
      if (found_ == wanted_) break;
      fill(next);
      if (basis_.cols() + next.cols() > room_) restart();
    }
    return result();
  }

 private:
  static Block times(const linear::Matrix& M, const Block& x) {
    Block y(x.rows(), x.cols());
    const auto n = static_cast<std::size_t>(x.rows());
    for (Eigen::Index c = 0; c < x.cols(); ++c)
      linear::multiply(M, {x.col(c).data(), n}, {y.col(c).data(), n});
    return y;
  }
  // Numbers without pattern that are always the same, orthogonal to the basis.
  Block numbers(Eigen::Index columns) {
    Block x(size_, columns);
    for (Eigen::Index c = 0; c < columns; ++c)
      for (Eigen::Index i = 0; i < size_; ++i)
        x(i, c) = ((seed_ = 1664525u * seed_ + 1013904223u) >> 8) / 16777216.0 - 0.5;
    return x;
  }
  Block solved(const Block& b) {
    Block x(b.rows(), b.cols());
    const auto n = static_cast<std::size_t>(b.rows());
    for (Eigen::Index c = 0; c < b.cols(); ++c) linear_.solve(B_, {b.col(c).data(), n}, {x.col(c).data(), n});
    return x;
  }
  Block first() {
    Block x = solved(times(A_, numbers(width_)));
    orthonormalise(x);
    fill(x);
    return x;
  }
  // Takes the basis out of x, twice against rounding, and makes it B-orthonormal. Returns R, of which x was
  // the product with the new x; columns of which nothing but rounding is left are left out.
  Block orthonormalise(Block& x) {
    constexpr double rounding = 1e-14;  // of squares
    const double before = largest(x.transpose() * times(B_, x));
    for (int twice = 0; twice < 2; ++twice) x -= basis_ * (b_basis_.transpose() * x);
    Block R = Block::Identity(x.cols(), x.cols());
    for (int twice = 0; twice < 2 && x.cols() > 0; ++twice) {
      const Eigen::SelfAdjointEigenSolver<Block> parts(x.transpose() * times(B_, x));
      const auto& squares = parts.eigenvalues();
      const double least =
          std::max(rounding * squares.maxCoeff(), twice == 0 ? 1e-12 * rounding * before : 0.0);
      Eigen::Index kept = 0;
      while (kept < x.cols() && squares[x.cols() - 1 - kept] > least) ++kept;
      const Eigen::VectorXd root = squares.tail(kept).cwiseSqrt();
      const Block Q = parts.eigenvectors().rightCols(kept);
      R = (root.asDiagonal() * Q.transpose() * R).eval();
      x = (x * Q * root.cwiseInverse().asDiagonal()).eval();
      x -= basis_ * (b_basis_.transpose() * x);
    }
    return R;
  }
  static double largest(const Block& gram) { return gram.size() == 0 ? 0 : gram.diagonal().maxCoeff(); }
  // Where a block has lost columns, because what it leads to has been found, others take their place.
  void fill(Block& x) {
    const Eigen::Index there = x.cols(), more = std::min(width_, size_ - basis_.cols()) - there;
    if (more <= 0) return;
    Block y = numbers(more);
    const Block bx = times(B_, x);
    for (int twice = 0; twice < 3 && y.cols() > 0; ++twice) {
      y -= x * (bx.transpose() * y);
      orthonormalise(y);
    }
    x.conservativeResize(size_, there + y.cols());
    x.rightCols(y.cols()) = y;
  }
  void append(const Block& x) {
    const Eigen::Index before = basis_.cols(), more = x.cols();
    for (Block* all : {&basis_, &b_basis_, &a_basis_}) all->conservativeResize(size_, before + more);
    basis_.rightCols(more) = x;
    b_basis_.rightCols(more) = times(B_, x);
    a_basis_.rightCols(more) = times(A_, x);
  }
  // B^-1 A times the last block, less what the basis has of it; returns how much of the rest there was.
  Block advance(Block& x) {
    x = solved(a_basis_.rightCols(x.cols()));
    last_ = x.cols();
    return orthonormalise(x);
  }
  void ritz() {
    const Block T = basis_.transpose() * a_basis_;
    pairs_.compute((T + T.transpose()) / 2);
  }
  double theta(Eigen::Index i) const { return pairs_.eigenvalues()[basis_.cols() - 1 - i]; }
  auto part(Eigen::Index i) const { return pairs_.eigenvectors().col(basis_.cols() - 1 - i); }
  // How many of the largest have: the residual of a Ritz vector is in the next block alone.
  Eigen::Index converged(const Block& coupling) const {
    const double most = pairs_.eigenvalues().cwiseAbs().maxCoeff();
    Eigen::Index i = 0;
    while (i < std::min(wanted_, basis_.cols()) &&
           (coupling * part(i).tail(last_)).norm() <=
               kResidualOfPairs * std::max(std::abs(theta(i)), 1e-6 * most))
      ++i;
    return i;
  }
  void restart() {
    const Eigen::Index kept = std::min(basis_.cols() - 1, wanted_ + 2 * width_);
    const Block S = pairs_.eigenvectors().rightCols(kept);
    for (Block* all : {&basis_, &b_basis_, &a_basis_}) *all = (*all * S).eval();
  }
  Eigenpairs result() const {
    Eigenpairs out;
    out.converged = found_ >= wanted_;
    out.iterations = iterations_;
    for (Eigen::Index i = 0; i < std::min(found_, basis_.cols()); ++i) {
      const Eigen::VectorXd x = basis_ * part(i);
      out.value.push_back(theta(i));
      out.shape.emplace_back(x.data(), x.data() + x.size());
    }
    return out;
  }

  const linear::Matrix &A_, &B_;
  linear::LinearSolver& linear_;
  const Eigen::Index size_, wanted_, width_, room_;
  Block basis_, b_basis_, a_basis_;  // and times B, times A
  Eigen::SelfAdjointEigenSolver<Block> pairs_;
  Eigen::Index last_ = 0, found_ = 0;
  int iterations_ = 0;
  std::uint32_t seed_ = 1;
};

}  // namespace

Eigenpairs largest_eigenpairs(const linear::Matrix& A, const linear::Matrix& B, linear::LinearSolver& linear,
                              int count, const std::function<void()>& poll) {
  if (A.size() == 0) return {{}, {}, true, 0};
  const OneEigenThread one;
  return BlockLanczos(A, B, linear, count).run(poll);
}

}  // namespace fabricsh::solver
