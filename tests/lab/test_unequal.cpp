// Specimens that differ: reach, number of points, noise.
#include <cmath>

#include "catch.hpp"
#include "lab/backbone.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::lab;

namespace {

Tension pulled(const std::vector<double>& d, double reach, int rows) {
  Tension t;
  for (int i = 1; i <= rows; ++i) {
    t.E.push_back(reach * i / rows);
    t.S.push_back(backbone_stress(d, t.E.back()));
  }
  return t;
}

}  // namespace

TEST_CASE("two specimens of unequal reach: the mean curve is judged where both of them were measured",
          "[lab]") {
  // Tangents 10 + 100 E and 30 - 500 E: their mean 20 - 200 E vanishes at E = 0.1. The second was pulled to
  // 0.03 only, up to where the mean tangent falls to 14.
  const std::vector<double> rises{10, 100}, falls{30, -500};
  for (const bool swapped : {false, true}) {
    std::vector<Tension> both = {pulled(rises, 0.2, 50), pulled(falls, 0.03, 20)};
    if (swapped) std::swap(both[0], both[1]);
    const auto c = fit_backbones(both, {{2}, false});
    REQUIRE(c.size() == 1);
    CHECK(c[0].initial == Approx(20).epsilon(1e-9));
    CHECK(c[0].least == Approx(20 - 200 * 0.03).epsilon(1e-9));
    CHECK(c[0].admissible);
    CHECK(c[0].specimens[swapped ? 1 : 0].reach == Approx(0.2).epsilon(1e-14));
    CHECK(c[0].specimens[swapped ? 0 : 1].reach == Approx(0.03).epsilon(1e-14));
    CHECK(c[0].specimens[swapped ? 0 : 1].points == 20);
  }
  // Both pulled to 0.11 show that it cannot be.
  const auto far = fit_backbones({pulled(rises, 0.2, 50), pulled(falls, 0.11, 20)}, {{2}, false});
  CHECK(far[0].least == Approx(20 - 200 * 0.11).epsilon(1e-9));
  CHECK_FALSE(far[0].admissible);
}

TEST_CASE("means of bins end where the shorter specimen does, and each row counts once", "[lab]") {
  // S = 100 E to 0.05 with 40 rows, S = 300 E to 0.02 with 8 rows: five bins of 0.004 up to 0.02, in each of
  // them three or four rows of the first (E = 0.00125 i) and one or two of the second (E = 0.0025 i).
  const Tension a = pulled({100}, 0.05, 40), b = pulled({300}, 0.02, 8);
  std::vector<std::pair<double, double>> wanted{{0, 0}};
  for (int bin = 0; bin < 5; ++bin) {
    double E = 0, S = 0, n = 0;
    for (const Tension* t : {&a, &b})
      for (std::size_t i = 0; i < t->E.size(); ++i) {
        const int mine = std::min(4, int(std::floor(t->E[i] / 0.02 * 5)));
        if (t->E[i] > 0.02 + 1e-15 || mine != bin) continue;
        E += t->E[i], S += t->S[i], n += 1;
      }
    wanted.emplace_back(E / n, S / n);
  }
  for (const bool swapped : {false, true}) {
    const auto points = monotone_points(swapped ? std::vector{b, a} : std::vector{a, b}, 5);
    REQUIRE(points.size() == wanted.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK(points[i].first == Approx(wanted[i].first).margin(1e-15));
      CHECK(points[i].second == Approx(wanted[i].second).margin(1e-12));
    }
    CHECK(points.back().first < 0.02);
  }
  // Two bins that fall become one, of the mean of their rows: (5 + 3 * 2) / 4 at (0.5 + 1.2 + 1.5 + 1.8) / 4.
  const auto pooled = monotone_points({Tension{{0.5, 1.2, 1.5, 1.8, 3}, {5, 2, 2, 2, 9}}}, 3);
  REQUIRE(pooled.size() == 3);
  CHECK(pooled[1].first == Approx(1.25).epsilon(1e-14));
  CHECK(pooled[1].second == Approx(2.75).epsilon(1e-14));
  CHECK(pooled[2] == std::pair(3.0, 9.0));
}

TEST_CASE("a fit weighs each specimen by its own scatter", "[lab]") {
  // Residuals of +-e by turns are orthogonal to every smooth curve but for the ends: the root mean square of
  // each specimen is its own e. 2 %: two of 200 rows' worth of freedom, and the ends.
  const std::vector<double> d{20, 300};
  Tension quiet = pulled(d, 0.1, 200), noisy = pulled(d, 0.06, 200);
  for (std::size_t i = 0; i < 200; ++i) {
    quiet.S[i] += i % 2 == 0 ? 0.002 : -0.002;
    noisy.S[i] += i % 2 == 0 ? 0.03 : -0.03;
  }
  const auto c = fit_backbones({quiet, noisy}, {{2}, false});
  CHECK(c[0].specimens[0].residual == Approx(0.002).epsilon(0.02));
  CHECK(c[0].specimens[1].residual == Approx(0.03).epsilon(0.02));
  // Over their variance every row is 1.
  CHECK(c[0].specimens[0].squares == Approx(200).epsilon(0.02));
  CHECK(c[0].specimens[1].squares == Approx(200).epsilon(0.02));
  CHECK(c[0].criterion ==
        Approx(c[0].specimens[0].squares + c[0].specimens[1].squares + 2 * 2 * std::log(200)).epsilon(1e-12));
}
