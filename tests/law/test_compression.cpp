// Sheets pressed one on the other, and what a card says of it.
#include <cmath>

#include "card/compression.hpp"
#include "catch.hpp"
#include "law/compression.hpp"
#include "law/law.hpp"
#include "message_of.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using law::Points;
using law::pressed_together;

TEST_CASE("compression: thicknesses add up at every pressure that was measured") {
  const Points a = {{0.3e-3, 4000}, {0.6e-3, 40}}, b = {{0.1e-3, 4000}, {0.2e-3, 400}, {0.5e-3, 40}};
  CHECK(pressed_together({{a, 1, 1}}) == a);
  CHECK(pressed_together({{{}, 1e-3, 1}}).empty());
  // Half of a sheet on another half of its own is as thick as the sheet.
  const Points twice = pressed_together({{a, 1, 0.5}, {a, 1, 0.5}});
  REQUIRE(twice.size() == 2);
  CHECK(twice[0].first == Approx(0.3e-3).epsilon(1e-15));
  // At 400 Pa the first is half way in the pressure's logarithm.
  const Points both = pressed_together({{a, 1, 1}, {b, 1, 1}});
  REQUIRE(both.size() == 3);
  CHECK(both[0].first == Approx(0.4e-3).epsilon(1e-14));
  CHECK(both[1].first == Approx(0.65e-3).epsilon(1e-14));
  CHECK(both[1].second == 400);
  CHECK(both[2].first == Approx(1.1e-3).epsilon(1e-14));
  // A ply that nobody measured stays as thick as it is.
  CHECK(pressed_together({{a, 1, 0.5}, {{}, 0.4e-3, 0.5}})[1].first == Approx(0.5e-3).epsilon(1e-14));
  // Ranges that do not meet: monotone all the same.
  const Points apart = pressed_together({{a, 1, 1}, {{{1e-4, 9e5}, {2e-4, 8e5}}, 1, 1}});
  REQUIRE(apart.size() == 3);
  for (std::size_t i = 1; i < apart.size(); ++i) {
    CHECK(apart[i].first > apart[i - 1].first);
    CHECK(apart[i].second < apart[i - 1].second);
  }
}

TEST_CASE("compression: a card whose points, fibres and thickness do not go together is refused") {
  const auto refusal = [](Points points, std::optional<double> fibres) {
    card::Card card = test::svk();  // 0.5 mm
    card.thickness = 0.5e-3;
    card.density = 500;
    card.name = "x";
    card.compression = std::move(points);
    card.fibre_density = fibres;
    return message_of([&] { law::compile(card); });
  };
  CHECK(refusal({{0.3e-3, 5000}, {0.6e-3, 50}}, 1540) == "no error");
  CHECK(refusal({{0.3e-3, 5000}}, {}) ==
        "card 'x': field 'compression': expected at least two points {gap, pressure}, got 1");
  CHECK(refusal({{0.3e-3, 5000}, {0.6e-3, 6000}}, {}) ==
        "card 'x': field 'compression': expected a pressure that falls as the gap grows, got {0.0003, 5000} "
        "and "
        "{0.0006, 6000}");
  CHECK(refusal({{-1, 5000}, {0.6e-3, 50}}, {}) ==
        "card 'x': field 'compression': expected positive gaps in m and pressures in Pa, got {-1, 5000}");
  CHECK(refusal({{0.3, 5000}, {0.6, 50}}, {}) ==
        "card 'x': field 'compression': expected gaps in m that are near the thickness of 0.0005 m, got from "
        "0.3 "
        "m to 0.6 m");
  CHECK(refusal({{0.15e-3, 5000}, {0.6e-3, 50}}, 1540) ==
        "card 'x': field 'compression': expected gaps above the 0.0001623 m that the fibres alone fill "
        "(areal "
        "mass over fibre_density), got 0.00015 m");
  CHECK(refusal({}, 400) ==
        "card 'x': field 'fibre_density': expected more than the cloth's own density of 500 kg/m^3, got 400 "
        "kg/m^3");
}
