// The woven law "potential" against closed forms written here from the card's table.
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "law/law_point.hpp"
#include "law/thesis_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

constexpr double exact = 1e-12;  // relative: the closed forms differ from the code by rounding only

// Both sides in units of `scale`.
void same(double got, double want, double scale) {
  INFO(got << " against " << want);
  CHECK(std::fabs(got - want) <= exact * std::fabs(scale));
}

struct Numbers {
  double nn, c, h1, h2;
  explicit Numbers(const ThesisRow& row)
      : nn(row.nu12 * row.nu21),
        c(std::fmin(row.nu21 * row.warp[0], row.nu12 * row.weft[0]) / (1 - nn) * MPa),
        h1(c / row.nu21),
        h2(c / row.nu12) {}
};

double left_at(const std::vector<double>& D, double Du, double m) { return m - stress_of(D, m) / Du; }

// Goes to E in n equal steps.
void go_in(LawPoint& point, const Strain& E, int n) {
  const Strain start = point.E;
  for (int k = 1; k <= n; ++k) {
    Strain e;
    for (int i = 0; i < 5; ++i) e[i] = k == n ? E[i] : start[i] + (E[i] - start[i]) * k / n;
    REQUIRE(point.go(e));
  }
}

}  // namespace

TEST_CASE("biaxial 1:1 loading and unloading in closed form", "[law][potential]") {
  for (int f = 0; f < 4; ++f)
    for (const int n : {1, 10000}) {
      const ThesisRow& row = thesis_rows()[f];
      const Numbers k(row);
      LawPoint point(thesis_card(f));
      const double top = 0.08;
      const double P1 = stress_of(row.warp, top) * MPa, P2 = stress_of(row.weft, top) * MPa;
      go_in(point, {top, top, 0, 0, 0}, n);
      same(point.S[0], P1 + k.c * row.nu12 * top + k.c * top, P1);
      same(point.S[1], P2 + k.c * row.nu21 * top + k.c * top, P2);
      const double down = 0.99 * top;
      go_in(point, {down, down, 0, 0, 0}, n);
      same(point.S[0], P1 - row.Du1 * MPa * (top - down) + k.c * (row.nu12 + 1) * down, P1);
      same(point.S[1], P2 - row.Du2 * MPa * (top - down) + k.c * (row.nu21 + 1) * down, P2);
      const double r1 = left_at(row.warp, row.Du1, top), r2 = left_at(row.weft, row.Du2, top);
      go_in(point, {r1 - 0.02, r2 - 0.03, 0, 0, 0}, n);
      same(point.S[0], k.c * row.nu12 * r1 - k.h1 * 0.02 + k.c * (r2 - 0.03), P1);
      same(point.S[1], k.c * row.nu21 * r2 - k.h2 * 0.03 + k.c * (r1 - 0.02), P2);
      go_in(point, {top, top, 0, 0, 0}, n);  // reloading meets the virgin curve where it left it
      same(point.S[0], P1 + k.c * row.nu12 * top + k.c * top, P1);
    }
}

TEST_CASE("cyclic simple shear with flips in closed form", "[law][potential]") {
  for (int f = 0; f < 4; ++f)
    for (const int n : {1, 10000}) {
      const ThesisRow& row = thesis_rows()[f];
      const double Gu = row.Gu * MPa / 2;
      const auto P = [&](double r) { return stress_of(row.shear, r / 2) * MPa; };
      const auto U = [&](double r) { return 2 * energy_of(row.shear, r / 2) * MPa; };
      const auto loss = [&](double r) { return U(r) - P(r) * P(r) / (2 * Gu); };
      LawPoint point(thesis_card(f));
      double origin = 0, sign = 1, lost = 0;
      for (const double reach : {0.5, 0.4, 0.55, 0.2, 0.3}) {  // each half-cycle on its own branch
        const double top = origin + sign * reach;
        go_in(point, {0, 0, 0, 0, top}, n);
        same(point.S[4], sign * P(reach), P(0.5));
        const double back = 0.5 * P(reach) / Gu;  // half the way to zero stress, and on again
        go_in(point, {0, 0, 0, 0, top - sign * back}, n);
        same(point.S[4], sign * (P(reach) - Gu * back), P(0.5));
        same(point.energy().stored, std::pow(P(reach) - Gu * back, 2) / (2 * Gu), U(0.5));
        lost += loss(reach);
        same(point.energy().dissipated(), lost, U(0.5));
        go_in(point, {0, 0, 0, 0, top}, n);
        same(point.S[4], sign * P(reach), P(0.5));
        origin = top - sign * P(reach) / Gu;
        sign = -sign;
      }
    }
}

