#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "contact/rigid.hpp"
#include "contact/touch.hpp"
#include "model/gas.hpp"

namespace fabricsh::model {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kAcross = 0.5;    // least share of a rim's area that is seen along the axis of a body
constexpr double kCovered = 1e-2;  // of a hole's area: what facets may leave of it, or cover twice

Vec3 mean_of(const std::vector<Vec3>& points) {
  return std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero())) /
         static_cast<double>(points.size());
}

// Whether the surface encloses a solid, so that its facets face outwards.
bool encloses_solid(const Facets& f) {
  try {
    contact::solid_mass(f.vertices, f.triangles, 1);
    return true;
  } catch (const Error&) {
    return false;
  }
}

struct SeatOn {
  const Vec3& x;
  Vec3 operator()(const Sphere& s) const { return from(s.centre, s.radius, Vec3::UnitZ()); }
  Vec3 operator()(const Plane& p) const {
    const Vec3 n = p.normal.normalized();
    return x - n.dot(x - p.point) * n;
  }
  Vec3 operator()(const Cylinder& c) const {
    const Vec3 way = c.to - c.from;
    const double share = std::clamp(way.dot(x - c.from) / way.squaredNorm(), 0.0, 1.0);
    return from(c.from + share * way, c.radius, way.unitOrthogonal());
  }
  Vec3 operator()(const Disc& d) const {
    const Vec3 n = d.normal.normalized(), off = x - d.centre;
    Vec3 flat = off - n.dot(off) * n;
    if (const double r = flat.norm(), most = d.radius - d.edge; r > most) flat *= most / r;
    return from(d.centre + flat, d.edge, n);
  }
  Vec3 operator()(const Facets& f) const {
    Vec3 best = Vec3::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (const auto& t : f.triangles) {
      const auto corner = [&](std::size_t k) { return f.vertices[static_cast<std::size_t>(t[k])]; };
      if (contact::squared_point_triangle(x, corner(0), corner(1), corner(2)) >= least) continue;
      const auto touch = contact::point_triangle({x, corner(0), corner(1), corner(2)}).touch;
      least = touch.distance * touch.distance;
      best.setZero();
      for (std::size_t k = 0; k < 3; ++k) best -= touch.weight[k + 1] * corner(k);
    }
    return best;
  }
  Vec3 operator()(const MovingFacets& m) const { return (*this)(m.first); }

 private:
  // At a distance from a place towards x; along `other` if x is that place.
  Vec3 from(const Vec3& place, double radius, const Vec3& other) const {
    const Vec3 off = x - place;
    return place + radius * (off.norm() > 0 ? Vec3(off.normalized()) : other);
  }
};

// --- volumes between the fan of a rim's seats and the surface that it encloses, positive where the surface
// lies beyond the fan as seen from the gas

class Bulge {
 public:
  Bulge(const std::vector<Vec3>& seats, std::string name)
      : seats_(seats), middle_(mean_of(seats)), name_(std::move(name)) {
    for (std::size_t i = 0; i < seats.size(); ++i)
      area_ += (seats[i] - middle_).cross(next(i) - middle_) / 2;  // out of the gas
  }

  double operator()(const Plane&) const { return 0; }

  // Seen from the centre, a part of a sphere has r^3/3 times its solid angle; it is negative, since the way
  // out of the gas leads into the ball.
  double operator()(const Sphere& s) const {
    double angle = 0, fan = 0;
    const Vec3 a = seats_[0] - s.centre;
    for (std::size_t i = 0; i < seats_.size(); ++i) {
      const Vec3 b = seats_[i] - s.centre, c = next(i) - s.centre;
      fan += (middle_ - s.centre).dot(b.cross(c)) / 6;
      if (i == 0 || i + 1 == seats_.size()) continue;
      const double r = s.radius;
      angle += 2 * std::atan2(a.dot(b.cross(c)), r * (r * r + a.dot(b) + b.dot(c) + c.dot(a)));
    }
    const double whole = 4 * std::numbers::pi;
    angle -= whole * std::ceil(angle / whole);
    return std::pow(s.radius, 3) * angle / 3 - fan;
  }

