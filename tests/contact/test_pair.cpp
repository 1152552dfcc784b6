// Energy, gradient and Hessian of each kind of pair by slope; friction's force, loss and exact Jacobian by
// slope; invariance, and what the counting of places promises.
#include <string>

#include "catch.hpp"
#include "contact/pair.hpp"
#include "contact/places.hpp"
#include "contact/slope.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;
using test::Random;

namespace {

const Law& law() {
  static const Law made({0.8, 0.02, 3, {}});
  return made;
}

Pair pair_of(Kind kind) {
  Pair pair;
  pair.kind = kind;
  pair.area = 1.7;
  pair.offset = 0.05;
  if (kind == Kind::facet) {
    // Other counts than those of a surface, with which a facet and its edge cancel to rounding.
    pair.edge = {-2, 0, 1};
    pair.corner = {0, 1, 2};
  }
  if (kind == Kind::edges) pair.fading = {true, 0.3, 0.2};
  return pair;
}

// Which pieces of the energy's definition hold at x: derivatives are compared where they stay the same.
std::string pieces(const Pair& pair, const Corners& x) {
  std::string out;
  visit_places(pair, x, law().gap() * pair.scale, [&](const Place& place) {
    const double d = place.touch.distance - pair.offset, crush = law().gap() - law().floor();
    out += std::to_string(int(place.touch.feature)) + (d < law().guard_gap() ? "g" : "") +
           (d < law().gap() - 0.2 * crush ? "l" : "o") + " ";
  });
  if (!modulates(pair.kind) || out.empty()) return out;
  const Modulation m = modulation(x, pair.fading, false);
  const Vec3 u = x[1] - x[0], v = x[3] - x[2];
  return out +
         (m.value == 0 ? "0"
          : m.constant ? "1"
                       : "m") +
         (u.cross(v).squaredNorm() < 0.02 * u.squaredNorm() * v.squaredNorm() ? "p" : "");
}

double energy(const Pair& pair, const Corners& x) {
  const Derivatives d = pair_derivatives(law(), pair, x);
  return d.contact + d.guard;
}

// Corners at which the pair touches; every third case of segments is nearly parallel.
Corners touching(Random& random, Kind kind, int n) {
  Corners x = {random.vector(1), random.vector(1), random.vector(1), random.vector(1)};
  if (modulates(kind) && n % 3 == 0) x[3] = x[2] + random(0.5, 1.5) * (x[1] - x[0]) + random.vector(0.1);
  return x;
}

// Calls check(x, direction, step) at `cases` states that touch and keep their pieces within the step.
void at_states(const Pair& pair, int cases,
               const std::function<void(const Corners&, const Vector12&, double)>& check) {
  Random random(7);
  int used = 0, tried = 0;
  while (used < cases && ++tried < 400 * cases) {
    const Corners x = touching(random, pair.kind, tried);
    const std::string held = pieces(pair, x);
    const Vector12 by = random.direction();
    const double h = 1e-4;
    double nearest = 1e9;
    visit_places(pair, x, 1e9,
                 [&](const Place& p) { nearest = std::min(nearest, p.touch.distance - pair.offset); });
    if (held.empty() || held.back() == '0' || nearest < law().floor() + 0.05) continue;
    if (pieces(pair, test::moved(x, by, h)) != held || pieces(pair, test::moved(x, by, -h)) != held) continue;
    ++used;
    INFO("pieces " << held << " try " << tried);
    check(x, by, h);
  }
  CHECK(used == cases);
}

const Kind kinds[] = {Kind::facet, Kind::plane, Kind::edges, Kind::wrap, Kind::segment, Kind::centre};

}  // namespace

TEST_CASE("pair: the gradient is the energy's derivative, the Hessian the gradient's", "[contact]") {
  for (const Kind kind : kinds) {
    const Pair pair = pair_of(kind);
    INFO("kind " << int(kind));
    at_states(pair, 150, [&](const Corners& x, const Vector12& by, double h) {
      const Derivatives at = pair_derivatives(law(), pair, x);
      Random random(3);
      const Vector12 along = random.direction();
      CHECK(test::order([&](const Corners& y) { return energy(pair, y); }, at.gradient.dot(by), x, by, h) >
            1.8);
      CHECK(
          test::order([&](const Corners& y) { return pair_derivatives(law(), pair, y).gradient.dot(along); },
                      along.dot(at.hessian * by), x, by, h) > 1.8);
      CHECK((at.hessian - at.hessian.transpose()).norm() <= 1e-9 * at.hessian.norm());
    });
  }
}

