// Yarns that unload along curves: closed forms, loops in loops, energies; and checks that must not pass where
// the friction or the memory of the strands has the wrong sign or rule.
#include <cmath>
#include <functional>

#include "catch.hpp"
#include "draws.hpp"
#include "law/beside_batches.hpp"
#include "law/data.hpp"
#include "law/law_point.hpp"
#include "law/thesis_cards.hpp"
#include "law/yarn_loop.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

constexpr double friction = 0.35, reach = 0.6, bend = 0.5, m = 0.12;  // as in with_loops; the peak

// The stress along the warp at the share x of the way from the residual strain to the peak, of P(m), by the
// formulas of share/doc/law.md written out anew: straight pieces between the ends of the strands.
double elastic(double x) { return (1 - friction) * ((1 - bend) * x + bend * x * x); }
double lost_friction(double y) {  // at the distance y from the peak, or built up over y from zero stress
  const double z = std::fmin(y, reach) / reach, n = law::loop_strands;
  const double low = std::floor(z * n) / n, high = std::fmin(low + 1 / n, 1.0), t = (z - low) * n;
  const auto parabola = [](double u) { return friction * (1 - (1 - u) * (1 - u)); };
  return parabola(low) + t * (parabola(high) - parabola(low));
}
double down(double x) { return elastic(x) + friction - lost_friction(1 - x); }
double up(double x) { return elastic(x) + lost_friction(x); }

struct Way {
  double P, Du, residual;
  double strain(double x) const { return residual + x * P / Du; }
};
Way way_of_blend() {
  const double Du = 864 * MPa, P = stress_of(thesis_rows()[0].warp, m) * MPa;
  return {P, Du, m - P / Du};
}

// Strains to E11 = e in n equal steps under uniaxial strain; the yarn's own stress, of P(m).
double pull(LawPoint& point, double e, int n = 1) {
  const double start = point.E[0], c = point.C[1];
  for (int k = 1; k <= n; ++k) REQUIRE(point.go({k == n ? e : start + (e - start) * k / n, 0, 0, 0, 0}));
  return (point.S[0] - (c == 0 ? point.C[1] : c) * 0.25 * e) / way_of_blend().P;
}

}  // namespace

TEST_CASE("a curved loop goes down and up by its closed form, in any number of steps", "[law][loop]") {
  const Way way = way_of_blend();
  for (const int n : {1, 1000}) {
    LawPoint point(with_loops(thesis_card(0)));
    CHECK(pull(point, m, n) == Approx(1).epsilon(1e-13));
    for (double x = 0.95; x > 0; x -= 0.05)
      CHECK(pull(point, way.strain(x), n) == Approx(down(x)).epsilon(1e-11));
    CHECK(std::fabs(pull(point, way.residual, n)) < 1e-11);
    const auto at_rest = point.energy();
    CHECK(at_rest.stored == Approx(0.5 * point.C[1] * 0.25 * way.residual * way.residual).epsilon(1e-10));
    pull(point, way.residual - 0.02, n);
    CHECK(law::internal(*point.law, point.E.data(), point.s.data()).residual1 ==
          Approx(way.residual).epsilon(1e-13));
    for (double x = 0.05; x < 1; x += 0.05)
      CHECK(pull(point, way.strain(x), n) == Approx(up(x)).epsilon(1e-11));
    CHECK(pull(point, m, n) == Approx(1).epsilon(1e-12));
    // The loop's area, of P^2 / Du: each strand slips by 1 - z_j at its limit.
    const double N = law::loop_strands;
    const double area = friction * (1 - reach * (2 * N * N + 1) / (3 * N * N));
    CHECK(point.energy().dissipated() - at_rest.dissipated() ==
          Approx(area * way.P * way.P / way.Du).epsilon(1e-11));
    // Then on along the backbone.
    const double P = stress_of(thesis_rows()[0].warp, 0.15) * MPa;
    CHECK(pull(point, 0.15, n) == Approx(P / way.P).epsilon(1e-13));
  }
}