TEST_CASE("shear memory: a loop that stops just before and just after zero stress", "[law][potential]") {
  for (const auto memory : {card::ShearMemory::printed, card::ShearMemory::fading}) {
    auto card = thesis_card(0);
    woven(card).shear.memory = memory;
    const auto& D = thesis_rows()[0].shear;
    const double Gu = 6 * MPa, peak = 0.5;
    const double P = stress_of(D, peak / 2) * MPa, zero = peak - P / Gu, little = 1e-6;
    LawPoint before(card), after(card);
    for (auto* point : {&before, &after}) point->go({0, 0, 0, 0, peak});
    before.go({0, 0, 0, 0, zero + little});
    after.go({0, 0, 0, 0, zero - little});
    for (auto* point : {&before, &after}) point->go({0, 0, 0, 0, peak});
    same(before.S[4], P, P);
    if (memory == card::ShearMemory::printed)
      CHECK(after.S[4] < 0.35 * P);  // the old branch is forgotten at once: virgin again from the crossing
    else
      CHECK(after.S[4] == Approx(P).epsilon(1e-4));  // it fades with the reverse slip, here 1e-6
    // After a slip as large as the old peak nothing of it is left, in either memory.
    LawPoint far(card);
    far.go({0, 0, 0, 0, peak});
    far.go({0, 0, 0, 0, zero - 1.5});
    const double Pr = law::backbone(*far.law, 3, 1.5);
    const double turn = zero - 1.5 + Pr / Gu;
    far.go({0, 0, 0, 0, turn + 0.2});
    same(far.S[4], stress_of(D, 0.1) * MPa, P);
  }
}

TEST_CASE("range guards act where they should", "[law][guard]") {
  const double limits[4][3] = {
      {1.036, 0.632, 0.4907}, {0.278, 0.173, 0.4361}, {0.102, 0.726, 0.5791}, {0.632, 0.249, 0.3414}};
  for (int f = 0; f < 4; ++f) {
    const auto law = law::compile(thesis_card(f));
    for (int axis = 1; axis <= 3; ++axis) {
      const double x = limits[f][axis - 1] * (axis == 3 ? 2 : 1), gap = axis == 3 ? 2e-4 : 1e-3;
      const double D = law::backbone_modulus(*law, axis, x + gap);
      CHECK(law::backbone_modulus(*law, axis, x + 0.5) == D);  // constant beyond
      CHECK(std::fabs(law::backbone_modulus(*law, axis, x - gap) - D) > 0);
      const double P = law::backbone(*law, axis, x + gap);
      CHECK(law::backbone(*law, axis, x + 0.5) == Approx(P + D * (0.5 - gap)).epsilon(1e-12));
    }
  }
  auto engineering = thesis_card(3);
  woven(engineering).shear.measure = card::StrainMeasure::engineering;
  const auto law = law::compile(engineering);
  const double top = (66 + std::sqrt(66.0 * 66 - 4 * 4 * 159)) / 318;  // D' = 0 of denim's table: 2 x 0.1707
  CHECK(law::backbone_modulus(*law, 3, 0.6) == Approx(modulus_of(thesis_rows()[3].shear, top) * MPa));
}

