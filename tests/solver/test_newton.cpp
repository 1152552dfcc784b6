// Newton's line search, the guard of a step along an arc, and what all solvers make of a limit and of forces
// that cannot be computed, on problems of one unknown whose every number is known beforehand.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "catch.hpp"
#include "solver/arc_length.hpp"
#include "solver/descent.hpp"
#include "solver/relaxation.hpp"
#include "solver/scalar.hpp"

using namespace fabricsh::solver;
using fabricsh::Answer;
using fabricsh::test::Scalar;

namespace {

NewtonResult correct(Scalar& problem, NewtonOptions options) {
  problem.shares.clear();
  problem.set_trial(problem.committed);
  return Newton(fabricsh::linear::make_unsymmetric_solver()).correct(problem, options);
}

// The shares tried in one iteration from u = 0 with K = 1 and so with the increment r(0) = 1.
std::vector<double> shares(const std::function<double(double u)>& force, bool line_search = true) {
  Scalar problem;
  problem.force = [&](double u, double) { return force(u); };
  problem.stiffness = [](double) { return 1.0; };
  correct(problem, {.max_iterations = 1, .line_search = line_search});
  CHECK(problem.trial() == problem.shares.back());
  return problem.shares;
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("the line search goes back to where the bracketed force vanishes, and no further than it must") {
  const auto line = [](double slope) { return [slope](double u) { return 1 - slope * u; }; };
  CHECK(shares(line(1)) == std::vector{1.0});
  // g(1) = -0.5 g(0) is enough, a little more is not.
  CHECK(shares(line(1.5)) == std::vector{1.0});
  const auto over = shares(line(1.6));
  REQUIRE(over.size() == 2);
  CHECK(std::abs(over[1] - 1 / 1.6) < 1e-15);
  CHECK(shares(line(5)) == std::vector{1.0, 0.2});
  CHECK(shares(line(5), false) == std::vector{1.0});
  // Still falling at the whole step: Newton goes on from there.
  CHECK(shares(line(0.2)) == std::vector{1.0});
  CHECK(shares(line(-3)) == std::vector{1.0});
  // One try takes at most nine tenths off.
  const auto far = shares(line(50));
  REQUIRE(far.size() == 3);
  CHECK(far[1] == 0.1);
  CHECK(std::abs(far[2] - 0.02) < 1e-15);
}

// A single secant from the start of such a step ends at a tenth of it at most, again and again.
TEST_CASE("where something stiff begins to resist within a step, the line search finds it from both sides") {
  for (const double stiff : {1e1, 1e3, 1e6})
    for (const double wall : {0.15, 0.5, 0.8, 0.95}) {
      const auto force = [&](double u) { return 1 - u - (u > wall ? stiff * (u - wall) : 0); };
      const double end = shares(force).back();
      CHECK((std::abs(force(end)) <= 0.5 || std::abs(end - wall) < 0.02));
    }
  // The first secant ends at 0.1, the next one would end there as well.
  CHECK(shares([](double u) { return u > 0.5 ? 1 - u - 1e3 * (u - 0.5) : 1 - u; })[2] == 0.1 + 0.9 * 0.1);
}

TEST_CASE("the line search takes a quarter of a step on which the law fails, ten times at most") {
  for (const double failure : {kNone, std::numeric_limits<double>::infinity()})
    CHECK(shares([=](double u) { return u > 0.3 ? failure : 1 - u; }) == std::vector{1.0, 0.25});
  Scalar problem;
  problem.force = [](double u, double) { return u == 0 ? 1 : kNone; };
  problem.stiffness = [](double) { return 1.0; };
  CHECK(correct(problem, {}).status == NewtonStatus::law_failed);
  REQUIRE(problem.shares.size() == 10);
  CHECK(problem.shares.back() == std::pow(0.25, 9));
}

TEST_CASE("from where Newton's method alone overshoots for ever, the line search brings it home") {
  Scalar problem;
  problem.force = [](double u, double) { return -std::atan(u); };
  problem.stiffness = [](double u) { return 1 / (1 + u * u); };
  problem.committed = 2;
  CHECK(correct(problem, {}).status == NewtonStatus::converged);
  CHECK(std::abs(problem.trial()) < 1e-10);
  CHECK(correct(problem, {.line_search = false}).status != NewtonStatus::converged);
}

TEST_CASE("the first step of a predicted solve is taken whole, the later ones are searched") {
  Scalar problem;
  problem.force = [](double u, double) { return 1 - 5 * u; };
  problem.stiffness = [](double u) { return u == 0 ? 1.0 : 2.0; };
  Newton newton(fabricsh::linear::make_unsymmetric_solver());
  CHECK(newton.solve(problem, {.max_iterations = 2}).status == NewtonStatus::converged);
  REQUIRE(problem.shares.size() == 3);
  CHECK(problem.shares[0] == 1);
  CHECK(problem.shares[1] == 1);
  CHECK(std::abs(problem.shares[2] - 0.4) < 1e-15);
}

// A path t = f(u) from u = 0.9 that lands at t = 1.05; its predictor goes to u = 1.05. The path beyond u = 1
// decides where the corrector ends.
TEST_CASE("a step along an arc that ends off its path is refused, however well it balances") {
  const auto land = [](const std::function<double(double)>& f, double beyond) {
    Scalar problem;
    problem.committed = 0.9;
    problem.force = [&](double u, double t) { return t - f(u); };
    problem.stiffness = [&](double u) { return u > 1 ? beyond : 1.0; };
    ArcLength arc(fabricsh::linear::make_unsymmetric_solver());
    const auto result = arc.solve(problem, {.tolerance = 1e-9, .line_search = false},
                                  {.time = 0.9, .landing = 1.05, .length = 1, .largest_step = 1});
    CHECK(result.landed);
    CHECK(result.residuals.back() < 1e-9);  // it balances
    CHECK(std::abs(f(problem.trial()) - 1.05) < 1e-9);
    return result.status;
  };
  // Softer by a half: the increment grows to 0.2, which is near enough.
  CHECK(land([](double u) { return u < 1 ? u : 1 + 0.5 * (u - 1); }, 0.5) == NewtonStatus::converged);
  // 2.9 times the predictor's increment, and 3.1 times.
  const auto soft = [](double end) {
    const double slope = 0.05 / (end - 1);
    return std::pair([slope](double u) { return u < 1 ? u : 1 + slope * (u - 1); }, slope);
  };
  const auto near = soft(0.9 + 2.9 * 0.15), far = soft(0.9 + 3.1 * 0.15);
  CHECK(land(near.first, near.second) == NewtonStatus::converged);
  CHECK(land(far.first, far.second) == NewtonStatus::diverged);
  // Round the back: the corrector jumps to another branch, at u = 0.5, against the predictor's way.
  const auto back = [](double u) { return u > 1 ? 1 - 0.1 * (u - 1) : u > 0.6 ? u : 1.55 - u; };
  CHECK(land(back, -0.1) == NewtonStatus::diverged);
}

// --- limits, and forces that are beyond repair, in all three solvers

namespace {

// A barrier before a wall at u = 1, beyond which no iterate may come; the solution lies close before it.
struct Walled {
  static constexpr double wall = 1;
  Scalar problem;
  double farthest = 0;
  explicit Walled(double load) {
    problem.force = [this, load](double u, double t) {
      farthest = std::max(farthest, u);
      return load * t - 0.1 * u - 1e-4 / (wall - u);
    };
    problem.stiffness = [](double u) { return 0.1 + 1e-4 / ((wall - u) * (wall - u)); };
    // Nine tenths of the way to the wall, as a barrier's line search has it.
    problem.safe = [](double from, double delta) {
      return delta > 0 ? std::min(1.0, 0.9 * (wall - from) / delta) : 1.0;
    };
    problem.set_time(1);
  }
};

}  // namespace

TEST_CASE("no solver steps farther than the problem's limit, and each gets to the solution before the wall") {
  // 0.2 = 0.1 u + 1e-4 / (1 - u): u = 0.999 but for a little.
  const double load = 0.2, solution = [] {
    double u = 0.99;
    for (int i = 0; i < 60; ++i) u = 1 - 1e-4 / (0.2 - 0.1 * u);
    return u;
  }();
  {
    Walled walled(load);
    CHECK(Newton(fabricsh::linear::make_unsymmetric_solver()).solve(walled.problem, {}).status ==
          NewtonStatus::converged);
    CHECK(walled.problem.shares.front() < 0.5);  // the first step would have gone to u = 2
    CHECK(walled.farthest < Walled::wall);
    CHECK(std::abs(walled.problem.trial() - solution) < 1e-9);
  }
  {
    Walled walled(load);
    Relaxation relaxation;
    CHECK(relaxation.solve(walled.problem, {.tolerance = 1e-10}).status == NewtonStatus::converged);
    CHECK(walled.farthest < Walled::wall);
    CHECK(std::abs(walled.problem.trial() - solution) < 1e-9);
    CHECK(std::any_of(walled.problem.shares.begin(), walled.problem.shares.end(),
                      [](double fraction) { return fraction > 0 && fraction < 1; }));
  }
  {
    Walled walled(load);
    Descent descent(fabricsh::linear::make_unsymmetric_solver());
    CHECK(descent.solve(walled.problem, {.tolerance = 1e-10, .max_iterations = 20000}).status ==
          NewtonStatus::converged);
    CHECK(walled.farthest < Walled::wall);
    CHECK(std::abs(walled.problem.trial() - solution) < 1e-9);
  }
  {
    Walled walled(load);
    ArcLength arc(fabricsh::linear::make_unsymmetric_solver());
    // At t = 0, u = 0 but for the barrier's 1e-3, which is balanced.
    const double offset = walled.problem.force(0, 0);
    const auto force = walled.problem.force;
    walled.problem.force = [=](double u, double t) { return force(u, t) - offset; };
    walled.problem.rate = 0.2;
    const auto result = arc.solve(walled.problem, {.tolerance = 1e-10, .max_iterations = 60},
                                  {.time = 0, .landing = 1, .length = 5, .largest_step = 1});
    CHECK(result.landed);
    CHECK(walled.farthest < Walled::wall);
    CHECK(walled.problem.shares.front() < 0.9);
  }
}

TEST_CASE("a limit of nothing is a step that cannot be done, not one that goes nowhere for ever") {
  Scalar problem;
  problem.force = [](double u, double t) { return t - u; };
  problem.stiffness = [](double) { return 1.0; };
  problem.safe = [](double, double) { return 0.0; };
  problem.set_time(1);
  CHECK(Newton(fabricsh::linear::make_unsymmetric_solver()).solve(problem, {}).status ==
        NewtonStatus::blocked);
  CHECK(problem.shares.empty());
  ArcLength arc(fabricsh::linear::make_unsymmetric_solver());
  CHECK(arc.solve(problem, {}, {.time = 1, .landing = 2, .length = 1, .largest_step = 1}).status ==
        NewtonStatus::law_failed);
  CHECK(Relaxation().solve(problem, {}).status == NewtonStatus::law_failed);
  CHECK(
      Descent(fabricsh::linear::make_unsymmetric_solver()).solve(problem, {.max_iterations = 20000}).status ==
      NewtonStatus::law_failed);
}

TEST_CASE("a part of a way that leaves the way is taken where it is safe alone") {
  // The force vanishes at 0.1; the first direction, by a tenth of the stiffness, goes to 1. What lies below
  // 0.5 of that way is not safe, as where a body goes by shares of a way that changes.
  Scalar problem;
  problem.force = [](double u, double) { return u < 0.1 ? 1 : 10 * (0.1 - u); };
  problem.stiffness = [](double u) { return u < 0.1 ? 1 : 10; };
  std::vector<double> asked;
  problem.safe_part = [&asked](double part) {
    asked.push_back(part);
    return part >= 0.5;
  };
  (void)Newton(fabricsh::linear::make_unsymmetric_solver()).correct(problem, {.max_iterations = 1});
  REQUIRE(!asked.empty());
  CHECK(problem.shares.front() == 1);
  for (const double share : problem.shares) CHECK(share >= 0.5);
}

TEST_CASE("an overdamped motion leaves an unstable equilibrium that Newton's method finds") {
  // The energy u^4/4 - u^2/2 has a maximum at 0 and minima at 1 and -1.
  const auto make = [] {
    Scalar problem;
    problem.force = [](double u, double) { return u - u * u * u; };
    problem.stiffness = [](double u) { return 3 * u * u - 1; };
    problem.committed = 0.01;
    return problem;
  };
  auto newton = make();
  CHECK(Newton(fabricsh::linear::make_unsymmetric_solver()).solve(newton, {.line_search = false}).status ==
        NewtonStatus::converged);
  CHECK(std::abs(newton.trial()) < 1e-9);
  auto falls = make();
  const auto result = Descent(fabricsh::linear::make_symmetric_solver())
                          .solve(falls, {.tolerance = 1e-12, .max_iterations = 20000});
  CHECK(result.status == NewtonStatus::converged);
  CHECK(std::abs(falls.trial() - 1) < 1e-11);  // a residual of 1e-12 over a stiffness of 2
  CHECK(result.negative_pivots == 0);
  // A spring a million times as stiff as the load asks for: one more digit is one more step, not a thousand.
  Scalar stiff;
  stiff.force = [](double u, double) { return 1e-6 * (1 - u) - 1e6 * std::pow(std::max(0.0, u - 0.5), 3); };
  stiff.stiffness = [](double u) { return 1e-6 + 3e6 * std::pow(std::max(0.0, u - 0.5), 2); };
  const auto ends = Descent(fabricsh::linear::make_symmetric_solver())
                        .solve(stiff, {.tolerance = 1e-14, .max_iterations = 20000});
  CHECK(ends.status == NewtonStatus::converged);
  CHECK(ends.iterations < 100);
  CHECK(std::abs(stiff.force(stiff.trial(), 0)) < 1e-14);
}

TEST_CASE("forces that are beyond repair end the solve at once, in every solver") {
  const auto make = [] {
    Scalar problem;
    problem.force = [](double u, double t) { return t - u; };
    problem.stiffness = [](double) { return 1.0; };
    problem.broken = [](double u) { return u > 0.5; };
    problem.set_time(1);
    return problem;
  };
  auto one = make();
  CHECK(Newton(fabricsh::linear::make_unsymmetric_solver()).solve(one, {}).status == NewtonStatus::broken);
  CHECK(one.shares == std::vector{1.0});  // no shorter share was tried
  auto two = make();
  ArcLength arc(fabricsh::linear::make_unsymmetric_solver());
  two.set_time(0);
  CHECK(arc.solve(two, {}, {.time = 0, .landing = 1, .length = 1, .largest_step = 1}).status ==
        NewtonStatus::broken);
  CHECK(two.shares == std::vector{1.0});
  auto three = make();
  CHECK(Relaxation().solve(three, {}).status == NewtonStatus::broken);
  auto four = make();
  CHECK(Descent(fabricsh::linear::make_unsymmetric_solver()).solve(four, {.max_iterations = 20000}).status ==
        NewtonStatus::broken);
}

// Soft, but for a stiff piece of 1e-3 from u = 0.1 on, within which it balances the load.
TEST_CASE(
    "what switches between branches goes over to the neighbouring one, and else the line search finds it") {
  constexpr double soft = 0.02, stiff = 100, first = 0.1, width = 1e-3, load = 0.005;
  const auto force_on = [&](int branch, double u) {
    if (branch == 1) return soft * first + stiff * (u - first);
    return soft * u + (branch == 0 ? 0 : (stiff - soft) * width);
  };
  const auto branch_at = [&](double u) { return u < first ? 0 : u < first + width ? 1 : 2; };
  Scalar problem;
  problem.force = [&](double u, double) { return load - force_on(branch_at(u), u); };
  problem.stiffness = [&](double u) { return branch_at(u) == 1 ? stiff : soft; };
  const auto solve = [&] {
    return Newton(fabricsh::linear::make_unsymmetric_solver()).solve(problem, {.tolerance = 1e-12});
  };
  const NewtonResult searched = solve();
  CHECK(searched.status == NewtonStatus::converged);
  const double root = problem.trial();
  int branch = 0;
  problem.on_branch = [&](double u) {
    const int here = branch_at(u);
    branch = branch == 1 || here == branch ? here : 1;
    return std::pair{branch == 1 ? stiff : soft, load - force_on(branch, u)};
  };
  const NewtonResult followed = solve();
  CHECK(followed.status == NewtonStatus::converged);
  CHECK(followed.iterations == 2);
  CHECK(std::abs(problem.trial() - root) < 1e-12);
  problem.on_branch = [&](double u) { return std::pair{soft, load - soft * u}; };  // never gets there
  const NewtonResult neither = solve();
  CHECK(neither.status == NewtonStatus::converged);
  CHECK(neither.iterations > searched.iterations);
  CHECK(std::abs(problem.trial() - root) < 1e-12);
}

TEST_CASE("close to a solution with branches the last direction takes the factors of the one before") {
  Scalar problem;
  int tangents = 0;
  problem.force = [](double u, double) { return 0.5 - u - 0.1 * u * u * u; };
  problem.stiffness = [](double u) { return 1 + 0.3 * u * u; };
  problem.on_branch = [&](double u) {
    ++tangents;
    return std::pair{problem.stiffness(u), problem.force(u, 0)};
  };
  const NewtonResult result =
      Newton(fabricsh::linear::make_unsymmetric_solver()).solve(problem, {.tolerance = 1e-12});
  CHECK(result.status == NewtonStatus::converged);
  CHECK(result.iterations == 4);
  CHECK(tangents == 2);  // and that of the beginning
  CHECK(std::abs(problem.force(problem.trial(), 0)) < 1e-12);
}
