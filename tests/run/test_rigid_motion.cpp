// Rigid sets in implicit motion: what a free body keeps, against an independent solution of Euler's
// equations, and together with cloth.
#include <Eigen/Geometry>
#include <numbers>

#include "catch.hpp"
#include "mechanics/terms/cloth.hpp"
#include "run/dynamic.hpp"
#include "run/problems.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using run::DynamicOptions;
using run::make_dynamic;
using run::Run;
using run::Scheme;

namespace {

constexpr double kFreeWidth = 0.13, kFreeHeight = 0.07;

// A sheet about the origin, whose nodes in the set move as one.
std::shared_ptr<model::Model> body(const std::string& set, const Vec3& spin, const Vec3& linear,
                                   int across = 3) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(kFreeWidth, kFreeHeight, 5, across));
  mesh->map([](const Vec3& X) { return Vec3(X.x() - 0.4 * kFreeWidth, X.y() - 0.5 * kFreeHeight, 0); });
  mesh->define("part", nodes_where(*mesh, [](const Vec3& X) { return X.x() < 1e-6; }));
  auto card = isotropic(8e6, 0.3, 0.5e-3);
  card.density = 480;
  model::Options options;
  options.warp = [](const Vec3&) { return model::Direction(Vec3::UnitX()); };
  auto m = std::make_shared<model::Model>(mesh, card, options);
  m->add<model::Tie>({model::TieKind::rigid, set, "", {}});
  m->add<model::InitialVelocity>({"all", linear, spin, Vec3(0.1 * kFreeWidth, 0, 0)});
  return m;
}

struct Kept {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
};

Kept kept_by(const run::Dynamic& a) {
  Kept sum;
  const auto &mass = a.assembly().cloth().mass(), &rotary = a.assembly().cloth().rotary_inertia(false);
  for (std::size_t n = 0; n < mass.size(); ++n) {
    const auto node = a.node(static_cast<mesh::Index>(n));
    const Vec3 w(a.rates().d[3 * n], a.rates().d[3 * n + 1], a.rates().d[3 * n + 2]);
    sum.linear += mass[n] * node.v;
    sum.angular += mass[n] * node.x.cross(node.v) + rotary[n] * node.n.cross(w);
  }
  return sum;
}

std::shared_ptr<run::Dynamic> implicit(std::shared_ptr<model::Model> m, double duration, double step,
                                       double hht = 0) {
  return make_dynamic(std::move(m),
                      {.duration = duration, .step = step, .scheme = Scheme::implicit_steps, .hht = hht},
                      quiet());
}

// The orientation of a free body with these nodes, directors and masses, after `duration`: the angular
// momentum is constant in space, R' = (I(R)^-1 L) x R, by the classical Runge-Kutta method.
Mat3 turned(const run::Dynamic& a, const Vec3& spin, double duration) {
  const auto &mass = a.assembly().cloth().mass(), &rotary = a.assembly().cloth().rotary_inertia(false);
  const auto& X = a.assembly().dofs().reference();
  double total = 0;
  Vec3 centre = Vec3::Zero();
  for (std::size_t n = 0; n < X.size(); ++n) {
    total += mass[n];
    centre += mass[n] * X[n];
  }
  Mat3 I = Mat3::Zero();
  const auto add = [&](double m, const Vec3& r) {
    I += m * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
  };
  for (std::size_t n = 0; n < X.size(); ++n) {
    add(mass[n], X[n] - centre / total);
    add(rotary[n], Vec3::UnitZ());
  }
  const Vec3 L = I * spin;
  const auto rate = [&](const Mat3& R) {
    const Vec3 w = R * I.inverse() * R.transpose() * L;
    Mat3 W;
    W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
    return Mat3(W * R);
  };
  Mat3 R = Mat3::Identity();
  const int steps = 20000;
  const double h = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const Mat3 a1 = rate(R), a2 = rate(R + h / 2 * a1), a3 = rate(R + h / 2 * a2), a4 = rate(R + h * a3);
    R += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return R;
}

