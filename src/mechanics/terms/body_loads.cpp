#include "mechanics/terms/body_loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kOfStable = 0.5;  // of the longest stable step, at which springs are followed well

}  // namespace

void BodyLoads::add() {
  for (const auto& load : state_.model.interactions().all<model::BodyLoad>())
    for (std::size_t b = 0; b < state_.bodies.size(); ++b)
      if (state_.bodies[b].given == load.body) loads_.push_back({b, &load});
  for (const auto& given : state_.model.interactions().all<model::BodySpring>()) {
    Spring spring;
    spring.stiffness = given.stiffness;
    spring.damper = given.damper;
    spring.slack = given.place ? Vec3(*given.place - given.body->centre()) : Vec3(Vec3::Zero());
    for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
      if (state_.bodies[b].given == given.body) spring.body = b;
      if (state_.bodies[b].given == given.to) spring.to = static_cast<int>(b);
    }
    springs_.push_back(spring);
  }
}

// At the beginning or the end of the step.
Vec3 BodyLoads::displacement_of(std::size_t b, bool end) const {
  const BodyState::Body& body = state_.bodies[b];
  if (body.free >= 0) {
    const BodyState::Free& free = state_.free[static_cast<std::size_t>(body.free)];
    return (end ? free.predicted : free.committed).centre() - body.given->centre();
  }
  if (body.motion == nullptr) return Vec3::Zero();
  return state_.driven(body, end ? state_.to : state_.from)(body.given->centre()) - body.given->centre();
}

// By how much its far end is displaced more than its body, m.
Vec3 BodyLoads::stretch(const Spring& spring, bool end) const {
  const Vec3 far = spring.to < 0 ? Vec3(Vec3::Zero()) : displacement_of(std::size_t(spring.to), end);
  return far + spring.slack - displacement_of(spring.body, end);
}

Vec3 BodyLoads::total(const Load& load, double time) const {
  Vec3 sum = Vec3::Zero();
  try {
    for (int c = 0; c < 3; ++c)
      if (const auto& h = load.given->total[static_cast<std::size_t>(c)])
        sum[c] = h->value(time) - state_.missing(time) * h->value(0);
  } catch (const Error& error) {
    throw Error(std::string(load.given->moment ? "moment" : "force") + ": the " +
                state_.model.interactions().name_of(*load.given->body) + ": " + error.what());
  }
  return sum;
}

// N, on the body. A damper acts with the mean speed of an implicit or static step; at the end of an explicit
// one with the speed to which the other forces, known by then, and its own bring the body.
Vec3 BodyLoads::pull(const Spring& spring) const {
  const Vec3 before = stretch(spring, false), after = stretch(spring, true);
  if (spring.damper && !state_.implicit && state_.to > state_.from) {
    const BodyState::Free& free = state_.free[static_cast<std::size_t>(state_.bodies[spring.body].free)];
    const double half = (state_.to - state_.from) / 2 / free.committed.mass();
    const Vec3 others =
        free.trial.force + free.load.force + free.committed.mass() * state_.gravity(state_.to);
    const Vec3 speed = (after - before) / (state_.to - state_.from) - half * free.left({others, {}}).force;
    return spring.stiffness.cwiseProduct(speed).cwiseQuotient(Vec3::Ones() + half * spring.stiffness);
  }
  if (!spring.damper) return spring.stiffness.cwiseProduct(state_.in_step(before, after));
  return state_.to > state_.from
             ? Vec3(spring.stiffness.cwiseProduct(after - before) / (state_.to - state_.from))
             : Vec3(Vec3::Zero());
}

void BodyLoads::push(const Spring& spring, const Vec3& force) {
  BodyState::Free& free = state_.free[static_cast<std::size_t>(state_.bodies[spring.body].free)];
  free.load.force += force;
  free.largest = std::max(free.largest, force.lpNorm<Eigen::Infinity>());
  if (spring.to < 0) return;
  if (const int other = state_.bodies[std::size_t(spring.to)].free; other >= 0)
    state_.free[static_cast<std::size_t>(other)].load.force -= force;
}

void BodyLoads::push(const Load& load, const Vec3& total) {
  BodyState::Free& free = state_.free[static_cast<std::size_t>(state_.bodies[load.body].free)];
  (load.given->moment ? free.load.torque : free.load.force) += total;
  free.largest =
      std::max(free.largest, total.lpNorm<Eigen::Infinity>() / (load.given->moment ? free.size : 1));
}

// Adds to the forces of contact at the start of the run those of loads, springs and dampers.
void BodyLoads::begin() {
  for (BodyState::Free& free : state_.free) free.load = {};
  for (const Load& load : loads_) push(load, total(load, state_.from));
  for (Spring& spring : springs_) {
    Vec3 force = spring.stiffness.cwiseProduct(stretch(spring, false));
    if (spring.damper) {
      const Vec3 far =
          spring.to < 0 ? Vec3(Vec3::Zero()) : state_.kinematics(std::size_t(spring.to)).velocity;
      force = spring.force = spring.stiffness.cwiseProduct(far - state_.kinematics(spring.body).velocity);
    }
    push(spring, force);
  }
  for (BodyState::Free& free : state_.free) {
    free.wrench = free.left({free.wrench.force + free.load.force, free.wrench.torque + free.load.torque});
    free.end = free.iterate = state_.start_of(free);
  }
}

