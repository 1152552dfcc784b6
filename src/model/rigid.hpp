// A rigid body as declared: its shape at time 0, and its mass if it is free.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "contact/rigid.hpp"
#include "geometry/vec.hpp"
#include "model/facets.hpp"

namespace fabricsh::contact {
class Scene;
}

namespace fabricsh::model {

struct Sphere {
  double radius = 0;           // m
  Vec3 centre = Vec3::Zero();  // m
};
// The half space behind the point, seen from the side to which the normal points, is solid.
struct Plane {
  Vec3 point = Vec3::Zero();    // m
  Vec3 normal = Vec3::UnitZ();  // of any length
};
// With hemispherical ends.
struct Cylinder {
  double radius = 0;                             // m
  Vec3 from = Vec3::Zero(), to = Vec3::UnitX();  // m
};
// A flat disc; its thickness is twice the radius of its rounded edge.
struct Disc {
  double radius = 0;                                   // m, over all
  Vec3 centre = Vec3::Zero(), normal = Vec3::UnitZ();  // m
  double edge = 0;                                     // m, radius of its edge
};
// The same facets with moving vertices; the motion is linear between the times.
struct MovingFacets {
  Facets first;
  std::vector<double> times;              // s, ascending
  std::vector<std::vector<Vec3>> shapes;  // m, a list of vertices for each time
};
using RigidShape = std::variant<Sphere, Plane, Cylinder, Disc, Facets, MovingFacets>;

class Rigid {
 public:
  // `call` names the shape in messages, and the body if it has no name. Errors: sizes that are not positive
  // and finite; a plane or a moving surface with a mass; an open surface with a mass, or one declared closed;
  // shapes with different facets; times that do not ascend.
  Rigid(RigidShape shape, std::optional<double> mass, std::string name, const std::string& call);

  const RigidShape& shape() const { return shape_; }
  const std::optional<double>& mass() const { return mass_; }  // kg; none: fixed or driven
  bool free() const { return mass_.has_value(); }
  const std::string& name() const { return name_; }  // as given; empty: none
  const std::string& kind() const { return kind_; }  // "sphere"
  // Default centre of rotations and the position that a:body returns, m: the centre of mass of a free body,
  // otherwise that of the shape, of a surface that of its area.
  const Vec3& centre() const { return centre_; }
  contact::Mass weigh() const;  // of a free body
  const MovingFacets* moving() const { return std::get_if<MovingFacets>(&shape_); }
  const Facets* facets() const;  // null: the shape is not a surface
  std::string describe() const;  // "sphere of radius 0.03 m at (0, 0, 0.1) m"

 private:
  void check() const;
  RigidShape shape_;
  std::optional<double> mass_;
  std::string name_, kind_;
  Vec3 centre_ = Vec3::Zero();
};
using RigidPointer = std::shared_ptr<const Rigid>;

// Adds the body to the scene; returns the number of its surface.
int add_to(contact::Scene& scene, const Rigid& body);

// Triangles for showing the body at time 0, m. A sphere and a cylinder are approximated by facets; a plane
// becomes a square of size `extent` (m) about its point.
Facets shown(const Rigid& body, double extent);

}  // namespace fabricsh::model
