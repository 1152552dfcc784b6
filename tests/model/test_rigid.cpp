// Rigid bodies as they are declared: what they weigh, and where their middle is.
#include <numbers>

#include "catch.hpp"
#include "message_of.hpp"
#include "model/rigid.hpp"

using namespace fabricsh;
using namespace fabricsh::model;

namespace {

constexpr double kMass = 0.7;

// Moments along and across an axis.
void check_moments(const contact::Mass& m, const Vec3& axis, double along, double across) {
  const Vec3 n = axis.normalized(), side = n.unitOrthogonal(), other = n.cross(side);
  CHECK(n.dot(m.inertia * n) == Approx(along).epsilon(1e-13));
  CHECK(side.dot(m.inertia * side) == Approx(across).epsilon(1e-13));
  CHECK(other.dot(m.inertia * other) == Approx(across).epsilon(1e-13));
  CHECK(std::abs(n.dot(m.inertia * side)) < 1e-15 * kMass);
}

}  // namespace

TEST_CASE(
    "a body weighs what its solid does: ball, capsule, disc, box, each with other sizes in all directions") {
  const Vec3 place(0.3, -0.1, 0.2);
  const Rigid ball(Sphere{0.05, place}, kMass, "", "sphere");
  CHECK(ball.weigh().mass == kMass);
  CHECK((ball.centre() - place).norm() < 1e-16);
  check_moments(ball.weigh(), Vec3(1, 2, 3), 0.4 * kMass * 0.05 * 0.05, 0.4 * kMass * 0.05 * 0.05);

  // A capsule of the length l between the centres of its ends: a cylinder and two half balls, each about its
  // own centre of mass 3/8 r beyond the end.
  const double r = 0.02, l = 0.09;
  const Vec3 way = l * Vec3(2, -1, 2) / 3;
  const Rigid rod(Cylinder{r, place, place + way}, kMass, "", "cylinder");
  const double cylinder = std::numbers::pi * r * r * l, half = 2 * std::numbers::pi / 3 * r * r * r;
  const double density = kMass / (cylinder + 2 * half);
  const double arm = l / 2 + 3 * r / 8;
  const double along = density * (cylinder * r * r / 2 + 2 * half * 0.4 * r * r);
  const double across = density * (cylinder * (l * l / 12 + r * r / 4) +
                                   2 * half * (0.4 * r * r - 9.0 / 64 * r * r + arm * arm));
  CHECK((rod.centre() - (place + way / 2)).norm() < 1e-15);
  check_moments(rod.weigh(), way, along, across);

  // A flat disc as thick as twice the radius of its edge.
  const double R = 0.06, edge = 0.004;
  const Rigid disc(Disc{R, place, Vec3(1, -2, 2), edge}, kMass, "", "disc");
  check_moments(disc.weigh(), Vec3(1, -2, 2), kMass * R * R / 2, kMass * (R * R / 4 + 4 * edge * edge / 12));

  // A box a x b x c, off the origin: b^2 + c^2 about its first axis and so on.
  const double a = 0.03, b = 0.05, c = 0.11;
  Facets box;
  for (int i = 0; i < 8; ++i)
    box.vertices.push_back(place + Vec3(a * (i & 1), b * (i >> 1 & 1), c * (i >> 2)));
  box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  box.closed = true;
  const Rigid solid(box, kMass, "", "surface");
  CHECK((solid.centre() - (place + Vec3(a, b, c) / 2)).norm() < 1e-14);
  const Vec3 wanted = kMass / 12 * Vec3(b * b + c * c, a * a + c * c, a * a + b * b);
  CHECK((solid.weigh().inertia - Mat3(wanted.asDiagonal())).norm() < 1e-12 * wanted.norm());
}

TEST_CASE("the centre of a surface without mass is the same material point in all axes") {
  // An L of two rectangles, 4 x 1 and 1 x 2, in the plane; one of them cut otherwise than the other.
  model::Facets l;
  l.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  l.triangles = {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {3, 4, 5}, {3, 5, 6}};
  const Vec3 wanted = (4 * Vec3(2, 0.5, 0) + 2 * Vec3(0.5, 2, 0)) / 6;
  CHECK((Rigid(l, {}, "", "surface").centre() - wanted).norm() < 1e-15);
  const Mat3 turn = Eigen::AngleAxisd(2.4, Vec3(1, 2, -0.7).normalized()).toRotationMatrix();
  for (Vec3& x : l.vertices) x = Vec3(100, -70, 50) + turn * x;
  CHECK((Rigid(l, {}, "", "surface").centre() - (Vec3(100, -70, 50) + turn * wanted)).norm() < 1e-13);
  const model::MovingFacets moving{l, {0, 1}, {l.vertices, l.vertices}};
  CHECK(Rigid(moving, {}, "", "motion").centre() == Rigid(l, {}, "", "surface").centre());
}

TEST_CASE("a body without mass does not move by itself, and what cannot be free is refused with a mass") {
  CHECK_FALSE(Rigid(Sphere{0.05, Vec3(1, 2, 3)}, {}, "", "sphere").free());
  CHECK(Rigid(Sphere{0.05, Vec3(1, 2, 3)}, {}, "", "sphere").centre() == Vec3(1, 2, 3));
  says(message_of([] { Rigid(Plane{}, 1.0, "", "plane"); }), "a plane has no end and cannot be free");
  says(message_of([] {
         Rigid(Sphere{0.05, Vec3::Zero()}, -1.0, "", "sphere");
       }),
       "expected a positive number in kg, got -1");
  says(message_of([] {
         Rigid(Cylinder{0.1, Vec3::Zero(), Vec3::Zero()}, {}, "", "cylinder");
       }),
       "expected another place than 'from'");
  says(message_of([] {
         Rigid(Disc{0.1, Vec3::Zero(), Vec3::UnitZ(), 0.2}, {}, "", "disc");
       }),
       "below the radius of 0.1 m");
}
