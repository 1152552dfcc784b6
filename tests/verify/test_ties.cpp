// Ties in a run: a periodic patch, a rigid grip that is pulled, a rigid edge turned by a moment.
#include <numbers>

#include "../run/problems.hpp"
#include "catch.hpp"
#include "strip.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using model::TieKind;

namespace {

model::FixedFreedoms tied(const char* text) { return model::parse_freedoms(text, "tie"); }

model::Components ramp(int axis, double value) {
  model::Components c;
  c[axis] = history::History::table({{0, 0}, {1, value}});
  return c;
}

}  // namespace

TEST_CASE("patch test through periodic ties: a distorted cell stretched and sheared is in one strain") {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.08, 4, 4));
  for (const mesh::Index n : {6, 7, 8, 11, 12, 13, 16, 17, 18})
    mesh->nodes[n] +=
        0.005 * Vec3(std::sin(5.0 * static_cast<double>(n)), std::cos(3.0 * static_cast<double>(n)), 0);
  mesh->define("first", mesh::NodeSet{0});
  mesh->define("along", mesh::NodeSet{4});
  mesh->define("across", mesh::NodeSet{20});
  model::Options options;
  options.warp = [](const Vec3&) { return model::Direction(25.0); };
  auto m = std::make_shared<model::Model>(mesh, isotropic(1e7, 0.3, 1e-3), options);
  m->add<model::Tie>({TieKind::periodic, "left", "right", tied("x y z rotation")});
  m->add<model::Tie>({TieKind::periodic, "bottom", "top", tied("x y z rotation")});
  m->fix("first", model::parse_freedoms("x y z"));
  m->move("along", ramp(0, 0.01));
  m->fix("along", model::parse_freedoms("y z"));
  m->move("across", ramp(0, 0.004));
  m->fix("across", model::parse_freedoms("y z"));
  run::Static a(m, {.duration = 1, .step = 0.5, .tolerance = 1e-12}, quiet());
  a.solve();
  Mat3 F = Mat3::Identity();
  F(0, 0) = 1.1;
  F(0, 1) = 0.05;
  for (std::size_t n = 0; n < mesh->nodes.size(); ++n)
    CHECK((a.node(static_cast<mesh::Index>(n)).x - F * mesh->nodes[n]).norm() < 1e-12);
  // The reactions at the driven corners carry the whole cell's: no force is left over.
  CHECK(a.reaction("all").norm() < 1e-9 * a.reaction("along").norm());
  CHECK(a.energy().error < 0.02);  // trapezoids of two steps
}

TEST_CASE("a rigid edge pulled by the force of a clamped grip moves as that grip does") {
  Strip s;
  s.card = isotropic(1e7, 0.3, 0.4e-3);
  s.grips = Grips::clamped;
  s.stroke = 10e-3;
  run::Static grip(make_strip(s), {.duration = 1, .step = 0.1, .tolerance = 1e-12}, quiet());
  grip.solve();
  const double force = grip.reaction("top").y();

  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(strip_width, strip_length, s.nx, s.ny));
  model::Options options;
  options.warp = [](const Vec3&) { return model::Direction(90.0); };
  auto m = std::make_shared<model::Model>(mesh, s.card, options);
  m->fix("bottom", model::parse_freedoms("x y z rotation"));
  m->add<model::Tie>({TieKind::rigid, "top", {}, {}});
  m->force("top", ramp(1, force));
  run::Static a(m, {.duration = 1, .step = 0.1, .tolerance = 1e-12}, quiet());
  a.solve();
  for (const auto n : mesh->set("all")) CHECK((a.node(n).x - grip.node(n).x).norm() < 1e-10);
  std::printf("  rigid edge under %.4f N: %.9f mm for the grip's 10\n", force, 1e3 * a.node(39).u.y());
}

TEST_CASE("a strip rolled by a moment on its rigid end closes as under the same moment spread") {
  // 2 pi B / L rolls a strip of rigidity B to a circle; here half of it, a half circle [sze2004,
  // section 4.2].
  const double E = 1.2e6, t = 0.1, L = 12, M = E * t * t * t / 12 * std::numbers::pi / L;
  const auto roll = [&](bool rigid) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(L, 1, 16, 2));
    auto m = std::make_shared<model::Model>(mesh, isotropic(E, 0, t), model::Options{});
    m->fix("left", model::parse_freedoms("x y z rotation"));
    if (rigid) m->add<model::Tie>({TieKind::rigid, "right", {}, {}});
    m->add<model::MomentLoad>({"right", ramp(1, -M)});
    run::Static a(m, {.duration = 1, .step = 0.1}, quiet());
    a.solve();
    int iterations = 0;
    for (const auto& step : a.steps()) iterations += step.iterations;
    std::printf("  %s end: %d iterations, tip at %.6f %.6f %.6f\n", rigid ? "rigid" : "free", iterations,
                a.node(16).x.x(), a.node(16).x.y(), a.node(16).x.z());
    return a.node(16).x;
  };
  const Vec3 rigid = roll(true), free = roll(false);
  CHECK((rigid - free).norm() < 1e-6 * L);
  // A polygon of 16 chords, each turned by pi / 16 against the last. Its stress linear in Green-Lagrange
  // strain, the plate bends by 0.3 (k t)^2 = 2e-4 more than B k = M says.
  const double h = L / 16, turn = std::numbers::pi / 16;
  CHECK(rigid.z() == Approx(h * (1 - std::cos(16 * turn)) / (2 * std::sin(turn / 2))).epsilon(5e-4));
}

TEST_CASE("a moment about the normal of a rigid end turns the sheet in its plane") {
  // The director has no rotation about itself; the body has. In-plane bending of a beam, quadratic end.
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, 0.1, 20, 2));
  const double E = 1e6, t = 0.01, b = 0.1, M = 1e-3 * E * t * b * b * b / 12;  // curvature 1e-3
  auto m = std::make_shared<model::Model>(mesh, isotropic(E, 0, t), model::Options{});
  m->fix("left", model::parse_freedoms("x y z rotation"));
  m->add<model::Tie>({TieKind::rigid, "right", {}, {}});
  m->add<model::MomentLoad>({"right", ramp(2, M)});
  run::Static a(m, {.duration = 1, .step = 1}, quiet());
  a.solve();
  CHECK(a.node(41).u.y() == Approx(0.5e-3).epsilon(1e-4));
  CHECK(a.steps().back().iterations <= 4);
}

TEST_CASE("an edge kept straight under a pull stays straight, and its ends carry the reaction") {
  Strip s;
  s.card = blend();
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(strip_width, strip_length, 4, 6));
  mesh->define("ends", mesh::NodeSet{30, 34});
  model::Options options;
  options.warp = [](const Vec3&) { return model::Direction(60.0); };
  auto m = std::make_shared<model::Model>(mesh, s.card, options);
  m->fix("all", model::parse_freedoms("z rotation"));
  m->fix("bottom", model::parse_freedoms("x y"));
  m->add<model::Tie>({TieKind::straight, "top", {}, tied("x y")});
  m->move("ends", ramp(1, 5e-3));
  run::Static a(m, {.duration = 1, .step = 0.1}, quiet());
  a.solve();
  CHECK(std::abs(a.node(32).u.y() - 5e-3) < 1e-15);
  CHECK(a.node(32).x.x() == Approx((a.node(30).x.x() + a.node(34).x.x()) / 2));
  CHECK(a.reaction("ends").y() > 0);
  CHECK(a.reaction("ends").y() == Approx(-a.reaction("bottom").y()).epsilon(1e-9));
}