TEST_CASE("loops in loops close, and leave nothing behind", "[law][loop]") {
  const Way way = way_of_blend();
  LawPoint with(with_loops(thesis_card(0))), without(with_loops(thesis_card(0)));
  for (auto* point : {&with, &without}) {
    pull(*point, m);
    pull(*point, way.strain(0.7));
  }
  // To 0.5, up to 0.62, down to 0.55, up and down again: back at 0.5 as before, then as if nothing had been.
  const double turned = pull(with, way.strain(0.5));
  pull(without, way.strain(0.5));
  double top = 0, inner = 0;
  for (int cycle = 0; cycle < 3; ++cycle) {
    const double here = pull(with, way.strain(0.62));
    // Masing: from a turn the friction goes the same way as from the peak.
    CHECK(here - turned == Approx(elastic(0.62) - elastic(0.5) + lost_friction(0.12)).epsilon(1e-10));
    const double deep = pull(with, way.strain(0.55));
    CHECK(here - deep == Approx(elastic(0.62) - elastic(0.55) + lost_friction(0.07)).epsilon(1e-10));
    if (cycle > 0) {
      CHECK(here == Approx(top).epsilon(1e-12));
      CHECK(deep == Approx(inner).epsilon(1e-12));
    }
    top = here, inner = deep;
    CHECK(pull(with, way.strain(0.62)) == Approx(here).epsilon(1e-12));
    CHECK(pull(with, way.strain(0.5)) == Approx(turned).epsilon(1e-12));
  }
  for (const double x : {0.4, 0.2, 0.0, 0.3, 0.8, 1.0, 0.9})
    CHECK(pull(with, way.strain(x)) == Approx(pull(without, way.strain(x))).epsilon(1e-11).margin(1e-12));
}

TEST_CASE("without friction and curve a loop is the straight law", "[law][loop]") {
  Random random(5);
  auto card = thesis_card(0);
  LawPoint straight(card);
  woven(card).warp.loop = woven(card).weft.loop = card::YarnLoop{0, 0.5, 0};
  LawPoint point(card);
  CHECK(law::state_size(*straight.law) == law::potential_state::count);
  CHECK(law::stiffest(*point.law) == Approx(law::stiffest(*straight.law)).epsilon(1e-14));
  for (int k = 0; k < 2000; ++k) {
    const Strain E{random(-0.05, 0.2), random(-0.05, 0.1), 0.01, 0, random(-0.3, 0.3)};
    REQUIRE(point.go(E));
    REQUIRE(straight.go(E));
    for (int i = 0; i < 5; ++i) CHECK(point.S[i] == Approx(straight.S[i]).epsilon(1e-12).margin(1e-3));
    for (int i = 0; i < 25; ++i) CHECK(point.C[i] == Approx(straight.C[i]).epsilon(1e-12).margin(1e-3));
    CHECK(point.energy().stored == Approx(straight.energy().stored).epsilon(1e-11).margin(1e-7));
    CHECK(point.energy().dissipated() == Approx(straight.energy().dissipated()).epsilon(1e-11).margin(1e-7));
  }
}

TEST_CASE("a yarn with a loop never pushes, and stays between its two curves", "[law][loop]") {
  Random random(11);
  const Way way = way_of_blend();
  LawPoint point(with_loops(thesis_card(0)));
  pull(point, m);
  for (int k = 0; k < 5000; ++k) {
    const double x = random(-0.1, 1.0), inside = std::fmax(x, 0.0), T = pull(point, way.strain(x));
    if (x < 0) continue;
    CHECK(T >= down(inside) - 1e-11);
    CHECK(T <= up(inside) + 1e-11);
    // Positive definite wherever the warp is; the weft is slack or virgin.
    CHECK(point.C[0] * point.C[6] > point.C[1] * point.C[1]);
  }
}

TEST_CASE("the tangent at a turn is that of loading on or of the way back, as asked", "[law][loop]") {
  const Way way = way_of_blend();
  LawPoint point(with_loops(thesis_card(0)));
  const auto slope = [&](law::AtSwitch at) {
    REQUIRE(point.evaluate(point.E, {0, 0, at}));
    return point.C[0] - 0.25 * point.C[1];
  };
  const double n = law::loop_strands, first = friction * (2 - 1 / n) / reach;  // all strands stick
  pull(point, m);
  CHECK(slope(law::AtSwitch::loading) == Approx(modulus_of(thesis_rows()[0].warp, m) * MPa).epsilon(1e-12));
  CHECK(slope(law::AtSwitch::unloading) ==
        Approx(way.Du * ((1 - friction) * (1 + bend) + first)).epsilon(1e-12));
  pull(point, way.strain(0.1));  // all strands are slack
  const double tail = (1 - friction) * (1 - bend + 0.2 * bend);
  CHECK(slope(law::AtSwitch::loading) == Approx(way.Du * tail).epsilon(1e-10));
  CHECK(slope(law::AtSwitch::unloading) == Approx(way.Du * (tail + first)).epsilon(1e-10));
}

TEST_CASE("a reading of stress of a curved loop is the one that balanced the step", "[law][loop]") {
  Random random(4);
  LawPoint point(with_loops(with_viscous(thesis_card(2))));
  for (int k = 0; k < 500; ++k) {
    const Strain E{random(-0.02, 0.05), random(-0.02, 0.1), 0, 0, random(-0.3, 0.3)};
    REQUIRE(point.go(E, {0, random(0, 1)}));
    Strain S;
    law::stress(*point.law, E.data(), point.s.data(), S.data());
    for (int i = 0; i < 5; ++i) CHECK(S[i] == Approx(point.S[i]).epsilon(1e-11).margin(1e-4));
  }
}

