// Rigid bodies that move: where they are, how they turn, what they weigh.
//
// A body is a set of points given in its own frame (origin at the centre of mass, for a driven body
// anywhere). One that stands or is driven is told where it is; one that is free moves under forces and
// torques.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "contact/intersect.hpp"

namespace fabricsh::contact {

// x = place + turn * (point of the body).
struct Pose {
  Vec3 place = Vec3::Zero();  // m
  Mat3 turn = Mat3::Identity();
  Vec3 operator()(const Vec3& own) const { return place + turn * own; }
  // The rotation by an angle (radian) about an axis of any length but zero.
  static Mat3 about(const Vec3& axis, double angle);
};

struct Mass {
  double mass = 0;              // kg
  Vec3 centre = Vec3::Zero();   // m, in the frame that it was worked out in
  Mat3 inertia = Mat3::Zero();  // kg m2 about the centre
};
Mass ball_mass(const Vec3& centre, double radius, double mass);
// A cylinder with round ends, as a rod is in contact.
Mass rod_mass(const Vec3& from, const Vec3& to, double radius, double mass);
// A flat cylinder.
Mass disc_mass(const Vec3& centre, const Vec3& normal, double radius, double thickness, double mass);
// What a closed surface of triangles (counter-clockwise from outside) encloses, evenly filled. Errors: a
// surface that is open, or encloses no positive volume.
Mass solid_mass(std::span<const Vec3> vertices, std::span<const Triangle> triangles, double mass);

// A free body. Between forces its rotation is split into turns about its three principal axes, each of them
// exact [dullweber1997]: angular momentum in space is kept to rounding, energy to the square of the step
// without drift.
class FreeBody {
 public:
  // `at`: the centre of mass and the body's frame in which `mass.inertia` was worked out (turned with the
  // body). Errors: mass or a principal moment not positive and finite.
  FreeBody(const Mass& mass, const Vec3& velocity, const Vec3& spin);

  // Adds a force (N) and a torque about the centre of mass (N m), in space, over `dt` (s).
  void kick(const Vec3& force, const Vec3& torque, double dt);
  // Moves and turns for dt (s) without forces.
  void drift(double dt);

  Pose pose() const { return {place_, turn_ * frame_.transpose()}; }  // of the frame of the body at the start
  const Vec3& centre() const { return place_; }                       // m
  const Vec3& velocity() const { return velocity_; }                  // m/s
  Vec3 spin() const;                                                  // radian/s, in space
  const Vec3& angular_momentum() const { return momentum_; }          // kg m2/s about the centre, in space
  Vec3 velocity_at(const Vec3& x) const { return velocity_ + spin().cross(x - place_); }
  double kinetic_energy() const;  // J
  double mass() const { return mass_; }
  Mat3 inertia() const;  // in space, kg m2
  // 1/kg: how readily a point at x gives way along the unit vector n.
  double inverse_mass_at(const Vec3& x, const Vec3& n) const;

  template <class Archive>
  void keep(Archive& archive) {
    archive.filled({place_.data(), 3});
    archive.filled({velocity_.data(), 3});
    archive.filled({momentum_.data(), 3});
    archive.filled({turn_.data(), 9});
  }

 private:
  void turn_about(int axis, Vec3& own, double dt);
  double mass_ = 0;
  Vec3 moments_ = Vec3::Ones();    // principal, kg m2
  Mat3 frame_ = Mat3::Identity();  // principal axes in the frame at the start
  Vec3 place_ = Vec3::Zero(), velocity_ = Vec3::Zero();
  Vec3 momentum_ = Vec3::Zero();  // angular, in space
  Mat3 turn_ = Mat3::Identity();  // from principal axes to space
};

// Sum of the forces on a body's points, and their torque about a place, N and N m; in the points' order.
struct Wrench {
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
};
Wrench wrench(std::span<const Vec3> x, std::span<const Vec3> force, const Vec3& about);

// A surface that moves from shape to shape: vertices at times that ascend, straight lines between them;
// before the first and after the last it stands.
class MovingShape {
 public:
  // Errors: no shapes, another number of times, times that do not ascend, shapes of different numbers of
  // vertices, a vertex that is not finite.
  MovingShape(std::vector<double> times, std::vector<std::vector<Vec3>> shapes);
  void at(double time, std::span<Vec3> x) const;        // m
  void velocity(double time, std::span<Vec3> v) const;  // m/s, of the line that follows the time

 private:
  std::vector<double> times_;
  std::vector<std::vector<Vec3>> shapes_;
};

}  // namespace fabricsh::contact
