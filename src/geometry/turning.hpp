// Rotation of directors on the unit sphere, and the matrices of the vector product and of a rotating body.
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

// cos, sin / angle and (cos - 1) / x of the angle whose square is x. Below x =
// 0.01, the usual case in dynamics, by series truncated below rounding error.
struct TurnFunctions {
  double cosine, sine, versed;
};
inline TurnFunctions turn_by(double x) {
  if (x < 0.01)
    return {1 - x / 2 * (1 - x / 12 * (1 - x / 30 * (1 - x / 56))),
            1 - x / 6 * (1 - x / 20 * (1 - x / 42 * (1 - x / 72))),
            -0.5 * (1 - x / 12 * (1 - x / 30 * (1 - x / 56 * (1 - x / 90))))};
  const double angle = std::sqrt(x), cosine = std::cos(angle);
  return {cosine, std::sin(angle) / angle, (cosine - 1) / x};
}

// Normalises v, whose length is almost 1: one Newton step, whose error is quadratic in that of the length.
inline void renew(Eigen::Map<Vec3> v) { v *= 1.5 - 0.5 * v.squaredNorm(); }

// Rotates the director d by the increment q (tangent to the sphere,
// rad) along a great circle, and parallel-transports its first axis b1.
inline void turn(Eigen::Map<Vec3> d, Eigen::Map<Vec3> b1, const Vec3& q) {
  const TurnFunctions by = turn_by(q.squaredNorm());
  const Vec3 d0 = d;
  d = by.cosine * d0 + by.sine * q;
  renew(d);
  const double along = b1.dot(q);
  b1 += along * (by.versed * q - by.sine * d0);
  b1 -= b1.dot(d) * Vec3(d);
  renew(b1);
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
