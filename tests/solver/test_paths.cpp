// Steps along an arc through limit points, and dynamic relaxation, against paths that are known.
#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.hpp"
#include "solver/relaxation.hpp"
#include "solver/scalar.hpp"

using namespace fabricsh;
using namespace fabricsh::solver;
using fabricsh::test::Scalar;

namespace {

// The path t = f(u) = u^3 - 3/2 u^2 + 0.6 u: it rises to a maximum, falls to a minimum and rises again.
double snap(double u) { return u * (u * (u - 1.5) + 0.6); }
double slope(double u) { return u * (3 * u - 3) + 0.6; }

Scalar snapping() {
  Scalar problem;
  problem.force = [](double u, double t) { return t - snap(u); };
  problem.stiffness = slope;
  return problem;
}

struct Point {
  double u, t;
  Index negative;
};

// Steps of one length from u = 0 to the time 0.3.
std::vector<Point> follow(Scalar& problem, ArcLength& arc, double length, int most) {
  std::vector<Point> path;
  double time = 0;
  for (int i = 0; i < most; ++i) {
    const auto result = arc.solve(problem, {.tolerance = 1e-13},
                                  {.time = time, .landing = 0.3, .length = length, .largest_step = 0.3});
    REQUIRE(result.status == NewtonStatus::converged);
    arc.committed();
    problem.committed = problem.trial();
    time = result.time;
    path.push_back({problem.trial(), time, result.negative_pivots});
    if (result.landed) break;
  }
  return path;
}

}  // namespace

TEST_CASE("steps along an arc pass a limit point and the way back, and land where they are told") {
  auto problem = snapping();
  ArcLength arc(linear::make_unsymmetric_solver());
  constexpr double length = 0.04;
  const auto path = follow(problem, arc, length, 60);
  double u = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    INFO("step " << i << ", u = " << path[i].u << ", t = " << path[i].t);
    CHECK(std::abs(path[i].t - snap(path[i].u)) < 1e-12);  // on the path
    // Every step but the last has the length that was asked for.
    if (i + 1 < path.size()) CHECK(std::abs(path[i].u - u - length) < 1e-12);
    CHECK(path[i].u > u);  // never back
    u = path[i].u;
  }
  CHECK(path.back().t == 0.3);
  CHECK(std::abs(snap(u) - 0.3) < 1e-12);
  // Time falls between the two limit points, u = 1/2 -+ sqrt(1/20), and only there.
  const double first = 0.5 - std::sqrt(0.05), second = 0.5 + std::sqrt(0.05);
  int falls = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    if (path[i - 1].u > first && path[i].u < second) {
      CHECK(path[i].t < path[i - 1].t);
      CHECK(path[i].negative == 1);
      ++falls;
    }
  CHECK(falls >= 9);
}

TEST_CASE("a path goes on after a restart with the direction that it had; forgotten, it starts forwards") {
  const double past = 0.6;  // u, on the falling branch
  const auto step = [&](ArcLength& arc) {
    auto problem = snapping();
    problem.committed = past;
    const auto result = arc.solve(problem, {.tolerance = 1e-13},
                                  {.time = snap(past), .landing = 0.3, .length = 0.02, .largest_step = 0.3});
    REQUIRE(result.status == NewtonStatus::converged);
    return problem.trial();
  };
  auto problem = snapping();
  problem.committed = 0.55;
  ArcLength arc(linear::make_unsymmetric_solver());
  // The first step of all goes forwards in time, on the falling branch towards smaller u.
  CHECK(step(arc) < past);
  arc.committed();
  // It remembers that way now; kept and read, another goes on the same.
  CHECK(step(arc) < past);
  Archive kept;
  arc.keep(kept);
  ArcLength other(linear::make_unsymmetric_solver());
  Archive read(kept.bytes());
  other.keep(read);
  CHECK(step(other) == step(arc));
  other.forget();
  CHECK(step(other) < past);
}

TEST_CASE("a step along an arc is no longer than its largest step in time allows") {
  auto problem = snapping();
  ArcLength arc(linear::make_unsymmetric_solver());
  const auto result = arc.solve(problem, {.tolerance = 1e-13},
                                {.time = 0, .landing = 0.3, .length = 10, .largest_step = 1e-3});
  CHECK(result.status == NewtonStatus::converged);
  // The predictor: dt = 1e-3, and with the slope 0.6 there the length 1e-3 / 0.6.
  CHECK(std::abs(result.length - 1e-3 / 0.6) < 1e-15);
  CHECK(std::abs(problem.trial() - result.length) < 1e-12);
}

TEST_CASE("dynamic relaxation needs no tangent that is positive, and ends in the nearest minimum downhill") {
  // The energy u^4/4 - u^2/2: a maximum at 0, minima at -1 and 1. The masses are those of a stiffness of 20,
  // above all that the motion meets, as the masses of a mesh are by the stiffness of each node's neighbours.
  for (const double from : {0.01, -0.01, 1.8}) {
    Scalar problem;
    problem.force = [](double u, double) { return u - u * u * u; };
    problem.stiffness = [](double) { return 20.0; };
    problem.committed = from;
    const auto result = Relaxation().solve(problem, {.tolerance = 1e-11});
    INFO("from " << from);
    REQUIRE(result.status == NewtonStatus::converged);
    CHECK(std::abs(problem.trial() - std::copysign(1, from)) < 1e-10);
    CHECK(result.residuals.back() <= 1e-11);
  }
}

TEST_CASE("dynamic relaxation takes the steps of its kinetic damping on a spring, by the closed form") {
  // r = -k u with m = 1.1 k / 4 and a step of 1: from rest at u = 1 the first kick is v = -k u / m = -1 /
  // 0.275, halved at the start, and a peak of kinetic energy stops the motion.
  Scalar problem;
  problem.force = [](double u, double) { return -5 * u; };
  problem.stiffness = [](double) { return 5.0; };
  problem.committed = 1;
  const auto result = Relaxation().solve(problem, {.tolerance = 1e-12});
  CHECK(result.status == NewtonStatus::converged);
  CHECK(std::abs(problem.trial()) < 1e-12);
  CHECK(result.iterations < 400);
  Scalar first = problem;
  first.committed = 1;
  Relaxation().solve(first, {.tolerance = 1e-12, .max_iterations = 1});
  CHECK(std::abs(first.trial() - (1 - 1 / 0.55)) < 1e-14);
  // Its residuals fall from peak to peak.
  CHECK(std::is_sorted(result.residuals.rbegin(), result.residuals.rend()));
  Scalar again = problem;
  again.committed = 1;
  CHECK(Relaxation().solve(again, {.tolerance = 1e-12, .max_iterations = 2}).status ==
        NewtonStatus::too_many_iterations);
}