  // r h(r) summed from the axis on, where h is the height of the surface over the middle.
  double operator()(const Cylinder& c) const {
    const double half = (c.to - c.from).norm() / 2, R = c.radius;
    return over_axis((c.from + c.to) / 2, c.to - c.from, half, [=](double r) {
      const double below = std::max(0.0, R * R - r * r);
      return half * r * r / 2 + (R * R * R - below * std::sqrt(below)) / 3;
    });
  }
  double operator()(const Disc& d) const {
    const double flat = d.radius - d.edge, e = d.edge;
    return over_axis(d.centre, d.normal, 0, [=](double r) {
      if (r <= flat) return e * r * r / 2;
      const double u = std::min(1.0, (r - flat) / e), v = std::sqrt(1 - u * u);
      return e * flat * flat / 2 + e * e * (flat * (u * v + std::asin(u)) / 2 + e * (1 - v * v * v) / 3);
    });
  }

  // The facets that face the gas, each cut by the triangles of the fan as they are seen along the rim's axis.
  double operator()(const Facets& f) const {
    const Vec3 up = -area_.normalized(), u = up.unitOrthogonal(), v = up.cross(u);
    const auto flat = [&](const Vec3& x) { return Vec2(u.dot(x - middle_), v.dot(x - middle_)); };
    const bool outwards = encloses_solid(f);
    double covered = 0, volume = 0;
    for (const auto& t : f.triangles) {
      std::array<Vec3, 3> facet;
      for (std::size_t k = 0; k < 3; ++k) facet[k] = f.vertices[static_cast<std::size_t>(t[k])];
      const Vec3 normal = (facet[1] - facet[0]).cross(facet[2] - facet[0]);
      const double faces = normal.dot(up);
      if (faces == 0 || (outwards && faces < 0)) continue;
      if (faces < 0) std::swap(facet[1], facet[2]);
      for (std::size_t i = 0; i < seats_.size(); ++i) {
        std::array<Vec3, 3> part{middle_, next(i), seats_[i]};  // seen from the gas
        const Vec3 across = (part[1] - part[0]).cross(part[2] - part[0]);
        double sign = 1;
        if (across.dot(up) < 0) std::swap(part[1], part[2]), sign = -1;
        if (across.dot(up) == 0) continue;
        std::vector<Vec2> cut{flat(facet[0]), flat(facet[1]), flat(facet[2])};
        for (std::size_t k = 0; k < 3; ++k) cut = behind(cut, flat(part[k]), flat(part[(k + 1) % 3]));
        const auto [size, centre] = size_of(cut);
        if (!(size > 0)) continue;
        const double below = height(part, across, u, v, up, centre) - height(facet, normal, u, v, up, centre);
        covered += sign * size;
        volume += sign * size * below;
      }
    }
    const double share = covered / area_.norm();
    if (std::abs(share - 1) > kCovered)
      refuse("as the gas sees it, its facets cover " + number(100 * share, 4) +
             " % of the hole: expected one whole surface behind the rim, without gaps or folds");
    return volume;
  }
  double operator()(const MovingFacets&) const {
    refuse("it changes its shape: expected a body that keeps it");
  }

 private:
  const Vec3& next(std::size_t i) const { return seats_[(i + 1) % seats_.size()]; }
  [[noreturn]] void refuse(const std::string& why) const {
    throw Error("the " + name_ + " does not close the hole at (" + number(middle_.x()) + ", " +
                number(middle_.y()) + ", " + number(middle_.z()) + ") m: " + why);
  }

