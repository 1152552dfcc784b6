// Cards that are refused, with their reasons; curves from points; the elastic laws; what the stiffest tangent
// is.
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "catch.hpp"
#include "law/law_point.hpp"
#include "law/thesis_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

std::string refusal(const card::Card& card) {
  try {
    law::compile(card);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// The reason must hold every one of the words.
void refused(const std::function<void(card::Card&)>& spoil, const std::vector<std::string>& words) {
  auto card = thesis_card(0);
  spoil(card);
  const std::string reason = refusal(card);
  for (const auto& word : words) {
    INFO("'" << word << "' in: " << reason);
    CHECK(reason.find(word) != std::string::npos);
  }
}

}  // namespace

TEST_CASE("the four cards are accepted under every law", "[compile]") {
  for (int f = 0; f < 4; ++f)
    for (const auto law : {card::LawKind::potential, card::LawKind::incremental, card::LawKind::thesis})
      CHECK(refusal(thesis_card(f, law)).empty());
}

TEST_CASE("a bad card is refused with its reason", "[compile]") {
  refused(
      [](auto& c) {
        woven(c).warp.loading.coefficients = {8e6, -50e6};
      },
      {"blend", "warp.loading", "positive modulus", "E11 = 0.16"});
  refused([](auto& c) { woven(c).weft.unloading = 100e6; }, {"weft.loading", "100 MPa", "E22"});
  refused(
      [](auto& c) {
        woven(c).shear.loading.coefficients = {2e6, -18e6};
      },
      {"shear.loading", "E12 = 0.1111"});
  refused([](auto& c) { woven(c).warp.loading.coefficients = {0, 1e6}; }, {"warp.loading", "E11 = 0"});
  refused([](auto& c) { woven(c).warp.poisson = 2.5; }, {"nu12 nu21 < 1", "2.5", "0.42"});
  refused([](auto& c) { woven(c).warp.poisson = -0.1; }, {"warp.poisson", "-0.1"});
  refused([](auto& c) { woven(c).weft.poisson = 0; }, {"weft.poisson", "both", "0.25"});
  refused([](auto& c) { woven(c).warp.unloading = std::nan(""); }, {"warp.unloading", "nan"});
  refused([](auto& c) { woven(c).weft.loading.coefficients[1] = std::numeric_limits<double>::infinity(); },
          {"weft.loading", "inf"});
  refused([](auto& c) { woven(c).warp.loading.coefficients.clear(); }, {"warp.loading", "neither"});
  refused([](auto& c) { c.density = 0; }, {"density", "0"});
  refused([](auto& c) { c.thickness = -1e-3; }, {"thickness", "-0.001"});
  refused([](auto& c) { c.bending = card::Bending{1e-5, -1e-5, 0, {}, {}}; }, {"bending.weft"});
  refused([](auto& c) { woven(c).biaxial = card::Biaxial{1, 0.1, -5, 1e6}; }, {"biaxial.loading"});
  auto both_zero = thesis_card(0);
  woven(both_zero).warp.poisson = woven(both_zero).weft.poisson = 0;
  CHECK(refusal(both_zero).empty());
}

TEST_CASE("points stand in for coefficients", "[compile][curve]") {
  auto card = thesis_card(0);
  const auto& D = thesis_rows()[0].warp;
  card::Curve points;
  for (int i = 0; i <= 24; ++i) points.points.emplace_back(0.011 * i, stress_of(D, 0.011 * i) * MPa);
  woven(card).warp.loading = points;
  const auto law = law::compile(card);
  double last = 0;
  for (int i = 0; i <= 2640; ++i) {
    const double x = 1e-4 * i, P = law::backbone(*law, 1, x);
    CHECK(P == Approx(stress_of(D, x) * MPa).margin(2e4));  // PCHIP is second order near the first point
    CHECK((P > last || i == 0));
    last = P;
    const double h = 1e-7, slope = (law::backbone(*law, 1, x + h) - law::backbone(*law, 1, x - h)) / (2 * h);
    if (i > 0) CHECK(law::backbone_modulus(*law, 1, x) == Approx(slope).epsilon(1e-5).margin(10));
  }
  for (const auto& [x, S] : points.points) CHECK(law::backbone(*law, 1, x) == Approx(S).epsilon(1e-13));
  // Beyond the last point the guard: a constant modulus.
  CHECK(law::backbone_modulus(*law, 1, 0.5) == law::backbone_modulus(*law, 1, 0.9));
  // A straight line through points is the linear spring, exactly.
  woven(card).warp.loading = card::Curve{{}, {{0, 0}, {0.1, 1e6}, {0.25, 2.5e6}}};
  CHECK(law::backbone(*law::compile(card), 1, 0.2) == Approx(2e6).epsilon(1e-14));
}

TEST_CASE("bad points are refused", "[compile][curve]") {
  refused(
      [](auto& c) {
        woven(c).warp.loading = {{}, {{0, 0}, {0.1, 1e6}, {0.1, 2e6}}};
      },
      {"rising strictly", "point 3"});
  refused([](auto& c) { woven(c).warp.loading = {{}, {{0, 1}, {0.1, 1e6}}}; }, {"(0, 0)"});
  refused([](auto& c) { woven(c).warp.loading = {{1e6}, {{0, 0}, {0.1, 1e6}}}; }, {"both"});
}

TEST_CASE("a law with points obeys the same rules", "[compile][curve]") {
  auto card = thesis_card(0);
  woven(card).warp.loading = card::Curve{{}, {{0, 0}, {0.05, 0.8e6}, {0.12, 4e6}, {0.2, 14e6}, {0.26, 30e6}}};
  LawPoint point(card);
  point.go({0.2, -0.05, 0, 0, 0});
  CHECK(point.S[0] == Approx(14e6).epsilon(1e-13));  // E22 = -nu12 E11: uniaxial stress, P(E) exactly
  point.go({0.199, -0.04975, 0, 0, 0});
  CHECK(point.S[0] == Approx(14e6 - 864e6 * 0.001).epsilon(1e-12));
}

TEST_CASE("St. Venant-Kirchhoff keeps both moduli and the product of the ratios", "[compile][elastic]") {
  auto card = thesis_card(0);
  card.law = card::Svk{8e6, 37e6, 2e6, 0.25, 0.42, {}, {}};
  LawPoint point(card);
  const double nn = 0.25 * 0.42, c = std::sqrt(nn * 8e6 * 37e6) / (1 - nn);
  const double lateral = -c / (37e6 / (1 - nn));  // S22 = 0
  point.go({0.1, 0.1 * lateral, 0, 0, 0.3});
  CHECK(point.S[0] == Approx(8e5).epsilon(1e-13));
  CHECK(std::fabs(point.S[1]) < 1e-9);
  CHECK(point.S[4] == Approx(2e6 * 0.3));
  CHECK(point.C[1] == point.C[5]);
  CHECK(point.energy().stored == Approx(0.5 * (8e5 * 0.1 + 2e6 * 0.09)).epsilon(1e-13));
}

TEST_CASE("the linear law is symmetric or refused", "[compile][elastic]") {
  auto card = thesis_card(0);
  card.law = card::LinearElastic{8e6, 37e6, 2e6, 0.25, 0.42};
  const std::string reason = refusal(card);
  CHECK(reason.find("symmetric") != std::string::npos);
  CHECK(reason.find("1.156") != std::string::npos);  // nu21 that would do
  card.law = card::LinearElastic{8e6, 16e6, 2e6, 0.25, 0.5};
  LawPoint point(card);
  point.go({0.1, -0.025, 0, 0, 0});
  CHECK(point.S[0] == Approx(8e5).epsilon(1e-13));
  CHECK(std::fabs(point.S[1]) < 1e-9);
}

TEST_CASE("no tangent is stiffer than stiffest()", "[compile]") {
  Random random(3);
  for (const auto kind : {card::LawKind::potential, card::LawKind::incremental, card::LawKind::thesis})
    for (int f = 0; f < 4; ++f) {
      auto card = with_biaxial(thesis_card(f, kind));
      if (kind == card::LawKind::potential && f % 2 == 1) card = with_loops(card);
      LawPoint point(card);
      const double bound = law::stiffest(*point.law) * (1 + 1e-9);
      for (int k = 0; k < 2000; ++k) {
        const Strain E{random(-0.2, 0.8), random(-0.2, 0.8), 0, 0, random(-1.5, 1.5)};
        point.go(E);
        law::evaluate(*point.law, law::Step{0, 0, law::AtSwitch::unloading}, E.data(), point.s.data(),
                      point.trial.data(), point.S.data(), point.C.data());
        const auto& C = point.C;
        const double half = 0.5 * (C[0] - C[6]);
        const double top = 0.5 * (C[0] + C[6]) + std::sqrt(std::fmax(half * half + C[1] * C[5], 0.0));
        CHECK(top <= bound);
        CHECK(C[24] <= bound);
      }
    }
}
