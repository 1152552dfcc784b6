// The structure through the thickness: points and their weights, plies, fibres, what presses, separate
// bending.
#include "catch.hpp"
#include "law/data.hpp"
#include "message_of.hpp"
#include "section/section.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using section::integrated;
using section::Section;
using section::stacked;

namespace {

// Integral over the thickness, in parts of it, of a function of zeta.
template <class F>
double over_thickness(const Section& s, F f) {
  double sum = 0;
  for (const auto& p : s.points) sum += p.weight / 2 * f(p);
  return sum;
}

// A compression curve of a sheet of 0.38 mm.
const std::vector<std::pair<double, double>> kPressed = {{0.2e-3, 4000}, {0.33e-3, 50}};

}  // namespace

TEST_CASE("section: n points integrate polynomials of degree 2 n - 1 over the thickness") {
  for (int n = 1; n <= 9; ++n) {
    const Section s = integrated(test::svk(), 1e-3, n, 0);
    for (int degree = 0; degree <= 2 * n - 1; ++degree) {
      const double got = over_thickness(s, [&](const auto& p) { return std::pow(p.zeta, degree); });
      CHECK(got == Approx(degree % 2 == 0 ? 1.0 / (degree + 1) : 0).margin(2e-14));
    }
  }
}

TEST_CASE(
    "section: a sheet thicker than its card says is thicker at every pressure, in the same proportion") {
  card::Card card = test::svk();
  card.thickness = 0.38e-3;
  card.compression = kPressed;
  const Section s = integrated(card, 0.57e-3, 3, 0);  // half as thick again
  REQUIRE(s.compression.size() == 2);
  CHECK(s.compression[0].first == Approx(0.3e-3).epsilon(1e-14));
  CHECK(s.compression[1].first == Approx(0.495e-3).epsilon(1e-14));
  CHECK(s.compression[0].second == 4000);
  CHECK(s.compression[1].second == 50);
  CHECK(s.areal_mass == Approx(590 * 0.57e-3).epsilon(1e-15));
}

TEST_CASE(
    "section: a ply's curve is scaled by that ply's thickness, a ply without one stays as thick as it is") {
  card::Card pressed = test::svk(), solid = test::svk();
  pressed.thickness = 0.38e-3;
  pressed.compression = kPressed;
  solid.thickness = 0.2e-3;
  const Section s = stacked({{pressed, 0.19e-3, 0}, {solid, 0.5e-3, 30}}, 2, 0);
  REQUIRE(s.compression.size() == 2);
  CHECK(s.compression[0].first == Approx(0.1e-3 + 0.5e-3).epsilon(1e-14));
  CHECK(s.compression[1].first == Approx(0.165e-3 + 0.5e-3).epsilon(1e-14));
}

TEST_CASE(
    "section: what fibres fill is density over theirs, three quarters at most where theirs is not known") {
  card::Card card = test::svk();
  card.density = 600;
  CHECK(integrated(card, 0.5e-3, 1, 0).solid_thickness == Approx(0.5e-3 * 600 / 1500).epsilon(1e-15));
  card.fibre_density = 960;
  CHECK(integrated(card, 0.5e-3, 1, 0).solid_thickness == Approx(0.5e-3 * 600 / 960).epsilon(1e-15));
  card.density = 950;
  CHECK(integrated(card, 0.5e-3, 1, 0).solid_thickness == Approx(0.5e-3 * 0.95).epsilon(1e-15));
  card.fibre_density.reset();
  card.density = 1400;
  CHECK(integrated(card, 0.5e-3, 1, 0).solid_thickness == Approx(0.5e-3 * 0.75).epsilon(1e-15));
}

TEST_CASE("section: plies add up their fibres and their mass, each by its own thickness and density") {
  card::Card light = test::svk(), heavy = test::svk(), full = test::svk();
  light.density = 300;
  heavy.density = 700;
  heavy.fibre_density = 1400;
  full.density = 1450;  // more than three quarters of 1500
  const Section s = stacked({{light, 0.2e-3, 0}, {heavy, 0.5e-3, 45}, {full, 0.1e-3, -30}}, 2, 0.25);
  CHECK(s.thickness == Approx(0.8e-3).epsilon(1e-15));
  CHECK(s.areal_mass == Approx(300 * 0.2e-3 + 700 * 0.5e-3 + 1450 * 0.1e-3).epsilon(1e-14));
  CHECK(s.solid_thickness == Approx(0.2e-3 * 0.2 + 0.5e-3 * 0.5 + 0.1e-3 * 0.75).epsilon(1e-14));
  CHECK(s.offset == 0.25);
  CHECK(s.compression.empty());
}

