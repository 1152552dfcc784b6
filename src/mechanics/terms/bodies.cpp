#include "mechanics/terms/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/error.hpp"
#include "contact/scene.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kRadian = std::numbers::pi / 180;

// Force and torque about its centre from the forces on a free body's vertices.
contact::Wrench wrench_on(const contact::FreeBody& body, std::span<const Vec3> x,
                          std::span<const Vec3> force) {
  return contact::wrench(x, force, body.centre());
}

}  // namespace

Bodies::Bodies(const model::Model& model, contact::Scene& scene) : model_(model) {
  const auto& given = model.interactions();
  const std::size_t nodes = scene.reference().size();
  for (const auto& rigid : given.bodies()) {
    Body body{rigid};
    body.first = scene.reference().size() - nodes;
    body.surface = model::add_to(scene, *rigid);
    body.count = scene.reference().size() - nodes - body.first;
    body.motion = given.motion_of(*rigid);
    if (const auto* moving = rigid->moving()) body.moving.emplace(moving->times, moving->shapes);
    if (rigid->free()) {
      const auto* start = given.velocity_of(*rigid);
      const contact::FreeBody free(rigid->weigh(), start != nullptr ? start->linear : Vec3(Vec3::Zero()),
                                   start != nullptr ? start->spin : Vec3(Vec3::Zero()));
      body.free = static_cast<int>(free_.size());
      free_.push_back({free, free, {}, {}, 0});
    }
    bodies_.push_back(std::move(body));
  }
  reference_.assign(scene.reference().begin() + static_cast<std::ptrdiff_t>(nodes), scene.reference().end());
  committed_ = target_ = reference_;
  force_.assign(reference_.size(), Vec3::Zero());
  trial_force_ = force_;
  for (const Body& body : bodies_) {
    if (body.free < 0) continue;
    Free& free = free_[body.free];
    double far = 0;
    for (std::size_t i = body.first; i < body.first + body.count; ++i)
      far = std::max(far, (reference_[i] - free.committed.centre()).norm());
    const double moment = Eigen::SelfAdjointEigenSolver<Mat3>(free.committed.inertia()).eigenvalues()[0];
    free.bound = 1 / free.committed.mass() + far * far / moment;
  }
  aim(0, 0);
  committed_ = target_;
}

bool Bodies::any_free() const { return !free_.empty(); }
bool Bodies::any_driven() const {
  return std::any_of(bodies_.begin(), bodies_.end(),
                     [](const Body& b) { return b.motion != nullptr || b.moving.has_value(); });
}

contact::Pose Bodies::driven(const Body& body, double time) const {
  contact::Pose pose;
  if (body.motion == nullptr) return pose;
  try {
    for (int c = 0; c < 3; ++c)
      if (const auto& h = body.motion->displacement[c]) pose.place[c] = h->value(time);
    if (const auto& turn = body.motion->turn) {
      pose.turn = contact::Pose::about(turn->axis, kRadian * turn->angle.value(time));
      const Vec3 centre = turn->centre.value_or(body.given->centre());
      pose.place += centre - pose.turn * centre;
    }
  } catch (const Error& error) {
    throw Error("move: the " + model_.interactions().name_of(*body.given) + ": " + error.what());
  }
  return pose;
}

void Bodies::place(const Body& body, double time, std::span<Vec3> x) const {
  if (body.moving) return body.moving->at(time, x);
  const contact::Pose pose = driven(body, time);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = pose(reference_[body.first + i]);
}

Vec3 Bodies::gravity(double time) const {
  Vec3 g = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
    if (const auto& h = model_.gravity()[c]) g[c] = h->value(time);
  return g;
}

contact::FreeBody Bodies::flown(const Free& body, double time, double dt) const {
  contact::FreeBody at = body.committed;
  if (dt == 0) return at;
  at.kick(body.wrench.force + at.mass() * gravity(time), body.wrench.torque, dt / 2);
  at.drift(dt);
  return at;
}

void Bodies::aim(double from, double to) {
  loaded_ = false;
  from_ = from;
  to_ = to;
  for (const Body& body : bodies_) {
    const std::span<Vec3> x = std::span(target_).subspan(body.first, body.count);
    if (body.free < 0) {
      if (body.motion != nullptr || body.moving) place(body, to, x);
      continue;
    }
    Free& free = free_[body.free];
    free.predicted = flown(free, from, to - from);
    const contact::Pose pose = free.predicted.pose();
    const Vec3& origin = body.given->centre();
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = pose(reference_[body.first + i] - origin);
  }
}

