// Rigid bodies: masses in closed form, the free top, shapes that move.
#include "catch.hpp"
#include "contact/rigid.hpp"
#include "contact/slope.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;

namespace {

// A box from the origin, twelve triangles seen counter-clockwise from outside.
struct Cube {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  explicit Cube(const Vec3& size) {
    for (int i = 0; i < 8; ++i)
      vertices.push_back(size.cwiseProduct(Vec3(double(i & 1), double(i >> 1 & 1), double(i >> 2))));
  }
};

}  // namespace

TEST_CASE("rigid: mass and inertia of a closed surface are those of what it encloses", "[contact]") {
  const Cube cube(Vec3(0.1, 0.2, 0.3));
  std::vector<Vec3> moved;
  for (const Vec3& x : cube.vertices) moved.push_back(x + Vec3(5, -3, 1));
  const Mass m = solid_mass(moved, cube.triangles, 2);
  CHECK((m.centre - Vec3(5.05, -2.9, 1.15)).norm() < 1e-13);
  const Vec3 wanted = 2.0 / 12 * Vec3(0.04 + 0.09, 0.01 + 0.09, 0.01 + 0.04);
  CHECK((m.inertia - Mat3(wanted.asDiagonal())).norm() < 1e-12 * wanted.norm());
}

TEST_CASE("rigid: a rod's inertia is that of a cylinder between two half balls", "[contact]") {
  // Limits: no length between the ends is a ball, a thin one a line.
  const Mass ball = rod_mass(Vec3(0, 0, -1e-9), Vec3(0, 0, 1e-9), 0.5, 3);
  CHECK((ball.inertia - ball_mass(Vec3::Zero(), 0.5, 3).inertia).norm() < 1e-6);
  const Mass line = rod_mass(Vec3(0, -1, 0), Vec3(0, 1, 0), 1e-5, 3);
  CHECK(line.inertia(0, 0) == Approx(3 * 4.0 / 12).epsilon(1e-4));
  CHECK(line.inertia(1, 1) < 1e-9);
}

TEST_CASE("rigid: open and inverted surfaces have no mass", "[contact]") {
  Cube cube(Vec3(1, 1, 1));
  Cube open = cube;
  open.triangles.pop_back();
  says(message_of([&] { solid_mass(open.vertices, open.triangles, 1); }), "expected a closed surface");
  for (Triangle& t : cube.triangles) std::swap(t[0], t[1]);
  says(message_of([&] { solid_mass(cube.vertices, cube.triangles, 1); }),
       "counter-clockwise as seen from outside");
  says(message_of([] {
         FreeBody(Mass{0, Vec3::Zero(), Mat3::Identity()}, Vec3::Zero(), Vec3::Zero());
       }),
       "mass: expected");
}

TEST_CASE("rigid: a free top keeps its angular momentum to rounding and its energy without drift",
          "[contact]") {
  Mass m{1.5, Vec3(1, 2, 3), Vec3(1, 2, 3.5).asDiagonal()};
  const Mat3 turn = Pose::about(Vec3(1, 2, -1), 0.7);
  m.inertia = turn * m.inertia * turn.transpose();
  const auto largest_error = [&](double dt, int steps) {
    FreeBody body(m, Vec3(0.1, 0.2, 0.3), turn * Vec3(0.1, 2, 0.1));  // about the unstable axis: it tumbles
    const double energy = body.kinetic_energy();
    const Vec3 momentum = body.angular_momentum();
    double error = 0;
    for (int i = 0; i < steps; ++i) {
      body.drift(dt);
      error = std::max(error, std::fabs(body.kinetic_energy() - energy) / energy);
    }
    CHECK(body.angular_momentum() == momentum);
    CHECK((body.pose().turn * body.pose().turn.transpose() - Mat3::Identity()).norm() < 1e-13);
    CHECK((body.inertia() * body.spin() - momentum).norm() < 1e-12 * momentum.norm());
    CHECK((body.centre() - Vec3(1, 2, 3) - dt * steps * Vec3(0.1, 0.2, 0.3)).norm() < 1e-9 * dt * steps);
    return error;
  };
  const double coarse = largest_error(0.02, 2000), fine = largest_error(0.01, 4000);
  CHECK(coarse / fine == Approx(4).epsilon(0.05));
  CHECK(largest_error(0.01, 40000) < 1.05 * fine);  // ten times as long, no worse
}

