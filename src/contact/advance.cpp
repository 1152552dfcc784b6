#include "contact/advance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fabricsh::contact {
namespace {

double distance(Simplices kind, const Corners& x) {
  return std::sqrt(kind == Simplices::point_triangle ? squared_point_triangle(x[0], x[1], x[2], x[3])
                                                     : squared_segment_segment(x[0], x[1], x[2], x[3]));
}

// Upper bound of the approach speed between a point of one simplex and a point of the other.
// The corners suffice, because no point inside a simplex moves farther than its fastest corner.
double approach(Simplices kind, const Corners& by) {
  const std::size_t first = kind == Simplices::point_triangle ? 1 : 2;  // corners of the first simplex
  double a = 0, b = 0;
  for (std::size_t i = 0; i < 4; ++i) (i < first ? a : b) = std::max(i < first ? a : b, by[i].norm());
  return a + b;
}

}  // namespace

double safe_fraction(Simplices kind, const Corners& start, const Corners& end, double least) {
  constexpr double kept = 0.1;       // share of the first distance at which it stops
  constexpr int most_steps = 20000;  // what slides far along at a tiny distance stops short
  const Vec3 centre = 0.25 * (start[0] + start[1] + start[2] + start[3]);
  const Vec3 mean = 0.25 * (end[0] + end[1] + end[2] + end[3]) - centre;
  Corners x, by;
  double size = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    x[i] = start[i] - centre;
    by[i] = end[i] - start[i] - mean;
    size = std::max({size, start[i].lpNorm<Eigen::Infinity>(), end[i].lpNorm<Eigen::Infinity>()});
  }
  const double speed = approach(kind, by) * (1 + 1e-12);
  const double rounding = 64 * std::numeric_limits<double>::epsilon() * size;
  double left = distance(kind, x) - least - rounding;
  if (!(left > 0)) return 0;
  if (!(speed >= left)) return 1;  // too slow to meet; NaN does not come here from finite corners
  const double stop = kept * left;
  double at = 0;
  for (int step = 0; step < most_steps; ++step) {
    const double next = (1 - kept) * left / speed;
    if (at + next >= 1) return 1;
    at += next;
    Corners now;
    for (std::size_t i = 0; i < 4; ++i) now[i] = x[i] + at * by[i];
    left = distance(kind, now) - least - rounding;
    if (left < stop) return at;
  }
  return at;
}

}  // namespace fabricsh::contact