void Bodies::load(std::span<const Vec3> force) {
  std::copy(force.begin(), force.end(), trial_force_.begin());
  loaded_ = true;
  for (const Body& body : bodies_) {
    if (body.free < 0) continue;
    Free& free = free_[body.free];
    free.trial = wrench_on(free.predicted, std::span<const Vec3>(target_).subspan(body.first, body.count),
                           force.subspan(body.first, body.count));
  }
}

contact::FreeBody Bodies::kicked(const Free& body) const {
  if (!loaded_) return body.committed;
  if (to_ == from_) return body.predicted;
  contact::FreeBody at = body.predicted;
  at.kick(body.trial.force + at.mass() * gravity(to_), body.trial.torque, (to_ - from_) / 2);
  return at;
}

void Bodies::commit() {
  for (Free& free : free_) {
    free.committed = kicked(free);
    if (loaded_) free.wrench = free.trial;
    free.predicted = free.committed;
  }
  if (loaded_) force_ = trial_force_;
  committed_ = target_;
  from_ = to_;
  loaded_ = false;
}

void Bodies::keep(Archive& archive) {
  for (Free& free : free_) {
    free.committed.keep(archive);
    archive.filled({free.wrench.force.data(), 3});
    archive.filled({free.wrench.torque.data(), 3});
  }
  if (!committed_.empty()) {
    archive.filled({committed_.front().data(), 3 * committed_.size()});
    archive.filled({force_.front().data(), 3 * force_.size()});
  }
  archive(to_);
  if (!archive.reading()) return;
  from_ = to_;
  target_ = committed_;
  loaded_ = false;
  for (Free& free : free_) free.predicted = free.committed;
}

double Bodies::kinetic() const {
  double sum = 0;
  for (const Free& free : free_) sum += kicked(free).kinetic_energy();
  return sum;
}

double Bodies::step_work() const {
  double work = 0;
  if (!loaded_) return work;
  for (const Body& body : bodies_) {
    if (body.free >= 0) {
      const Free& free = free_[body.free];
      const Vec3 moved = free.predicted.centre() - free.committed.centre();
      work += free.committed.mass() * (gravity(from_) + gravity(to_)).dot(moved) / 2;
      continue;
    }
    for (std::size_t i = body.first; i < body.first + body.count; ++i)
      work -= (force_[i] + trial_force_[i]).dot(target_[i] - committed_[i]) / 2;
  }
  return work;
}

Vec3 Bodies::force(std::size_t i) const {
  const auto& all = loaded_ ? trial_force_ : force_;
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = bodies_[i].first; k < bodies_[i].first + bodies_[i].count; ++k) sum += all[k];
  return sum;
}

contact::Pose Bodies::pose(std::size_t i) const {
  const Body& body = bodies_[i];
  if (body.free < 0) return driven(body, now());
  contact::Pose pose = (loaded_ ? free_[body.free].predicted : free_[body.free].committed).pose();
  pose.place -= pose.turn * body.given->centre();
  return pose;
}

std::vector<Vec3> Bodies::moved(std::size_t i, const std::vector<Vec3>& points) const {
  const Body& body = bodies_[i];
  std::vector<Vec3> out = points;
  if (body.moving) {
    body.moving->at(now(), out);
    return out;
  }
  const contact::Pose at = pose(i);
  for (Vec3& p : out) p = at(p);
  return out;
}

Bodies::State Bodies::state(std::size_t i) const {
  const Body& body = bodies_[i];
  if (body.free >= 0) {
    const contact::FreeBody at = kicked(free_[body.free]);
    return {at.centre(), at.velocity(), at.spin()};
  }
  State state{body.given->centre(), Vec3::Zero(), Vec3::Zero()};
  if (body.moving) {
    const std::vector<Vec3> x = moved(i, std::vector<Vec3>(body.count));
    state.place = std::accumulate(x.begin(), x.end(), Vec3(Vec3::Zero())) / double(body.count);
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

double Bodies::inverse_mass(std::size_t i) const {
  return bodies_[i].free < 0 ? 0 : free_[bodies_[i].free].bound;
}

}  // namespace fabricsh::mechanics
