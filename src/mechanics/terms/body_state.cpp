#include "mechanics/terms/body_state.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "base/error.hpp"

namespace fabricsh::mechanics {

Vec3 BodyState::displaced(const Body& body, double time) const {
  Vec3 moved = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
    if (const auto& h = body.motion->displacement[c]) moved[c] = h->value(time);
  return moved;
}

contact::Pose BodyState::driven(const Body& body, double time) const {
  contact::Pose pose;
  if (body.motion == nullptr) return pose;
  try {
    pose.place = displaced(body, time);
    if (const auto& turn = body.motion->turn) {
      pose.turn = contact::Pose::about(turn->axis, std::numbers::pi / 180 * turn->angle.value(time));
      const Vec3 centre = turn->centre.value_or(body.given->centre());
      pose.place += centre - pose.turn * centre;
    }
  } catch (const Error& error) {
    throw Error("move: the " + model.interactions().name_of(*body.given) + ": " + error.what());
  }
  return pose;
}

Vec3 BodyState::gravity(double time) const {
  Vec3 g = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
    if (const auto& h = model.gravity()[c]) g[c] = h->value(time) - missing(time) * h->value(0);
  return g;
}

contact::Wrench BodyState::first_part(const Free& body) const {
  if (statics) return body.left(body.end);
  const double mass = body.committed.mass();
  if (!implicit) return body.left({body.wrench.force + mass * gravity(from), body.wrench.torque});
  return body.left({body.end.force + mass * mean(gravity(from), gravity(to)), body.end.torque});
}

contact::FreeBody BodyState::kicked(const Free& body) const {
  if (!loaded) return body.committed;
  if (to == from || statics) return body.predicted;
  contact::FreeBody at = body.predicted;
  // The rest of the impulse: of the mean of both forces, or in implicit steps of the force at the end.
  const contact::Wrench first = first_part(body), &end = body.trial;
  const contact::Wrench acts =
      implicit ? end
               : contact::Wrench{mean(body.wrench.force, end.force), mean(body.wrench.torque, end.torque)};
  const contact::Wrench rest =
      body.left({acts.force + at.mass() * mean(gravity(from), gravity(to)) - late * first.force,
                 acts.torque - late * first.torque});
  at.kick(rest.force, rest.torque, to - from);
  return at;
}

void BodyState::fly() {
  const double dt = flight();
  for (Body& body : bodies) {
    if (body.free < 0) continue;
    Free& free = this->free[static_cast<std::size_t>(body.free)];
    free.predicted = free.committed;
    if (dt != 0) {
      const contact::Wrench kick = first_part(free);
      free.predicted.kick(kick.force, kick.torque, dt * late);
      free.predicted.drift(dt);
      if (statics) free.predicted.rest();
    }
    body.turned = rotation(free.committed.pose().turn, free.predicted.pose().turn);
    const contact::Pose pose = free.predicted.pose();
    const Vec3& origin = body.given->centre();
    for (std::size_t i = body.first; i < body.first + body.count; ++i)
      target[i] = pose(reference[i] - origin);
  }
}

Vec3 BodyState::rotation(const Mat3& from, const Mat3& to) {
  const Eigen::AngleAxisd turned(Mat3(to * from.transpose()));
  return turned.angle() * turned.axis();
}

contact::Pose BodyState::pose(std::size_t i) const {
  const Body& body = bodies[i];
  if (body.free < 0) return driven(body, now());
  contact::Pose pose = (loaded ? free[body.free].predicted : free[body.free].committed).pose();
  pose.place -= pose.turn * body.given->centre();
  return pose;
}

std::vector<Vec3> BodyState::moved(std::size_t i, const std::vector<Vec3>& points) const {
  const Body& body = bodies[i];
  std::vector<Vec3> out = points;
  if (body.moving) {
    body.moving->at(now(), out);
    return out;
  }
  const contact::Pose at = pose(i);
  for (Vec3& p : out) p = at(p);
  return out;
}

BodyState::Kinematics BodyState::kinematics(std::size_t i) const {
  const Body& body = bodies[i];
  if (body.free >= 0) {
    const contact::FreeBody at = kicked(free[body.free]);
    return {at.centre(), at.velocity(), at.spin()};
  }
  Kinematics state{body.given->centre(), Vec3::Zero(), Vec3::Zero()};
  if (body.moving) {
    const std::vector<Vec3> x = moved(i, std::vector<Vec3>(body.count));
    std::vector<Vec3> v(body.count);
    body.moving->velocity(now(), v);
    state.place = std::accumulate(x.begin(), x.end(), Vec3(Vec3::Zero())) / double(body.count);
    state.velocity = std::accumulate(v.begin(), v.end(), Vec3(Vec3::Zero())) / double(body.count);
    return state;
  }
  if (body.motion == nullptr) return state;
  constexpr double h = 1e-6;  // s
  const double from = std::max(0.0, now() - h), width = now() - from;
  state.place = driven(body, now())(body.given->centre());
  if (!(width > 0)) return state;
  const contact::Pose before = driven(body, from), after = driven(body, now());
  state.velocity = (after(body.given->centre()) - before(body.given->centre())) / width;
  const Eigen::AngleAxisd turned(after.turn * before.turn.transpose());
  state.spin = turned.angle() / width * turned.axis();
  return state;
}

}  // namespace fabricsh::mechanics
