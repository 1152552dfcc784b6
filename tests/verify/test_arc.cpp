// The arc length on cloth: yarns slacken and switch at once when an arch buckles, at strains near zero.
#include "catch.hpp"
#include "strip.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

// An arch 200 mm wide and 20 mm high, 50 mm deep, clamped at both feet; its crown is pushed down by a force
// or moved down.
struct Arch {
  std::shared_ptr<model::Model> model;
  mesh::Index crown;
};

Arch make_arch(double force, double move) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.2, 0.05, 8, 2));
  mesh->map(
      [](const Vec3& X) { return Vec3(X.x(), X.y(), 0.02 * std::sin(std::numbers::pi * X.x() / 0.2)); });
  mesh->define("crown", [](const Vec3& X) { return std::abs(X.x() - 0.1) < 1e-9; });
  model::Options options;
  options.warp = [](const Vec3&) { return model::Direction(Vec3(Vec3::UnitX())); };
  auto m = std::make_shared<model::Model>(mesh, denim(), options);
  for (const char* foot : {"left", "right"}) m->fix(foot, model::parse_freedoms("x y z rotation"));
  model::Components down;
  down[2] = history::History::ramp(force != 0 ? force : move, 1);
  if (force != 0)
    m->force("crown", down);
  else
    m->move("crown", down);
  return {m, mesh->set("crown")[1]};
}

}  // namespace

TEST_CASE("an arch of cloth is pushed through along the arc, without a cut at every yarn that switches") {
  const Arch arch = make_arch(-2, 0);
  run::Static a(arch.model, {.duration = 1, .step = 0.05, .control = run::Control::arc},
                std::make_shared<Notices>());
  double last = 0;
  bool turned = false;
  a.every_step([&](run::Run& run) {
    turned = turned || run.time() < last;
    last = run.time();
  });
  a.solve();
  int iterations = 0, cuts = 0;
  for (const auto& step : a.steps()) {
    iterations += step.iterations;
    cuts += step.cuts;
  }
  std::printf("  arch of denim: %zu steps, %d iterations, %d cuts\n", a.steps().size(), iterations, cuts);
  CHECK(turned);  // past a limit point and back
  // Without a line search: 58 cuts and 33 iterations for each of its steps.
  CHECK(cuts <= 5);
  CHECK(iterations < 10 * static_cast<int>(a.steps().size()));
}
