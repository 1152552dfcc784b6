// Which freedoms of which node are unknown, held or driven, and in which frame.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "model/model.hpp"

namespace fabricsh::assembly {

using Index = std::int64_t;

// Equation numbers of one node, order u1 u2 u3 (along the node's frame) q1 q2: >= 0 unknown, held = -1,
// driven <= -2.
inline constexpr Index held = -1;
inline constexpr Index driven(Index motion) { return -2 - motion; }
inline constexpr Index motion_of(Index equation) { return -2 - equation; }

// A driven displacement (component 0 to 2, m along the node's frame) or the angle (rad) of a turned director
// (3 and 4).
struct DrivenFreedom {
  Index node;
  int component;
  std::function<double(double time)> value;
};

struct NodeFreedoms {
  std::array<Index, 5> equation{};
  Mat3 frame = Mat3::Identity();  // rows: the directions of u1 u2 u3, global
  bool oblique = false;
  std::optional<Vec3> turn_axis;  // director driven: d = R(axis, angle) D
  std::vector<Vec3> held_axes;  // rotation axes held, global; empty with both rotations free or held outright
};

struct Freedoms {
  std::vector<NodeFreedoms> nodes;
  std::vector<DrivenFreedom> motions;
  Index unknowns = 0;
};

// Numbers the unknowns node by node. The model must have been validated.
Freedoms number_freedoms(const model::Model& model, const std::vector<Vec3>& directors);

// The tangent direction that a director d may still take when some rotation axes are held: the projection of
// the held axis with the longest shadow on the tangent plane, unit length. Zero if none casts a shadow.
Vec3 allowed_direction(const std::vector<Vec3>& held_axes, const Vec3& d);

}  // namespace fabricsh::assembly
