// Plane curves by their length: lines, arcs of circles, cubic splines and Bezier curves.
#pragma once
#include <memory>
#include <vector>

namespace fabricsh::mesh {

using Vec2 = Eigen::Vector2d;

// A curve, or a part of one, in either direction. Places on it are lengths from its start, m, 0 to length().
class PlaneCurve {
 public:
  struct Shape;

  static PlaneCurve line(const Vec2& from, const Vec2& to);
  // The arc from a point through a second one to a third. Error: the three lie on a line.
  static PlaneCurve arc_through(const Vec2& from, const Vec2& through, const Vec2& to);
  // Counter-clockwise unless `clockwise`. Error: the two points are not at one distance from the centre
  // (to 1e-6 of it), or they are one point.
  static PlaneCurve arc_about(const Vec2& centre, const Vec2& from, const Vec2& to, bool clockwise);
  // Counter-clockwise from the +x direction.
  static PlaneCurve circle(const Vec2& centre, double radius);
  // Cubic Bezier curves one after the other: 3 n + 1 points, of which each third lies on the curve.
  static PlaneCurve bezier(const std::vector<Vec2>& points);
  // The cubic spline through the points over the lengths of their chords, without curvature at its two ends.
  // Error: two points that follow each other are one.
  static PlaneCurve spline(const std::vector<Vec2>& points);

  double length() const { return std::abs(to_ - from_); }
  Vec2 at(double place) const;
  Vec2 tangent(double place) const;  // unit vector
  Vec2 start() const { return at(0); }
  Vec2 end() const { return at(length()); }
  bool straight() const;
  // Radians through which the direction turns along the curve, without sign.
  double turning() const;
  PlaneCurve part(double from, double to) const;
  PlaneCurve reversed() const;
  // The place of the point of the curve that is nearest to x.
  double nearest(const Vec2& x) const;

 private:
  PlaneCurve(std::shared_ptr<const Shape> shape, double from, double to)
      : shape_(std::move(shape)), from_(from), to_(to) {}
  explicit PlaneCurve(std::shared_ptr<const Shape> shape);
  double own(double place) const { return from_ < to_ ? from_ + place : from_ - place; }

  std::shared_ptr<const Shape> shape_;
  double from_, to_;  // places on the shape; from_ > to_: against its direction
};

}  // namespace fabricsh::mesh
