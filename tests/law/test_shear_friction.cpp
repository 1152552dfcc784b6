// Elastic shear with friction that grows with the strain: the loop in closed form, its account, its tangent.
#include <cmath>

#include "catch.hpp"
#include "law/beside_batches.hpp"
#include "law/law_point.hpp"
#include "law/thesis_cards.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

// S12 in Pa over gamma = 2 E12: elastic 0.4 MPa, friction 20 kPa + 150 kPa |gamma|, sticking with 5 MPa.
constexpr double modulus = 0.4e6, friction_stress = 20e3, growth = 150e3, k = 5e6, tested = 0.3;

card::Card cloth(double grows = growth) {
  auto c = thesis_card(0);
  auto& w = woven(c);
  w.shear.loading = {{2 * modulus}, {}};  // tensor measure
  w.shear.unloading = 2 * (modulus + k);
  w.shear.friction = card::ShearFriction{friction_stress, 2 * grows};
  w.tested.shear = tested / 2;
  return c;
}

double shear(LawPoint& point, double gamma, int n = 1) {
  const double start = point.E[4];
  for (int i = 1; i <= n; ++i)
    REQUIRE(point.go({0, 0, 0, 0, i == n ? gamma : start + (gamma - start) * i / n}));
  return point.S[4];
}

}  // namespace

TEST_CASE("a shear loop that widens: its sides and its account in closed form", "[law][friction]") {
  for (const double grows : {growth, 0.0, -0.3 * growth})
    for (const int n : {1, 4000}) {
      LawPoint point(cloth(grows));
      const auto limit = [&](double g) { return friction_stress + grows * std::min(std::fabs(g), tested); };
      for (int cycle = 0; cycle < 2; ++cycle) {
        for (const double g : {0.05, 0.2, 0.35})
          CHECK(shear(point, g, n) == Approx(modulus * g + limit(g)).epsilon(1e-11));
        for (const double g : {0.2, 0.05, 0.0, -0.1, -0.35})
          CHECK(shear(point, g, n) == Approx(modulus * g - limit(g)).epsilon(1e-11));
        for (const double g : {-0.1, -0.02})
          CHECK(shear(point, g, n) == Approx(modulus * g + limit(g)).epsilon(1e-11));
      }
      // A whole cycle between +-0.2 loses the area between its sides, less what sticks at the two turns.
      shear(point, 0.2, n);
      const auto before = point.energy();
      shear(point, -0.2, n);
      shear(point, 0.2, n);
      const auto after = point.energy();
      const double area = 4 * (friction_stress * 0.2 + grows * 0.02);
      CHECK(after.stored == Approx(before.stored).epsilon(1e-12));
      const double Y = limit(0.2);
      // At a turn the side is left with slope k, to come to the other one 2 c on: k c ... of width 2 Y.
      const double c = 2 * Y / (k + grows), corner = Y * c;
      CHECK(after.dissipated() - before.dissipated() == Approx(area - 2 * corner).epsilon(1e-9));
    }
}

TEST_CASE("the tangent of shear with friction, against differences", "[law][friction][tangent]") {
  Random random(6);
  LawPoint point(cloth());
  int sticks = 0, slips = 0;
  for (int i = 0; i < 5000; ++i) {
    const double g = i % 2 == 0 ? random(-0.4, 0.4) : point.E[4] + random(-0.01, 0.01), h = 1e-7;
    point.evaluate({0, 0, 0, 0, g + h});
    const double up = point.S[4];
    point.evaluate({0, 0, 0, 0, g - h});
    const double down = point.S[4];
    point.evaluate({0, 0, 0, 0, g});
    const double C = point.C[24], middle = point.S[4];
    if (std::fabs(up + down - 2 * middle) < 1e-9 * k) CHECK((up - down) / (2 * h) == Approx(C).epsilon(1e-5));
    (C > k ? sticks : slips)++;
    CHECK(C > 0);
    point.go({0, 0, 0, 0, g});
  }
  CHECK(sticks > 500);
  CHECK(slips > 500);
}

TEST_CASE("friction in shear that no law can carry is refused", "[law][friction]") {
  const auto refused = [](const std::function<void(card::Woven&)>& change, const std::string& words) {
    auto c = cloth();
    change(woven(c));
    says(message_of([&] { law::compile(c); }), "field 'shear.friction': expected " + words);
  };
  refused([](auto& w) { w.law = card::LawKind::thesis; }, "law = \"potential\"");
  refused([](auto& w) { w.shear.memory = card::ShearMemory::fading; }, "shear.memory = \"printed\"");
  refused([](auto& w) { w.shear.unloading = 2 * modulus + 1e4; }, "unloading above the initial modulus");
  refused([](auto& w) { w.shear.friction->growth = -2 * friction_stress / tested * 1.01; },
          "a stress above 0 up to");
  refused([](auto& w) { w.shear.friction->growth = 2 * modulus * 1.01; },
          "a growth below the modulus of loading");
}

TEST_CASE("single points and batches agree on shear with friction and on shear that relaxes",
          "[law][batch]") {
  Random random(8);
  for (const auto& card : {cloth(), with_viscous(cloth()), with_viscous(thesis_card(1))})
    beside_batches(card, 50, random, [](const LawPoint& point, const Lane& lane) {
      CHECK(lane.S(4) == Approx(point.S[4]).epsilon(1e-11).margin(1e-3));
      CHECK(lane.C(24) == Approx(point.C[24]).epsilon(1e-11));
      CHECK(lane.energy(0) == Approx(point.energy().stored).epsilon(1e-11).margin(1e-6));
      CHECK(lane.energy(3) == Approx(point.energy().lost[2]).epsilon(1e-11).margin(1e-6));
    });
}
