// Which freedoms of which node are unknown, held or driven, and in which frame.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "model/model.hpp"

namespace fabricsh::mechanics {

using Index = std::int64_t;

// Equation numbers of one node, order u1 u2 u3 (along the node's frame) q1 q2: >= 0 unknown, held = -1,
// driven <= -2, tied: follows other nodes' (see Tied).
inline constexpr Index held = -1;
inline constexpr Index tied = std::numeric_limits<Index>::min();
inline constexpr Index driven(Index motion) { return -2 - motion; }
inline constexpr Index motion_of(Index equation) { return -2 - equation; }

// A driven displacement (component 0 to 2, m along the node's frame) or the angle (rad) of a turned director
// (3 and 4): what a history's value makes of it. Histories are kept once, however many nodes follow them.
struct DrivenFreedom {
  Index node;
  int component;
  Index history;  // of Freedoms::histories
  enum class Kind : char { displacement, angle, arm } kind = Kind::displacement;
  Vec3 arm = Vec3::Zero();   // kind arm: from the centre to the node, m
  Vec3 axis = Vec3::Zero();  // kind arm: of the turn, unit
  double of(double value) const;
};

struct NodeFreedoms {
  std::array<Index, 5> equation{};
  Mat3 frame = Mat3::Identity();  // rows: the directions of u1 u2 u3, global
  bool oblique = false;
  std::optional<Vec3> turn_axis;  // director driven: d = R(axis, angle) D
  std::vector<Vec3> held_axes;  // rotation axes held, global; empty with both rotations free or held outright
};

// A rigid body's unknowns: displacement and rotation increments about its centroid, global axes.
struct Body {
  mesh::NodeSet nodes;
  Index equation = 0;  // the first of six
};

// How a tied node's five freedoms move with an unknown or a driven freedom.
struct Link {
  Index equation;
  Eigen::Matrix<double, 5, 1> column;
};

struct Freedoms {
  std::vector<NodeFreedoms> nodes;
  std::vector<DrivenFreedom> motions;
  std::vector<model::History> histories;
  std::vector<model::Follower> followers;
  std::vector<Body> bodies;
  std::vector<Index> body_of;  // per node: its body or -1; empty without bodies
  Index unknowns = 0;

  bool ties(Index node) const {
    const auto& eq = nodes[node].equation;
    return eq[0] == tied || eq[1] == tied || eq[2] == tied || eq[3] == tied;
  }
  Index body(Index node) const { return body_of.empty() ? -1 : body_of[node]; }
};

// Numbers the unknowns node by node. The model must have been validated.
Freedoms number_freedoms(const model::Model& model, const std::vector<Vec3>& directors);

// Lays the directors of nodes with symmetry supports (a displacement held and the two rotations that lead out
// of the plane) into their planes: a mesh's normals lean out of a plane that cuts it by half an element, and
// a part would not be the whole. A director along the plane's normal stays.
void lay_into_planes(const model::Model& model, std::vector<Vec3>& directors);

// The tangent direction that a director d may still take when some rotation axes are held: the projection of
// the held axis with the longest shadow on the tangent plane, unit length. Zero if none casts a shadow.
Vec3 allowed_direction(const std::vector<Vec3>& held_axes, const Vec3& d);

}  // namespace fabricsh::mechanics
