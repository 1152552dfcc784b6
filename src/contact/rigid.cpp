#include "contact/rigid.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "base/number.hpp"

namespace fabricsh::contact {
namespace {

[[noreturn]] void refuse_body(const std::string& what) { throw Error("rigid body: " + what); }

// Inertia of a body of revolution from its moments along and perpendicular to its axis.
Mat3 about_axis(const Vec3& axis, double along, double across) {
  const Vec3 n = axis.normalized();
  return across * Mat3::Identity() + (along - across) * n * n.transpose();
}

void check_closed(std::span<const Vec3> vertices, std::span<const Triangle> triangles) {
  const std::vector<Edge> open = open_edges(triangles);
  if (open.empty() && !triangles.empty()) return;
  std::string where;
  if (!open.empty()) {
    const Vec3 middle = (vertices[std::size_t(open[0][0])] + vertices[std::size_t(open[0][1])]) / 2;
    where = ", one of them about (" + number(middle.x()) + ", " + number(middle.y()) + ", " +
            number(middle.z()) + ") m";
  }
  refuse_body("expected a closed surface, whose every edge two triangles walk in opposite senses; " +
              std::to_string(open.size()) + " edges are not" + where);
}

}  // namespace

Mat3 Pose::about(const Vec3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

Mass ball_mass(const Vec3& centre, double radius, double mass) {
  return {mass, centre, 0.4 * mass * radius * radius * Mat3::Identity(),
          4.0 / 3 * std::numbers::pi * radius * radius * radius};
}

Mass rod_mass(const Vec3& from, const Vec3& to, double radius, double mass) {
  const double l = (to - from).norm(), r = radius;
  const double cylinder = l * r * r, ball = 4.0 / 3 * r * r * r;  // volumes divided by pi
  const double mc = mass * cylinder / (cylinder + ball), mb = mass - mc;
  const double along = mc * r * r / 2 + mb * 0.4 * r * r;
  const double across = mc * (l * l / 12 + r * r / 4) + mb * (0.4 * r * r + l * l / 4 + 3 * l * r / 8);
  return {mass, 0.5 * (from + to), about_axis(to - from, along, across),
          std::numbers::pi * (cylinder + ball)};
}

Mass disc_mass(const Vec3& centre, const Vec3& normal, double radius, double thickness, double mass) {
  const double along = mass * radius * radius / 2;
  return {mass, centre, about_axis(normal, along, along / 2 + mass * thickness * thickness / 12),
          std::numbers::pi * radius * radius * thickness};
}

Mass solid_mass(std::span<const Vec3> vertices, std::span<const Triangle> triangles, double mass) {
  check_closed(vertices, triangles);
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();  // integral of x x^T
  const Vec3 origin = vertices.empty() ? Vec3(Vec3::Zero()) : vertices[0];
  for (const Triangle& t : triangles) {  // sum over tetrahedra with a corner at the origin
    const Vec3 a = vertices[std::size_t(t[0])] - origin, b = vertices[std::size_t(t[1])] - origin,
               c = vertices[std::size_t(t[2])] - origin, sum = a + b + c;
    const double v = a.dot(b.cross(c)) / 6;
    volume += v;
    first += v / 4 * sum;
    second += v / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  if (!(volume > 0)) refuse_body("expected triangles that run counter-clockwise as seen from outside");
  const Vec3 centre = first / volume;
  second -= volume * centre * centre.transpose();
  return {mass, origin + centre, mass / volume * (second.trace() * Mat3::Identity() - second), volume};
}

FreeBody::FreeBody(const Mass& mass, const Vec3& velocity, const Vec3& spin)
    : mass_(mass.mass), place_(mass.centre), velocity_(velocity), momentum_(mass.inertia * spin) {
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(mass.inertia);
  moments_ = principal.eigenvalues();
  frame_ = principal.eigenvectors();
  if (frame_.determinant() < 0) frame_.col(0) = -frame_.col(0);
  turn_ = frame_;
  if (!(mass_ > 0) || !std::isfinite(mass_))
    refuse_body("mass: expected a positive number in kg, got " + number(mass_));
  if (!(moments_.minCoeff() > 0) || !moments_.allFinite())
    refuse_body("expected an inertia with positive moments");
  if (!velocity.allFinite() || !spin.allFinite()) refuse_body("expected a finite velocity and spin");
}

void FreeBody::kick(const Vec3& force, const Vec3& torque, double dt) {
  velocity_ += dt / mass_ * force;
  momentum_ += dt * torque;
}

void FreeBody::rest() {
  velocity_.setZero();
  momentum_.setZero();
}

// The exact motion under the part H = own_axis^2 / (2 moment)
// of the energy, with the angular momentum in principal axes.
void FreeBody::turn_about(int axis, Vec3& own, double dt) {
  const double angle = dt * own[axis] / moments_[axis];
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double c = std::cos(angle), s = std::sin(angle), a = own[i], b = own[j];
  own[i] = c * a + s * b;
  own[j] = c * b - s * a;
  const Vec3 p = turn_.col(i), q = turn_.col(j);
  turn_.col(i) = c * p + s * q;
  turn_.col(j) = c * q - s * p;
}

void FreeBody::drift(double dt) {
  place_ += dt * velocity_;
  Vec3 own = turn_.transpose() * momentum_;
  turn_about(0, own, dt / 2);
  turn_about(1, own, dt / 2);
  turn_about(2, own, dt);
  turn_about(1, own, dt / 2);
  turn_about(0, own, dt / 2);
  // Rounding would make the axes drift from orthonormality;
  // one Newton step towards the nearest rotation prevents it.
  turn_ = 0.5 * turn_ * (3 * Mat3::Identity() - turn_.transpose() * turn_);
}

Vec3 FreeBody::spin() const {
  const Vec3 own = turn_.transpose() * momentum_;
  return turn_ * own.cwiseQuotient(moments_);
}

double FreeBody::kinetic_energy() const {
  return 0.5 * (mass_ * velocity_.squaredNorm() + momentum_.dot(spin()));
}

Mat3 FreeBody::inertia() const { return turn_ * moments_.asDiagonal() * turn_.transpose(); }

Wrench wrench(std::span<const Vec3> x, std::span<const Vec3> force, const Vec3& about) {
  Wrench out;
  for (std::size_t i = 0; i < x.size(); ++i) {
    out.force += force[i];
    out.torque += (x[i] - about).cross(force[i]);
  }
  return out;
}

MovingShape::MovingShape(std::vector<double> times, std::vector<std::vector<Vec3>> shapes)
    : times_(std::move(times)), shapes_(std::move(shapes)) {
  if (shapes_.empty() || times_.size() != shapes_.size())
    refuse_body("moving surface: expected as many times as shapes and at least one, got " +
                std::to_string(times_.size()) + " and " + std::to_string(shapes_.size()));
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    if (!std::isfinite(times_[i]) || (i > 0 && !(times_[i] > times_[i - 1])))
      refuse_body("moving surface: expected finite times (s) that ascend, got " + number(times_[i]) +
                  " as number " + std::to_string(i + 1));
    if (shapes_[i].size() != shapes_[0].size())
      refuse_body("moving surface: shape " + std::to_string(i + 1) + " has " +
                  std::to_string(shapes_[i].size()) + " vertices, the first has " +
                  std::to_string(shapes_[0].size()));
    for (const Vec3& x : shapes_[i])
      if (!x.allFinite())
        refuse_body("moving surface: shape " + std::to_string(i + 1) + " has a vertex that is not finite");
  }
}

void MovingShape::at(double time, std::span<Vec3> x) const {
  const auto after = std::size_t(std::upper_bound(times_.begin(), times_.end(), time) - times_.begin());
  if (after == 0 || after == times_.size()) {
    const auto& shape = shapes_[after == 0 ? 0 : after - 1];
    std::copy(shape.begin(), shape.end(), x.begin());
    return;
  }
  const double share = (time - times_[after - 1]) / (times_[after] - times_[after - 1]);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = (1 - share) * shapes_[after - 1][i] + share * shapes_[after][i];
}

void MovingShape::velocity(double time, std::span<Vec3> v) const {
  const auto after = std::size_t(std::upper_bound(times_.begin(), times_.end(), time) - times_.begin());
  const bool stands = after == 0 || after == times_.size();
  for (std::size_t i = 0; i < v.size(); ++i) {
    v[i] = Vec3::Zero();
    if (!stands) v[i] = (shapes_[after][i] - shapes_[after - 1][i]) / (times_[after] - times_[after - 1]);
  }
}

}  // namespace fabricsh::contact