TEST_CASE("a loop that no yarn can have is refused by its field", "[law][loop][compile]") {
  const auto refused = [](const std::function<void(card::Woven&)>& change, const std::string& words) {
    auto c = with_loops(thesis_card(0));
    change(woven(c));
    says(message_of([&] { law::compile(c); }), words);
  };
  refused(
      [](auto& w) { w.law = card::LawKind::thesis; },
      "field 'warp.loop': expected law = \"potential\", the only one that takes it, got law = \"thesis\"");
  refused([](auto& w) { w.weft.loop->curve = 0.99; },
          "field 'weft.loop': expected a tail (1 - friction) (1 - curve) unloading of at least ");
  refused([](auto& w) { w.warp.loop->friction = 1; },
          "field 'warp.loop.friction': expected a number from 0 to below 1, got 1");
  refused([](auto& w) { w.warp.loop->reach = 0; },
          "field 'warp.loop.reach': expected a number from 0.001 to 1, got 0");
  refused([](auto& w) { w.weft.loop->curve = 1.1; },
          "field 'weft.loop.curve': expected a number from 0 to 1");
}

TEST_CASE("single points and batches agree on curved loops", "[law][batch][loop]") {
  Random random(8);
  auto one_side = with_viscous(thesis_card(1));
  woven(one_side).weft.loop = card::YarnLoop{0.4, 0.3, 0.2};
  for (const auto& card : {with_loops(thesis_card(0)), one_side,
                           with_loops(with_biaxial(with_viscous(with_friction(thesis_card(0)))))})
    beside_batches(card, 80, random, [](const LawPoint& point, const Lane& lane) {
      const auto energy = point.energy();
      for (const int i : {0, 1}) CHECK(lane.S(i) == Approx(point.S[i]).epsilon(1e-9).margin(1e-2));
      for (const int i : {0, 6}) CHECK(lane.C(i) == Approx(point.C[i]).epsilon(1e-9));
      for (int i = 0; i < law::state_size(*point.law); ++i)
        CHECK(lane.s(i) == Approx(point.s[i]).epsilon(1e-9).margin(1e-9));
      CHECK(lane.energy(0) == Approx(energy.stored).epsilon(1e-9).margin(1e-6));
      CHECK(lane.energy(1) == Approx(energy.lost[0]).epsilon(1e-9).margin(1e-6));
      CHECK(lane.energy(2) == Approx(energy.lost[1]).epsilon(1e-9).margin(1e-6));
    });
}

// --- what the checks of energy and memory are worth: they must fail on laws that are wrong ---

