// Consistent tangents of every law against central differences on 10,000 random states each, with the
// branches counted. A state is reached by a random walk; differences are taken where no switch lies within
// reach.
#include <cstdio>
#include <map>
#include <vector>

#include "catch.hpp"
#include "law/law_point.hpp"
#include "law/thesis_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

Strain random_strain(Random& random, const card::Woven& w, double reach) {
  return {random(-0.3, reach) * w.tested.warp, random(-0.3, reach) * w.tested.weft, random(-0.02, 0.02),
          random(-0.02, 0.02), random(-0.6, 0.6)};
}

struct Comparison {
  double error = 0;  // relative to the largest entry of C
  bool smooth = true;
};

// Central differences with two steps; where they disagree a switch lies between, and the state is not used.
Comparison compare(LawPoint& point, const Strain& E) {
  point.evaluate(E);
  const auto C = point.C;
  double size = 0;
  for (const double c : C) size = std::max(size, std::fabs(c));
  Comparison out;
  for (int j = 0; j < 5; ++j) {
    double column[2][5];
    for (int k = 0; k < 2; ++k) {
      const double h = k == 0 ? 3e-7 : 9e-7;
      Strain up = E, down = E;
      up[j] += h;
      down[j] -= h;
      point.evaluate(up);
      const Strain high = point.S;
      point.evaluate(down);
      for (int i = 0; i < 5; ++i) column[k][i] = (high[i] - point.S[i]) / (2 * h);
    }
    for (int i = 0; i < 5; ++i) {
      if (std::fabs(column[0][i] - column[1][i]) > 5e-7 * size) out.smooth = false;
      const double derivative = (9 * column[0][i] - column[1][i]) / 8;  // Richardson: error h^4
      out.error = std::max(out.error, std::fabs(derivative - C[5 * i + j]) / size);
    }
  }
  return out;
}

std::string branch_key(const LawPoint& point, const Strain& E) {
  const auto in = law::internal(*point.law, E.data(), point.s.data());
  const char letters[] = {'v', 'u', 's'};
  return {letters[int(in.warp)], letters[int(in.weft)], letters[int(in.shear)]};
}

// Random walks of eight steps, each from virgin cloth.
void walk(const card::Card& card, int states, unsigned seed) {
  Random random(seed);
  const auto& w = std::get<card::Woven>(card.law);
  std::map<std::string, int> branches;
  double worst = 0;
  int used = 0, tried = 0;
  while (used < states && tried < 2 * states) {
    LawPoint point(card);
    for (int step = 0; step < 8; ++step, ++tried) {
      Strain E = random_strain(random, w, 1.3);
      // Small steps now and then, so that the narrow branches (band, unloading) are met.
      if (random.below(2) == 0)
        for (int i = 0; i < 5; ++i) E[i] = point.E[i] + random(-2e-3, 2e-3);
      const auto found = compare(point, E);
      if (found.smooth) {
        ++used;
        ++branches[branch_key(point, E)];
        worst = std::max(worst, found.error);
      }
      REQUIRE(point.go(E));
    }
  }
  INFO(card.name << ": worst " << worst << " over " << used << " of " << tried);
  CHECK(used >= 0.9 * tried);
  CHECK(worst < 1e-7);  // what a kink inside the differences may leave undetected
  std::string covered;
  for (const char a : {'v', 'u', 's'})
    for (const char b : {'v', 'u', 's'})
      for (const char c : {'v', 'u'}) {
        const int n = branches[{a, b, c}];
        covered += std::string{a, b, c} + " " + std::to_string(n) + "  ";
        CHECK((n > 0 || !w.shear_hysteresis));
      }
  std::printf("tangent %-7s law %d follow %d: worst %.1e, branches %s\n", card.name.c_str(), int(w.law),
              int(w.transverse), worst, covered.c_str());
}

}  // namespace

TEST_CASE("tangent of the potential law against differences", "[law][tangent]") {
  for (int i = 0; i < 4; ++i) walk(thesis_card(i), 2500, 11 + i);
}

TEST_CASE("tangent of the potential law with its options", "[law][tangent]") {
  for (int i = 0; i < 4; ++i) {
    auto card = with_biaxial(thesis_card(i));
    woven(card).shear.memory = card::ShearMemory::fading;
    walk(card, 2500, 23 + i);
  }
}

TEST_CASE("tangent of the potential law with curved loops", "[law][tangent][loop]") {
  for (int i = 0; i < 4; ++i) walk(with_loops(thesis_card(i)), 2500, 53 + i);
}

TEST_CASE("tangent of the potential law with yarns that break", "[law][tangent][damage]") {
  for (int i = 0; i < 4; ++i) walk(with_damage(thesis_card(i)), 10000, 63 + i);
}

TEST_CASE("tangents of the comparison laws against differences", "[law][tangent]") {
  for (const auto law : {card::LawKind::incremental, card::LawKind::thesis})
    for (const auto transverse : {card::Transverse::elastic, card::Transverse::follow})
      for (int i = 0; i < 4; ++i) walk(thesis_card(i, law, transverse), 2500, 31 + i);
}

TEST_CASE("tangents of the comparison laws without shear hysteresis", "[law][tangent]") {
  for (const auto law : {card::LawKind::incremental, card::LawKind::thesis}) {
    auto card = thesis_card(0, law, card::Transverse::follow);
    woven(card).shear_hysteresis = false;
    walk(card, 2500, 47);
  }
}
