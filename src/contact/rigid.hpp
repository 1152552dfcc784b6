// Rigid bodies that move: pose, rotation, mass and inertia.
//
// A body is a set of points in its own frame, with the origin at the
// centre of mass (for a driven body anywhere). The pose of a fixed or
// driven body is prescribed; a free body moves under forces and torques.
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
  // The rotation by an angle (rad) about an axis of any nonzero length.
  static Mat3 about(const Vec3& axis, double angle);
};

struct Mass {
  double mass = 0;              // kg
  Vec3 centre = Vec3::Zero();   // m, in the frame of the given geometry
  Mat3 inertia = Mat3::Zero();  // kg m2 about the centre
  double volume = 0;            // m3
};
Mass ball_mass(const Vec3& centre, double radius, double mass);
// A cylinder with hemispherical ends, as a rod has in contact.
Mass rod_mass(const Vec3& from, const Vec3& to, double radius, double mass);
// A flat cylinder.
Mass disc_mass(const Vec3& centre, const Vec3& normal, double radius, double thickness, double mass);
// A homogeneous solid bounded by a closed surface of triangles (counter-clockwise
// seen from outside). Errors: the surface is open or encloses no positive volume.
Mass solid_mass(std::span<const Vec3> vertices, std::span<const Triangle> triangles, double mass);

// A free body. Its rotation without torque is split into rotations about the three principal
// axes, each of them exact [dullweber1997]. The angular momentum in space is conserved to
// rounding, and the error of the energy is of second order in the step without drift.
class FreeBody {
 public:
  // `mass.centre` is the initial position; `velocity` and `spin` are initial
  // values. Errors: a mass or a principal moment that is not positive and finite.
  FreeBody(const Mass& mass, const Vec3& velocity, const Vec3& spin);

  // Applies a force (N) and a torque about the centre of mass (N m), both in space, for `dt` (s).
  void kick(const Vec3& force, const Vec3& torque, double dt);
  // Moves and rotates for dt (s) without forces.
  void drift(double dt);
  void rest();  // takes its velocity and its spin

  Pose pose() const { return {place_, turn_ * frame_.transpose()}; }  // of the body's frame at the start
  const Vec3& centre() const { return place_; }                       // m
  const Vec3& velocity() const { return velocity_; }                  // m/s
  Vec3 spin() const;                                                  // radian/s, in space
  const Vec3& angular_momentum() const { return momentum_; }          // kg m2/s about the centre, in space
  Vec3 velocity_at(const Vec3& x) const { return velocity_ + spin().cross(x - place_); }
  double kinetic_energy() const;  // J
  double mass() const { return mass_; }
  Mat3 inertia() const;  // in space, kg m2

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
  Vec3 moments_ = Vec3::Ones();    // principal moments, kg m2
  Mat3 frame_ = Mat3::Identity();  // principal axes in the initial frame of the body
  Vec3 place_ = Vec3::Zero(), velocity_ = Vec3::Zero();
  Vec3 momentum_ = Vec3::Zero();  // angular momentum, in space
  Mat3 turn_ = Mat3::Identity();  // rotation from principal axes to space
};

// Sum of the forces on a body's points (N) and their torque about a point (N m), in the points' order.
struct Wrench {
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
};
Wrench wrench(std::span<const Vec3> x, std::span<const Vec3> force, const Vec3& about);

// A surface that changes its shape: vertices at ascending times with linear
// motion between them; at rest before the first and after the last time.
class MovingShape {
 public:
  // Errors: no shapes, a different number of times, times that do not ascend,
  // shapes with different numbers of vertices, a vertex that is not finite.
  MovingShape(std::vector<double> times, std::vector<std::vector<Vec3>> shapes);
  void at(double time, std::span<Vec3> x) const;        // m
  void velocity(double time, std::span<Vec3> v) const;  // m/s, to the right of the time

 private:
  std::vector<double> times_;
  std::vector<std::vector<Vec3>> shapes_;
};

}  // namespace fabricsh::contact
