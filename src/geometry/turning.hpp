// Axes of directors on the unit sphere, and the matrices of the vector product and of a rotating body.
#pragma once
#include <cmath>

#include "geometry/vec.hpp"

namespace fabricsh {

// a x v = cross_matrix(a) v.
inline Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

// Second variation of the work of a force f on a vector r that rotates with a
// body, exp(theta) r: the quadratic form theta . (sym(r f^T) - (r.f) 1) theta.
inline Mat3 turning_stiffness(const Vec3& r, const Vec3& f) {
  return (r * f.transpose() + f * r.transpose()) / 2 - r.dot(f) * Mat3::Identity();
}

// The two axes about which the director d turns, as columns: the rates of d by its two rotations.
inline Eigen::Matrix<double, 3, 2> turning_axes(const Vec3& d, const Vec3& b1) {
  Eigen::Matrix<double, 3, 2> B;
  B.col(0) = b1;
  B.col(1) = d.cross(b1);
  return B;
}

// The first axis of a director's frame, unit and normal to
// d, from the global axis least aligned with d [hughes1981].
inline Vec3 first_axis(const Vec3& d) {
  double a1 = std::abs(d.x()), a3 = std::abs(d.z());
  const double a2 = std::abs(d.y());
  int j = 0;
  if (a1 > a3) {
    a3 = a1;
    j = 1;
  }
  if (a2 > a3) j = 2;
  const Vec3 e2 = d.cross(Vec3::Unit(j)).normalized();
  return e2.cross(d);
}

}  // namespace fabricsh