TEST_CASE("pair: forces are the negative gradient, and balance", "[contact]") {
  for (const Kind kind : kinds) {
    const Pair pair = pair_of(kind);
    at_states(pair, 50, [&](const Corners& x, const Vector12&, double) {
      const Derivatives at = pair_derivatives(law(), pair, x);
      const Force force = pair_force(law(), pair, x);
      Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
      for (std::size_t i = 0; i < 4; ++i) {
        CHECK((force.on[i] + at.gradient.segment<3>(3 * int(i))).norm() <= 1e-12 * at.gradient.norm());
        sum += force.on[i];
        moment += x[i].cross(force.on[i]);
      }
      CHECK(sum.norm() <= 1e-11 * at.gradient.norm());
      CHECK(moment.norm() <= 1e-11 * at.gradient.norm());
      CHECK(force.contact == Approx(at.contact).epsilon(1e-13));
      CHECK(force.guard == Approx(at.guard).epsilon(1e-13));
    });
  }
}

TEST_CASE("pair: the positive part has no negative eigenvalue and keeps what is positive", "[contact]") {
  Random random(5);
  int indefinite = 0;
  for (int n = 0; n < 100; ++n) {
    const Matrix12 h =
        pair_derivatives(law(), pair_of(Kind::facet), touching(random, Kind::facet, n)).hessian;
    const Matrix12 p = positive_part(h);
    const double size = h.norm();
    if (size == 0 || !std::isfinite(size)) continue;
    const Eigen::SelfAdjointEigenSolver<Matrix12> before(h), after(p);
    if (before.eigenvalues().minCoeff() < -1e-9 * size) ++indefinite;
    CHECK(after.eigenvalues().minCoeff() > -1e-13 * size);
    CHECK(after.eigenvalues().maxCoeff() == Approx(before.eigenvalues().maxCoeff()).epsilon(1e-12));
  }
  CHECK(indefinite > 20);
}

TEST_CASE("pair: the Jacobian of friction by slope, its unsymmetric part included", "[contact]") {
  for (const Kind kind : kinds) {
    const Pair pair = pair_of(kind);
    INFO("kind " << int(kind));
    Random random(11);
    double skew = 0;
    at_states(pair, 100, [&](const Corners& x, const Vector12& by, double h) {
      Slip slip{0.4, random(0, 1) < 0.5 ? 3.0 : 0.03, x};
      for (Vec3& start : slip.start) start += random.vector(0.5);
      const Friction at = pair_friction(law(), pair, x, slip, true);
      const Vector12 along = random.direction();
      CHECK(test::order(
                [&](const Corners& y) { return pair_friction(law(), pair, y, slip, false).force.dot(along); },
                along.dot(at.jacobian * by), x, by, h) > 1.8);
      skew = std::max(skew, (at.jacobian - at.jacobian.transpose()).norm() / at.jacobian.norm());
    });
    CHECK(skew > 0.1);
  }
}

