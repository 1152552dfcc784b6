// Eigenvalues of matrices whose eigenvalues are known.
#include <cmath>

#include "catch.hpp"
#include "solver/eigen.hpp"

using namespace fabricsh;
using namespace fabricsh::solver;
using linear::Index;

namespace {

// Some chains of n masses between two walls that know nothing of each other: each eigenvalue of one comes as
// often as there are chains.
linear::Matrix chains(int n, int many, double mass, double spring) {
  std::vector<std::vector<Index>> columns(static_cast<std::size_t>(n * many));
  for (int c = 0; c < n * many; ++c)
    for (int r = std::max(c / n * n, c - 1); r <= std::min(c / n * n + n - 1, c + 1); ++r)
      columns[static_cast<std::size_t>(c)].push_back(r);
  linear::Matrix K(std::make_shared<const linear::Pattern>(std::move(columns)));
  for (int c = 0; c < n * many; ++c) {
    K.add(c, c, mass + 2 * spring);
    if (c % n == n - 1) continue;
    K.add(c, c + 1, -spring);
    K.add(c + 1, c, -spring);
  }
  return K;
}

}  // namespace

TEST_CASE("the largest eigenvalues are found as often as they are there") {
  for (const int n : {7, 300})
    for (const int many : {1, 3, 6}) {
      const linear::Matrix K = chains(n, many, 0, 1), M = chains(n, many, 2, 0);
      const auto solver = linear::make_symmetric_solver();
      REQUIRE(solver->factorise(K));
      const auto found = largest_eigenpairs(M, K, *solver, 5 * many);
      INFO(n << " " << many);
      REQUIRE(found.converged);
      REQUIRE(found.value.size() == static_cast<std::size_t>(5 * many));
      linear::Vector Mx(found.shape[0].size()), Kx(Mx.size());
      for (std::size_t i = 0; i < found.value.size(); ++i) {
        const int k = static_cast<int>(i) / many + 1;
        const double lambda = (2 - 2 * std::cos(k * M_PI / (n + 1))) / 2;
        CHECK(std::abs(found.value[i] * lambda - 1) < 1e-9);
        linear::multiply(M, found.shape[i], Mx);
        linear::multiply(K, found.shape[i], Kx);
        CHECK(std::abs(linear::dot(found.shape[i], Kx) - 1) < 1e-9);
        for (std::size_t j = 0; j < i; ++j) CHECK(std::abs(linear::dot(found.shape[j], Kx)) < 1e-8);
        double off = 0;
        for (std::size_t u = 0; u < Mx.size(); ++u)
          off = std::max(off, std::abs(Mx[u] - found.value[i] * Kx[u]));
        CHECK(off < 1e-6 * found.value[i]);
      }
    }
}

TEST_CASE("unknowns without mass, and more modes than there are, do no harm") {
  linear::Matrix K = chains(9, 1, 0, 1), M = chains(9, 1, 1, 0);
  for (Index i = 0; i < 9; i += 2) M.value[static_cast<std::size_t>(M.pattern->slot(i, i))] = 0;
  const auto solver = linear::make_symmetric_solver();
  REQUIRE(solver->factorise(K));
  const auto found = largest_eigenpairs(M, K, *solver, 50);
  int masses = 0;
  for (const double theta : found.value) masses += theta > 1e-9 ? 1 : 0;
  CHECK(masses == 4);
  // Every other mass of the chain, from the second on: springs of half the stiffness, to walls of half again.
  CHECK(std::abs(1 / found.value[0] - (1 - std::cos(M_PI / 5))) < 1e-9);
}

TEST_CASE("the same numbers come each time") {
  const linear::Matrix K = chains(120, 2, 0.1, 1), M = chains(120, 2, 1, 0);
  const auto solver = linear::make_symmetric_solver();
  REQUIRE(solver->factorise(K));
  const auto one = largest_eigenpairs(M, K, *solver, 12), other = largest_eigenpairs(M, K, *solver, 12);
  CHECK(one.value == other.value);
  CHECK(one.shape == other.shape);
}
