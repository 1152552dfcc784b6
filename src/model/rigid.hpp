// A rigid body as it is declared: its shape where it stands at time 0, and its mass where it is free.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "contact/rigid.hpp"
#include "geometry/vec.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::contact {
class Scene;
}

namespace fabricsh::model {

struct Sphere {
  double radius = 0;           // m
  Vec3 centre = Vec3::Zero();  // m
};
// All that lies behind it, as seen from where its normal points to, is solid.
struct Plane {
  Vec3 point = Vec3::Zero();    // m
  Vec3 normal = Vec3::UnitZ();  // of any length
};
// Its ends are round.
struct Cylinder {
  double radius = 0;                             // m
  Vec3 from = Vec3::Zero(), to = Vec3::UnitX();  // m
};
// Flat, as thick as its rounded edge is wide.
struct Disc {
  double radius = 0;                                   // m, over all
  Vec3 centre = Vec3::Zero(), normal = Vec3::UnitZ();  // m
  double edge = 0;                                     // m, radius of its edge
};
struct Facets {
  std::vector<Vec3> vertices;                // m
  std::vector<contact::Triangle> triangles;  // counter-clockwise from outside
  bool closed = false;                       // is it the border of a solid
};
// The same facets at other places, in straight lines between the times.
struct MovingFacets {
  Facets first;
  std::vector<double> times;              // s, ascending
  std::vector<std::vector<Vec3>> shapes;  // m, a list of vertices for each time
};
using RigidShape = std::variant<Sphere, Plane, Cylinder, Disc, Facets, MovingFacets>;

class Rigid {
 public:
  // `call` names the shape in messages and, where there is no name, the body. Errors: sizes that are not
  // positive and finite; a plane or a moving surface with a mass; a surface that is open where it has a mass
  // or is said to be closed; shapes of different facets, times that do not ascend.
  Rigid(RigidShape shape, std::optional<double> mass, std::string name, const std::string& call);

  const RigidShape& shape() const { return shape_; }
  const std::optional<double>& mass() const { return mass_; }  // kg; none: it stands or is driven
  bool free() const { return mass_.has_value(); }
  const std::string& name() const { return name_; }  // as given; empty: none
  const std::string& kind() const { return kind_; }  // "sphere"
  // Where a turn without a centre of its own turns about, and what a:body tells, m: the centre of mass of a
  // free body, else of the shape.
  const Vec3& centre() const { return centre_; }
  contact::Mass weigh() const;  // of a free body
  const MovingFacets* moving() const { return std::get_if<MovingFacets>(&shape_); }
  const Facets* facets() const;  // of a surface, null: of another shape
  std::string describe() const;  // "sphere of radius 0.03 m at (0, 0, 0.1) m"

 private:
  void check() const;
  RigidShape shape_;
  std::optional<double> mass_;
  std::string name_, kind_;
  Vec3 centre_ = Vec3::Zero();
};
using RigidPointer = std::shared_ptr<const Rigid>;

// Quadrilaterals of a mesh cut into triangles; which are closed where so said.
Facets facets_of(const mesh::Mesh& mesh, bool closed);

// The surface in the scene that stands for it.
int add_to(contact::Scene& scene, const Rigid& body);

// Triangles to show it by, m, at time 0: a sphere and a cylinder as facets, a plane as a square of `extent`
// (m) about its point.
Facets shown(const Rigid& body, double extent);

}  // namespace fabricsh::model
