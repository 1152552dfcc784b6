// Following a path through limit points: the hinged roof of [sze2004, section 4.7].
#include "catch.hpp"
#include "message_of.hpp"
#include "run/problems.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using run::Control;
using run::Static;
using run::StaticOptions;

namespace {

struct Point {
  double load, sag;  // N, mm
};

std::vector<Point> follow(const Roof& roof, StaticOptions options) {
  Static a(make_roof(roof), options, quiet());
  std::vector<Point> path;
  a.every_step([&](run::Run& run) { path.push_back({roof.load_at(run.time()), sag(run)}); });
  a.solve();
  std::printf("  %g mm, %s: %zu steps, ", roof.thickness, options.control == Control::arc ? "arc" : "load",
              a.steps().size());
  int iterations = 0, cuts = 0;
  for (const auto& s : a.steps()) {
    iterations += s.iterations;
    cuts += s.cuts;
  }
  std::printf("%d iterations, %d cuts, damping %.2g of the work\n", iterations, cuts,
              a.energy().damping / a.energy().external);
  return path;
}

// Load at a given sag, on the straight lines between points.
double load_at(const std::vector<Point>& path, double w) {
  for (std::size_t i = 1; i < path.size(); ++i)
    if (path[i - 1].sag <= w && w < path[i].sag) {
      const double s = (w - path[i - 1].sag) / (path[i].sag - path[i - 1].sag);
      return path[i - 1].load + s * (path[i].load - path[i - 1].load);
    }
  return NAN;
}

}  // namespace

TEST_CASE("arc length: the 12.7 mm roof goes through its limit points and lands on the duration") {
  const Roof roof;
  const auto path = follow(roof, {.duration = 1, .step = 0.05, .control = Control::arc});
  double top = 0, bottom = 1e9;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path[i].sag < 15) top = std::max(top, path[i].load);
    if (path[i].sag > 12) bottom = std::min(bottom, path[i].load);
    CHECK(path[i].sag > path[i - 1].sag);
  }
  CHECK(path.back().load == 3000);
  CHECK(std::abs(top / 2230 - 1) < 0.05);
  CHECK(bottom < 0.5 * top);
}

TEST_CASE("arc length and load control give the same path where both can go") {
  const Roof low{.load = 1500};
  const auto arc = follow(low, {.duration = 1, .step = 0.02, .control = Control::arc}),
             steps = follow(low, {.duration = 1, .step = 0.02});
  CHECK(arc.back().load == 1500);
  CHECK(std::abs(arc.back().sag / steps.back().sag - 1) < 1e-8);
  for (const double w : {1.0, 2.0, 3.0}) CHECK(std::abs(load_at(arc, w) / load_at(steps, w) - 1) < 3e-3);
}

TEST_CASE("arc length: the 6.35 mm roof snaps back, in load and in displacement") {
  // The path goes down to negative loads: the history begins below the lowest of them.
  const Roof thin{.thickness = 6.35, .load = 1000, .cells = 16, .path = {{0, -0.6}, {1, 1.2}}};
  const auto path = follow(thin, {.duration = 1, .step = 0.02, .control = Control::arc});
  double top = 0, bottom = 1e9;
  int back = 0;
  for (std::size_t i = 2; i < path.size(); ++i) {
    if (path[i].sag < 15) top = std::max(top, path[i].load);
    bottom = std::min(bottom, path[i].load);
    if (path[i].sag < path[i - 1].sag && path[i].load < path[i - 1].load) ++back;
  }
  std::printf("  6.35 mm: limits %.1f and %.1f N, %d steps in which load and sag fall\n", top, bottom, back);
  CHECK(back >= 2);
  CHECK(std::abs(top / 585 - 1) < 0.02);
  CHECK(bottom < -300);
  CHECK(path.back().load == 1200);
}

