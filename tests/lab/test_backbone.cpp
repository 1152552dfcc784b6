#include <array>
#include <cmath>
#include <random>

#include "lab/backbone.hpp"
#include "lab/statistics.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::lab;

namespace {

// The record of a pull of d with a stretch of contact, against the nominal gauge.
Tension pulled(const std::vector<double>& d, double reach, double contact, int rows = 300) {
  Tension t;
  for (int i = 0; i < rows; ++i) {
    const double E = -0.01 + (reach + 0.01) * i / (rows - 1);  // seen from contact
    const double S = E > 0 ? backbone_stress(d, E) : 0;
    const double stretch = (1 + contact) * std::sqrt(1 + 2 * E);
    t.E.push_back((stretch * stretch - 1) / 2);
    t.S.push_back(S / (1 + contact));
  }
  return t;
}

void check_close(const std::vector<double>& got, const std::vector<double>& want, double relative) {
  REQUIRE(got.size() == want.size());
  for (std::size_t i = 0; i < want.size(); ++i) {
    INFO("coefficient " << i << ": " << got[i] << ", wanted " << want[i]);
    CHECK(std::abs(got[i] - want[i]) < relative * std::abs(want[i]));
  }
}

}  // namespace

TEST_CASE("the tangent is the derivative of the stress", "[lab]") {
  const std::vector<double> d{15e6, -184e6, 6240e6, 3040e6};
  for (const double h : {1e-3, 5e-4}) {
    const double slope = (backbone_stress(d, 0.1 + h) - backbone_stress(d, 0.1 - h)) / (2 * h);
    const double third = 2 * d[2] + 6 * d[3] * 0.1;  // D''
    CHECK(std::abs(slope - backbone_tangent(d, 0.1) - third * h * h / 6) < 1e-3 * third * h * h);
  }
}

TEST_CASE("exact curves give their coefficients and their slack back", "[lab]") {
  const std::vector<double> blend{8e6, 826e6}, duck{28e6, -1000e6, 48300e6, -79200e6};
  for (const auto& d : {blend, duck}) {
    for (const double contact : {0.0, 0.004}) {
      const auto c = fit_backbones({pulled(d, 0.09, contact)}, {{static_cast<int>(d.size())}, true});
      // the golden section stops at half of the digits of a minimum
      CHECK(std::abs(c[0].specimens[0].slack - contact) < 1e-7);
      check_close(c[0].specimens[0].d, d, 2e-5);
    }
  }
  const auto plain = fit_backbones({Tension{{0.1, 0.2, 0.3, 0.4}, {3, 8, 15, 24}}}, {{2}, false});
  check_close(plain[0].specimens[0].d, {20, 200}, 1e-12);
}

TEST_CASE("the criterion takes the curve that is there, and refuses a tangent below zero", "[lab]") {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0, 2e3);
  for (const int degree : {2, 4}) {
    Tension t = pulled(
        degree == 2 ? std::vector<double>{8e6, 826e6} : std::vector<double>{28e6, -1000e6, 48300e6, -79200e6},
        0.09, 0);
    for (double& s : t.S) s += noise(random);
    const auto c = fit_backbones({t}, {});
    CHECK(c[*choose(c)].degree == degree);
  }
  Tension t;
  for (int i = 1; i < 100; ++i) {
    t.E.push_back(i * 1e-3);
    t.S.push_back(-5e6 * i * 1e-3 + 900e6 * i * i * 1e-6);
  }
  CHECK_FALSE(choose(fit_backbones({t}, {{2}, false})));
  const auto points = monotone_points({t}, 10);
  CHECK(points.size() > 5);
  for (std::size_t i = 1; i < points.size(); ++i) CHECK(points[i].second > points[i - 1].second);
  says(message_of([] { fit_backbones({Tension{{0.1}, {1}}}, {}); }), "at least 6 loading points");
}

TEST_CASE("the unloading modulus of a straight line, with an outlier", "[lab]") {
  std::vector<double> E, S;
  for (int i = 0; i < 20; ++i) {
    E.push_back(0.2 - 1e-3 * i);
    S.push_back(100 - 2 * i);
  }
  CHECK(std::abs(*unloading_modulus(E, S, {}) - 2000) < 1e-8);
  S[1] += 5;
  CHECK(std::abs(*unloading_modulus(E, S, {UnloadingRule::robust, 3, 0.7}) - 2000) < 1e-8);
  CHECK_FALSE(unloading_modulus(std::span(E).first(1), std::span(S).first(1), {}));
}

