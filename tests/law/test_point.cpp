// The point driver: uniaxial stress against closed forms, for any fabric, direction and number of steps.
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "catch.hpp"
#include "law/point.hpp"
#include "thesis_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using law::PointDriver;

namespace {

struct Pull {
  double angle;  // rad
  const std::vector<double>& D;
  double Du, ratio, top;
};

Pull pull_of(int f, bool warp) {
  const ThesisRow& row = thesis_rows()[f];
  return warp ? Pull{0, row.warp, row.Du1 * MPa, row.nu12, tested_strain(row.max_warp)}
              : Pull{std::numbers::pi / 2, row.weft, row.Du2 * MPa, row.nu21, tested_strain(row.max_weft)};
}

void to(PointDriver& p, double angle, double E, int n) {
  const double start = p.now().E;
  for (int k = 1; k <= n; ++k) p.uniaxial(angle, k == n ? E : start + (E - start) * k / n);
}

}  // namespace

TEST_CASE("uniaxial stress: P(E), the measured ratio and Du, at any step size", "[point]") {
  for (int f = 0; f < 4; ++f)
    for (const bool warp : {true, false})
      for (const int n : {1, 40, 10000}) {
        const Pull pull = pull_of(f, warp);
        PointDriver p(law::compile(thesis_card(f)));
        const double peak = stress_of(pull.D, pull.top) * MPa;
        to(p, pull.angle, pull.top, n);
        CHECK(p.now().S == Approx(peak).epsilon(1e-12));
        CHECK(p.now().E_lateral == Approx(-pull.ratio * pull.top).epsilon(1e-12));
        const double down = pull.top - 0.5 * peak / pull.Du;
        to(p, pull.angle, down, n);
        CHECK(p.now().S == Approx(0.5 * peak).epsilon(1e-12));
        CHECK(p.now().E_lateral == Approx(-pull.ratio * down).epsilon(1e-12));
        // W = stored + dissipated, the loss being U(m) - P^2 / (2 Du).
        const double loss = energy_of(pull.D, pull.top) * MPa - peak * peak / (2 * pull.Du);
        CHECK(p.now().dissipated == Approx(loss).epsilon(1e-12));
        CHECK(p.now().stored == Approx(0.25 * peak * peak / (2 * pull.Du)).epsilon(1e-12));
      }
}

TEST_CASE("reload 75 -> 70 -> 100 % in closed form", "[point]") {
  for (int f = 0; f < 4; ++f)
    for (const bool warp : {true, false})
      for (const int n : {1, 100}) {
        const Pull pull = pull_of(f, warp);
        PointDriver p(law::compile(thesis_card(f)));
        const double m = 0.75 * pull.top, P = stress_of(pull.D, m) * MPa;
        const double low = std::fmax(0.70 * pull.top, m - 0.9 * P / pull.Du);  // while it still carries
        to(p, pull.angle, m, n);
        to(p, pull.angle, low, n);
        CHECK(p.now().S == Approx(P - pull.Du * (m - low)).epsilon(1e-11));  // a difference of large numbers
        to(p, pull.angle, 0.5 * (low + m), n);
        CHECK(p.now().S == Approx(P - pull.Du * (m - low) / 2).epsilon(1e-12));
        to(p, pull.angle, pull.top, n);
        CHECK(p.now().S == Approx(stress_of(pull.D, pull.top) * MPa).epsilon(1e-12));
        CHECK(p.now().E_lateral == Approx(-pull.ratio * pull.top).epsilon(1e-12));
      }
}

TEST_CASE("crimp interchange: a stretched weft moves the rest state of the warp", "[point]") {
  for (int f = 0; f < 4; ++f) {
    const ThesisRow& row = thesis_rows()[f];
    PointDriver p(law::compile(thesis_card(f)));
    const double m = 0.05, residual = m - stress_of(row.weft, m) / row.Du2;
    p.uniaxial(std::numbers::pi / 2, m);
    // The pull's own strain at which its stress is zero again; across it the cloth has drawn in.
    p.uniaxial(std::numbers::pi / 2, residual);
    CHECK(std::fabs(p.now().S) < 1e-9 * row.Du2 * MPa);
    CHECK(p.now().E11 == Approx(-row.nu21 * residual).epsilon(1e-10));
  }
}

