#include "contact/touch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/plane.hpp"

namespace fabricsh::contact {
namespace {

// Computes vector, distance and normal of a touch whose weights are known.
void measure(const Corners& x, Touch& touch) {
  Vec3 r = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i)
    if (touch.weight[i] != 0) r += touch.weight[i] * x[i];
  touch.distance = r.norm();
  if (touch.distance > 0) touch.normal = r / touch.distance;
}

// The parameter of the closest point on a segment, from 0 to 1.
double along(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 u = b - a;
  const double length = u.squaredNorm();
  return length > 0 ? std::clamp(u.dot(p - a) / length, 0.0, 1.0) : 0;
}

void set_parameter(Touch& touch, int k, int plus, int minus) {
  touch.plus[std::size_t(k)] = static_cast<std::int8_t>(plus);
  touch.minus[std::size_t(k)] = static_cast<std::int8_t>(minus);
}

// Where the closest point of a triangle lies: the face, or a border region [ericson2005, sec. 5.1.5].
struct TriangleRegion {
  int on = 0;           // 0: the face
  bool corner = false;  // `on` is a corner; otherwise an edge, named by its opposite corner
  double v = 0, w = 0;  // weights of the second and third corner on the face
  std::size_t part() const { return std::size_t(corner ? 3 + on : on); }
};

TriangleRegion region(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp),
               d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return {1, true};
  if (d3 >= 0 && d4 <= d3) return {2, true};
  if (d6 >= 0 && d5 <= d6) return {3, true};
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {3, false};
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {2, false};
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return {1, false};
  const double sum = va + vb + vc;
  return {0, false, vb / sum, vc / sum};
}

// Whether the closest points of two lines lie inside of their segments, and where.
struct Crossing {
  double s = 0, t = 0;
  bool inside = false;
};

Crossing crossing(const Vec3& u, const Vec3& v, const Vec3& r) {
  const double a = u.dot(u), b = u.dot(v), c = v.dot(v), e = u.dot(r), f = v.dot(r);
  const double det = a * c - b * b;
  if (!(det > 1e-14 * a * c)) return {};
  const double s = b * f - c * e, t = a * f - b * e;
  // Most edges that are near do not cross: no division for those.
  if (!(s > 0 && s < det && t > 0 && t < det)) return {};
  return {s / det, t / det, true};
}

}  // namespace

Touch point_point(const Corners& x, int p, int q) {
  Touch touch;
  touch.weight[std::size_t(p)] = 1;
  touch.weight[std::size_t(q)] = -1;
  measure(x, touch);
  return touch;
}

Touch point_segment(const Corners& x, int p, int a, int b) {
  const double t = along(x[std::size_t(p)], x[std::size_t(a)], x[std::size_t(b)]);
  if (t <= 0) return point_point(x, p, a);
  if (t >= 1) return point_point(x, p, b);
  Touch touch;
  touch.feature = Feature::point_edge;
  touch.weight[std::size_t(p)] = 1;
  touch.weight[std::size_t(a)] = -(1 - t);
  touch.weight[std::size_t(b)] = -t;
  set_parameter(touch, 0, a, b);
  measure(x, touch);
  return touch;
}

FacetTouch point_triangle(const Corners& x) {
  const TriangleRegion at = region(x[0], x[1], x[2], x[3]);
  if (at.corner) return {point_point(x, 0, at.on), at.part()};
  if (at.on != 0) return {point_segment(x, 0, at.on % 3 + 1, (at.on + 1) % 3 + 1), at.part()};
  Touch touch;
  touch.feature = Feature::face;
  touch.weight = {1, -(1 - at.v - at.w), -at.v, -at.w};
  set_parameter(touch, 0, 1, 2);
  set_parameter(touch, 1, 1, 3);
  measure(x, touch);
  return {touch, 0};
}

std::size_t nearest_part(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  return region(p, a, b, c).part();
}

Touch point_plane(const Corners& x) {
  const Plane& plane = plane_through(x);
  const Vec3 r = x[0] - x[1];
  const double e = vector_of(plane.u).dot(r), f = vector_of(plane.v).dot(r);
  const double s = (plane.c * e - plane.b * f) / plane.det, t = (plane.a * f - plane.b * e) / plane.det;
  Touch touch;
  touch.feature = Feature::face;
  touch.weight = {1, -(1 - s - t), -s, -t};
  set_parameter(touch, 0, 1, 2);
  set_parameter(touch, 1, 1, 3);
  touch.normal = vector_of(plane.normal);
  touch.distance = touch.normal.dot(r);
  return touch;
}

std::optional<Touch> segments_crossing(const Corners& x) {
  const Crossing at = crossing(x[1] - x[0], x[3] - x[2], x[0] - x[2]);
  if (!at.inside) return {};
  Touch touch;
  touch.feature = Feature::crossing;
  touch.weight = {1 - at.s, at.s, -(1 - at.t), -at.t};
  set_parameter(touch, 0, 1, 0);
  set_parameter(touch, 1, 2, 3);
  measure(x, touch);
  return touch;
}

