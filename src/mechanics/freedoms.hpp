// Which degrees of freedom of a node are unknown, held or driven, and in which frame.
#pragma once
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "mechanics/joints.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

// Equation numbers of one node in the order u1 u2 u3 (in the node's frame) q1 q2: >= 0 unknown, held = -1,
// driven <= -2, tied: follows other nodes (see model::Follower).
inline constexpr Index held = -1;
inline constexpr Index tied = std::numeric_limits<Index>::min();
// Whether a boundary condition states it: held or driven.
inline constexpr bool is_prescribed(Index equation) { return equation < 0 && equation != tied; }
inline constexpr Index driven(Index motion) { return -2 - motion; }
inline constexpr Index motion_of(Index equation) { return -2 - equation; }

// A driven displacement (component 0 to 2, m, in the node's frame) or angle of a rotated director (3 and 4,
// rad), as a function of a history's value. Histories are stored once, however many nodes follow them.
struct DrivenFreedom {
  Index node;
  int component;
  Index history;  // index in Freedoms::histories
  enum class FreedomKind : char { displacement, angle, arm } kind = FreedomKind::displacement;
  Vec3 arm = Vec3::Zero();   // for kind arm: from the centre to the node, m
  Vec3 axis = Vec3::Zero();  // for kind arm: axis of the rotation, unit
  double of(double value) const;
};

struct NodeFreedoms {
  std::array<Index, 5> equation{};
  Mat3 frame = Mat3::Identity();  // rows: the directions of u1 u2 u3, global
  bool oblique = false;
  std::optional<Vec3> turn_axis;  // for a driven director: d = R(axis, angle) D
  std::vector<Vec3> held_axes;    // held rotation axes, global; empty if both rotations are free or both held
};

// A rigid body: its unknowns are increments of displacement and rotation about its centroid, global axes.
struct RigidBody {
  mesh::NodeSet nodes;
  Index equation = 0;  // number of the first of six
};

// The motion of a tied node's five degrees of freedom with one unknown or driven degree of freedom.
struct Link {
  Index equation;
  Eigen::Matrix<double, 5, 1> column;
};

struct Freedoms {
  std::vector<NodeFreedoms> nodes;
  std::vector<DrivenFreedom> motions;
  std::vector<model::History> histories;
  std::vector<model::Follower> followers;
  std::vector<RigidBody> bodies;
  std::vector<Index> body_of;  // per node: its body or -1; empty if there are none
  Index unknowns = 0;

  bool ties(Index node) const {
    const auto& eq = nodes[node].equation;
    return eq[0] == tied || eq[1] == tied || eq[2] == tied || eq[3] == tied;
  }
  Index body(Index node) const { return body_of.empty() ? -1 : body_of[node]; }
  // Numbers the unknowns node by node; the nodes of a joint share those of its leader.
  void number(const Joints& joints);
};

// The model must be validated.
Freedoms number_freedoms(const model::Model& model, const std::vector<Vec3>& directors, const Joints& joints);

// Projects the directors of nodes with symmetry supports (one displacement held, and the two rotations that
// lead out of the plane) into the symmetry planes. Where such a plane cuts a mesh, the normals lean by half
// an element, and a part would not behave like the whole. A director along the plane's normal stays.
void lay_into_planes(const model::Model& model, std::vector<Vec3>& directors);

// The tangent direction in which a director d can still move while some rotation axes are held: the longest
// projection of a held axis on the tangent plane, normalised. Zero if all projections vanish.
Vec3 allowed_direction(const std::vector<Vec3>& held_axes, const Vec3& d);

}  // namespace fabricsh::mechanics