TEST_CASE("a pull at any angle ends in uniaxial stress", "[point]") {
  for (int f = 0; f < 4; ++f)
    for (int degrees = 0; degrees < 180; degrees += 15) {
      const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
      PointDriver p(law::compile(thesis_card(f)));
      for (const double E : {0.02, 0.05, 0.08, 0.079, 0.06, 0.07, 0.1, 0.0}) {
        const auto q = p.uniaxial(angle, E);
        const double across = s * s * q.S11 + c * c * q.S22 - 2 * c * s * q.S12;
        const double shear = c * s * (q.S22 - q.S11) + (c * c - s * s) * q.S12;
        const double size = 1e-12 * 1e6 * thesis_rows()[f].Du1 * 0.1;
        CHECK(std::fabs(across) < size);
        CHECK(std::fabs(shear) < size);
        CHECK(c * c * q.E11 + s * s * q.E22 + 2 * c * s * q.E12 == Approx(E).margin(1e-14));
      }
    }
}

TEST_CASE("paths: one call, the same as many; components without a value stay", "[point]") {
  PointDriver one(law::compile(thesis_card(0))), many(law::compile(thesis_card(0)));
  const auto curve = one.path({{0.05, 0, 0}, {0.05, 0.03, 0}, {0.05, 0.03, 0.2}, {0.01, 0.03, 0.2}});
  many.strain(0.05, {}, {});
  many.strain({}, 0.03, {});
  many.strain({}, {}, 0.2);
  const auto last = many.strain(0.01, {}, {});
  REQUIRE(curve.size() == 4);
  CHECK(curve.back().S11 == last.S11);
  CHECK(curve.back().S12 == last.S12);
  CHECK(curve.back().E22 == 0.03);
  CHECK(last.dissipated == last.lost[0] + last.lost[1] + last.lost[2]);
  const auto biaxial = PointDriver(law::compile(thesis_card(0))).biaxial(1.0, {0.05, 0.1, 0.125});
  CHECK(biaxial.back().E11 == biaxial.back().E22);
}

TEST_CASE("biaxial stiffening at 1:1, E = 0.125, default, thesis and biaxial spring", "[point]") {
  const auto over = [](const card::Card& card, int f, bool warp) {
    const auto q = PointDriver(law::compile(card)).biaxial(1.0, {0.125}).back();
    const auto& row = thesis_rows()[f];
    const double P = stress_of(warp ? row.warp : row.weft, 0.125) * MPa;
    return 100 * ((warp ? q.S11 : q.S22) / P - 1);
  };
  using card::LawKind;
  CHECK(over(thesis_card(0), 0, true) == Approx(8).margin(0.5));
  CHECK(over(thesis_card(0), 0, false) == Approx(4).margin(0.5));
  CHECK(over(thesis_card(3), 3, true) == Approx(25).margin(0.5));
  CHECK(over(thesis_card(3), 3, false) == Approx(5).margin(0.5));
  CHECK(over(thesis_card(0, LawKind::incremental), 0, true) == Approx(59).margin(0.5));
  CHECK(over(thesis_card(0, LawKind::incremental), 0, false) == Approx(40).margin(0.5));
  CHECK(over(thesis_card(3, LawKind::incremental), 3, true) == Approx(25).margin(0.5));
  CHECK(over(thesis_card(3, LawKind::incremental), 3, false) == Approx(15).margin(0.5));
  CHECK(over(with_biaxial(thesis_card(0)), 0, true) == Approx(59).margin(0.5));
  CHECK(over(with_biaxial(thesis_card(0)), 0, false) == Approx(38).margin(0.5));
}

TEST_CASE("the biaxial spring leaves both uniaxial tests as they are", "[point]") {
  for (const bool warp : {true, false}) {
    const Pull pull = pull_of(0, warp);
    PointDriver plain(law::compile(thesis_card(0))), stiffened(law::compile(with_biaxial(thesis_card(0))));
    const double top = 0.999 * pull.top;
    CHECK(stiffened.uniaxial(pull.angle, top).S == Approx(plain.uniaxial(pull.angle, top).S).epsilon(1e-12));
  }
}

TEST_CASE("a strain that is no number is reported, and the point stays where it was", "[point]") {
  PointDriver p(law::compile(thesis_card(0)));
  p.strain(0.05, 0.01, 0.1);
  const auto before = p.now();
  CHECK_THROWS_AS(p.strain(std::nan(""), {}, {}), NumericalFailure);
  CHECK_THROWS_AS(p.uniaxial(0.3, std::numeric_limits<double>::infinity()), NumericalFailure);
  CHECK(p.now().S11 == before.S11);
  CHECK(p.strain(0.05, 0.01, 0.1).S11 == before.S11);
}
