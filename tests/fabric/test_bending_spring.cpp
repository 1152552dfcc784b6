// Bending with friction: the moment-curvature loop in closed form, its energies, its tangent.
#include <cmath>

#include "catch.hpp"
#include "fabric/bending_spring.hpp"
#include "fabric/law_point.hpp"

using namespace fabricsh;
using fabric::AtSwitch;

namespace {

const fabric::BendingSpring spring{10e-6, 0.4e-3, 20.0};  // N.m, N, 1/m: 2HB = 0.8 mN

struct Fold {
  fabric::BendingState<double> s;
  double kappa = 0, work = 0;
  double M = 0;
  void to(double target, int n) {
    const double start = kappa;
    for (int k = 1; k <= n; ++k) {
      const double before = M, last = kappa;
      kappa = k == n ? target : start + (target - start) * k / n;
      M = fabric::bending_moment(spring, AtSwitch::loading, kappa, s).M;
      work += 0.5 * (before + M) * (kappa - last);
    }
  }
};

}  // namespace

TEST_CASE("a bending loop has the width of its friction, in any number of steps", "[bending]") {
  for (const int n : {1, 10000}) {
    Fold fold;
    fold.to(250, n);
    CHECK(fold.M == Approx(10e-6 * 250 + 0.4e-3).epsilon(1e-12));
    fold.to(100, n);
    CHECK(fold.M == Approx(10e-6 * 100 - 0.4e-3).epsilon(1e-12));
    fold.to(-250, n);
    CHECK(fold.M == Approx(-10e-6 * 250 - 0.4e-3).epsilon(1e-12));
    fold.to(250, n);
    // Slip of a full cycle: 2 x (500 - 40), after 230 on the way out; each costs M_f.
    CHECK(fold.s.lost == Approx(0.4e-3 * (230 + 2 * 460)).epsilon(1e-12));
    const double stored = fabric::bending_stored(spring, fold.kappa, fold.s);
    CHECK(stored == Approx(0.5 * 10e-6 * 250 * 250 + 0.5 * 0.4e-3 * 20).epsilon(1e-12));
    // Trapezoids over the kinks: second order in 1 / n.
    if (n > 1) CHECK(fold.work == Approx(stored + fold.s.lost).epsilon(1e-6));
  }
}

TEST_CASE("bending tangent against differences, and at the edge of slip", "[bending]") {
  test::Random random(2);
  fabric::BendingState<double> s;
  int sticking = 0, slipping = 0;
  for (int k = 0; k < 10000; ++k) {
    const double kappa = random(-60, 60), h = 1e-4;
    auto a = s, b = s, c = s;
    const double C = fabric::bending_moment(spring, AtSwitch::loading, kappa, a).C;
    const double up = fabric::bending_moment(spring, AtSwitch::loading, kappa + h, b).M;
    const double down = fabric::bending_moment(spring, AtSwitch::loading, kappa - h, c).M;
    if (std::fabs(std::fabs(kappa - s.slip) - spring.curvature) > 2 * h)
      CHECK((up - down) / (2 * h) == Approx(C).epsilon(1e-8));
    (C > 2 * spring.rigidity ? sticking : slipping)++;
    s = a;
  }
  CHECK(sticking > 1000);
  CHECK(slipping > 1000);
  auto edge = s;
  fabric::bending_moment(spring, AtSwitch::loading, 100.0, edge);
  auto again = edge;
  CHECK(fabric::bending_moment(spring, AtSwitch::loading, 100.0, again).C == spring.rigidity);
  CHECK(fabric::bending_moment(spring, AtSwitch::unloading, 100.0, again).C > 2 * spring.rigidity);
}