TEST_CASE(
    "pair: friction of a step is against the sliding, mu times the normal force, and its loss their product",
    "[contact]") {
  const Pair pair = pair_of(Kind::plane);
  const Corners x = {Vec3(0.2, 0.3, 0.4), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  Slip slip{0.25, 1e-3, x};
  slip.start[0] -= Vec3(0.03, 0.04, 0.1);
  const double normal = pair_force(law(), pair, x).on[0].z();
  REQUIRE(normal > 0);
  const Friction f = pair_friction(law(), pair, x, slip, false);
  CHECK((f.force.head<3>() + 0.25 * normal * Vec3(0.6, 0.8, 0)).norm() < 1e-13);
  CHECK(f.lost == Approx(0.25 * normal * 0.05).epsilon(1e-13));
  slip.start[0] = x[0] - Vec3(0.5e-3, 0, 0);  // half the creep: 3/4 of the full friction
  CHECK(pair_friction(law(), pair, x, slip, false).force[0] == Approx(-0.75 * 0.25 * normal).epsilon(1e-12));
}

TEST_CASE("pair: explicit friction stops what slides slowly and is mu times the normal force else",
          "[contact]") {
  const Pair pair = pair_of(Kind::plane);
  const Corners x = {Vec3(0.2, 0.3, 0.4), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const double normal = pair_force(law(), pair, x).on[0].z(), mass = 0.5;
  Sliding sliding;
  sliding.friction = 0.3;
  sliding.step = 1e-3;
  sliding.inverse_mass[0] = 1 / mass;
  sliding.velocity[0] = Vec3(0, 10, -3);
  const Force fast = pair_force(law(), pair, x, &sliding);
  CHECK(fast.on[0].y() == Approx(-0.3 * normal).epsilon(1e-12));
  CHECK(fast.lost == Approx(0.3 * normal * 10).epsilon(1e-12));
  sliding.velocity[0] = Vec3(0, 1e-5, -3);
  CHECK(pair_force(law(), pair, x, &sliding).on[0].y() == Approx(-0.2 * mass * 1e-5 / 1e-3).epsilon(1e-12));
}

TEST_CASE("pair: an edge that slides off another's end, or turns parallel to it, leaves without a jump",
          "[contact]") {
  const Pair pair = pair_of(Kind::edges);
  const auto crossed = [](double shift, double angle) {
    return Corners{Vec3(-0.5 + shift, 0, 0.3), Vec3(0.5 + shift, 0, 0.3),
                   0.5 * Vec3(-std::cos(angle), -std::sin(angle), 0),
                   0.5 * Vec3(std::cos(angle), std::sin(angle), 0)};
  };
  const double full = energy(pair, crossed(0, 1.2));
  CHECK(energy(pair, crossed(0.499, 1.2)) < 1e-4 * full);
  CHECK(energy(pair, crossed(0.499, 1.2)) > 0);
  CHECK(energy(pair, crossed(0.501, 1.2)) == 0);
  CHECK(energy(pair, crossed(0, 1e-3)) < 1e-3 * full);
  CHECK(energy(pair, crossed(0, 0)) == 0);
}

TEST_CASE("pair: an edge about an axis counts once, crossing or parallel", "[contact]") {
  Pair pair = pair_of(Kind::wrap);
  const double one = pair.area * law()(0.3 - pair.offset).contact;
  for (const double angle : {0.0, 1e-4, 0.05, 0.1, 0.3, 1.5}) {
    // Short, so that all of it is as far from the axis as its middle, to the order of its length squared.
    const Vec3 half = 1e-5 * Vec3(std::cos(angle), std::sin(angle), 0);
    const Corners x = {Vec3(0, 0, 0.3) - half, Vec3(0, 0, 0.3) + half, Vec3(-1, 0, 0), Vec3(1, 0, 0)};
    CHECK(energy(pair, x) == Approx(one).epsilon(1e-8));
  }
}

TEST_CASE("friction: forces and torque change with the turn of a body as their derivatives say",
          "[contact]") {
  const Law law({0.38e-3, 0.15e-3, 2e10, {}});
  Pair pair;
  pair.kind = Kind::facet;
  pair.area = 1e-5;
  pair.offset = 0.03;  // a ball above a triangle
  const Corners x = {Vec3(0.001, 0.0015, 0.03025), Vec3(0, 0, 0), Vec3(0.004, 0, 1e-4),
                     Vec3(0, 0.005, -1e-4)};
  Slip slip{0.3, 2e-5, x, Vec3(2e-4, -3e-4, 1e-4)};
  slip.start[0] += Vec3(1e-6, 2e-6, 0);
  for (const double creep : {2e-5, 1e-6}) {  // sticking, sliding
    slip.creep = creep;
    const Friction exact = pair_friction(law, pair, x, slip, true);
    REQUIRE(exact.lost > 0);
    const double turn = 1e-9, move = 1e-10;
    for (int c = 0; c < 3; ++c) {
      Slip up = slip, down = slip;
      up.turn[c] += turn;
      down.turn[c] -= turn;
      const Friction a = pair_friction(law, pair, x, up, false), b = pair_friction(law, pair, x, down, false);
      CHECK(((a.force - b.force) / (2 * turn) - exact.by_turn.col(c)).norm() < 1e-5 * exact.by_turn.norm());
      CHECK(((a.torque - b.torque) / (2 * turn) - exact.torque_by_turn.col(c)).norm() <
            1e-5 * exact.torque_by_turn.norm());
    }
    for (int k = 0; k < 12; ++k) {
      Corners up = x, down = x;
      up[std::size_t(k / 3)][k % 3] += move;
      down[std::size_t(k / 3)][k % 3] -= move;
      const Friction a = pair_friction(law, pair, up, slip, false),
                     b = pair_friction(law, pair, down, slip, false);
      CHECK(((a.torque - b.torque) / (2 * move) - exact.torque_by_x.col(k)).norm() <
            1e-4 * exact.torque_by_x.norm());
    }
  }
}
