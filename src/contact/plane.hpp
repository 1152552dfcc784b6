// The plane that many nodes meet, worked out once for those that follow each other.
#pragma once
#include <algorithm>

#include "contact/touch.hpp"

namespace fabricsh::contact {

inline Vec3 vector_of(const double* v) { return {v[0], v[1], v[2]}; }

// A plane through three corners: many nodes in turn meet the same one.
// Plain numbers, which a thread keeps without a constructor.
struct Plane {
  double corners[9], u[3], v[3], across[3], normal[3];
  double a, b, c, det, squared;  // products of the sides, and of `across`
  bool is_through(const Corners& x) const {
    for (int k = 0; k < 9; ++k)
      if (corners[k] != x[std::size_t(1 + k / 3)][k % 3]) return false;
    return true;
  }
  void pass(const Corners& x) {
    const Vec3 first = x[2] - x[1], second = x[3] - x[1], product = first.cross(second);
    for (int k = 0; k < 9; ++k) corners[k] = x[std::size_t(1 + k / 3)][k % 3];
    put(first, u);
    put(second, v);
    put(product, across);
    put(product.normalized(), normal);
    a = first.dot(first), b = first.dot(second), c = second.dot(second), det = a * c - b * b;
    squared = product.squaredNorm();
  }

 private:
  static void put(const Vec3& from, double* to) { std::copy_n(from.data(), 3, to); }
};

inline const Plane& plane_through(const Corners& x) {
  thread_local Plane last{};
  if (last.squared == 0 || !last.is_through(x)) last.pass(x);
  return last;
}

// Whether corner 0 is clearly farther than so many metres from the plane through the others, on the side that
// sees them counter-clockwise; `squared`: m2.
inline bool is_above_plane(const Corners& x, double squared) {
  const Plane& plane = plane_through(x);
  const double height = vector_of(plane.across).dot(x[0] - x[1]);
  return height > 0 && height * height > squared * plane.squared;
}

}  // namespace fabricsh::contact
