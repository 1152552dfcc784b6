#include <algorithm>
#include <cmath>

#include "mechanics/terms/bodies.hpp"

namespace fabricsh::mechanics {

double BodyReadings::kinetic() const {
  double sum = 0;
  for (const BodyState::Free& free : state_.free) sum += state_.kicked(free).kinetic_energy();
  return sum;
}

StepWork BodyReadings::step_work() const {
  if (!state_.loaded) return {};
  StepWork sum = loads_.work();
  for (const BodyState::Body& body : state_.bodies) {
    if (body.free >= 0) {
      const BodyState::Free& free = state_.free[body.free];
      const Vec3 moved = free.predicted.centre() - free.committed.centre();
      sum.work += body.given->mass().value_or(0) *
                  state_.mean(state_.gravity(state_.from), state_.gravity(state_.to)).dot(moved);
      continue;
    }
    const auto& force = state_.implicit ? state_.trial_force : state_.force;
    const Vec3& torque = state_.implicit ? body.trial_torque : body.torque;
    double change = (torque - body.trial_torque).dot(body.turned) / 2;
    for (std::size_t i = body.first; i < body.first + body.count; ++i) {
      const Vec3 way = state_.target[i] - state_.committed[i];
      sum.work -= (force[i] + state_.trial_force[i]).dot(way) / 2;
      change += (force[i] - state_.trial_force[i]).dot(way) / 2;
    }
    sum.work -= (torque + body.trial_torque).dot(body.turned) / 2;
    sum.spread += std::abs(change);
    sum += work_of_gas(body);
  }
  return sum;
}

double BodyReadings::lost_by_rule() const {
  double sum = 0;
  for (const BodyState::Free& free : state_.free) {
    const contact::FreeBody after = state_.kicked(free);
    const Vec3 turned = after.angular_momentum() - free.committed.angular_momentum();
    sum += after.mass() * (after.velocity() - free.committed.velocity()).squaredNorm() +
           turned.dot(after.inertia().ldlt().solve(turned));
  }
  return (state_.late - 0.5) * (sum + loads_.spring_work());
}

Vec3 BodyReadings::force(std::size_t i) const {
  const auto& all = state_.loaded ? state_.trial_force : state_.force;
  Vec3 sum = Vec3::Zero();
  const auto gas = state_.pressed();
  for (std::size_t k = state_.bodies[i].first; k < state_.bodies[i].first + state_.bodies[i].count; ++k)
    sum += gas.empty() ? all[k] : Vec3(all[k] + gas[k]);
  return sum;
}

double BodyReadings::inverse_mass_pressed(std::size_t i) const {
  if (state_.bodies[i].free < 0) return 0;
  const BodyState::Free& free = state_.free[state_.bodies[i].free];
  return free.arm > 0 ? free.bound : 1 / free.committed.mass();
}

double BodyReadings::size(std::size_t i) const {
  const model::RigidShape& shape = state_.bodies[i].given->shape();
  if (const auto* ball = std::get_if<model::Sphere>(&shape)) return ball->radius;
  if (const auto* rod = std::get_if<model::Cylinder>(&shape)) return rod->radius;
  if (std::holds_alternative<model::Plane>(shape)) return 0;
  double most = 0;
  const auto all = std::span(state_.reference).subspan(state_.bodies[i].first, state_.bodies[i].count);
  for (const Vec3& x : all) most = std::max(most, (x - state_.bodies[i].given->centre()).norm());
  return most;
}

double BodyReadings::fastest_free() const {
  double most = 0;
  for (const BodyState::Free& free : state_.free) most = std::max(most, free.committed.velocity().norm());
  return most;
}

void BodyReadings::add_places(OwnUnknowns::Places which, std::vector<double>& x) const {
  for (const BodyState::Free& free : state_.free) {
    contact::FreeBody body = which == OwnUnknowns::Places::after ? free.predicted : free.committed;
    if (which == OwnUnknowns::Places::ahead) {
      const contact::Wrench now =
          free.left({free.wrench.force + body.mass() * state_.gravity(state_.from), free.wrench.torque});
      body.kick(now.force, now.torque, state_.flight() / 2);
      body.drift(state_.flight());
    }
    const Mat3 axes = free.size * body.pose().turn;
    for (int i = -1; i < 3; ++i) {
      const Vec3 at = i < 0 ? body.centre() : Vec3(body.centre() + axes.col(i));
      x.insert(x.end(), at.data(), at.data() + 3);
    }
  }
}

double BodyReadings::inverse_mass(std::size_t i) const {
  return state_.bodies[i].free < 0 ? 0 : state_.free[state_.bodies[i].free].bound;
}

unsigned char BodyReadings::planes_through(std::size_t i) const {
  unsigned char planes = 0;
  for (int axis = 0; axis < 3 && state_.bodies[i].free >= 0; ++axis)
    if (state_.free[state_.bodies[i].free].moves[axis] == 0) planes |= static_cast<unsigned char>(1 << axis);
  return planes;
}

// The balance of all other forces on the body, which does not move where it is held.
Vec3 BodyReadings::held(std::size_t i) const {
  const model::BodySupport support = state_.model.interactions().held(*state_.bodies[i].given);
  Vec3 others = force(i) + state_.bodies[i].given->mass().value_or(0) * state_.gravity(state_.now());
  loads_.add_forces_on(i, others);
  Vec3 out = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
    if (support.moves[static_cast<std::size_t>(c)]) out[c] = -others[c];
  return out;
}

// J, in the step, on the cloth and what encloses the gas with it, of what drives the body.
StepWork BodyReadings::work_of_gas(const BodyState::Body& body) const {
  StepWork sum;
  double change = 0;
  for (std::size_t i = body.first; i < body.first + body.count && !state_.gas.empty(); ++i) {
    const Vec3 way = state_.target[i] - state_.committed[i];
    sum.work -= (state_.gas[i] + state_.trial_gas[i]).dot(way) / 2;
    change += (state_.gas[i] - state_.trial_gas[i]).dot(way) / 2;
  }
  sum.spread = std::abs(change);
  return sum;
}

}  // namespace fabricsh::mechanics