TEST_CASE("section: plies lie one on the other from below, each with its angle, density and states") {
  const card::Card below = test::blend(), above = test::duck();
  const double t1 = 0.3e-3, t2 = 0.5e-3, t = t1 + t2;
  const Section s = stacked({{below, t1, 20}, {above, t2, -70}}, 3, 0);
  REQUIRE(s.points.size() == 6);
  const double boundary = -1 + 2 * t1 / t;
  int state = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& p = s.points[i];
    const bool lower = i < 3;
    CHECK((p.zeta < boundary) == lower);
    CHECK(p.angle == Approx((lower ? 20 : -70) * 3.14159265358979323846 / 180).epsilon(1e-15));
    CHECK(p.density == (lower ? below.density : above.density));
    CHECK(p.state == state);
    state += law::state_size(*p.law);
  }
  CHECK(s.state_size == state);
  CHECK(s.plain == nullptr);  // two laws
  // First moment of the mass, over t^2: rho1 t1 (-t2 / 2) + rho2 t2 (t1 / 2).
  const double first = over_thickness(s, [](const auto& p) { return p.density * p.zeta / 2; });
  CHECK(first == Approx((above.density - below.density) * t1 * t2 / 2 / (t * t)).epsilon(1e-13));
}

TEST_CASE(
    "section: separate bending has a membrane in the middle and states for each friction that is there") {
  card::Card card = test::blend();
  card.bending = card::Bending{15e-6, 9e-6, 5e-6, {}, {}, {}, {}, 0};
  const Section plain = integrated(card, 0.4e-3, 5, 0);
  CHECK(plain.bends_apart);
  REQUIRE(plain.points.size() == 1);
  CHECK(plain.points[0].zeta == 0);
  CHECK(plain.points[0].weight == 2);
  CHECK(plain.bending[0].rigidity == 15e-6);
  CHECK(plain.bending[1].rigidity == 9e-6);
  CHECK(plain.bending[2].rigidity == 5e-6);
  const int membrane = law::state_size(*plain.points[0].law);
  CHECK(plain.state_size == membrane);
  CHECK(plain.bending_state == -1);

  using Friction = std::optional<card::BendingFriction>;
  const card::BendingFriction slips{2e-4, 6, card::FrictionMemory::slip},
      fades{3e-4, 9, card::FrictionMemory::fading};
  struct Case {
    Friction warp, weft;
    int states;
  };
  for (const Case& c : {Case{slips, {}, 2}, Case{{}, slips, 2}, Case{fades, {}, 3}, Case{{}, fades, 3},
                        Case{slips, fades, 3}, Case{fades, slips, 3}, Case{slips, slips, 2}}) {
    card.bending->friction_warp = c.warp;
    card.bending->friction_weft = c.weft;
    const Section s = integrated(card, 0.4e-3, 3, 0);
    CHECK(s.bending_state == membrane);
    CHECK(s.bending_states == c.states);
    CHECK(s.state_size == membrane + 2 * c.states);
    CHECK(s.bending[0].friction == (c.warp ? c.warp->moment : 0));
    CHECK(s.bending[1].friction == (c.weft ? c.weft->moment : 0));
    CHECK(s.bending[2].friction == 0);
  }
}

TEST_CASE("section: what cannot be is refused with the layer's number") {
  const card::Card card = test::svk();
  card::Card bends = card;
  bends.bending = card::Bending{1e-5, 1e-5, 1e-5, {}, {}, {}, {}, 0};
  says(message_of([&] { stacked({}, 2, 0); }), "layers: expected at least one layer");
  says(message_of([&] {
         stacked({{card, 1e-3, 0}, {card, 0, 0}}, 2, 0);
       }),
       "layers: layer 2: thickness: expected a positive length in m, got 0");
  says(message_of([&] {
         stacked({{card, 1e-3, 0}, {bends, 1e-3, 0}}, 2, 0);
       }),
       "layers: layer 2: a card with its own bending rigidity can't be one of several layers");
  says(message_of([&] { integrated(card, 1e-3, 10, 0); }), "points: expected 1 to 9");
  says(message_of([&] { integrated(card, 1e-3, 0, 0); }), "points: expected 1 to 9");
  says(message_of([&] { integrated(card, -1e-3, 3, 0); }), "thickness: expected a positive length");
  says(message_of([&] { integrated(card, 1e-3, 3, 1.5); }), "offset: expected a number from -1 to 1");
}
