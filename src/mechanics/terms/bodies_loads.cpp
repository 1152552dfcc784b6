// Forces, moments, springs, dampers and supports of rigid bodies, and bodies that are at rest in static
// steps.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/error.hpp"
#include "mechanics/terms/bodies.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kOfStable = 0.5;     // of the longest stable step, at which springs are followed well
constexpr double kReach = 10;         // ranges of contact, that an unheld body goes in an iteration at most
constexpr double kLeastForce = 1e-6;  // N, by which the stiffness is chosen that stands for no support

}  // namespace

void Bodies::add_loads() {
  for (const auto& load : model_.interactions().all<model::BodyLoad>())
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      if (bodies_[b].given == load.body) loads_.push_back({b, &load});
}

void Bodies::add_springs() {
  for (const auto& given : model_.interactions().all<model::BodySpring>()) {
    Spring spring;
    spring.stiffness = given.stiffness;
    spring.damper = given.damper;
    spring.slack = given.place ? Vec3(*given.place - given.body->centre()) : Vec3(Vec3::Zero());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (bodies_[b].given == given.body) spring.body = b;
      if (bodies_[b].given == given.to) spring.to = static_cast<int>(b);
    }
    springs_.push_back(spring);
  }
}

// At the beginning or the end of the step.
Vec3 Bodies::displacement_of(std::size_t b, bool end) const {
  const Body& body = bodies_[b];
  if (body.free >= 0) {
    const Free& free = free_[static_cast<std::size_t>(body.free)];
    return (end ? free.predicted : free.committed).centre() - body.given->centre();
  }
  if (body.motion == nullptr) return Vec3::Zero();
  return driven(body, end ? to_ : from_)(body.given->centre()) - body.given->centre();
}

// By how much its far end is displaced more than its body, m.
Vec3 Bodies::stretch(const Spring& spring, bool end) const {
  const Vec3 far = spring.to < 0 ? Vec3(Vec3::Zero()) : displacement_of(std::size_t(spring.to), end);
  return far + spring.slack - displacement_of(spring.body, end);
}

Vec3 Bodies::total(const Load& load, double time) const {
  Vec3 sum = Vec3::Zero();
  try {
    for (int c = 0; c < 3; ++c)
      if (const auto& h = load.given->total[static_cast<std::size_t>(c)])
        sum[c] = h->value(time) - missing(time) * h->value(0);
  } catch (const Error& error) {
    throw Error(std::string(load.given->moment ? "moment" : "force") + ": the " +
                model_.interactions().name_of(*load.given->body) + ": " + error.what());
  }
  return sum;
}

// N, on the body. A damper acts with the mean speed of an implicit or static step; at the end of an explicit
// one with the speed to which the other forces, known by then, and its own bring the body.
Vec3 Bodies::pull(const Spring& spring) const {
  const Vec3 before = stretch(spring, false), after = stretch(spring, true);
  if (spring.damper && !implicit_ && to_ > from_) {
    const Free& free = free_[static_cast<std::size_t>(bodies_[spring.body].free)];
    const double half = (to_ - from_) / 2 / free.committed.mass();
    const Vec3 others = free.trial.force + free.load.force + free.committed.mass() * gravity(to_);
    const Vec3 speed = (after - before) / (to_ - from_) - half * free.left({others, {}}).force;
    return spring.stiffness.cwiseProduct(speed).cwiseQuotient(Vec3::Ones() + half * spring.stiffness);
  }
  if (!spring.damper)
    return spring.stiffness.cwiseProduct(implicit_ && !static_ ? Vec3((before + after) / 2) : after);
  return to_ > from_ ? Vec3(spring.stiffness.cwiseProduct(after - before) / (to_ - from_))
                     : Vec3(Vec3::Zero());
}

void Bodies::push(const Spring& spring, const Vec3& force) {
  Free& free = free_[static_cast<std::size_t>(bodies_[spring.body].free)];
  free.load.force += force;
  free.largest = std::max(free.largest, force.lpNorm<Eigen::Infinity>());
  if (spring.to < 0) return;
  if (const int other = bodies_[std::size_t(spring.to)].free; other >= 0)
    free_[static_cast<std::size_t>(other)].load.force -= force;
}

void Bodies::push(const Load& load, const Vec3& total) {
  Free& free = free_[static_cast<std::size_t>(bodies_[load.body].free)];
  (load.given->moment ? free.load.torque : free.load.force) += total;
  free.largest =
      std::max(free.largest, total.lpNorm<Eigen::Infinity>() / (load.given->moment ? free.size : 1));
}

