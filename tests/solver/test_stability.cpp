// The lowest eigenvalue of matrices whose eigenvalues are known.
#include <cmath>

#include "catch.hpp"
#include "solver/stability.hpp"

using namespace fabricsh;
using namespace fabricsh::solver;

namespace {

// A chain of n masses between two walls, with the eigenvalues 2 - 2 cos(k pi / (n + 1)), less a shift.
linear::Matrix chain(int n, double shift, double skew = 0) {
  std::vector<std::vector<Index>> columns(static_cast<std::size_t>(n));
  for (int c = 0; c < n; ++c)
    for (int r = std::max(0, c - 1); r <= std::min(n - 1, c + 1); ++r)
      columns[static_cast<std::size_t>(c)].push_back(r);
  linear::Matrix K(std::make_shared<const linear::Pattern>(std::move(columns)));
  for (int c = 0; c < n; ++c) K.add(c, c, 2 - shift);
  for (int c = 0; c + 1 < n; ++c) {
    K.add(c, c + 1, -1 + skew);
    K.add(c + 1, c, -1 - skew);
  }
  return K;
}

double eigenvalue(int n, int k) { return 2 - 2 * std::cos(k * M_PI / (n + 1)); }

Stability asked(const linear::Matrix& K, bool symmetric, Judge judge, double& value, int& factorisations) {
  const auto linear = symmetric ? linear::make_symmetric_solver() : linear::make_unsymmetric_solver();
  StabilityCheck check(*linear, symmetric, judge);
  const linear::Vector ones(static_cast<std::size_t>(K.size()), 1.0);
  const Stability answer = check.of(K, ones);
  value = check.mode().value;
  factorisations = check.factorisations();
  return answer;
}

}  // namespace

TEST_CASE("the sign of the lowest eigenvalue decides, however close to zero it is") {
  double value = 0;
  int factorisations = 0;
  for (const int n : {3, 40, 700})
    for (const bool symmetric : {true, false})
      for (const double beyond : {1e-2, 1e-6, 1e-10}) {
        const double first = eigenvalue(n, 1);
        CHECK(asked(chain(n, first - beyond), symmetric, Judge::energy, value, factorisations) ==
              Stability::stable);
        CHECK(factorisations == 1);
        INFO(n << " " << beyond);
        REQUIRE(asked(chain(n, first + beyond), symmetric, Judge::energy, value, factorisations) ==
                Stability::unstable);
        CHECK(value < 0);
        if (first + beyond < eigenvalue(n, 2))  // of very many one is taken
          CHECK(std::abs(value + beyond) < 1e-9 * beyond + 1e-13);
      }
}

TEST_CASE("of several negative eigenvalues the lowest one is taken") {
  double value = 0;
  int factorisations = 0;
  const int n = 200;
  const double shift = (eigenvalue(n, 3) + eigenvalue(n, 4)) / 2;
  REQUIRE(asked(chain(n, shift), true, Judge::energy, value, factorisations) == Stability::unstable);
  CHECK(std::abs(value - (eigenvalue(n, 1) - shift)) < 1e-6 * shift);
}

TEST_CASE("an eigenvalue that is zero but for rounding is not unstable") {
  double value = 0;
  int factorisations = 0;
  for (const int n : {5, 60, 500})
    CHECK(asked(chain(n, eigenvalue(n, 1)), true, Judge::energy, value, factorisations) == Stability::stable);
}

TEST_CASE("without a potential there is no answer, and a law without one is judged by its work") {
  double value = 0;
  int factorisations = 0;
  const auto stable = chain(20, 0, 0.1), unstable = chain(20, 1, 0.1);
  CHECK(asked(stable, false, Judge::energy, value, factorisations) == Stability::unchecked);
  CHECK(asked(stable, false, Judge::work, value, factorisations) == Stability::stable);
  CHECK(asked(unstable, false, Judge::work, value, factorisations) != Stability::stable);
  CHECK(asked(chain(20, 0), true, Judge::never, value, factorisations) == Stability::unchecked);
}

TEST_CASE(
    "what follows friction's bounds is judged beside the rest, whose lowest mode is that of the shape") {
  const int n = 20;
  double value = 0;
  int factorisations = 0;
  const auto with = [&](double shift, double apart) {
    linear::Matrix K = chain(n, shift);
    K.apart.assign(K.value.size(), 0.0);
    K.apart[static_cast<std::size_t>(K.pattern->slot(8, 9))] = -apart;
    return K;
  };
  // The determinant over that of the rest is 1 - apart 9 (n + 1 - 10) / (n + 1).
  const double none = (n + 1.0) / 9 / (n - 9);
  CHECK(asked(with(0, 0.9 * none), true, Judge::energy, value, factorisations) == Stability::unchecked);
  CHECK(factorisations == 1);
  CHECK(asked(with(0, -20), true, Judge::energy, value, factorisations) == Stability::unchecked);
  CHECK(asked(with(0, 1.1 * none), true, Judge::energy, value, factorisations) == Stability::unstable);
  CHECK(value < 0);
  const double shift = (eigenvalue(n, 1) + eigenvalue(n, 2)) / 2;
  CHECK(asked(with(shift, 1e-3), true, Judge::energy, value, factorisations) == Stability::unstable);
  CHECK(std::abs(value - (eigenvalue(n, 1) - shift)) < 1e-9);
  // Zeros apart are none.
  CHECK(asked(with(0, 0), true, Judge::energy, value, factorisations) == Stability::stable);
}