// About each axis, in steps of so many to a turn, with and without damping of high frequencies.
void check_kept(double turns, std::initializer_list<int> steps_per_turn, int across) {
  for (const double hht : {0.0, -0.15})
    for (const auto& spin : {Vec3(0, 0, 13), Vec3(0.2, 12, 0.3), Vec3(11, 0.1, 0)})
      for (const int per_turn : steps_per_turn) {
        CAPTURE(hht, spin.transpose(), per_turn);
        const double turn = 2 * std::numbers::pi / spin.norm();
        const auto a =
            implicit(body("all", spin, Vec3(0.4, -0.1, 0.2), across), turns * turn, turn / per_turn, hht);
        Kept first;
        double worst = 0;
        a->every_step([&](Run& r) {
          const Kept now = kept_by(static_cast<run::Dynamic&>(r));
          if (r.time() == 0) first = now;
          worst = std::max({worst, (now.linear - first.linear).norm() / first.linear.norm(),
                            (now.angular - first.angular).norm() / first.angular.norm(),
                            std::abs(r.energy().kinetic / r.energy().initial - 1)});
        });
        a->solve();
        CHECK(worst < 1e-6);  // Newton's tolerance of every step adds up
        CHECK(std::abs(a->energy().damping) < 1e-6 * a->energy().initial);
      }
}

}  // namespace

TEST_CASE("a rigid sheet keeps energy and momenta over many turns, about any axis, at any step", "[many]") {
  check_kept(5, {24, 75}, 1);
  check_kept(1, {240}, 1);
}

TEST_CASE("a rigid sheet of more nodes keeps them over many turns of short steps", "[long]") {
  check_kept(5, {24, 75, 240}, 3);
}

TEST_CASE("a tumbling rigid sheet turns as Euler's equations have it, to the second order") {
  const Vec3 spin(0.3, 12, 0.5);
  const double duration = 1.1;
  double errors[2];
  for (int k = 0; k < 2; ++k) {
    const auto a = implicit(body("all", spin, Vec3::Zero()), duration, duration / (k == 0 ? 200 : 400));
    const Mat3 R = turned(*a, spin, duration);
    a->solve();
    const auto& X = a->assembly().dofs().reference();
    const Vec3 arm = X[23] - X[0], now = a->node(23).x - a->node(0).x;
    errors[k] = std::max((now - R * arm).norm() / arm.norm(), (a->node(5).n - R.col(2)).norm());
  }
  INFO(errors[0] << " " << errors[1]);
  CHECK(errors[0] < 0.2);
  CHECK(errors[0] / errors[1] > 3.5);
  CHECK(errors[0] / errors[1] < 4.5);
}

TEST_CASE("a rigid part with cloth at its side closes the ledger, and damping that the scheme has is in it") {
  const Vec3 spin(1, 2, 14);
  const double turn = 2 * std::numbers::pi / spin.norm();
  double errors[2], swings[2];
  for (int k = 0; k < 2; ++k) {
    const auto a = implicit(body("part", spin, Vec3(0.2, 0, 0.1)), 2 * turn, turn / (200 << 2 * k));
    Kept first;
    double swing = 0;
    a->every_step([&](Run& r) {
      const Kept now = kept_by(static_cast<run::Dynamic&>(r));
      if (r.time() == 0) first = now;
      swing = std::max(swing, (now.angular - first.angular).norm() / first.angular.norm());
    });
    a->solve();
    errors[k] = a->energy().error;
    swings[k] = swing;
  }
  INFO(errors[0] << " " << errors[1] << "; " << swings[0] << " " << swings[1]);
  CHECK(errors[0] < 0.02);
  CHECK(errors[1] < 2e-3);
  CHECK(swings[0] < 0.02);
  CHECK(swings[1] < swings[0] / 8);
  const auto damped = implicit(body("part", spin, Vec3(0.2, 0, 0.1)), 2 * turn, turn / 400, -0.1);
  damped->solve();
  const auto e = damped->energy();
  CHECK(e.damping > 0);
  CHECK(e.error < 1e-3);
  CHECK(e.kinetic + e.stored + e.damping < 1.001 * e.initial);
}

TEST_CASE("a rigid body on a spring of cloth goes on with the same bits after a snapshot") {
  const auto make = [] { return implicit(body("part", Vec3(1, 2, 14), Vec3::Zero()), 0.1, 1e-3, -0.05); };
  const auto a = make();
  a->advance(0.04);
  const std::string kept = a->kept();
  a->solve();
  const auto b = make();
  b->resume(kept);
  b->solve();
  CHECK(a->node(9).x == b->node(9).x);
  CHECK(a->energy().damping == b->energy().damping);
}
