// Rigid bodies that close holes of volumes of gas.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/rigid.hpp"

namespace fabricsh::model {

// A hole whose rim lies at a rigid body: the part of the body's surface within the rim bounds the gas. A
// uniform pressure pushes on any surface within the same rim with the same force and moment, so that beside
// its volume nothing of the part's shape matters.
struct BodyLid {
  std::vector<mesh::Index> rim;  // nodes around the hole, in the order of a face that is seen from outside
  RigidPointer body;
  std::vector<Vec3> seats;  // m, at time 0: the place on the body's surface that is nearest to each of them
  double bulge = 0;         // m3, between the fan of the seats about their mean and the body's surface
};

// m, the place on the body's surface that is nearest to a point, as it is at time 0.
Vec3 seat_on(const Rigid& body, const Vec3& point);
// Error: the rim does not enclose a part of the surface that is seen whole from the gas; `name` of the body.
BodyLid body_lid(std::vector<mesh::Index> rim, const mesh::Mesh& mesh, RigidPointer body,
                 const std::string& name);

}  // namespace fabricsh::model