TEST_CASE("at a limit point load control, relaxation and stabilisation jump to where the path goes on") {
  const Roof thin{.thickness = 6.35, .load = 1200, .cells = 6};
  auto below = thin;
  below.path = {{0, -0.8}, {1, 1}};
  const auto path = follow(below, {.duration = 1, .step = 0.02, .control = Control::arc});
  const auto stable = follow(thin, {.duration = 1, .step = 0.1});
  CHECK(std::abs(stable.back().sag / path.back().sag - 1) < 1e-6);
  const auto relaxed = follow(thin, {.duration = 1, .step = 0.1, .method = run::Method::either});
  CHECK(std::abs(relaxed.back().sag / path.back().sag - 1) < 1e-6);
  const auto damped = follow(thin, {.duration = 1, .step = 0.1, .stabilise = run::usual_stabilisation});
  CHECK(std::abs(damped.back().sag / path.back().sag - 1) < 1e-3);
}

TEST_CASE("a path that turns back to time 0 says so, and what to do") {
  const Roof thin{.thickness = 6.35, .load = 1000};
  try {
    follow(thin, {.duration = 1, .step = 0.05, .control = Control::arc});
    FAIL("no failure");
  } catch (const NumericalFailure& failure) {
    const std::string message = failure.what();
    says(message, "turned back to time 0");
    says(message, "\nTry: a history that begins below");
    CHECK(std::count(message.begin(), message.end(), '\n') == 1);
  }
}

TEST_CASE("a path goes forward again at a kink of its history") {
  const Roof low{.load = 1500, .path = {{0, 0}, {1, 1}, {2, 0}}};
  const auto path = follow(low, {.duration = 2, .step = 0.05, .control = Control::arc});
  double top = 0;
  for (const auto& p : path) top = std::max(top, p.load);
  CHECK(top == 1500);
  CHECK(path.back().load == 0);
  CHECK(std::abs(path.back().sag) < 1e-6);
}

TEST_CASE("driven supports along an arc: the roof's middle pushed down gives the same path as loads") {
  const Roof roof;
  const auto loaded = follow(roof, {.duration = 1, .step = 0.01, .control = Control::arc});
  for (const Control control : {Control::load, Control::arc}) {
    auto m = make_roof({.load = 0});
    model::Components down;
    down[2] = history::History::ramp(-25, 1);
    m->move("centre", down);
    Static a(m, {.duration = 1, .step = 0.02, .control = control}, quiet());
    int checked = 0;
    a.every_step([&](run::Run& run) {
      const double w = sag(run), want = load_at(loaded, w);
      if (w < 1 || std::isnan(want)) return;
      ++checked;
      CHECK(std::abs(-4 * run.reaction("centre").z() - want) < 15);  // N, chords of `loaded`
    });
    a.solve();
    CHECK(a.time() == 1);
    CHECK(checked > 20);
  }
}

TEST_CASE("an event along an arc is found inside a step") {
  const Roof roof;
  Static a(make_roof(roof), {.duration = 1, .step = 0.05, .control = Control::arc}, quiet());
  double at = 0;
  a.event([](run::Run& run) { return sag(run) - 15; }, 1e-9,
          [&](run::Run& run) {
            at = sag(run);
            run.stop("there");
          });
  a.solve();
  CHECK(std::abs(at - 15) < 1e-7);
  CHECK(a.steps().back().step < 0);  // between the limit points: time goes down
}

TEST_CASE("a snapshot along an arc goes on as before, bit by bit") {
  const Roof roof;
  Static a(make_roof(roof), {.duration = 1, .step = 0.05, .control = Control::arc}, quiet());
  for (int i = 0; i < 17; ++i) a.step();
  const auto here = a.snapshot();
  std::vector<double> first, second;
  for (auto* sags : {&first, &second}) {
    a.restore(*here);
    for (int i = 0; i < 6; ++i) {
      a.step();
      sags->push_back(sag(a));
    }
  }
  CHECK(first == second);
}
