// Matrices with a part of few ranks: solutions, products, and the count of negative eigenvalues.
#include <Eigen/Eigenvalues>
#include <cmath>
#include <tuple>

#include "catch.hpp"
#include "linear/linear_solver.hpp"

using namespace fabricsh::linear;

namespace {

// Second differences on a line less `shift`, and two ranks.
Matrix line_with_ranks(Index n, double shift, const Eigen::Matrix2d& core) {
  std::vector<std::vector<Index>> columns(static_cast<std::size_t>(n));
  for (Index c = 0; c < n; ++c)
    for (Index r = std::max<Index>(0, c - 1); r <= std::min(n - 1, c + 1); ++r)
      columns[static_cast<std::size_t>(c)].push_back(r);
  Matrix A(std::make_shared<const Pattern>(std::move(columns)));
  for (Index c = 0; c < n; ++c) {
    A.add(c, c, 2 - shift);
    if (c > 0) A.add(c, c - 1, -1);
    if (c + 1 < n) A.add(c, c + 1, -1);
  }
  for (int j = 0; j < 2; ++j) {
    A.ranks.columns.emplace_back();
    for (Index i = 0; i < n; ++i) A.ranks.columns.back().push_back(std::cos(0.3 * (j + 1) * (i + 0.5)));
  }
  A.ranks.core = core;
  return A;
}

Eigen::MatrixXd dense(const Matrix& A) {
  Eigen::MatrixXd all(A.size(), A.size());
  std::vector<double> x(static_cast<std::size_t>(A.size())), y(x.size());
  for (Index c = 0; c < A.size(); ++c) {
    std::fill(x.begin(), x.end(), 0.0);
    x[static_cast<std::size_t>(c)] = 1;
    multiply(A, x, y);
    for (Index r = 0; r < A.size(); ++r) all(r, c) = y[static_cast<std::size_t>(r)];
  }
  return all;
}

}  // namespace

TEST_CASE("a matrix with few ranks is solved as the dense one, and has its negative eigenvalues") {
  constexpr Index n = 12;
  Eigen::Matrix2d pressing, pulling, mixed, one_sided;
  pressing << 3, 1, 1, 2;
  pulling = -pressing;
  mixed << 5, 0, 0, -4;
  one_sided << 3, 0.4, 0.9, 2;
  for (const double shift : {0.0, 0.2, 1.1, 3.0})
    for (const auto& core : {pressing, pulling, mixed, one_sided}) {
      const Matrix A = line_with_ranks(n, shift, core);
      const Eigen::MatrixXd D = dense(A);
      const bool symmetric = core.isApprox(core.transpose());
      auto solver = with_ranks(symmetric ? make_symmetric_solver() : make_unsymmetric_solver());
      REQUIRE(solver->factorise(A));
      std::vector<double> b(n), x(n);
      for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::sin(1.0 + static_cast<double>(i));
      REQUIRE(solver->solve(A, b, x));
      const Eigen::Map<const Eigen::VectorXd> want(b.data(), n), found(x.data(), n);
      CHECK((D * found - want).norm() < 1e-9 * want.norm());
      if (!symmetric) continue;
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of(D, Eigen::EigenvaluesOnly);
      CHECK(solver->report().negative_pivots == (of.eigenvalues().array() < 0).count());
    }
}

TEST_CASE("a singular matrix that few ranks make regular is solved as the dense one") {
  constexpr Index n = 11;
  Eigen::Matrix2d holding, pulling;
  holding << 2, 0.5, 0.5, 3;
  pulling = -holding;
  for (const auto& core : {holding, pulling}) {
    // Two lines beside each other, or one, which nothing holds.
    for (const bool parted : {false, true}) {
      Matrix A = line_with_ranks(n, 0, core);
      A.add(0, 0, -1);
      A.add(n - 1, n - 1, -1);
      if (parted) {
        for (const auto& [r, c, v] : {std::tuple{4, 5, 1.0}, {5, 4, 1.0}, {4, 4, -1.0}, {5, 5, -1.0}})
          A.add(r, c, v);
      }
      REQUIRE(!make_symmetric_solver()->factorise(A));
      const Eigen::MatrixXd D = dense(A);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of(D, Eigen::EigenvaluesOnly);
      REQUIRE(of.eigenvalues().cwiseAbs().minCoeff() > 1e-6);
      for (auto make : {make_symmetric_solver, make_unsymmetric_solver}) {
        auto solver = with_ranks(make(Ordering::automatic));
        for (int twice = 0; twice < 2; ++twice) {
          REQUIRE(solver->factorise(A));
          std::vector<double> b(n), x(n);
          for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::sin(2.0 + static_cast<double>(i));
          REQUIRE(solver->solve(A, b, x));
          const Eigen::Map<const Eigen::VectorXd> want(b.data(), n), found(x.data(), n);
          CHECK((D * found - want).norm() < 1e-9 * want.norm());
          CHECK(solver->report().negative_pivots == (of.eigenvalues().array() < 0).count());
        }
      }
    }
  }
  // One that they do not make regular.
  Matrix A = line_with_ranks(n, 0, holding);
  for (double& v : A.value) v = 0;
  CHECK(!with_ranks(make_symmetric_solver())->factorise(A));
}

TEST_CASE("the sums of a matrix with few ranks bound its entries, and a factor scales all of it") {
  Matrix A = line_with_ranks(9, 0.5, Eigen::Matrix2d{{2, 0}, {0, 1}});
  const Eigen::MatrixXd D = dense(A);
  std::vector<double> sums;
  absolute_sums(A, sums);
  for (Index c = 0; c < 9; ++c) CHECK(sums[static_cast<std::size_t>(c)] >= D.col(c).cwiseAbs().sum() - 1e-12);
  A.scale(3);
  CHECK(dense(A).isApprox(3 * D, 1e-14));
  A.clear();
  CHECK(dense(A).isZero());
}
