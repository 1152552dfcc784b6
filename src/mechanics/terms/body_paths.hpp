// How long a step may be, so that contact can take the ways of rigid bodies in it for straight.
#pragma once
#include <cmath>
#include <numbers>

#include "geometry/box.hpp"
#include "mechanics/terms/body_state.hpp"

namespace fabricsh::mechanics {

class BodyPaths {
 public:
  explicit BodyPaths(const BodyState& state) : state_(state) {}
  // The largest turn of a body in a step, rad: friction takes its direction in the step as one.
  static constexpr double largest_turn = std::numbers::pi / 6;
  // s: the latest end, up to `to`, of a step from `from` on in which body i turns by no more than that, and
  // its points stay within `near` (m) of their straight ways. `cloth`: where the cloth is; a plane has no
  // points farther out, and a free body that flies towards it may come to roll on it.
  double latest_end(std::size_t i, double from, double to, double near, const BoundingBox& cloth) const;
  double turned_most() const;  // rad, of any body in the step

 private:
  // Of a body's path from one time to another: how much more it turns and bends than contact follows, 1: just
  // as much. A step that is n times as short has a share n or n^2 times as small.
  struct Path {
    double turn = 0, bend = 0;
    double parts() const { return std::max(turn, std::sqrt(bend)); }
  };
  Path path(const BodyState::Body& body, double from, double to, double near, const BoundingBox& cloth) const;
  double lever(const BodyState::Body& body, const BoundingBox& cloth) const;

  const BodyState& state_;
};

}  // namespace fabricsh::mechanics
