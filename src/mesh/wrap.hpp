// A flat mesh laid around a cylinder or a cone, with lengths kept.
#pragma once
#include "mesh/panel.hpp"

namespace fabricsh::mesh {

// A cylinder, or with an angle a cone. The point `at` of the panel comes to lie at the distance `radius` from
// the axis, beside `from` in the direction `towards`; +y of the panel runs there along the axis, and +x
// around it counter-clockwise, so that the normal of the panel points outward.
struct Wrap {
  double radius = 0;          // m
  double angle = 0;           // between axis and surface, degrees, -90 to 90; positive: wider along the axis
  Vec3 from = Vec3::Zero();   // a point of the axis, m
  Vec3 axis = Vec3::UnitZ();  // any length but 0
  Vec3 towards = Vec3::Zero();  // zero: +x, or +y if the axis is along x, made square to the axis
  Vec2 at = Vec2::Zero();       // m, in the plane of the panel
  bool overlap = false;         // it may go around more than once
};

// Moves the nodes of a mesh in the x-y plane onto the surface. On a cone: what is at the distance s from the
// apex in the plane is at the distance s from the apex on the cone, and the angle about it grows by
// 1 / sin(angle); areas, lengths and angles stay. Errors, before any node is moved: a mesh that is not in the
// x-y plane, or in use; an axis without length, or along `towards`; the apex of the cone in the panel (or a
// panel that runs around it); more than 360 degrees without `overlap`; an element over more than 60 degrees.
void wrap(Mesh& mesh, const Wrap& shape);

}  // namespace fabricsh::mesh
