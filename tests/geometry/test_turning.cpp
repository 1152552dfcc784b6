// The first axes of directors; the work of a force on an arm that turns.
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "geometry/turning.hpp"

using namespace fabricsh;

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