TEST_CASE("Student's quantiles against the tables [abramowitz1964, table 26.10]", "[lab]") {
  CHECK(std::abs(student_quantile(0.975, 1) - 12.706) < 5e-4);
  CHECK(std::abs(student_quantile(0.975, 5) - 2.571) < 5e-4);
  CHECK(std::abs(student_quantile(0.95, 10) - 1.812) < 5e-4);
  CHECK(std::abs(student_quantile(0.5, 3)) < 1e-14);
  CHECK(std::abs(student_quantile(0.75, 1) - 1) < 1e-13);  // tan(pi/4)
}

TEST_CASE("the band of a mean covers it as often as it says", "[lab]") {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(10, 2);
  for (const int n : {3, 5}) {
    int inside = 0;
    for (int k = 0; k < 2000; ++k) {
      std::vector<std::vector<double>> specimens;
      for (int i = 0; i < n; ++i) specimens.push_back({normal(random)});
      const auto b = band_of(specimens, {0.95, 400, 1, {}});
      inside += b.low[0] < 10 && 10 < b.high[0] ? 1 : 0;
    }
    CHECK(std::abs(inside / 2000.0 - 0.95) < 0.015);  // three deviations of the count
  }
}

TEST_CASE("the bootstrap's covariance is that of the mean; a shared error adds to it", "[lab]") {
  const std::vector<std::vector<double>> s{{1, 2}, {2, 1}, {4, 5}, {1, 0}};
  const auto b = band_of(s, {0.95, 200000, 1, {}}), wide = band_of(s, {0.95, 200000, 1, {0.1, 0.2}});
  CHECK(b.value == std::vector<double>{2, 2});
  // sums of squares 6, 14, product 8, over n (n-1) = 12; the draws leave 1/sqrt(draws)
  CHECK(std::abs(b.covariance[0] - 0.5) < 0.005);
  CHECK(std::abs(b.covariance[3] - 14.0 / 12) < 0.01);
  CHECK(std::abs(b.covariance[1] - 8.0 / 12) < 0.007);
  CHECK(std::abs(wide.covariance[1] - b.covariance[1] - 0.2 * 0.4) < 1e-12);
  CHECK(band_of({{1, 2}}, {}).low.empty());
}

TEST_CASE("drawn parameters fill their bands and keep their correlation", "[lab]") {
  std::mt19937_64 random(1);
  const std::vector<double> value{1, -2}, low{0.5, -5}, high{1.5, 1},
      covariance{4, 5.4, 5.4, 9};  // correlation 0.9
  double inside = 0, xx = 0, xy = 0, yy = 0;
  constexpr int draws = 20000;
  for (int i = 0; i < draws; ++i) {
    const auto d = draw_around(value, low, high, covariance, 0.95, random);
    const double x = (d[0] - 1) / 0.5, y = (d[1] + 2) / 3;
    inside += std::abs(x) < 1 ? 1 : 0;
    xx += x * x, xy += x * y, yy += y * y;
  }
  CHECK(std::abs(inside / draws - 0.95) < 0.005);  // three deviations of the count
  CHECK(std::abs(xy / std::sqrt(xx * yy) - 0.9) < 0.01);
}

TEST_CASE("bands whose value is nearer to one end are drawn as they are stated", "[lab]") {
  std::mt19937_64 random(2);
  // at its lower end; a quarter of the way up; at its upper end, and moving against the first
  const std::vector<double> value{3, 1, 8}, low{3, 0, 2}, high{7, 4, 8},
      covariance{4, 0, -6, 0, 1, 0, -6, 0, 9};
  constexpr int draws = 20000;
  std::array<int, 3> inside{}, below{};
  double apart = 0;
  for (int k = 0; k < draws; ++k) {
    const auto d = draw_around(value, low, high, covariance, 0.95, random);
    for (std::size_t i = 0; i < 3; ++i) {
      inside[i] += low[i] <= d[i] && d[i] <= high[i] ? 1 : 0;
      below[i] += d[i] < value[i] ? 1 : 0;
    }
    apart = std::max(apart, std::abs((d[0] - 3) / 4 - (8 - d[2]) / 6));
  }
  for (const int n : inside) CHECK(std::abs(static_cast<double>(n) / draws - 0.95) < 0.005);
  CHECK(below[0] == 0);
  CHECK(std::abs(static_cast<double>(below[1]) / draws - 0.25) < 0.01);  // three deviations of the count
  CHECK(below[2] == draws);
  CHECK(apart < 1e-6);  // fully correlated, so they move together
}
