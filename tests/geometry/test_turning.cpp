// Directors that turn: against the exact rotation, over small and large angles; the work of a force on an arm
// that turns.
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "geometry/turning.hpp"

using namespace fabricsh;

namespace {

const Vec3 kDirector = Vec3(2, -1, 2) / 3;
const Vec3 kAxis = Vec3(1, 2, 0).normalized();  // normal to the director

}  // namespace

TEST_CASE("turning: a director and its first axis turn as by the rotation, by any angle") {
  CHECK(std::abs(kDirector.dot(kAxis)) < 1e-15);
  for (const double angle : {1e-9, 1e-3, 0.05, 0.0999, 0.1001, 0.7, 2.0, 3.0})
    for (const double turned : {0.3, 1.9}) {
      // Two directions on the sphere: the axis of the rotation is normal to the director, so the way is a
      // great circle.
      const Vec3 about = Eigen::AngleAxisd(turned, kDirector) * kAxis, way = about.cross(kDirector);
      const Mat3 R = Eigen::AngleAxisd(angle, about).toRotationMatrix();
      Vec3 d = kDirector, b = kAxis;
      turn(Eigen::Map<Vec3>(d.data()), Eigen::Map<Vec3>(b.data()), angle * way);
      INFO("angle " << angle);
      CHECK((d - R * kDirector).norm() < 1e-14);
      CHECK((b - R * kAxis).norm() < 1e-14);
    }
}

TEST_CASE("turning: the series agree with the functions at their end") {
  const double x = 0.01;
  const TurnFunctions below = turn_by(std::nextafter(x, 0)), above = turn_by(x);
  CHECK(below.cosine == Approx(above.cosine).epsilon(1e-15));
  CHECK(below.sine == Approx(above.sine).epsilon(1e-15));
  CHECK(below.versed == Approx(above.versed).epsilon(1e-13));  // (cos - 1) / x loses two digits there
  CHECK(turn_by(0).cosine == 1);
  CHECK(turn_by(0).sine == 1);
  CHECK(turn_by(0).versed == -0.5);
}

TEST_CASE(
    "turning: a director's frame has its first axis normal to it, from the axis least aligned with it") {
  for (const Vec3& v :
       {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(3, -1, 2), Vec3(-1, 3, 2), Vec3(2, 1, -3)}) {
    const Vec3 d = v.normalized(), e1 = first_axis(d);
    CHECK(e1.norm() == Approx(1).epsilon(1e-15));
    CHECK(std::abs(e1.dot(d)) < 1e-15);
  }
  // [hughes1981]: for d = z the axis is x, and near it stays near x.
  CHECK((first_axis(Vec3::UnitZ()) - Vec3::UnitX()).norm() < 1e-15);
  CHECK((first_axis(Vec3(0.1, 0.2, 1).normalized()) - Vec3::UnitX()).norm() < 0.2);
}

TEST_CASE("turning: the second variation of a force's work on an arm that turns, by differences") {
  const Vec3 r(0.3, -0.2, 0.5), f(4, 1, -7), theta(0.6, -0.3, 0.74);
  const auto work = [&](double s) {
    return f.dot(Eigen::AngleAxisd(s * theta.norm(), theta.normalized()) * r);
  };
  const double wanted = theta.dot(turning_stiffness(r, f) * theta);
  double last = 0;
  for (const double h : {2e-2, 1e-2}) {
    const double second = (work(h) - 2 * work(0) + work(-h)) / (h * h), error = std::abs(second - wanted);
    if (last > 0) CHECK(last / error == Approx(4).epsilon(0.01));
    last = error;
  }
  CHECK(last < 1e-4 * std::abs(wanted));
  const Vec3 v(1, 5, -2);
  CHECK((cross_matrix(r) * v - r.cross(v)).norm() < 1e-15);
}
