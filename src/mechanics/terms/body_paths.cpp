// How long a step may be, so that the straight ways from its beginning to its end stand for the paths of
// bodies.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanics/facets.hpp"
#include "mechanics/terms/bodies.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kRadian = std::numbers::pi / 180;
constexpr double kInPlane = 1e-6;
constexpr int kLooks = 32;  // times within a step at which a path is looked at

// m, from a point to the segment from a to b.
double off(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp(way.dot(p - a) / length, 0.0, 1.0) : 0;
  return (p - a - share * way).norm();
}

bool runs_straight(const model::BodyMotion& motion) {
  return std::all_of(motion.displacement.begin(), motion.displacement.end(),
                     [](const auto& h) { return !h || h->is_straight(); }) &&
         (!motion.turn || motion.turn->angle.is_straight());
}

}  // namespace

// m: the largest distance of the body's points from the axis that it turns about. A plane that turns in
// itself has none; else it reaches as far as the cloth.
double BodyPaths::lever(const BodyState::Body& body, const BoundingBox& cloth) const {
  if (body.free >= 0) return state_.free[body.free].arm;
  const auto& turn = *body.motion->turn;
  const Vec3 axis = turn.axis.normalized(), centre = turn.centre.value_or(body.given->centre());
  if (const auto* plane = std::get_if<model::Plane>(&body.given->shape())) {
    const bool in_itself = axis.cross(plane->normal.normalized()).norm() < kInPlane;
    return in_itself ? 0 : (cloth.middle() - centre).norm() + cloth.size().norm() / 2;
  }
  double most = 0;
  for (std::size_t i = body.first; i < body.first + body.count; ++i)
    most = std::max(most, axis.cross(state_.reference[i] - centre).norm());
  return most;
}

namespace {

// Whether a ball of this radius that flies from a place by `way` may come to the cloth, m.
bool may_reach(const BoundingBox& cloth, const Vec3& place, const Vec3& way, double radius) {
  const Vec3 margin = Vec3::Constant(radius + way.norm() / 2);
  return ((place.cwiseMin(place + way) - margin).array() <= cloth.high.array()).all() &&
         ((place.cwiseMax(place + way) + margin).array() >= cloth.low.array()).all();
}

}  // namespace

// Between two kinks, at which every step ends, tables are straight lines; a function of time may do anything.
// A point at the distance r from an axis leaves its chord by r angle^2 / 8. A free body may begin to roll.
BodyPaths::Path BodyPaths::path(const BodyState::Body& body, double from, double to, double near,
                                const BoundingBox& cloth) const {
  if (body.free >= 0) {
    const BodyState::Free& free = state_.free[body.free];
    const Vec3 way = (to - from) * free.committed.velocity();
    const double spun = free.committed.spin().norm() * (to - from);
    const bool rolls = may_reach(cloth, free.committed.centre(), way, free.size);
    return {std::max(spun, rolls ? way.norm() / free.size : 0) / largest_turn,
            free.arm * spun * spun / 8 / near};
  }
  const Vec3 start = state_.displaced(body, from), end = state_.displaced(body, to);
  const auto& turn = body.motion->turn;
  const int looks = runs_straight(*body.motion) ? 1 : kLooks;
  double angle = 0, aside = 0, before = turn ? turn->angle.value(from) : 0;
  for (int k = 1; k <= looks; ++k) {
    const double time = k == looks ? to : from + (to - from) * k / looks;
    if (k < looks) aside = std::max(aside, off(state_.displaced(body, time), start, end));
    if (!turn) continue;
    const double now = turn->angle.value(time);
    angle += kRadian * std::abs(now - before);
    before = now;
  }
  const double bend = angle > 0 ? lever(body, cloth) * angle * angle / 8 : 0;
  return {angle / largest_turn, (aside + bend) / near};
}

double BodyPaths::latest_end(std::size_t i, double from, double to, double near,
                             const BoundingBox& cloth) const {
  const BodyState::Body& body = state_.bodies[i];
  if (body.free < 0 && body.motion == nullptr) return to;
  return mechanics::latest_end(from, to,
                               [&](double end) { return path(body, from, end, near, cloth).parts(); });
}

double BodyPaths::turned_most() const {
  double most = 0;
  for (const BodyState::Body& body : state_.bodies) most = std::max(most, body.turned.norm());
  for (const BodyState::Free& free : state_.free)
    most = std::max(most, free.predicted.spin().norm() * (state_.to - state_.from));
  return most;
}

}  // namespace fabricsh::mechanics