  // Of a body of revolution with two equal ends. straight: m, from its middle to where its ends begin.
  template <class Summed>
  double over_axis(const Vec3& origin, const Vec3& axis, double straight, Summed summed) const {
    Vec3 up = axis.normalized();
    if (area_.dot(up) > 0) up = -up;
    if (!(-area_.dot(up) >= kAcross * area_.norm()))
      refuse("the rim does not go around its axis: expected it around an end that faces the gas");
    double volume = 0, least = 0;
    for (std::size_t i = 0; i < seats_.size(); ++i) {
      const Vec3 a = middle_ - origin, b = seats_[i] - origin, c = next(i) - origin;
      least = std::min(least, b.dot(up) + straight);
      // The triangle seen from the gas, under which the heights are those of the fan.
      const double under = (c - a).cross(b - a).dot(up) / 2;
      volume += under * (a + b + c).dot(up) / 3;
      volume -= sector(b - up * up.dot(b), c - up * up.dot(c), -up, summed);
    }
    if (least < -1e-6 * area_.norm() / std::sqrt(area_.norm()))
      refuse("the rim is behind its middle, " + number(-least) +
             " m: expected it around the end that faces the gas");
    return volume;
  }

  // Over the triangle from the axis to the chord between two points, in polar coordinates about the axis.
  template <class Summed>
  static double sector(const Vec3& p, const Vec3& q, const Vec3& around, Summed summed) {
    constexpr int parts = 16;
    constexpr double place[4] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                 0.8611363115940526},
                     weight[4] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                  0.3478548451374538};  // of Gauss
    const double turned = p.cross(q).dot(around);
    double sum = 0;
    for (int k = 0; k < parts; ++k)
      for (int g = 0; g < 4; ++g) {
        const Vec3 x = p + (k + (1 + place[g]) / 2) / parts * (q - p);
        const double r2 = x.squaredNorm();
        if (r2 > 0) sum += weight[g] / 2 / parts * summed(std::sqrt(r2)) * turned / r2;
      }
    return sum;
  }

  // The part of a convex polygon to the left of the line from a to b.
  static std::vector<Vec2> behind(const std::vector<Vec2>& polygon, const Vec2& a, const Vec2& b) {
    const auto side = [&](const Vec2& x) { return (b - a).x() * (x - a).y() - (b - a).y() * (x - a).x(); };
    std::vector<Vec2> out;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double sp = side(p), sq = side(q);
      if (sp >= 0) out.push_back(p);
      if ((sp > 0 && sq < 0) || (sp < 0 && sq > 0)) out.push_back(p + sp / (sp - sq) * (q - p));
    }
    return out;
  }
  // Area and centre of a convex polygon.
  static std::pair<double, Vec2> size_of(const std::vector<Vec2>& polygon) {
    double area = 0;
    Vec2 moment = Vec2::Zero();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      const Vec2 p = polygon[i] - polygon[0], q = polygon[i + 1] - polygon[0];
      const double part = (p.x() * q.y() - p.y() * q.x()) / 2;
      area += part;
      moment += part * (polygon[0] + (p + q) / 3);
    }
    return {area, area > 0 ? Vec2(moment / area) : Vec2(Vec2::Zero())};
  }
  // m, of a triangle's plane over the middle at a place as it is seen.
  double height(const std::array<Vec3, 3>& triangle, const Vec3& normal, const Vec3& u, const Vec3& v,
                const Vec3& up, const Vec2& place) const {
    const Vec3 flat = middle_ + place.x() * u + place.y() * v;
    return normal.dot(triangle[0] - flat) / normal.dot(up);
  }

  const std::vector<Vec3>& seats_;
  const Vec3 middle_;
  const std::string name_;
  Vec3 area_ = Vec3::Zero();  // m2
};

}  // namespace

Vec3 seat_on(const Rigid& body, const Vec3& point) { return std::visit(SeatOn{point}, body.shape()); }

BodyLid body_lid(std::vector<mesh::Index> rim, const mesh::Mesh& mesh, RigidPointer body,
                 const std::string& name) {
  BodyLid lid{std::move(rim), std::move(body), {}, 0};
  for (const mesh::Index n : lid.rim)
    lid.seats.push_back(seat_on(*lid.body, mesh.nodes[static_cast<std::size_t>(n)]));
  lid.bulge = std::visit(Bulge(lid.seats, name), lid.body->shape());
  return lid;
}

}  // namespace fabricsh::model