// The same at the end of the step; in implicit steps their means in the step.
void BodyLoads::apply() {
  for (BodyState::Free& free : state_.free) {
    free.load = {};
    free.largest = free.trial.force.lpNorm<Eigen::Infinity>();
  }
  for (const Load& load : loads_)
    push(load, state_.in_step(total(load, state_.from), total(load, state_.to)));
  for (const bool dampers : {false, true})
    for (Spring& spring : springs_) {
      if (spring.damper != dampers) continue;
      spring.trial_force = pull(spring);
      push(spring, spring.trial_force);
    }
  for (const BodyState::Body& body : state_.bodies) {
    if (body.free < 0) continue;
    BodyState::Free& free = state_.free[static_cast<std::size_t>(body.free)];
    if (state_.statics) free.load.force += body.given->mass().value_or(0) * state_.gravity(state_.to);
    free.trial = free.left({free.trial.force + free.load.force, free.trial.torque + free.load.torque});
  }
}

// J, in the step. In implicit steps a damper's force is that of the whole step.
double BodyLoads::lost_in(const Spring& spring) const {
  const Vec3 way = stretch(spring, true) - stretch(spring, false);
  return state_.implicit ? spring.trial_force.dot(way) : (spring.force + spring.trial_force).dot(way) / 2;
}

double BodyLoads::damped() const {
  double sum = 0;
  for (const Spring& spring : springs_)
    if (spring.damper) sum += spring.lost + (state_.loaded ? lost_in(spring) : 0);
  return sum;
}

double BodyLoads::spring_energy() const {
  double sum = 0;
  for (const Spring& spring : springs_)
    if (!spring.damper) sum += spring.stiffness.dot(stretch(spring, state_.loaded).cwiseAbs2()) / 2;
  return sum;
}

double BodyLoads::spring_work() const {
  double sum = 0;
  for (const Spring& spring : springs_)
    if (!spring.damper)
      sum += spring.stiffness.dot((stretch(spring, true) - stretch(spring, false)).cwiseAbs2());
  return sum;
}

// Of loads, and of what drives the far ends of springs.
StepWork BodyLoads::work() const {
  StepWork sum;
  for (const Load& load : loads_) {
    const BodyState::Body& body = state_.bodies[load.body];
    const BodyState::Free& free = state_.free[static_cast<std::size_t>(body.free)];
    const Vec3 way =
        load.given->moment ? body.turned : Vec3(free.predicted.centre() - free.committed.centre());
    const Vec3 before = total(load, state_.from), after = total(load, state_.to);
    sum.work += state_.mean(before, after).dot(way);
    sum.spread += std::abs((after - before).dot(way)) / 2;
  }
  for (const Spring& spring : springs_) {
    if (spring.to < 0 || state_.bodies[std::size_t(spring.to)].motion == nullptr) continue;
    const auto to = static_cast<std::size_t>(spring.to);
    const Vec3 way = displacement_of(to, true) - displacement_of(to, false);
    const Vec3 mean =
        !spring.damper
            ? Vec3(spring.stiffness.cwiseProduct(state_.mean(stretch(spring, false), stretch(spring, true))))
        : state_.implicit ? spring.trial_force
                          : Vec3((spring.force + spring.trial_force) / 2);
    sum.work += mean.dot(way);
  }
  return sum;
}

// Where a damper ties two bodies that both move freely, the speed of the other is that of half a step before.
double BodyLoads::stable_step() const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < state_.free.size(); ++f)
    for (int c = 0; c < 3; ++c) {
      double square = 0, rate = 0;  // 1/s^2, 1/s
      for (const Spring& spring : springs_) {
        const auto b = static_cast<std::size_t>(state_.bodies[spring.body].free);
        const int other = spring.to < 0 ? -1 : state_.bodies[std::size_t(spring.to)].free;
        if (f != b && static_cast<int>(f) != other) continue;
        double inverse = 1 / state_.free[b].committed.mass();
        if (other >= 0) inverse += 1 / state_.free[static_cast<std::size_t>(other)].committed.mass();
        (spring.damper ? rate : square) += spring.stiffness[c] * inverse;
      }
      if (square == 0 && rate == 0) continue;
      // (2 / omega) (sqrt(1 + xi^2) - xi) with xi = rate / (2 omega)
      least = std::min(least, kOfStable * 4 / (std::sqrt(4 * square + rate * rate) + rate));
    }
  return least;
}

void BodyLoads::add_forces_on(std::size_t i, Vec3& force) const {
  for (const Load& load : loads_)
    if (load.body == i && !load.given->moment) force += total(load, state_.now());
  for (const Spring& spring : springs_) {
    const bool far = spring.to == static_cast<int>(i);
    if (spring.body != i && !far) continue;
    const Vec3 pull = spring.damper ? (state_.loaded ? spring.trial_force : spring.force)
                                    : Vec3(spring.stiffness.cwiseProduct(stretch(spring, state_.loaded)));
    force += far ? Vec3(-pull) : pull;
  }
}

void BodyLoads::commit() {
  for (Spring& spring : springs_) {
    if (!state_.loaded || !spring.damper) continue;
    spring.lost += lost_in(spring);
    spring.force = spring.trial_force;
  }
}

void BodyLoads::keep(Archive& archive) {
  for (Spring& spring : springs_)
    if (spring.damper) {
      archive.filled({spring.force.data(), 3});
      archive(spring.lost);
    }
}

}  // namespace fabricsh::mechanics