TEST_CASE("rigid: the symmetric top of Euler turns as its closed form says", "[contact]") {
  // Its axis goes round the angular momentum with L/I1, the closed form of the free symmetric top.
  const double across = 2, along = 0.7;
  const Mass m{1, Vec3::Zero(), Vec3(across, across, along).asDiagonal()};
  const Vec3 spin(0.5, 0, 3), momentum = m.inertia * spin;
  const double time = 5;
  double last = 0;
  for (const int steps : {250, 500, 1000}) {
    FreeBody body(m, Vec3::Zero(), spin);
    for (int i = 0; i < steps; ++i) body.drift(time / steps);
    const Vec3 axis = body.pose().turn * Vec3::UnitZ();
    const Vec3 wanted = Pose::about(momentum, momentum.norm() / across * time) * Vec3::UnitZ();
    const double error = (axis - wanted).norm();
    if (last > 0) CHECK(last / error == Approx(4).epsilon(0.1));
    last = error;
  }
  CHECK(last < 1e-3);
}

TEST_CASE("rigid: kicks change momenta by force and torque, and work is energy", "[contact]") {
  FreeBody body(ball_mass(Vec3::Zero(), 0.1, 2), Vec3::Zero(), Vec3::Zero());
  body.kick(Vec3(1, 0, 0), Vec3(0, 0.01, 0), 0.5);
  CHECK((body.velocity() - Vec3(0.25, 0, 0)).norm() < 1e-15);
  CHECK((body.spin() - Vec3(0, 0.005 / 0.008, 0)).norm() < 1e-13);
  CHECK(body.kinetic_energy() == Approx(0.5 * 2 * 0.0625 + 0.5 * 0.005 * 0.005 / 0.008).epsilon(1e-13));
  CHECK((body.velocity_at(Vec3(0.1, 0, 0)) - Vec3(0.25, 0, -0.0625)).norm() < 1e-13);
}

TEST_CASE("rigid: a surface moves from shape to shape in straight lines and stands before and after",
          "[contact]") {
  const MovingShape shape({0, 2}, {{Vec3(0, 0, 0)}, {Vec3(4, 0, 2)}});
  std::vector<Vec3> x(1);
  shape.at(0.5, x);
  CHECK(x[0] == Vec3(1, 0, 0.5));
  shape.velocity(0.5, x);
  CHECK(x[0] == Vec3(2, 0, 1));
  shape.at(9, x);
  CHECK(x[0] == Vec3(4, 0, 2));
  shape.velocity(9, x);
  CHECK(x[0] == Vec3(0, 0, 0));
  says(message_of([] {
         MovingShape({0, 1}, {{Vec3::Zero()}, {}});
       }),
       "shape 2 has 0 vertices, the first has 1");
  says(message_of([] { MovingShape({1, 1}, {{Vec3::Zero()}, {Vec3::Zero()}}); }), "times (s) that ascend");
}

TEST_CASE("rigid: a closed surface tells inside from outside, near it and far away", "[contact]") {
  // A box without one of its corners: not convex.
  const std::vector<Vec3> x = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {0, 0, 2}, {1.4, 1.1, 0.5}};
  const std::vector<Triangle> t = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {0, 4, 3},
                                   {1, 2, 5}, {1, 5, 4}, {2, 3, 5}, {3, 4, 5}};
  REQUIRE(solid_mass(x, t, 1).mass == 1);  // closed, and seen from outside counter-clockwise
  for (const Vec3& in : {Vec3(0.1, 0.1, 1.5), Vec3(1, 1, 0.2), Vec3(3.4, 0.2, 0.05), Vec3(0.1, 0.1, 1e-6)})
    CHECK(encloses(x, t, in));
  for (const Vec3& out : {Vec3(1.4, 1.1, 0.6), Vec3(3, 2, 1), Vec3(0.1, 0.1, -1e-6), Vec3(-50, 70, 20)})
    CHECK_FALSE(encloses(x, t, out));
}
