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

const ContactLaw& law() {
  static const ContactLaw made({0.8, 0.02, 3, {}});
  return made;
}

Pair pair_of(PairKind kind) {
  Pair pair;
  pair.kind = kind;
  pair.area = 1.7;
  pair.offset = 0.05;
  if (kind == PairKind::facet) {
    // Other counts than those of a surface, with which a facet and its edge cancel to rounding.
    pair.edge = {-2, 0, 1};
    pair.corner = {0, 1, 2};
  }
  if (kind == PairKind::edges) pair.fading = {true, 0.3, 0.2};
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
  const Modulation m = modulation(x, pair.fading);
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
Corners touching(Random& random, PairKind kind, int n) {
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

const PairKind kinds[] = {PairKind::facet, PairKind::plane,   PairKind::edges,
                          PairKind::wrap,  PairKind::segment, PairKind::centre};

}  // namespace

TEST_CASE("pair: the gradient is the energy's derivative, the Hessian the gradient's", "[contact]") {
  for (const PairKind kind : kinds) {
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
  for (const PairKind kind : kinds) {
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

namespace {

// Of friction alone.
Force friction_of(const ContactLaw& law, const Pair& pair, const Corners& x, const Slip& slip) {
  Force both = pair_force(law, pair, x, &slip);
  const Force pressed = pair_force(law, pair, x);
  for (std::size_t i = 0; i < 4; ++i) both.on[i] -= pressed.on[i];
  return both;
}

Vector12 stacked(const std::array<Vec3, 4>& rows) {
  Vector12 out;
  for (int i = 0; i < 4; ++i) out.segment<3>(3 * i) = rows[std::size_t(i)];
  return out;
}

// The slip of a step from `start` to x.
Slip from(const Slip& slip, const Corners& start, const Corners& x) {
  Slip out = slip;
  for (std::size_t i = 0; i < 4; ++i) out.moved[i] = x[i] - start[i];
  return out;
}

const Corners flat = {Vec3(0.2, 0.3, 0.4), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};

}  // namespace

TEST_CASE("pair: the Jacobian of friction by slope, its unsymmetric part included", "[contact]") {
  for (const PairKind kind : kinds) {
    const Pair pair = pair_of(kind);
    INFO("kind " << int(kind));
    Random random(11);
    double skew = 0;
    at_states(pair, 100, [&](const Corners& x, const Vector12& by, double h) {
      // A pair that slides everywhere, and one that sticks everywhere.
      const Slip slips{0.4, 1e6}, sticks{1e6, 1};
      Slip slip = random(0, 1) < 0.5 ? slips : sticks;
      slip.held = random.vector(0.2);
      Corners start = x;
      for (Vec3& s : start) s += random.vector(0.5);
      const FrictionTangent at = friction_tangent(law(), pair, x, from(slip, start, x));
      const Vector12 along = random.direction();
      const auto force = [&](const Corners& y) {
        const Slip moved = from(slip, start, y);
        return stacked(pair_force(law(), pair, y, &moved).on).dot(along);
      };
      const Matrix12 all = at.jacobian - pair_derivatives(law(), pair, x).hessian;
      CHECK(test::order(force, along.dot(all * by), x, by, h) > 1.8);
      skew = std::max(skew, (at.jacobian - at.jacobian.transpose()).norm() / at.jacobian.norm());
      const Matrix12 rest = at.jacobian - at.apart;
      CHECK((rest - rest.transpose()).norm() < 1e-14 * at.jacobian.norm());
    });
    CHECK(skew > 0.1);
  }
}

TEST_CASE(
    "pair: apart is how friction grows with the pressure; without it sliding has no stiffness along itself",
    "[contact]") {
  const Pair pair = pair_of(PairKind::plane);
  Slip slip{0.4, 1e6};
  const Vec3 way(0.3, 0.4, 0), along = way.normalized(), normal(0, 0, 1);
  slip.moved[0] = way;
  const FrictionTangent at = friction_tangent(law(), pair, flat, slip);
  const auto pressed = law()(0.4 - pair.offset);
  const Mat3 apart = at.apart.block<3, 3>(0, 0), rest = at.jacobian.block<3, 3>(0, 0) - apart;
  const Mat3 grows = 0.4 * pair.area * pressed.stiffness * along * normal.transpose(),
             across = Mat3::Identity() - along * along.transpose() - normal * normal.transpose(),
             turns = 0.4 * pair.area * pressed.pressure / way.norm() * across;
  CHECK((apart - grows).norm() < 1e-12 * grows.norm());
  CHECK((rest + turns).norm() < 1e-12 * turns.norm());
}

TEST_CASE("pair: a film that thins resists with Carreau's traction, and its Jacobian is the slope",
          "[contact]") {
  const double dt = 0.03;
  for (const PairKind kind : kinds) {
    const Pair pair = pair_of(kind);
    INFO("kind " << int(kind));
    Random random(12);
    at_states(pair, 60, [&](const Corners& x, const Vector12& by, double h) {
      Slip slip{random(0, 1) < 0.5 ? 0 : 0.4, 1e6};
      slip.dt = dt;
      slip.film = {random(0.2, 2), random(1, 20), random(0.1, 1)};
      slip.held = random.vector(0.2);
      Corners start = x;
      for (Vec3& s : start) s += random.vector(0.5);
      const Vector12 along = random.direction();
      const FrictionTangent at = friction_tangent(law(), pair, x, from(slip, start, x));
      const auto force = [&](const Corners& y) {
        const Slip moved = from(slip, start, y);
        return stacked(pair_force(law(), pair, y, &moved).on).dot(along);
      };
      const Matrix12 all = at.jacobian - pair_derivatives(law(), pair, x).hessian;
      CHECK(test::order(force, along.dot(all * by), x, by, h) > 1.8);
    });
  }
  const Pair pair = pair_of(PairKind::plane);
  Slip slip;
  slip.dt = dt;
  slip.film = {0.7, 0.5, 0.3};
  for (const double v : {1e-3, 0.5, 40.0}) {
    slip.moved[0] = v * dt * Vec3(0.6, 0.8, 0);
    const double traction = 0.7 * v * std::pow(1 + v * v / 0.25, -0.35);
    const Force film = friction_of(law(), pair, flat, slip);
    CHECK(film.on[0].norm() == Approx(traction * pair.area).epsilon(1e-12));
    CHECK(film.work == Approx(traction * pair.area * v * dt).epsilon(1e-12));
  }
}

TEST_CASE("pair: friction is a spring until it pulls with mu times the normal force, and then slips",
          "[contact]") {
  const Pair pair = pair_of(PairKind::plane);
  const double normal = pair_force(law(), pair, flat).on[0].z(), k = 7;
  REQUIRE(normal > 0);
  const double spring = k * pair.area, most = 0.25 * normal, give = most / spring;  // m, where it gives way
  Slip slip{0.25, k};
  slip.moved[0] = give * Vec3(0.3, 0.4, 0.1);  // sticks
  const Force sticks = friction_of(law(), pair, flat, slip);
  CHECK((sticks.on[0] + 0.5 * most * Vec3(0.6, 0.8, 0)).norm() < 1e-13 * most);
  CHECK((sticks.slip - give * Vec3(0.3, 0.4, 0)).norm() < 1e-13 * give);
  CHECK(sticks.stick == Approx(spring * give * give / 8).epsilon(1e-13));
  slip.held = sticks.slip;  // another such step pulls it to the bound, a third one beyond it
  CHECK((friction_of(law(), pair, flat, slip).on[0] + most * Vec3(0.6, 0.8, 0)).norm() < 1e-12 * most);
  slip.held = friction_of(law(), pair, flat, slip).slip;
  const Force slips = friction_of(law(), pair, flat, slip);
  CHECK((slips.on[0] + most * Vec3(0.6, 0.8, 0)).norm() < 1e-12 * most);
  CHECK((slips.slip - give * Vec3(0.6, 0.8, 0)).norm() < 1e-12 * give);
  CHECK(slips.work == Approx(most * give / 2).epsilon(1e-12));
  slip.held = slips.slip;  // back by the same way: the spring lets go first
  slip.moved[0] = -give * Vec3(0.6, 0.8, 0);
  CHECK(friction_of(law(), pair, flat, slip).on[0].norm() < 1e-12 * most);
}

TEST_CASE("pair: explicit friction resists slow sliding and is mu times the normal force else", "[contact]") {
  const Pair pair = pair_of(PairKind::plane);
  const double normal = pair_force(law(), pair, flat).on[0].z(), mass = 0.5, dt = 1e-3;
  Slip slip{0.3, 0};
  slip.step = dt;
  slip.inverse_mass[0] = 1 / mass;
  slip.moved[0] = dt * Vec3(0, 10, -3);
  slip.pull = Vec3(0, 0.1 * normal, 0);
  const Force fast = friction_of(law(), pair, flat, slip);
  CHECK(fast.on[0].y() == Approx(-0.3 * normal).epsilon(1e-12));
  CHECK(fast.work == Approx((0.3 + 0.1) / 2 * normal * 10 * dt).epsilon(1e-12));  // of both ends' forces
  slip.moved[0] = dt * Vec3(0, 1e-5, -3);
  CHECK(friction_of(law(), pair, flat, slip).on[0].y() == Approx(-0.2 * mass * 1e-5 / dt).epsilon(1e-12));
}

TEST_CASE("pair: resistance to slow sliding counts as often as its place", "[contact]") {
  Pair pair = pair_of(PairKind::facet);
  const double mass = 0.5, dt = 1e-3;
  Slip slip{0.3, 0};
  slip.step = dt;
  slip.inverse_mass = {2 / mass, 2 / mass, 0, 0};
  slip.crowd = {2, 2, 1, 1};
  slip.moved[0] = dt * Vec3(1e-5, 0, 0);
  // Above a corner, which the first side shares with it in equal parts.
  Corners x = {Vec3(0, 0, 0.3), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const double once = -0.2 * mass / 4 * 1e-5 / dt;
  for (const int times : {0, -1, -2, 3}) {
    pair.edge = {};
    pair.corner = {std::int8_t(times), 0, 0};
    const Force got = friction_of(law(), pair, x, slip);
    CHECK(got.on[0].x() == Approx((1 + times) * once).epsilon(1e-12).margin(1e-20));
    CHECK(got.resists[0] == Approx((1 + times) / 2.0).margin(1e-15));
    CHECK(got.resists[1] == Approx((1 + times) / 2.0).margin(1e-15));
    CHECK(got.resists[2] == 0);
  }
}

TEST_CASE("pair: an approach is damped by the law's stiffness where it is, at most by its largest",
          "[contact]") {
  const Pair pair = pair_of(PairKind::plane);
  const double loss = 2, dt = 1e-3, speed = 40, guard = law().guard_gap(), floor = law().floor();
  for (const double gap : {0.9 * law().gap(), 0.5 * (guard + floor), 0.1 * guard + 0.9 * floor}) {
    const double stiffness = gap < guard ? law().stiffest() : law()(gap).stiffness;
    CHECK(stiffness > 0);
    Corners x = flat;
    x[0].z() = pair.offset + gap;
    Slip slip;
    slip.loss = loss;
    slip.dt = slip.step = dt;
    slip.moved[0] = dt * Vec3(3, -5, -speed);
    CHECK(friction_of(law(), pair, x, slip).damped ==
          Approx(pair.area * loss * std::sqrt(stiffness) * speed).epsilon(1e-12));
    slip.moved[0] = dt * Vec3(3, -5, speed);  // moving away
    CHECK(friction_of(law(), pair, x, slip).damped == 0);
  }
}

TEST_CASE("pair: an edge that slides off another's end, or turns parallel to it, leaves without a jump",
          "[contact]") {
  const Pair pair = pair_of(PairKind::edges);
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
  Pair pair = pair_of(PairKind::wrap);
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
  const ContactLaw law({0.38e-3, 0.15e-3, 2e10, {}});
  Pair pair;
  pair.kind = PairKind::facet;
  pair.area = 1e-5;
  pair.offset = 0.03;  // a ball above a triangle
  const Corners x = {Vec3(0.001, 0.0015, 0.03025), Vec3(0, 0, 0), Vec3(0.004, 0, 1e-4),
                     Vec3(0, 0.005, -1e-4)};
  Slip slip{0.3, 0};
  slip.turn = Vec3(2e-4, -3e-4, 1e-4);
  slip.held = Vec3(1e-6, -2e-6, 1e-6);
  Corners start = x;
  start[0] += Vec3(1e-6, 2e-6, 0);
  for (const double stiffness : {1e6, 1e10}) {  // sticking, sliding
    slip.stiffness = stiffness;
    const FrictionTangent exact = friction_tangent(law, pair, x, from(slip, start, x));
    const auto at = [&](const Corners& y, const Vec3& turn) {
      Slip moved = from(slip, start, y);
      moved.turn = turn;
      return friction_of(law, pair, y, moved);
    };
    REQUIRE((at(x, slip.turn).stick > 0 && exact.by_turn.norm() > 0));
    const double turn = 1e-9, move = 1e-10;
    for (int c = 0; c < 3; ++c) {
      const Force a = at(x, slip.turn + turn * Vec3::Unit(c)), b = at(x, slip.turn - turn * Vec3::Unit(c));
      CHECK(((stacked(a.on) - stacked(b.on)) / (2 * turn) - exact.by_turn.col(c)).norm() <
            1e-5 * exact.by_turn.norm());
      CHECK(((a.torque - b.torque) / (2 * turn) - exact.torque_by_turn.col(c)).norm() <
            1e-5 * exact.torque_by_turn.norm());
    }
    for (int k = 0; k < 12; ++k) {
      Corners up = x, down = x;
      up[std::size_t(k / 3)][k % 3] += move;
      down[std::size_t(k / 3)][k % 3] -= move;
      const Force a = at(up, slip.turn), b = at(down, slip.turn);
      CHECK(((a.torque - b.torque) / (2 * move) - exact.torque_by_x.col(k)).norm() <
            1e-4 * exact.torque_by_x.norm());
    }
  }
}
