// Shear that relaxes: closed forms, tangent, energies; without it nothing changes.
#include <cmath>

#include "catch.hpp"
#include "law/law_point.hpp"
#include "law/potential.hpp"
#include "law/thesis_cards.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

constexpr double G = 3 * MPa, tau = 0.7;  // of S12 over 2 E12; s

card::Card viscous_card() { return with_viscous(thesis_card(0), 2 * G, tau); }

// Shear gamma from where the point is, in n equal steps over so many seconds.
void shear(LawPoint& point, double gamma, double over, int n) {
  const double start = point.E[4];
  for (int k = 1; k <= n; ++k) {
    Strain e = point.E;
    e[4] = k == n ? gamma : start + (gamma - start) * k / n;
    REQUIRE(point.go(e, {0, over / n}));
  }
}

}  // namespace

TEST_CASE("a step of strain relaxes as a standard linear solid", "[law][viscous]") {
  for (const int n : {1, 1000}) {
    LawPoint point(viscous_card()), elastic(thesis_card(0));
    shear(point, 0.1, 0, n);
    shear(elastic, 0.1, 0, n);
    CHECK(point.S[4] == Approx(elastic.S[4] + G * 0.1).epsilon(1e-12));
    for (int k = 1; k <= 3; ++k) {
      shear(point, 0.1, 0.5, n);
      const double q = G * 0.1 * std::exp(-0.5 * k / tau);
      CHECK(point.S[4] == Approx(elastic.S[4] + q).epsilon(1e-12));
      CHECK(point.energy().stored == Approx(elastic.energy().stored + q * q / (2 * G)).epsilon(1e-12));
    }
  }
}

TEST_CASE("a ramp of strain follows its closed form, in any number of steps", "[law][viscous]") {
  for (const int n : {1, 7, 1000}) {
    LawPoint point(viscous_card()), elastic(thesis_card(0));
    const double over = 1.3, rate = 0.2 / over, left = -std::expm1(-over / tau);
    shear(point, 0.2, over, n);
    shear(elastic, 0.2, over, n);
    CHECK(point.S[4] - elastic.S[4] == Approx(G * tau * rate * left).epsilon(1e-11));
    // int q^2 / (G tau) dt over the ramp, q = G tau rate (1 - exp(-t / tau)).
    const double twice = -std::expm1(-2 * over / tau);
    const double lost = G * rate * rate * tau * (over - 2 * tau * left + tau * twice / 2);
    CHECK(point.energy().dissipated() - elastic.energy().dissipated() == Approx(lost).epsilon(1e-10));
  }
}

TEST_CASE("one step of relaxation is as good as two, however short or long", "[law][viscous]") {
  for (double x = 1e-14; x < 1e3; x *= 3) {
    const auto whole = rheology::viscous::effect_of_step(2 * x), half = rheology::viscous::effect_of_step(x);
    const double q0 = 0.3, g = 0.7;  // of the whole step; G = 1
    const auto loss = [](const rheology::viscous::StepEffect& w, double q, double pulled) {
      return w.own * q * q + 2 * w.mixed * q * pulled + w.pulled * pulled * pulled;
    };
    const double middle = half.decay * q0 + half.factor * g / 2;
    INFO("x = " << x);
    CHECK(whole.decay * q0 + whole.factor * g ==
          Approx(half.decay * middle + half.factor * g / 2).epsilon(1e-13));
    CHECK(loss(whole, q0, g) == Approx(loss(half, q0, g / 2) + loss(half, middle, g / 2)).epsilon(2e-13));
    // Its energy: what is done is stored or lost. Work = g int q ds.
    const double q1 = whole.decay * q0 + whole.factor * g;
    const double mean = whole.factor * q0 + g * (1 - whole.factor) / (2 * x);
    if (x > 1e-3)
      CHECK(g * mean == Approx((q1 * q1 - q0 * q0) / 2 + loss(whole, q0, g)).epsilon(1e-12).margin(1e-15));
  }
}

TEST_CASE("the tangent of shear that relaxes, against differences", "[law][viscous][tangent]") {
  Random random(9);
  LawPoint point(viscous_card());
  int smooth = 0;
  for (int k = 0; k < 4000; ++k) {
    Strain E{random(0, 0.1), random(0, 0.1), 0, 0, random(-0.5, 0.5)};
    const law::Step step{0, tau * (k % 3 == 0 ? 0.0 : random(0, 4))};
    double slope[2];
    for (int i = 0; i < 2; ++i) {
      const double h = i == 0 ? 3e-7 : 9e-7;
      Strain up = E, down = E;
      up[4] += h, down[4] -= h;
      point.evaluate(up, step);
      const double high = point.S[4];
      point.evaluate(down, step);
      slope[i] = (high - point.S[4]) / (2 * h);
    }
    point.evaluate(E, step);
    if (std::fabs(slope[0] - slope[1]) < 1e-6 * G) {  // no switch in between
      ++smooth;
      CHECK(point.C[24] == Approx((9 * slope[0] - slope[1]) / 8).epsilon(1e-7));
    }
    point.go(E, step);
  }
  CHECK(smooth > 3600);
}

TEST_CASE("a reading of stress is the one that balanced the step", "[law][viscous]") {
  Random random(4);
  for (const auto kind : {card::LawKind::potential, card::LawKind::incremental, card::LawKind::thesis}) {
    LawPoint point(kind == card::LawKind::potential ? viscous_card() : thesis_card(0, kind));
    for (int k = 0; k < 200; ++k) {
      const Strain E{random(-0.02, 0.1), random(-0.02, 0.1), random(-0.1, 0.1), 0, random(-0.5, 0.5)};
      REQUIRE(point.go(E, {0, random(0, 1)}));
      Strain S;
      law::stress(*point.law, E.data(), point.s.data(), S.data());
      for (int i = 0; i < 5; ++i) CHECK(S[i] == Approx(point.S[i]).epsilon(1e-13));
    }
  }
}

TEST_CASE("a law cuts a strain that is not finite, and is broken where its state is not", "[law]") {
  LawPoint point(viscous_card());
  const Strain fine{0.01, 0, 0, 0, 0.1};
  Strain bad = fine;
  bad[0] = std::nan("");
  const auto outcome = [&](const Strain& E) {
    return law::evaluate(*point.law, {0, 0.1}, E.data(), point.s.data(), point.trial.data(), point.S.data(),
                         nullptr);
  };
  CHECK(outcome(fine) == law::Evaluation::ok);
  CHECK(outcome(bad) == law::Evaluation::cut);
  point.s[law::elements_slot(point.law->woven) + rheology::viscous::state::q] = std::nan("");
  CHECK(outcome(fine) == law::Evaluation::broken);
}

TEST_CASE("a card without viscous shear has the state and the stiffness it had", "[law][viscous]") {
  const auto plain = law::compile(thesis_card(0)), viscous = law::compile(viscous_card());
  CHECK(law::state_size(*viscous) == law::state_size(*plain) + rheology::viscous::Element::numbers);
  CHECK(plain->is_plain);
  CHECK(!law::is_rate_dependent(*plain));
  CHECK(law::is_rate_dependent(*viscous));
  CHECK(law::stiffest(*viscous) >= law::stiffest(*plain));
  auto other = viscous_card();
  woven(other).law = card::LawKind::thesis;
  says(message_of([&] { law::compile(other); }), "field 'viscous': expected law = \"potential\"");
}