// Adds to the forces of contact at the start of the run those of loads, springs and dampers.
void Bodies::begin_loads() {
  for (Free& free : free_) free.load = {};
  for (const Load& load : loads_) push(load, total(load, from_));
  for (Spring& spring : springs_) {
    Vec3 force = spring.stiffness.cwiseProduct(stretch(spring, false));
    if (spring.damper) {
      const Vec3 far = spring.to < 0 ? Vec3(Vec3::Zero()) : state(std::size_t(spring.to)).velocity;
      force = spring.force = spring.stiffness.cwiseProduct(far - state(spring.body).velocity);
    }
    push(spring, force);
  }
  for (Free& free : free_) {
    free.wrench = free.left({free.wrench.force + free.load.force, free.wrench.torque + free.load.torque});
    free.end = free.iterate = start_of(free);
  }
}

// The same at the end of the step; in implicit steps their means in the step.
void Bodies::apply_loads() {
  for (Free& free : free_) {
    free.load = {};
    free.largest = free.trial.force.lpNorm<Eigen::Infinity>();
  }
  for (const Load& load : loads_)
    push(load, implicit_ && !static_ ? Vec3((total(load, from_) + total(load, to_)) / 2) : total(load, to_));
  for (const bool dampers : {false, true})
    for (Spring& spring : springs_) {
      if (spring.damper != dampers) continue;
      spring.trial_force = pull(spring);
      push(spring, spring.trial_force);
    }
  for (const Body& body : bodies_) {
    if (body.free < 0) continue;
    Free& free = free_[static_cast<std::size_t>(body.free)];
    if (static_) free.load.force += body.given->mass().value_or(0) * gravity(to_);
    free.trial = free.left({free.trial.force + free.load.force, free.trial.torque + free.load.torque});
  }
}

// The balance of all other forces on the body, which does not move where it is held.
Vec3 Bodies::held(std::size_t i) const {
  const model::BodySupport support = model_.interactions().held(*bodies_[i].given);
  Vec3 others = force(i) + bodies_[i].given->mass().value_or(0) * gravity(now());
  for (const Load& load : loads_)
    if (load.body == i && !load.given->moment) others += total(load, now());
  for (const Spring& spring : springs_) {
    const bool far = spring.to == static_cast<int>(i);
    if (spring.body != i && !far) continue;
    const Vec3 pull = spring.damper ? (loaded_ ? spring.trial_force : spring.force)
                                    : Vec3(spring.stiffness.cwiseProduct(stretch(spring, loaded_)));
    others += far ? Vec3(-pull) : pull;
  }
  Vec3 out = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
    if (support.moves[static_cast<std::size_t>(c)]) out[c] = -others[c];
  return out;
}

// J, in the step. In implicit steps a damper's force is that of the whole step.
double Bodies::lost_in(const Spring& spring) const {
  const Vec3 way = stretch(spring, true) - stretch(spring, false);
  return implicit_ ? spring.trial_force.dot(way) : (spring.force + spring.trial_force).dot(way) / 2;
}

double Bodies::damped() const {
  double sum = 0;
  for (const Spring& spring : springs_)
    if (spring.damper) sum += spring.lost + (loaded_ ? lost_in(spring) : 0);
  return sum;
}

double Bodies::spring_energy() const {
  double sum = 0;
  for (const Spring& spring : springs_)
    if (!spring.damper) sum += spring.stiffness.dot(stretch(spring, loaded_).cwiseAbs2()) / 2;
  return sum;
}

// Of loads, and of what drives the far ends of springs.
StepWork Bodies::work_of_loads() const {
  StepWork sum;
  for (const Load& load : loads_) {
    const Body& body = bodies_[load.body];
    const Free& free = free_[static_cast<std::size_t>(body.free)];
    const Vec3 way =
        load.given->moment ? body.turned : Vec3(free.predicted.centre() - free.committed.centre());
    const Vec3 before = total(load, from_), after = total(load, to_);
    sum.work += (before + after).dot(way) / 2;
    sum.spread += std::abs((after - before).dot(way)) / 2;
  }
  for (const Spring& spring : springs_) {
    if (spring.to < 0 || bodies_[std::size_t(spring.to)].motion == nullptr) continue;
    const auto to = static_cast<std::size_t>(spring.to);
    const Vec3 way = displacement_of(to, true) - displacement_of(to, false);
    const Vec3 mean =
        !spring.damper
            ? Vec3(spring.stiffness.cwiseProduct(stretch(spring, false) + stretch(spring, true)) / 2)
        : implicit_ ? spring.trial_force
                    : Vec3((spring.force + spring.trial_force) / 2);
    sum.work += mean.dot(way);
  }
  return sum;
}

