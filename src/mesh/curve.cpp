#include "mesh/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/number.hpp"

namespace fabricsh::mesh {

// A whole curve by its length.
struct PlaneCurve::Shape {
  virtual ~Shape() = default;
  virtual double length() const = 0;
  virtual Vec2 at(double s) const = 0;
  virtual Vec2 tangent(double s) const = 0;
  virtual bool straight() const { return false; }
  virtual double turning(double from, double to) const = 0;
};

namespace {

struct StraightLine final : PlaneCurve::Shape {
  Vec2 a, b;
  StraightLine(const Vec2& from, const Vec2& to) : a(from), b(to) {}
  double length() const override { return (b - a).norm(); }
  Vec2 at(double s) const override { return s < length() ? Vec2(a + s / length() * (b - a)) : b; }
  Vec2 tangent(double) const override { return (b - a).normalized(); }
  bool straight() const override { return true; }
  double turning(double, double) const override { return 0; }
};

struct Arc final : PlaneCurve::Shape {
  Vec2 centre, a, b;
  double radius, start, sweep;  // m; rad; rad, positive counter-clockwise
  Arc(const Vec2& about, const Vec2& from, const Vec2& to, bool clockwise)
      : centre(about), a(from), b(to), radius((from - about).norm()) {
    const Vec2 p = from - about, q = to - about;
    start = std::atan2(p.y(), p.x());
    sweep = std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q));
    constexpr double turn = 2 * std::numbers::pi;
    if (!clockwise && sweep <= 0) sweep += turn;
    if (clockwise && sweep >= 0) sweep -= turn;
  }
  double length() const override { return radius * std::abs(sweep); }
  double angle(double s) const { return start + s / length() * sweep; }
  Vec2 at(double s) const override {
    if (s <= 0) return a;
    if (s >= length()) return b;
    return centre + radius * Vec2(std::cos(angle(s)), std::sin(angle(s)));
  }
  Vec2 tangent(double s) const override {
    const Vec2 left(-std::sin(angle(s)), std::cos(angle(s)));
    return sweep > 0 ? left : Vec2(-left);
  }
  double turning(double from, double to) const override { return (to - from) / radius; }
};

using Cubic = std::array<Vec2, 4>;

Vec2 point(const Cubic& c, double t) {
  const double r = 1 - t;
  return r * r * r * c[0] + 3 * r * r * t * c[1] + 3 * r * t * t * c[2] + t * t * t * c[3];
}

Vec2 slope(const Cubic& c, double t) {
  const double r = 1 - t;
  return 3 * r * r * (c[1] - c[0]) + 6 * r * t * (c[2] - c[1]) + 3 * t * t * (c[3] - c[2]);
}

// The length of the curve between two parameters, by the Gauss rule of five points.
double length_between(const Cubic& c, double t0, double t1) {
  static const double inner = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3,
                      outer = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3;
  static const double weights[] = {128.0 / 225, (322 + 13 * std::sqrt(70.0)) / 900,
                                   (322 - 13 * std::sqrt(70.0)) / 900};
  const double middle = (t0 + t1) / 2, half = (t1 - t0) / 2;
  const auto speed = [&](double x) { return slope(c, middle + half * x).norm(); };
  return half * (weights[0] * speed(0) + weights[1] * (speed(-inner) + speed(inner)) +
                 weights[2] * (speed(-outer) + speed(outer)));
}

// Cubic curves one after the other, each in steps of its parameter that are short enough for the Gauss rule.
struct Chain final : PlaneCurve::Shape {
  static constexpr int steps = 32;
  std::vector<Cubic> cubics;
  std::vector<double> lengths{0};  // up to the end of each step

  explicit Chain(const std::vector<Vec2>& points) {
    for (std::size_t i = 0; i + 3 < points.size(); i += 3) {
      cubics.push_back({points[i], points[i + 1], points[i + 2], points[i + 3]});
      for (int k = 0; k < steps; ++k)
        lengths.push_back(lengths.back() +
                          length_between(cubics.back(), static_cast<double>(k) / steps, (k + 1.0) / steps));
    }
  }
  double length() const override { return lengths.back(); }

  struct PlaceOnCubic {
    const Cubic* cubic;
    double t;
  };
  PlaceOnCubic place(double s) const {
    const auto above = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, s);
    const auto step = static_cast<std::size_t>(above - lengths.begin()) - 1;
    const Cubic& cubic = cubics[step / steps];
    const double t0 = static_cast<double>(step % steps) / steps, wanted = s - lengths[step];
    const double whole = lengths[step + 1] - lengths[step];
    double t = t0 + (whole > 0 ? wanted / whole : 0) / steps;
    for (int i = 0; i < 8; ++i) {
      const double speed = slope(cubic, t).norm();
      if (speed > 0) t -= (length_between(cubic, t0, t) - wanted) / speed;
    }
    return {&cubic, std::clamp(t, t0, t0 + 1.0 / steps)};
  }
  Vec2 at(double s) const override {
    if (s <= 0) return cubics.front()[0];
    if (s >= length()) return cubics.back()[3];
    const PlaceOnCubic p = place(s);
    return point(*p.cubic, p.t);
  }
  Vec2 tangent(double s) const override {
    const PlaceOnCubic p = place(s);
    Vec2 direction = slope(*p.cubic, p.t);
    // Where a control point lies on the end of its curve the slope is zero there.
    if (direction.norm() < 1e-9 * (length() + 1e-300))
      direction = slope(*p.cubic, p.t < 0.5 ? p.t + 1e-6 : p.t - 1e-6);
    return direction.normalized();
  }
  double turning(double from, double to) const override {
    constexpr int parts = 64;
    double sum = 0;
    Vec2 before = tangent(from);
    for (int i = 1; i <= parts; ++i) {
      const Vec2 now = tangent(from + (to - from) * i / parts);
      sum += std::abs(std::atan2(before.x() * now.y() - before.y() * now.x(), before.dot(now)));
      before = now;
    }
    return sum;
  }
};

