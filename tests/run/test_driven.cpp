// Nodes that are driven along a ramp: no acceleration is left in them after the kinks, so that what holds
// them carries the weight and nothing else, and the cloth beside them does what the closed form says.
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "mechanics/terms/cloth.hpp"
#include "mechanics/terms/inertia.hpp"
#include "run/dynamic.hpp"
#include "run/newmark.hpp"
#include "run/problem.hpp"
#include "run/problems.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

// Lifted from `start` on with `speed`, m/s, until `end`.
history::History lift(double start, double end, double speed) {
  return history::History::table(
      {{0, 0}, {start, 0}, {end, speed * (end - start)}, {10, speed * (end - start)}});
}

}  // namespace

TEST_CASE(
    "the support of nodes on a ramp carries the weight and no inertia, between its kinks and after them") {
  const double weight = 0.4 * 0.1 * 590 * 0.38e-3 * 9.81, speed = 0.7;
  for (const auto scheme : {run::Scheme::explicit_steps, run::Scheme::implicit_steps}) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.4, 0.1, 4, 1));
    auto card = isotropic(8e6, 0.2, 0.38e-3);
    card.density = 590;
    auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
    model::Components up;
    up[2] = lift(0.003, 0.0075, speed);
    m->fix("all", model::parse_freedoms("x y rotation"));
    m->move("all", up);
    m->gravity(model::steady({0, 0, -9.81}));
    run::DynamicOptions options{.duration = 0.01, .scheme = scheme};
    if (scheme == run::Scheme::implicit_steps) options.step = 2.5e-4;
    const auto a = run::make_dynamic(m, options, quiet());
    for (const double time : {0.002, 0.005, 0.0065, 0.009}) {
      a->advance(time);
      INFO("at " << time);
      // The motion is differenced twice.
      CHECK(a->reaction("all").z() == Approx(weight).epsilon(1e-5));
      CHECK(a->node(3).v.z() == Approx(time > 0.003 && time < 0.0075 ? speed : 0).margin(1e-9));
    }
    // The work of the supports is that of lifting, and the weight takes it.
    CHECK(std::abs(a->energy().surplus()) < 1e-6 * weight * speed * 0.0045);
  }
}

TEST_CASE(
    "on a ramp driven nodes have the ramp's velocity and no acceleration along it, before a kink and behind "
    "it") {
  // Driven along an oblique direction, free across it, where gravity pulls: a is what is left of gravity
  // across the direction, v is g t across and the speed of the ramp along it.
  const Vec3 along = Vec3(2, -1, 2) / 3, g(4, 1, -9);
  const Vec3 across = g - g.dot(along) * along;
  const double speed = 0.7, dt = 3e-4;
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.4, 0.1, 2, 1));
  auto m = std::make_shared<model::Model>(mesh, isotropic(8e6, 0.2, 0.38e-3), model::Options{});
  model::Components way;
  way[0] = lift(2 * dt, 5 * dt, speed);
  m->move("all", way, model::frame_from(along, Vec3::UnitY()));
  m->fix("all", model::parse_freedoms("rotation"));
  m->gravity(model::steady({g.x(), g.y(), g.z()}));
  m->validate();
  mechanics::Assembly assembly(*m);
  const auto& inertia = assembly.terms().add(
      std::make_unique<mechanics::Inertia>(assembly.cloth().mass(), assembly.cloth().rotary_inertia(false)));
  run::Newmark newmark(assembly, inertia, {0.5, 0.25, 0});
  const run::EquilibriumProblem::Poll no_poll;
  run::EquilibriumProblem problem(assembly, newmark, no_poll);
  problem.set_time(0);
  REQUIRE(assembly.forces({}));
  assembly.commit(0);
  const std::vector<double> still(3 * mesh->nodes.size(), 0);
  problem.start({still, still});
  solver::Newton newton(linear::make_unsymmetric_solver());
  for (int i = 1; i <= 8; ++i) {
    problem.set_time(i * dt);
    REQUIRE(newton.solve(problem, {}).status == solver::NewtonStatus::converged);
    problem.commit(i * dt);
    const Vec3 v = i * dt * across + (i > 2 && i <= 5 ? speed : 0) * along;
    INFO("step " << i);
    for (std::size_t n = 0; n < mesh->nodes.size(); ++n) {
      const Eigen::Map<const Vec3> v_n(newmark.committed().v.x.data() + 3 * n),
          a_n(newmark.committed().a.x.data() + 3 * n);
      CHECK((v_n - v).norm() < 1e-9);
      CHECK((a_n - across).norm() < 1e-8 * g.norm());
    }
  }
}

TEST_CASE("a mass drawn along on a ramp swings as sin does, in any phase of the ramp") {
  // A strip of two elements whose left end goes with the constant speed v from t0 on: the right end, of mass
  // m on a spring k, follows with u = v (t - t0) - (v / w) sin w (t - t0), w^2 = k / m. The middle nodes are
  // tied to the right ones, so that there is one degree of freedom: k = E b t / h, m = the mass of all nodes
  // but the left (lumped): 3/4.
  const double E = 2e6, b = 0.03, t = 0.5e-3, h = 0.02, density = 800, v = 0.05, t0 = 0.004;
  const double stiffness = E * b * t / h, mass = density * b * t * 1.5 * h, w = std::sqrt(stiffness / mass);
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(2 * h, b, 2, 1));
  mesh->define("follows", nodes_where(*mesh, [&](const Vec3& X) { return X.x() > h / 2; }));
  auto card = isotropic(E, 0, t);
  card.density = density;
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->fix("all", model::parse_freedoms("y z rotation"));
  m->add<model::Tie>({model::TieKind::equal, "follows", {}, model::parse_freedoms("x")});
  model::Components along;
  along[0] = lift(t0, 1, v);
  m->move("left", along);
  const double period = 2 * std::numbers::pi / w, step = period / 400;
  run::DynamicOptions options{.duration = t0 + 2.3 * period, .scheme = run::Scheme::implicit_steps};
  options.step = step;
  const auto a = run::make_dynamic(m, options, quiet());
  for (const double phase : {0.25, 0.6, 1.1, 2.3}) {
    a->advance(t0 + phase * period);
    const double angle = 2 * std::numbers::pi * phase, amplitude = v / w;
    const double wanted = amplitude * (angle - std::sin(angle));
    // The trapezoidal rule's period is longer by (w dt)^2 / 12 = 2e-5; Green-Lagrange strain v / w / h = 1e-3
    // adds half as much to the stiffness.
    CHECK(std::abs(a->node(2).u.x() - wanted) < 3e-3 * amplitude);
    const double force = stiffness * (wanted - amplitude * angle);  // of the spring on the left end
    CHECK(std::abs(-a->reaction("left").x() - force) < 5e-3 * stiffness * amplitude);
  }
}
