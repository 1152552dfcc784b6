// Folds within a point: closed forms, tangents against differences, energies, and what must stay as it is.
#include <cmath>
#include <vector>

#include "catch.hpp"
#include "draws.hpp"
#include "law/law_point.hpp"
#include "law/thesis_cards.hpp"
#include "simd/isa.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

// A card of constant moduli.
card::Card straight(double warp, double weft, double shear, double nu12, card::Folds folds) {
  card::Card card;
  card.name = "straight";
  card.density = 500;
  card.thickness = 1e-4;
  card::Woven w;
  w.warp = {{{warp}, {}}, warp, nu12};
  w.weft = {{{weft}, {}}, weft, nu12 * weft / warp};
  w.shear = {{{2 * shear}, {}}, 2 * shear};
  w.tested = {0.3, 0.3, 0.5};
  card.law = w;
  card.folds = folds;
  return card;
}

struct FoldingPoint : LawPoint {
  FoldingPoint(const card::Card& card, double s1, double s2) : LawPoint(card) {
    law::Site site{{1e-3, 1e-3}};
    site.folding = {s1, s2};
    law::set_initial(*law, site, s.data());
  }
};

Strain random_strain(Random& random, double most) {
  const double size = most * std::pow(10, random(-3, 0));
  return {size * random(-1, 1), size * random(-1, 1), 0, 0, 2 * size * random(-1, 1)};
}

card::Card thesis_with(int f, card::Folds folds) {
  card::Card card = thesis_card(f);
  card.folds = folds;
  return card;
}

// Some compliance of folds stays, so that closed forms are met to this.
constexpr double nearly = 2e-3;

}  // namespace

TEST_CASE("folds: a point is found for any strain after any history", "[law][folds]") {
  Random random(7);
  for (int draw = 0; draw < draws(4000); ++draw) {
    const double k = std::pow(10, random(6, 9)), other = k * std::pow(10, random(-2, 2));
    const double shear = std::sqrt(k * other) * std::pow(10, random(-4, -0.4));
    const card::Card card =
        draw % 2 == 0 ? thesis_with(draw % 4, card::Folds::within)
                      : straight(k, other, shear, random(0, 0.9) * std::sqrt(k / other), card::Folds::within);
    const double limit = draw % 5 == 0 ? 0 : 1e6 * std::pow(10, random(-6, 0));
    FoldingPoint point(card, limit, limit * std::pow(10, random(-1, 1)));
    for (int leg = 0; leg < 6; ++leg) {
      INFO("draw " << draw << ", leg " << leg);
      REQUIRE(point.go(random_strain(random, 0.4)));
    }
  }
}

TEST_CASE("folds: cloth that is pressed along a yarn carries what its folds do", "[law][folds]") {
  const double k = 4e7, other = 1e7, nu12 = 0.3, s1 = 700, s2 = 300;
  FoldingPoint point(straight(k, other, 1e6, nu12, card::Folds::within), s1, s2);
  const double nu21 = nu12 * other / k, c = nu21 * k / (1 - nu12 * nu21), h1 = c / nu21;
  for (const double E : {-1e-4, -0.01, -0.2}) {
    REQUIRE(point.go({E, 0, 0, 0, 0}));
    const double r1 = s1 / 2 + 1e-5 * h1;               // the stiffness of its folds
    const double e = (r1 * E - s1) / (h1 + r1);         // h1 e + s1 + r1 (e - E) = 0
    CHECK(point.S[0] == Approx(h1 * e).epsilon(1e-9));  // a mere rounding of the strain is 1e-9 of it
    CHECK(point.S[1] == Approx(c * e).epsilon(1e-9));
    CHECK(point.S[4] == Approx(0).margin(1e-6));
  }
}

TEST_CASE("folds: a sheet that is sheared folds across its diagonal", "[law][folds]") {
  const double k = 1e8, nu = 0.3, G = k / (2 + 2 * nu);
  FoldingPoint point(straight(k, k, G, nu, card::Folds::free), 0, 0);
  for (const double gamma : {1e-3, -0.05, 0.2}) {
    REQUIRE(point.go({0, 0, 0, 0, gamma}));
    const double tension = k * std::fabs(gamma) / 2;  // along the diagonal, uniaxial
    CHECK(point.S[4] == Approx(std::copysign(tension / 2, gamma)).epsilon(nearly));
    CHECK(point.S[0] == Approx(tension / 2).epsilon(nearly));
    CHECK(point.S[1] == Approx(tension / 2).epsilon(nearly));
    CHECK(law::folded(*point.law, point.E.data(), point.s.data()) == Approx(1 - nu).epsilon(nearly));
  }
  REQUIRE(point.go({-0.02, -0.05, 0, 0, 0.01}));  // slack
  for (const int i : {0, 1, 4}) CHECK(std::fabs(point.S[i]) < 2e-5 * k * 0.06);
}

