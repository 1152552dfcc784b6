// Sobol's sequence and the normal quantile.
#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "catch.hpp"
#include "lab/statistics.hpp"

using namespace fabricsh;

TEST_CASE("Sobol's points: each half, quarter and eighth of an axis has as many points") {
  // The first 2^k - 1 points and the origin have one point in each of the 2^k parts of every axis.
  const std::size_t n = 63, dimensions = 12;
  const auto points = lab::sobol_points(n, dimensions, 0);
  REQUIRE(points.size() == n * dimensions);
  for (std::size_t k = 0; k < dimensions; ++k) {
    std::set<int> parts{0};
    for (std::size_t i = 0; i < n; ++i) {
      const double p = points[i * dimensions + k];
      CHECK((p > 0 && p < 1));
      parts.insert(static_cast<int>(64 * p));
    }
    CHECK(parts.size() == 64);
  }
}

TEST_CASE("Sobol's points integrate a smooth function far better than random ones; seeds shift them") {
  // The integral of prod (3 x_k^2) over the cube is 1.
  const auto mean = [](std::uint64_t seed) {
    const std::size_t n = 4096, dimensions = 4;
    const auto points = lab::sobol_points(n, dimensions, seed);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double product = 1;
      for (std::size_t k = 0; k < dimensions; ++k)
        product *= 3 * points[i * dimensions + k] * points[i * dimensions + k];
      sum += product;
    }
    return sum / n;
  };
  // Random points would have an error of deviation sqrt((9/5)^4 - 1) / 64 = 0.048.
  std::vector<double> errors;
  for (const std::uint64_t seed : {0, 1, 2, 3, 4}) errors.push_back(mean(seed) - 1);
  for (const double e : errors) CHECK(std::abs(e) < 0.01);
  std::sort(errors.begin(), errors.end());
  CHECK(std::adjacent_find(errors.begin(), errors.end()) == errors.end());
}

TEST_CASE("Sobol's points: dimensions") {
  CHECK_THROWS_AS(lab::sobol_points(4, 0, 1), Error);
  CHECK_THROWS_AS(lab::sobol_points(4, lab::most_dimensions + 1, 1), Error);
}

TEST_CASE("the normal quantile against the error function") {
  for (const double p : {1e-6, 0.025, 0.4, 0.5, 0.841344746068543, 0.999}) {
    const double x = lab::normal_quantile(p);
    CHECK(0.5 * std::erfc(-x / std::sqrt(2.0)) == Approx(p).epsilon(1e-12));
  }
}