namespace {

struct YarnState {
  double m = 0, E = 0;
  double s[law::loop_state::count] = {};
};
struct Yarn {
  std::shared_ptr<const law::Law> law;
  const law::AxisData& axis() const { return law->woven.axis[0]; }
  const law::LoopData& loop() const { return law->woven.loop[0]; }
};
using Kernel = std::function<double(const Yarn&, double E, YarnState& s)>;

double right(const Yarn& yarn, double E, YarnState& s) {
  const YarnState old = s;
  s.E = E;
  return law::looped_yarn(yarn.axis(), yarn.loop(), 0.0, law::AtSwitch::loading, E, old.s, s.s, s.m).S;
}

double loss_of_wrong_sign(const Yarn& yarn, double E, YarnState& s) {
  const double before = s.s[law::loop_state::lost], S = right(yarn, E, s);
  s.s[law::loop_state::lost] = 2 * before - s.s[law::loop_state::lost];
  return S;
}

// The strands push the way the yarn goes: the two curves of a loop change places.
double friction_of_wrong_sign(const Yarn& yarn, double E, YarnState& s) {
  const double S = right(yarn, E, s), P = law::backbone_at(yarn.axis().curve, s.m).P;
  const double x = 1 - (s.m - E) * yarn.axis().unloading / std::fmax(P, 1e-300);
  if (x < 0 || x >= 1) return S;
  double mean = yarn.loop().linear * x + yarn.loop().square * x * x;
  for (int j = 0; j < law::loop_strands; ++j) {
    const double z = yarn.loop().reach[j];
    mean += yarn.loop().stiffness[j] * (std::fmin(x, z) + std::fmax(z - 1 + x, 0.0)) / 2;
  }
  return 2 * mean * P - S;
}

// At every turn the strands forget where they were: they are at their limit again.
double memory_lost_at_a_turn(const Yarn& yarn, double E, YarnState& s) {
  const double P = law::backbone_at(yarn.axis().curve, s.m).P;
  const double x = 1 - (s.m - s.E) * yarn.axis().unloading / std::fmax(P, 1e-300);
  if (x > 0 && x < 1 && s.m > E)
    for (int j = 0; j < law::loop_strands; ++j)
      s.s[law::loop_state::slack + j] = E > s.E ? x : x - yarn.loop().reach[j];
  return right(yarn, E, s);
}

struct Audit {
  double least = 0, ledger = 0, fall = 0, open = 0;  // of the work of a loop; open: of the peak stress
};

// Random closed loops of one yarn, each leg in straight steps; and the gap of inner loops that should close.
Audit audit(const Kernel& kernel) {
  const Yarn yarn{law::compile(with_loops(thesis_card(0)))};
  const auto dissipated = [&](const YarnState& s) {
    return law::loop_energy(yarn.axis(), yarn.loop(), s.E, s.m, s.s).dissipated;
  };
  Random random(21);
  Audit out;
  const auto leg = [&](YarnState& s, double to, bool one_step) {
    constexpr int n = 400;
    double W = 0, S = 0;
    const double from = s.E;
    YarnState start = s;
    for (int i = 1; i <= n; ++i) {
      YarnState middle = start, end = start;
      const double h = (to - from) / n;
      W += h * kernel(yarn, from + (i - 0.5) * h, middle);
      S = kernel(yarn, i == n ? to : from + i * h, one_step ? end : s);
    }
    if (one_step) S = kernel(yarn, to, s);
    return std::pair{W, S};
  };
  for (int loop = 0; loop < draws(300); ++loop) {
    YarnState s;
    double W = 0, size = 0, before = 0;
    const int corners = 3 + random.below(4);
    for (int c = 0; c <= corners; ++c) {
      const double peak = std::fmax(s.m, 0.02),
                   residual = peak - law::backbone_at(yarn.axis().curve, peak).P * yarn.axis().softness;
      // Below zero strain a yarn alone is slack without stress, so that a loop may end where it is slack.
      const double to = c == corners ? residual - 1e-3
                        : c == 0     ? random(0.05, 0.15)
                                     : residual + random(-0.1, 1.1) * (peak - residual);
      const double part = leg(s, to, true).first;
      W += part, size += std::fabs(part);
      const auto now = law::loop_energy(yarn.axis(), yarn.loop(), s.E, s.m, s.s);
      out.fall = std::fmax(out.fall, (before - now.dissipated) / size);
      before = now.dissipated;
    }
    // At the end nothing is stored but what the slack spring has (h x^2 / 2).
    const double slack = 0.5 * yarn.axis().slack * 1e-6;
    out.ledger = std::fmax(out.ledger, std::fabs(W - slack - dissipated(s)) / size);
    // A closed loop on the way back from the peak; and the way up with and without a loop inside it.
    YarnState s0;
    const Way way = way_of_blend();
    const double a = random(0.1, 0.5), b = random(a, 0.9);
    for (const double x : {1.0, b, a}) kernel(yarn, way.strain(x), s0);
    YarnState direct = s0, detour = s0;
    double round = 0;
    for (const double x : {b, a}) round += leg(s0, way.strain(x), true).first;
    const double first = kernel(yarn, way.strain(b), direct);
    double again = 0;
    const double c = a + 0.3 * (b - a), d = a + 0.8 * (b - a);
    for (const double x : {d, c, b}) again = kernel(yarn, way.strain(x), detour);
    out.open = std::fmax(out.open, std::fabs(again - first) / way.P);
    // A closed loop from any state, through larger strains too.
    const double E0 = s0.E, peak0 = s0.m;
    double other = 0;
    for (int k = 0, n = 2 + random.below(4); k <= n; ++k)
      other += leg(s0, k == n ? E0 : way.residual + random(-0.1, 1.5) * (peak0 - way.residual), true).first;
    out.least = std::fmin(out.least, other / (way.P * way.P / way.Du));
    out.least = std::fmin(out.least, round / (way.P * way.P / way.Du));
  }
  return out;
}

}  // namespace

TEST_CASE("the account of a yarn's loops notices a wrong sign and a wrong memory", "[law][loop][energy]") {
  const Audit fine = audit(right);
  INFO("least " << fine.least << " ledger " << fine.ledger << " fall " << fine.fall << " open " << fine.open);
  CHECK(fine.least >= -1e-4);  // the quadrature of straight steps, over kinks
  CHECK(fine.ledger < 1e-4);
  CHECK(fine.fall <= 1e-14);
  CHECK(fine.open < 1e-12);
  const Audit lost = audit(loss_of_wrong_sign);
  CHECK(lost.ledger > 1e-2);
  CHECK(lost.fall > 1e-2);
  const Audit pushed = audit(friction_of_wrong_sign);
  CHECK(pushed.least < -1e-2);
  CHECK(pushed.ledger > 1e-2);
  const Audit forgot = audit(memory_lost_at_a_turn);
  CHECK(forgot.open > 1e-2);
}