TEST_CASE("folds: where cloth is taut everything is as without, to the bit", "[law][folds]") {
  Random random(11);
  int taut = 0;
  for (int draw = 0; draw < draws(2000); ++draw) {
    const int f = draw % 4;
    FoldingPoint folding(thesis_with(f, card::Folds::within), 500, 300);
    LawPoint plain(thesis_card(f));
    const Strain E = random_strain(random, 0.3);
    REQUIRE(plain.go(E));
    REQUIRE(folding.go(E));
    const double a = plain.S[0] + 500, b = plain.S[1] + 300;
    if (!(a > 1e-9 && b > 1e-9 && a * b > plain.S[4] * plain.S[4] * (1 + 1e-9))) continue;
    ++taut;
    for (std::size_t i = 0; i < 5; ++i) CHECK(folding.S[i] == plain.S[i]);
    for (std::size_t i = 0; i < 25; ++i) CHECK(folding.C[i] == plain.C[i]);
    CHECK(folding.energy().stored == plain.energy().stored);
  }
  CHECK(taut > draws(2000) / 20);
}

TEST_CASE("folds: tangents are those of differences, symmetric and positive", "[law][folds]") {
  Random random(5);
  constexpr int in[3] = {0, 1, 4};
  int kinks = 0, points = 0;
  for (int draw = 0; draw < draws(600); ++draw) {
    const double limit = 1e5 * std::pow(10, random(-4, 0));
    FoldingPoint point(thesis_with(draw % 4, card::Folds::within), limit, 2 * limit);
    REQUIRE(point.go(random_strain(random, 0.2)));
    const Strain E = random_strain(random, 0.2);
    REQUIRE(point.evaluate(E));
    const auto C = point.C;
    const double size = C[0] + C[6] + C[24];
    double off = 0;
    for (int j = 0; j < 3; ++j) {
      const double h = 1e-6 * (std::fabs(E[0]) + std::fabs(E[1]) + std::fabs(E[4]));
      Strain up = E, down = E;
      up[in[j]] += h, down[in[j]] -= h;
      REQUIRE(point.evaluate(up));
      const auto high = point.S;
      REQUIRE(point.evaluate(down));
      for (const int i : in)
        off = std::max(off, std::fabs((high[i] - point.S[i]) / (2 * h) - C[5 * i + in[j]]) / size);
    }
    ++points;
    kinks += off > 1e-3;
    CHECK(C[1] == C[5]);
    CHECK(C[4] == C[20]);
    CHECK(C[9] == C[21]);
    const double minor = C[0] * C[6] - C[1] * C[1];
    const double whole =
        C[24] * minor - C[4] * (C[4] * C[6] - C[1] * C[9]) - C[9] * (C[0] * C[9] - C[1] * C[4]);
    CHECK((C[0] > 0 && minor > 0 && whole > 0));
  }
  CHECK(kinks <= points / 50);  // a difference may lie across a switch of the law
}

TEST_CASE("folds: the work of random strain paths is stored or dissipated", "[law][folds]") {
  Random random(13);
  for (int draw = 0; draw < draws(80); ++draw) {
    const double limit = draw % 3 == 0 ? 0 : 1e4 * std::pow(10, random(-3, 1));
    FoldingPoint point(thesis_with(draw % 4, draw % 3 == 0 ? card::Folds::free : card::Folds::within), limit,
                       limit);
    double work = 0, gross = 0;
    for (int leg = 0; leg < 5; ++leg) {
      const Strain from = point.E, to = random_strain(random, 0.2);
      constexpr int steps = 2000;
      for (int k = 1; k <= steps; ++k) {
        Strain e{};
        for (std::size_t i = 0; i < 5; ++i) e[i] = from[i] + (to[i] - from[i]) * k / steps;
        const auto before = point.S;
        const auto last = point.E;
        REQUIRE(point.go(e));
        double part = 0;
        for (std::size_t i = 0; i < 5; ++i) part += 0.5 * (before[i] + point.S[i]) * (e[i] - last[i]);
        work += part;
        gross += std::fabs(part);
      }
    }
    const auto energy = point.energy();
    INFO("draw " << draw);
    CHECK(energy.stored + energy.dissipated() == Approx(work).margin(5e-3 * gross));  // of the quadrature
  }
}

TEST_CASE("folds: a batch of any instruction set gives what one point does", "[law][folds]") {
  Random random(17);
  const auto batch = law::batch_function(best_isa());
  for (const bool plain : {true, false}) {
    card::Card card =
        plain ? straight(3e8, 1e8, 2e6, 0.2, card::Folds::within) : thesis_with(0, card::Folds::within);
    if (!plain) std::get<card::Woven>(card.law).shear.memory = card::ShearMemory::fading;
    for (int draw = 0; draw < draws(50); ++draw) {
      FoldingPoint point(card, 2000, 500);
      const int n = law::state_size(*point.law);
      std::vector<double> s0(n * lanes), s1(n * lanes), E(5 * lanes), S(5 * lanes), C(25 * lanes);
      std::vector<Strain> strains;
      for (int l = 0; l < lanes; ++l) {
        strains.push_back(random_strain(random, 0.2));
        for (int i = 0; i < 5; ++i) E[i * lanes + l] = strains.back()[i];
        for (int i = 0; i < n; ++i) s0[i * lanes + l] = point.s[i];
      }
      CHECK(batch(*point.law, {}, E.data(), s0.data(), s1.data(), S.data(), C.data()) == 0);
      for (int l = 0; l < lanes; ++l) {
        REQUIRE(point.evaluate(strains[l]));
        const double size = std::fabs(point.S[0]) + std::fabs(point.S[1]) + std::fabs(point.S[4]);
        for (int i = 0; i < 5; ++i)
          CHECK(S[i * lanes + l] == Approx(point.S[i]).epsilon(1e-9).margin(1e-9 * size));
      }
    }
  }
}
