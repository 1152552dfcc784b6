// Bending that softens and rubs: the moment-curvature loop in closed form, its energies, its tangent.
#include <cmath>
#include <string>
#include <vector>

#include "catch.hpp"
#include "draws.hpp"
#include "law/bending_point.hpp"
#include "law/bending_spring.hpp"
#include "law/law_point.hpp"
#include "law/thesis_cards.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using law::AtSwitch;

namespace {

const law::BendingSpring plain{10e-6, 0.4e-3, 20.0};  // N.m, N, 1/m: 2HB = 0.8 mN

struct Fold {
  law::BendingState<double> s;
  double kappa = 0, work = 0;
  double M = 0;
  void to(double target, int n) {
    const double start = kappa;
    for (int k = 1; k <= n; ++k) {
      const double before = M, last = kappa;
      kappa = k == n ? target : start + (target - start) * k / n;
      M = law::bending_moment(plain, AtSwitch::loading, kappa, s).M;
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
    const double stored = law::bending_stored(plain, fold.kappa, fold.s);
    CHECK(stored == Approx(0.5 * 10e-6 * 250 * 250 + 0.5 * 0.4e-3 * 20).epsilon(1e-12));
    // Trapezoids over the kinks: second order in 1 / n.
    if (n > 1) CHECK(fold.work == Approx(stored + fold.s.lost).epsilon(1e-6));
  }
}

TEST_CASE("bending tangent against differences, and at the edge of slip", "[bending]") {
  test::Random random(2);
  law::BendingState<double> s;
  int sticking = 0, slipping = 0;
  for (int k = 0; k < 10000; ++k) {
    const double kappa = random(-60, 60), h = 1e-4;
    auto a = s, b = s, c = s;
    const double C = law::bending_moment(plain, AtSwitch::loading, kappa, a).C;
    const double up = law::bending_moment(plain, AtSwitch::loading, kappa + h, b).M;
    const double down = law::bending_moment(plain, AtSwitch::loading, kappa - h, c).M;
    if (std::fabs(std::fabs(kappa - s.slip) - plain.curvature) > 2 * h)
      CHECK((up - down) / (2 * h) == Approx(C).epsilon(1e-8));
    (C > 2 * plain.rigidity ? sticking : slipping)++;
    s = a;
  }
  CHECK(sticking > 1000);
  CHECK(slipping > 1000);
  auto edge = s;
  law::bending_moment(plain, AtSwitch::loading, 100.0, edge);
  auto again = edge;
  CHECK(law::bending_moment(plain, AtSwitch::loading, 100.0, again).C == plain.rigidity);
  CHECK(law::bending_moment(plain, AtSwitch::unloading, 100.0, again).C > 2 * plain.rigidity);
}

namespace {

// A card that bends as told; the rest is the thesis' blend.
card::Card bent(const card::Bending& bending) {
  auto card = test::thesis_card(0);
  card.bending = bending;
  return card;
}

// B = 15 uN.m at rest, 70 % of it at 100 /m; friction that slips or fades.
card::Bending cloth(card::FrictionMemory memory) {
  card::Bending b{15e-6, 9e-6, 5e-6, card::BendingFriction{0.3e-3, 12, memory}, {}};
  b.warp_curve.coefficients = {15e-6, -0.045e-6};
  b.tested = 120;
  return b;
}

}  // namespace

TEST_CASE(
    "rigidity that changes with the curvature: the moment is its integral, odd, straight past the range",
    "[bending]") {
  const auto springs = law::bending_springs(bent(cloth(card::FrictionMemory::slip)));
  law::BendingSpring spring = springs[0];
  spring.friction = 0;
  law::BendingState<double> s;
  const auto M = [&](double k) { return law::bending_moment(spring, AtSwitch::loading, k, s).M; };
  const auto straight = [](double k) { return 15e-6 * k - 0.0225e-6 * k * k; };
  for (const double k : {0.0, 1e-3, 10.0, 77.0, 120.0}) {
    CHECK(M(k) == Approx(straight(k)).epsilon(1e-14));
    CHECK(M(-k) == -M(k));
    CHECK(law::bending_stored(spring, -k, s) ==
          Approx(7.5e-6 * k * k - 0.0075e-6 * k * k * k).epsilon(1e-14).margin(1e-20));
  }
  const double B = 15e-6 - 0.045e-6 * 120;
  CHECK(M(200) == Approx(straight(120) + 80 * B).epsilon(1e-14));
  CHECK(law::bending_moment(spring, AtSwitch::loading, -200.0, s).C == Approx(B).epsilon(1e-14));
  CHECK(springs[1].curve == nullptr);
  CHECK(law::stiffest(springs[0]) == Approx(15e-6 + 0.3e-3 / 12).epsilon(1e-12));
}

TEST_CASE("measured points of curvature and moment are met", "[bending]") {
  auto b = cloth(card::FrictionMemory::slip);
  b.warp_curve = {{}, {{0, 0}, {20, 0.3e-3}, {60, 0.8e-3}, {150, 1.6e-3}}};
  b.friction_warp.reset();
  b.tested = 0;
  law::BendingPoint point(bent(b));
  for (const auto& [k, M] : b.warp_curve.points) {
    CHECK(point.bend(k, {}, {}).M11 == Approx(M).epsilon(1e-14));
    CHECK(point.bend(-k, {}, {}).M11 == Approx(-M).epsilon(1e-14));
  }
}

TEST_CASE("a bending that no cloth can have is refused by its field", "[bending]") {
  const auto refused = [](const std::function<void(card::Bending&)>& change, const std::string& words) {
    auto b = cloth(card::FrictionMemory::slip);
    change(b);
    const auto card = bent(b);
    says(message_of([&] { law::bending_springs(card); }), words);
  };
  refused([](auto& b) { b.tested = 400; },
          "field 'bending.warp': expected a positive rigidity up to the tested 400 1/m, got ");
  refused(
      [](auto& b) {
        b.warp_curve = {{}, {{0, 0}, {50, 1e-3}, {40, 2e-3}}};
      },
      "expected curvature and moment both rising strictly, got {40, 0.002} as point 3");
  refused([](auto& b) { b.warp_curve = {{}, {{0, 1e-3}, {50, 2e-3}}}; }, "the first {0, 0}");
  refused([](auto& b) { b.warp_curve.coefficients = {1e-6, 0, 0, 0, 1}; }, "at most 4 coefficients, got 5");
  says(message_of([] { law::BendingPoint point(test::thesis_card(0)); }),
       "field 'bending': expected the card's own bending");
  // Where nobody said how far it was measured, a curve that falls too far stays at a tenth.
  auto b = cloth(card::FrictionMemory::slip);
  b.tested = 0;
  b.warp_curve.coefficients = {15e-6, -0.3e-6};
  const auto spring = law::bending_springs(bent(b))[0];
  CHECK(spring.curve->backbone.D_limit == Approx(1.5e-6).epsilon(0.02));
}

TEST_CASE("friction that fades: closed form, in any number of steps", "[bending]") {
  const double Mf = 0.3e-3, reach = 12;
  auto card = bent(cloth(card::FrictionMemory::fading));
  for (const int n : {1, 5000}) {
    auto spring = law::bending_springs(card)[0];
    spring.curve = nullptr, spring.rigidity = 0;  // the friction alone
    law::BendingState<double> s;
    double m = 0, k = 0;
    for (const double target : {30.0, 22.0, -40.0, -40.0, 3.0}) {
      const double start = k;
      for (int i = 1; i <= n; ++i) {
        k = i == n ? target : start + (target - start) * i / n;
        m = law::bending_moment(spring, AtSwitch::loading, k, s).M;
      }
    }
    // 30: Mf (1 - e^-2.5), and so on; each leg comes to its side's Mf as exp(-way / reach).
    double want = 0, at = 0;
    for (const double target : {30.0, 22.0, -40.0, 3.0}) {
      const double side = target > at ? Mf : -Mf;
      want = side + (want - side) * std::exp(-std::fabs(target - at) / reach);
      at = target;
    }
    CHECK(m == Approx(want).epsilon(1e-11));
    CHECK(law::bending_stored(spring, k, s) == Approx(m * m * reach / (2 * Mf)).epsilon(1e-9));
  }
  // The loop of a KES test, to +-250 /m, is 2 M_f high where the friction has come to its end.
  law::BendingPoint point(card);
  point.bend(250, {}, {});
  point.bend(-250, {}, {});
  const double up = point.bend(50, {}, {}).M11;
  point.bend(250, {}, {});
  const double down = point.bend(50, {}, {}).M11;
  CHECK(up - down == Approx(2 * Mf).epsilon(1e-6));
}

TEST_CASE("closed loops of bending never make energy, and the account closes", "[bending][energy]") {
  for (const auto memory : {card::FrictionMemory::slip, card::FrictionMemory::fading}) {
    auto b = cloth(memory);
    b.friction_weft = card::BendingFriction{0.1e-3, 5, memory};
    const auto springs = law::bending_springs(bent(b));
    test::Random random(memory == card::FrictionMemory::slip ? 3 : 4);
    double worst = 0, account = 0, fall = 0;
    for (int loop = 0; loop < test::draws(2000); ++loop) {
      for (const auto& spring : {springs[0], springs[1]}) {
        law::BendingState<double> s;
        double k = 0, W = 0, size = 0, lost = 0;
        const int corners = 2 + random.below(5);
        for (int c = 0; c <= corners; ++c) {
          const double to = c == corners ? 0 : random(-150, 150);
          constexpr int n = 64;
          double sum = 0;
          for (int i = 0; i < n; ++i) {  // five Gauss points a piece, each from the state at its start
            constexpr double x[] = {0.046910077030668, 0.230765344947158, 0.5, 0.769234655052841,
                                    0.953089922969332};
            constexpr double w[] = {0.118463442528095, 0.239314335249683, 0.284444444444444,
                                    0.239314335249683, 0.118463442528095};
            const double from = k + (to - k) * i / n, step = (to - k) / n;
            for (int p = 0; p < 5; ++p) {
              auto copy = s;
              sum += w[p] * step * law::bending_moment(spring, AtSwitch::loading, from + x[p] * step, copy).M;
            }
            law::bending_moment(spring, AtSwitch::loading, i + 1 == n ? to : from + step, s);
          }
          k = to;
          W += sum;
          size += std::fabs(sum);
          fall = std::max(fall, lost - s.lost);
          lost = s.lost;
          account = std::max(account, std::fabs(W - law::bending_stored(spring, k, s) - s.lost) / size);
        }
        worst = std::min(worst, W / size);
      }
    }
    INFO("memory " << int(memory) << ": account " << account << ", least work " << worst);
    // The pieces of the quadrature are blind to what begins within them: a slip (second order in their size),
    // the bends of the softening curve at zero and at the end of its range (third).
    CHECK(worst >= -1e-10);
    CHECK(fall <= 0);
    CHECK(account < (memory == card::FrictionMemory::slip ? 1e-4 : 1e-7));
  }
}

TEST_CASE("tangent of bending that softens and fades, against differences", "[bending][tangent]") {
  const auto spring = law::bending_springs(bent(cloth(card::FrictionMemory::fading)))[0];
  test::Random random(7);
  law::BendingState<double> s;
  for (int i = 0; i < 5000; ++i) {
    const double k = random(-150, 150), h = 1e-4;
    if (std::fabs(k - s.last) < 2 * h) continue;
    auto a = s, b = s, c = s;
    const double C = law::bending_moment(spring, AtSwitch::loading, k, a).C;
    const double up = law::bending_moment(spring, AtSwitch::loading, k + h, b).M;
    const double down = law::bending_moment(spring, AtSwitch::loading, k - h, c).M;
    CHECK((up - down) / (2 * h) == Approx(C).epsilon(1e-6));
    CHECK(C <= law::stiffest(spring) * (1 + 1e-12));
    s = a;
  }
  // At rest: on along the moment, or the turn.
  auto rest = s;
  law::bending_moment(spring, AtSwitch::loading, s.last, rest);
  const double on = law::bending_moment(spring, AtSwitch::loading, s.last, rest).C;
  const double turn = law::bending_moment(spring, AtSwitch::unloading, s.last, rest).C;
  CHECK(on < turn);
}