TEST_CASE("at a switch the tangent is the one asked for, the stress the same", "[law][potential]") {
  for (int f = 0; f < 4; ++f) {
    const ThesisRow& row = thesis_rows()[f];
    const Numbers k(row);
    LawPoint point(thesis_card(f));
    const Strain E{0.03, 0.02, 0.01, -0.01, 0.25};
    point.go(E);
    point.evaluate(E);
    const Strain loading = point.S;
    same(point.C[0], (modulus_of(row.warp, 0.03) * MPa + k.c * row.nu12), row.Du1 * MPa);
    same(point.C[6], (modulus_of(row.weft, 0.02) * MPa + k.c * row.nu21), row.Du2 * MPa);
    same(point.C[24], modulus_of(row.shear, 0.125) * MPa / 2, row.Gu * MPa);
    point.evaluate(E, {0, 0, law::AtSwitch::unloading});
    same(point.C[0], row.Du1 * MPa + k.c * row.nu12, row.Du1 * MPa);
    same(point.C[6], row.Du2 * MPa + k.c * row.nu21, row.Du2 * MPa);
    same(point.C[24], row.Gu * MPa / 2, row.Gu * MPa);
    CHECK(point.S == loading);
    // Strain recomputed elsewhere differs in the last digits and is still on the switch.
    Strain near = E;
    for (double& e : near) e *= 1 - 2e-15;
    point.evaluate(near);
    CHECK(point.C[0] < 0.9 * row.Du1 * MPa);
  }
}

TEST_CASE("non-finite strain is a failed lane and never a hang", "[law]") {
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity(), 1e300};
  for (const auto kind : {card::LawKind::potential, card::LawKind::incremental, card::LawKind::thesis})
    for (int component = 0; component < 5; ++component)
      for (const double value : bad) {
        LawPoint point(thesis_card(1, kind));
        Strain E{0.01, 0.01, 0.01, 0.01, 0.01};
        E[component] = value;
        if (value != 1e300)
          CHECK(!point.evaluate(E));
        else
          point.evaluate(E);  // may be finite where the law is linear; must return
      }
}

TEST_CASE("a batch gives what single points give, on every instruction set", "[law][batch]") {
  Random random(5);
  for (const auto kind : {card::LawKind::potential, card::LawKind::incremental, card::LawKind::thesis})
    for (int f = 0; f < 4; ++f) {
      auto card = thesis_card(f, kind, card::Transverse::follow);
      if (f % 2 == 1) card = with_biaxial(card);
      if (f >= 2) woven(card).shear.memory = card::ShearMemory::fading;
      for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512}) {
        if (isa > best_isa()) continue;
        std::vector<LawPoint> points(lanes, LawPoint(card));
        const auto& law = *points[0].law;
        const int n = law::state_size(law);
        std::vector<double> E(5 * lanes), s0(n * lanes), s1(n * lanes), S(5 * lanes), C(25 * lanes);
        double worst = 0;
        for (int step = 0; step < 50; ++step) {
          for (int l = 0; l < lanes; ++l) {
            Strain e{random(-0.05, 0.1), random(-0.05, 0.1), random(-0.1, 0.1), random(-0.1, 0.1),
                     random(-0.7, 0.7)};
            for (int i = 0; i < 5; ++i) E[i * lanes + l] = e[i];
            for (int i = 0; i < n; ++i) s0[i * lanes + l] = points[l].s[i];
            points[l].go(e);
          }
          const unsigned failed =
              law::batch_function(isa)(law, law::Step{}, E.data(), s0.data(), s1.data(), S.data(), C.data());
          REQUIRE(failed == 0);
          for (int l = 0; l < lanes; ++l) {
            for (int i = 0; i < 5; ++i)
              worst = std::fmax(worst, std::fabs(S[i * lanes + l] - points[l].S[i]) / 1e8);
            for (int i = 0; i < 25; ++i)
              worst = std::fmax(worst, std::fabs(C[i * lanes + l] - points[l].C[i]) / 1e9);
            for (int i = 0; i < n; ++i)
              worst = std::fmax(
                  worst, std::fabs(s1[i * lanes + l] - points[l].s[i]) / (1 + std::fabs(points[l].s[i])));
          }
        }
        INFO(card.name << " " << fabricsh::name(isa) << " worst " << worst);
        CHECK(worst < 1e-11);  // fused multiply-add rounds differently
      }
    }
}
