#include <cmath>
#include <random>

#include "lab/averaged.hpp"
#include "lab/backbone.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::lab;

namespace {

// A pull of S = a (exp(b E) - 1), which is no polynomial, on a specimen that is longer than the gauge by
// `contact`.
Tension pulled(double contact, double noise, std::mt19937_64& random, int rows = 90) {
  std::normal_distribution<double> normal;
  Tension t;
  for (int i = 0; i < rows; ++i) {
    const double E = -0.008 + 0.108 * i / (rows - 1);  // from contact
    const double S = E > 0 ? 0.5e6 * (std::exp(18 * E) - 1) : 0;
    const double stretch = (1 + contact) * std::sqrt(1 + 2 * E);
    if (stretch < 1) continue;
    t.E.push_back((stretch * stretch - 1) / 2);
    t.S.push_back(S / (1 + contact) + noise * normal(random));
  }
  return t;
}

}  // namespace

TEST_CASE("a curve of no polynomial law and its first contact are found with what noise leaves open",
          "[lab]") {
  std::mt19937_64 random(8);
  for (const double contact : {0.0, 0.004, 0.007}) {
    const auto c = average_curves({pulled(contact, 4e3, random), pulled(contact, 4e3, random)}, {});
    REQUIRE(c.E.size() == 40);
    for (const auto& s : c.specimens) {
      CHECK(s.slack_low - 1e-4 <= contact);
      CHECK(contact <= s.slack_high + 1e-4);
      CHECK(s.slack_high - s.slack_low < 0.004);
      CHECK(s.residual < 6e3);
      for (std::size_t g = 0; g < c.E.size(); ++g) {
        const double reference = 0.5e6 * (std::exp(18 * c.E[g]) - 1);
        // three deviations of the mean covariance, which with the last digits is never nothing
        CHECK(std::abs(s.S[g] - reference) < 4 * std::sqrt(c.within[g * c.E.size() + g]) + 1e3);
      }
    }
    double sum = 0;
    for (const auto& law : c.laws) sum += law.weight;
    CHECK(std::abs(sum - 1) < 1e-2);  // laws of less than 1e-4 are not listed
  }
}

TEST_CASE("without noise contact is where it is", "[lab]") {
  std::mt19937_64 random(8);
  const auto c = average_curves({pulled(0.005, 0, random)}, {});
  CHECK(std::abs(c.specimens[0].slack - 0.005) < 2e-4);
  CHECK(c.specimens[0].none < 0.01);
}

TEST_CASE("a record that begins under load began before", "[lab]") {
  std::mt19937_64 random(8);
  Tension t = pulled(0, 1e3, random), late;
  for (std::size_t i = 6; i < t.E.size(); ++i) {
    late.E.push_back((1 + 2 * t.E[i]) / (1 + 2 * t.E[6]) / 2 - 0.5);
    late.S.push_back(t.S[i] * std::sqrt(1 + 2 * t.E[6]));
  }
  const double begun = 1 / std::sqrt(1 + 2 * t.E[6]) - 1;
  const auto c = average_curves({late}, {});
  CHECK(c.specimens[0].slack_low < begun);
  CHECK(begun < c.specimens[0].slack_high + 5e-4);
  CHECK(c.specimens[0].slack_high < 1e-4);
}