Touch segment_segment(const Corners& x) {
  if (const std::optional<Touch> crossing = segments_crossing(x)) return *crossing;
  Touch best = point_segment(x, 0, 2, 3);
  const auto better = [&](const Touch& other) {
    if (other.distance < best.distance) best = other;
  };
  better(point_segment(x, 1, 2, 3));
  for (const int p : {2, 3}) {
    Touch other = point_segment(x, p, 0, 1);
    other.normal = -other.normal;
    for (double& w : other.weight) w = -w;
    std::swap(other.plus, other.minus);
    better(other);
  }
  return best;
}

double squared_point_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  return (p - a - along(p, a, b) * (b - a)).squaredNorm();
}

double squared_point_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const TriangleRegion at = region(p, a, b, c);
  const Vec3* corner[] = {&a, &b, &c};
  if (at.corner) return (p - *corner[at.on - 1]).squaredNorm();
  if (at.on != 0) return squared_point_segment(p, *corner[at.on % 3], *corner[(at.on + 1) % 3]);
  return (p - a - at.v * (b - a) - at.w * (c - a)).squaredNorm();
}

double squared_crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = d - c, r = a - c;
  const Crossing at = crossing(u, v, r);
  return at.inside ? (r + at.s * u - at.t * v).squaredNorm() : std::numeric_limits<double>::infinity();
}

double squared_segment_segment(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  if (const double crossing = squared_crossing(a, b, c, d); std::isfinite(crossing)) return crossing;
  return std::min(std::min(squared_point_segment(a, c, d), squared_point_segment(b, c, d)),
                  std::min(squared_point_segment(c, a, b), squared_point_segment(d, a, b)));
}

Slides slides(const Corners& x, const Touch& touch) {
  Slides out;
  for (auto& row : out) row.fill(Vec3::Zero());
  const int n = touch.freedoms();
  if (n == 0) return out;
  // At the closest points r . r,k = 0. Since r is linear in the parameters, the
  // derivative of that is (r,k . r,l) dxi_l/dx_j = -(dw_j/dxi_k r + w_j r,k).
  const Vec3 r = touch.distance * touch.normal;
  std::array<Vec3, 2> direction;
  std::array<std::array<Vec3, 4>, 2> right;
  for (std::size_t k = 0; k < std::size_t(n); ++k) {
    direction[k] = x[std::size_t(touch.plus[k])] - x[std::size_t(touch.minus[k])];
    for (std::size_t j = 0; j < 4; ++j) right[k][j] = -touch.weight[j] * direction[k];
    right[k][std::size_t(touch.plus[k])] -= r;
    right[k][std::size_t(touch.minus[k])] += r;
  }
  const double a = direction[0].squaredNorm();
  if (n == 1) {
    for (std::size_t j = 0; j < 4; ++j) out[0][j] = right[0][j] / a;
    return out;
  }
  const double b = direction[0].dot(direction[1]), c = direction[1].squaredNorm(), det = a * c - b * b;
  for (std::size_t j = 0; j < 4; ++j) {
    out[0][j] = (c * right[0][j] - b * right[1][j]) / det;
    out[1][j] = (a * right[1][j] - b * right[0][j]) / det;
  }
  return out;
}

Vector12 distance_gradient(const Touch& touch) {
  Vector12 g;
  for (int i = 0; i < 4; ++i) g.segment<3>(3 * i) = touch.weight[std::size_t(i)] * touch.normal;
  return g;
}

Matrix12 distance_hessian(const Corners& x, const Touch& touch, Blocks of) {
  // The Hessian of r.r/2 is w_i w_j I + sum over k of (dw_i/dxi_k r + w_i r,k) dxi_k/dx_j. Subtracting
  // the square of the gradient and dividing by the distance gives the Hessian of the distance.
  const Slides slide = slides(x, touch);
  const Vec3 r = touch.distance * touch.normal;
  const Mat3 across = Mat3::Identity() - touch.normal * touch.normal.transpose();
  const auto block = [&](std::size_t i, std::size_t j) {
    Mat3 out = touch.weight[i] * touch.weight[j] * across;
    for (std::size_t k = 0; k < std::size_t(touch.freedoms()); ++k) {
      const auto plus = std::size_t(touch.plus[k]), minus = std::size_t(touch.minus[k]);
      Vec3 left = touch.weight[i] * (x[plus] - x[minus]);
      if (i == plus) left += r;
      if (i == minus) left -= r;
      out += left * slide[k][j].transpose();
    }
    return out;
  };
  // Terms that almost cancel leave an unsymmetric rounding error, which is removed here.
  Matrix12 h = Matrix12::Zero();
  each_corner(of.rows & touch.corners(), [&](std::size_t i) {
    each_corner(of.columns & touch.corners(), [&](std::size_t j) {
      h.block<3, 3>(3 * int(i), 3 * int(j)) = 0.5 / touch.distance * (block(i, j) + block(j, i).transpose());
    });
  });
  return h;
}

}  // namespace fabricsh::contact