// The slopes, per length of chord, of the spline without curvature at its ends: the tridiagonal system of
// continuous curvature at the points between, by elimination.
std::vector<Vec2> spline_slopes(const std::vector<Vec2>& points, const std::vector<double>& chord) {
  const std::size_t n = points.size();
  std::vector<double> diagonal(n), above(n);
  std::vector<Vec2> slopes(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool first = i == 0, last = i + 1 == n;
    const double before = first ? 0 : chord[i - 1], after = last ? 0 : chord[i];
    double below = last ? 1 : after;
    diagonal[i] = first || last ? 2 : 2 * (before + after);
    above[i] = first ? 1 : before;
    slopes[i] = first  ? Vec2(3 / after * (points[1] - points[0]))
                : last ? Vec2(3 / before * (points[i] - points[i - 1]))
                       : Vec2(3 * (after / before * (points[i] - points[i - 1]) +
                                   before / after * (points[i + 1] - points[i])));
    if (first) continue;
    below /= diagonal[i - 1];
    diagonal[i] -= below * above[i - 1];
    slopes[i] -= below * slopes[i - 1];
  }
  slopes[n - 1] /= diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) slopes[i] = (slopes[i] - above[i] * slopes[i + 1]) / diagonal[i];
  return slopes;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

PlaneCurve::PlaneCurve(std::shared_ptr<const Shape> shape) : shape_(std::move(shape)), from_(0) {
  to_ = shape_->length();
}

PlaneCurve PlaneCurve::line(const Vec2& from, const Vec2& to) {
  return PlaneCurve(std::make_shared<StraightLine>(from, to));
}

PlaneCurve PlaneCurve::arc_through(const Vec2& from, const Vec2& through, const Vec2& to) {
  const Vec2 p = through - from, q = to - from;
  const double twice = 2 * cross(p, q);
  if (std::abs(twice) <= 1e-12 * p.norm() * q.norm() || p.norm() == 0)
    throw Error("arc: expected three points that do not lie on a line");
  const Vec2 centre = from + Vec2(q.y() * p.squaredNorm() - p.y() * q.squaredNorm(),
                                  p.x() * q.squaredNorm() - q.x() * p.squaredNorm()) /
                                 twice;
  return PlaneCurve(std::make_shared<Arc>(centre, from, to, twice < 0));
}

PlaneCurve PlaneCurve::arc_about(const Vec2& centre, const Vec2& from, const Vec2& to, bool clockwise) {
  const double a = (from - centre).norm(), b = (to - centre).norm();
  if (std::abs(a - b) > 1e-6 * std::max(a, b))
    throw Error("arc: expected both ends at one distance from 'centre', got " + number(a) + " and " +
                number(b) + " m");
  if ((from - to).norm() <= 1e-9 * a)
    throw Error("arc: expected different ends (a whole circle is circle={x, y}, radius=)");
  return PlaneCurve(std::make_shared<Arc>(centre, from, to, clockwise));
}

PlaneCurve PlaneCurve::circle(const Vec2& centre, double radius) {
  const Vec2 start = centre + Vec2(radius, 0);
  return PlaneCurve(std::make_shared<Arc>(centre, start, start, false));
}

PlaneCurve PlaneCurve::bezier(const std::vector<Vec2>& points) {
  return PlaneCurve(std::make_shared<Chain>(points));
}

PlaneCurve PlaneCurve::spline(const std::vector<Vec2>& points) {
  std::vector<double> chord;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    chord.push_back((points[i + 1] - points[i]).norm());
    if (chord.back() == 0) throw Error("spline: expected different points, got one twice in succession");
  }
  const std::vector<Vec2> slopes = spline_slopes(points, chord);
  std::vector<Vec2> control{points[0]};
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    control.insert(control.end(), {points[i] + chord[i] / 3 * slopes[i],
                                   points[i + 1] - chord[i] / 3 * slopes[i + 1], points[i + 1]});
  return bezier(control);
}

Vec2 PlaneCurve::at(double place) const { return shape_->at(own(place)); }

Vec2 PlaneCurve::tangent(double place) const {
  const Vec2 along = shape_->tangent(own(place));
  return from_ < to_ ? along : Vec2(-along);
}

bool PlaneCurve::straight() const { return shape_->straight(); }

double PlaneCurve::turning() const { return shape_->turning(std::min(from_, to_), std::max(from_, to_)); }

PlaneCurve PlaneCurve::part(double from, double to) const { return {shape_, own(from), own(to)}; }

PlaneCurve PlaneCurve::reversed() const { return {shape_, to_, from_}; }

// The nearest of some places, then the root of the slope of the distance between its neighbours.
double PlaneCurve::nearest(const Vec2& x) const {
  constexpr int parts = 256;
  const double step = length() / parts;
  int best = 0;
  for (int i = 1; i <= parts; ++i)
    if ((at(i * step) - x).norm() < (at(best * step) - x).norm()) best = i;
  double low = std::max(0, best - 1) * step, high = std::min(parts, best + 1) * step;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((at(middle) - x).dot(tangent(middle)) < 0 ? low : high) = middle;
  }
  const double found = (low + high) / 2;
  for (const double end : {0.0, length()})
    if ((at(end) - x).norm() <= (at(found) - x).norm()) return end;
  return found;
}

}  // namespace fabricsh::mesh