// Where a damper ties two bodies that both move freely, the speed of the other is that of half a step before.
double Bodies::stable_step() const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < free_.size(); ++f)
    for (int c = 0; c < 3; ++c) {
      double square = 0, rate = 0;  // 1/s^2, 1/s
      for (const Spring& spring : springs_) {
        const auto b = static_cast<std::size_t>(bodies_[spring.body].free);
        const int other = spring.to < 0 ? -1 : bodies_[std::size_t(spring.to)].free;
        if (f != b && static_cast<int>(f) != other) continue;
        double inverse = 1 / free_[b].committed.mass();
        if (other >= 0) inverse += 1 / free_[static_cast<std::size_t>(other)].committed.mass();
        (spring.damper ? rate : square) += spring.stiffness[c] * inverse;
      }
      if (square == 0 && rate == 0) continue;
      // (2 / omega) (sqrt(1 + xi^2) - xi) with xi = rate / (2 omega)
      least = std::min(least, kOfStable * 4 / (std::sqrt(4 * square + rate * rate) + rate));
    }
  return least;
}

// --- static steps

void Bodies::go_static(double reach, double rise) {
  implicit_ = static_ = true;
  rise_ = rise;
  reach_ = kReach * reach;
  for (Free& free : free_) {
    free.committed.rest();
    free.predicted = free.committed;
    free.end = free.iterate = {};
  }
}

Bodies::Matrix6 Bodies::mass_matrix(std::size_t free) const {
  Matrix6 out = Matrix6::Zero();
  out.topLeftCorner<3, 3>() = free_[free].committed.mass() * Mat3::Identity();
  out.bottomRightCorner<3, 3>() = free_[free].committed.inertia();
  return out;
}

Bodies::Vector6 Bodies::freedom(std::size_t free) const {
  Vector6 out;
  out << free_[free].moves, free_[free].turns;
  return out;
}

Eigen::MatrixXd Bodies::spring_stiffness() const {
  const auto m = static_cast<Eigen::Index>(6 * free_.size());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(m, m);
  for (const Spring& spring : springs_) {
    if (spring.damper) continue;
    const int b = bodies_[spring.body].free,
              other = spring.to < 0 ? -1 : bodies_[std::size_t(spring.to)].free;
    const Mat3 k = spring.stiffness.asDiagonal();
    for (const auto& [row, column, sign] : {std::tuple(b, b, 1), std::tuple(b, other, -1),
                                            std::tuple(other, b, -1), std::tuple(other, other, 1)})
      if (row >= 0 && column >= 0) out.block<3, 3>(6 * row, 6 * column) += sign * k;
  }
  return out;
}

void Bodies::add_response(Eigen::MatrixXd& response) const {
  using Rows = Eigen::Matrix<double, 3, 6>;
  const double dt = to_ - from_;
  const auto add = [&](int row, int column, const Vec3& k) {
    if (row < 0 || column < 0) return;
    const Rows by = k.asDiagonal() * compliance(static_cast<std::size_t>(column)).topRows<3>();
    response.block<3, 6>(6 * row, 6 * column) += by;
  };
  for (const Spring& spring : springs_) {
    if (spring.damper && !(dt > 0)) continue;
    const Vec3 k = spring.stiffness * (spring.damper ? 1 / dt : static_ ? 1 : 0.5);
    const int b = bodies_[spring.body].free;
    const int other = spring.to < 0 ? -1 : bodies_[std::size_t(spring.to)].free;
    add(b, b, -k);
    add(b, other, k);
    add(other, b, k);
    add(other, other, -k);
  }
}

std::vector<bool> Bodies::held() const {
  std::vector<bool> out;
  for (const Free& free : free_)
    for (const Vec3& left : {free.moves, free.turns})
      for (int i = 0; i < 3; ++i) out.push_back(left[i] == 0);
  return out;
}

void Bodies::hold(Eigen::MatrixXd& response) const {
  if (!static_) return;
  for (std::size_t f = 0; f < free_.size(); ++f) {
    const Free& free = free_[f];
    const Matrix6 moved = compliance(f);
    const double load = free.load.force.cwiseProduct(free.moves).norm();
    const double force = std::max({kLeastForce, load, free.trial.force.norm()}) / reach_;
    Vec3 springs = Vec3::Zero();  // a direction that they hold needs nothing else
    for (const Spring& spring : springs_)
      if (!spring.damper && bodies_[spring.body].free == static_cast<int>(f)) springs += spring.stiffness;
    for (int i = 0; i < 6; ++i) {
      const bool turns = i > 2;
      if ((turns ? free.turns[i - 3] : free.moves[i]) == 0) continue;
      const bool sprung = !turns && springs[i] > 0;
      double& on = response(6 * static_cast<Eigen::Index>(f) + i, 6 * static_cast<Eigen::Index>(f) + i);
      const double least = sprung ? 0 : force * (turns ? free.size * free.size : 1) * moved(i, i);
      on = 1 + std::min(on, -least);
    }
  }
}

}  // namespace fabricsh::mechanics
