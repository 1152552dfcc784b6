// Energy: closed loops, W = stored + dissipated, dissipation that never falls. test_loops_long.cpp runs the
// same with 100,000 loops per card.
#include <cmath>
#include <cstdio>

#include "catch.hpp"
#include "draws.hpp"
#include "law/loops.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

TEST_CASE("closed loops of the potential law never make energy, whatever the option", "[law][energy]") {
  for (int f = 0; f < 4; ++f) potential_loops(f, draws(100));
}

TEST_CASE("closed loops of the comparison laws", "[law][energy]") { comparison_loops(draws(500)); }

namespace {

// Shear swings to and fro; E13 rises while shear unloads (Gu) and falls while it loads virgin (soft). Work
// per elastic energy of the E13 swing after ten swings, from law and transverse rule.
double pumped(card::LawKind law, card::Transverse transverse) {
  LawPoint point(thesis_card(0, law, transverse));
  const double swing = 0.02, lift = 0.2, Gu = 6 * MPa;
  const double way = stress_of(thesis_rows()[0].shear, swing / 2) * MPa / Gu;  // unloading to zero stress
  double top = swing, sign = 1;
  point.go({0, 0, 0, 0, top});
  for (int k = 0; k < 10; ++k) {
    top -= sign * way;
    point.go({0, 0, 0, lift, top});
    sign = -sign;
    top += sign * swing;
    point.go({0, 0, 0, 0, top});
  }
  const auto e = point.energy();
  const double G13 = 5.0 / 6 * modulus_of(thesis_rows()[0].shear, 0) * MPa / 2;
  return (e.stored + e.dissipated()) / (0.5 * G13 * lift * lift);
}

}  // namespace

TEST_CASE("transverse shear that follows the switch pumps energy, elastic transverse shear does not",
          "[law][energy]") {
  using card::LawKind, card::Transverse;
  const double follows = pumped(LawKind::incremental, Transverse::follow);
  std::printf(
      "ten swings of (E12, E13): work %.2f of the elastic energy (follow), %.3f (elastic), %.3f "
      "(potential)\n",
      follows, pumped(LawKind::incremental, Transverse::elastic),
      pumped(LawKind::potential, Transverse::elastic));
  CHECK(follows < -5);
  CHECK(pumped(LawKind::incremental, Transverse::elastic) > 0);
  CHECK(pumped(LawKind::potential, Transverse::elastic) > 0);
}
