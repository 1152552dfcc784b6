#include "mechanics/terms/bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/number.hpp"
#include "contact/scene.hpp"

namespace fabricsh::mechanics {

namespace {

// Force and torque about its centre from the forces on a free body's vertices.
contact::Wrench wrench_on(const contact::FreeBody& body, std::span<const Vec3> x,
                          std::span<const Vec3> force) {
  return contact::wrench(x, force, body.centre());
}

constexpr double kReach = 10;  // ranges of contact, that an unheld body goes in an iteration at most

}  // namespace

Bodies::Bodies(const model::Model& model, contact::Scene& scene) : state_{model} {
  const auto& given = model.interactions();
  const std::size_t nodes = scene.reference().size();
  for (const auto& rigid : given.bodies()) {
    BodyState::Body body{rigid};
    body.first = scene.reference().size() - nodes;
    body.surface = model::add_to(scene, *rigid);
    add_seats(body, scene);
    add_tied(body, scene);
    body.count = scene.reference().size() - nodes - body.first;
    body.motion = given.motion_of(*rigid);
    if (const auto* moving = rigid->moving()) body.moving.emplace(moving->times, moving->shapes);
    if (given.floats(*rigid)) {
      body.free = static_cast<int>(state_.free.size());
      state_.free.push_back(free_body(body, scene));
    }
    state_.bodies.push_back(std::move(body));
  }
  state_.reference.assign(scene.reference().begin() + static_cast<std::ptrdiff_t>(nodes),
                          scene.reference().end());
  state_.committed = state_.target = state_.reference;
  state_.force.assign(state_.reference.size(), Vec3::Zero());
  state_.trial_force = state_.force;
  for (const BodyState::Body& body : state_.bodies) {
    if (body.free < 0) continue;
    BodyState::Free& free = state_.free[body.free];
    double far = 0;
    for (std::size_t i = body.first; i < body.first + body.count; ++i)
      far = std::max(far, (state_.reference[i] - free.committed.centre()).norm());
    free.arm = far;
    far += scene.surfaces()[static_cast<std::size_t>(body.surface)].radius;
    const double moment = Eigen::SelfAdjointEigenSolver<Mat3>(free.committed.inertia()).eigenvalues()[0];
    const double turning = free.turns.isZero(0) ? 0 : far * far / moment;
    // Of the whole body: the other part is pushed at the same time.
    free.bound = (1 / free.committed.mass() + turning) * std::exp2(-free.planes);
    free.size = far;
  }
  state_.free_of.assign(state_.reference.size(), -1);
  for (const BodyState::Body& body : state_.bodies)
    std::fill_n(state_.free_of.begin() + static_cast<std::ptrdiff_t>(body.first), body.count, body.free);
  loads_.add();
  set_time(0, 0);
  state_.committed = state_.target;
}

// The places at which the rims of volumes of gas lie on a body go along with it.
void Bodies::add_seats(const BodyState::Body& body, contact::Scene& scene) {
  const auto& gases = state_.model.all<model::GasPointer>();
  const std::size_t nodes = state_.model.mesh().nodes.size();
  for (std::size_t g = 0; g < gases.size(); ++g) {
    if (gases[g]->bodies.empty()) continue;
    const auto lids = model::enclosure_of(state_.model, *gases[g]).bodies;
    seats_.resize(gases.size());
    seats_[g].resize(lids.size());
    for (std::size_t k = 0; k < lids.size(); ++k) {
      if (lids[k].body != body.given) continue;
      seats_[g][k] = scene.reference().size() - nodes;
      scene.add_followers(lids[k].seats);
    }
  }
}

void Bodies::add_tied(const BodyState::Body& body, contact::Scene& scene) {
  for (const model::Tie& tie : state_.model.all<model::Tie>()) {
    if (tie.kind != model::TieKind::rigid || tie.partner != body.given->name()) continue;
    for (const Index n : state_.model.mesh().set(tie.set)) {
      tied_.push_back({n, scene.reference().size() - state_.model.mesh().nodes.size()});
      scene.add_followers(std::array<Vec3, 1>{state_.model.mesh().nodes[static_cast<std::size_t>(n)]});
    }
  }
}

// --- bodies that a plane of symmetry cuts. The part of them in the model moves in the plane, and turns about
// its normal; the mass given is that of this part.

namespace {

constexpr double kNear = 1e-6;  // of a body's size

// Whether the body has a flat face in the plane: it is the part of a whole one that has been cut off there.
bool ends_in(const model::SymmetryPlane& plane, const model::Facets& facets, double near) {
  const auto lies = [&](std::int32_t v) {
    return std::abs(facets.vertices[static_cast<std::size_t>(v)][plane.axis] - plane.at) <= near;
  };
  return std::any_of(facets.triangles.begin(), facets.triangles.end(),
                     [&](const auto& t) { return lies(t[0]) && lies(t[1]) && lies(t[2]); });
}

// Whether the plane through the centre is one of symmetry for the inertia.
bool is_principal(const Mat3& inertia, int axis) {
  const double odd = std::hypot(inertia(axis, (axis + 1) % 3), inertia(axis, (axis + 2) % 3));
  return odd <= kNear * inertia.trace();
}

}  // namespace

// Whether the plane cuts the body. Error: it does, and the body is not symmetric about it.
bool Bodies::is_cut(const model::SymmetryPlane& plane, const BodyState::Body& body, const contact::Mass& mass,
                    const contact::Scene& scene) const {
  const double radius = scene.surfaces()[static_cast<std::size_t>(body.surface)].radius;
  const auto all = std::span(scene.reference()).last(body.count);
  const auto [low, high] = std::minmax_element(
      all.begin(), all.end(), [&](const Vec3& a, const Vec3& b) { return a[plane.axis] < b[plane.axis]; });
  const double from = (*low)[plane.axis] - radius, to = (*high)[plane.axis] + radius;
  double size = radius;
  for (const Vec3& x : all) size = std::max(size, (x - mass.centre).norm() + radius);
  const double near = kNear * size;
  if (plane.at <= from + near || plane.at >= to - near)
    return plane.at >= from - near && plane.at <= to + near && body.given->facets() != nullptr &&
           ends_in(plane, *body.given->facets(), near);
  if (std::abs(mass.centre[plane.axis] - plane.at) <= near && is_principal(mass.inertia, plane.axis))
    return true;
  throw Error("model: the " + state_.model.interactions().name_of(*body.given) + " is not symmetric about " +
              plane.words() +
              ", which cuts it: expected a body of the same shape on both sides, the centre of its "
              "mass in the plane (it is at " +
              std::string(1, "xyz"[plane.axis]) + " = " + number(mass.centre[plane.axis]) +
              " m), or one that ends in the plane or does not reach it");
}

BodyState::Free Bodies::free_body(const BodyState::Body& body, const contact::Scene& scene) {
  contact::Mass mass = body.given->weigh();
  const std::string name = state_.model.interactions().name_of(*body.given);
  if (!body.given->free()) {  // statics need no mass
    without_mass_ = name;
    mass = {1, body.given->centre(), Mat3::Identity()};
  }
  const auto* start = state_.model.interactions().velocity_of(*body.given);
  const Vec3 velocity = start != nullptr ? start->linear : Vec3(Vec3::Zero()),
             spin = start != nullptr ? start->spin : Vec3(Vec3::Zero());
  Vec3 moves = Vec3::Ones(), turns = Vec3::Ones();
  int planes = 0;
  for (const auto& plane : model::symmetry_planes(state_.model)) {
    if (!is_cut(plane, body, mass, scene)) continue;
    ++planes;
    const Vec3 normal = Vec3::Unit(plane.axis);
    moves -= moves.cwiseProduct(normal);
    turns = turns.cwiseProduct(normal);
    // The other part takes up the rest: there is no spin but that about the normal.
    for (int i = 0; i < 3; ++i)
      if (i != plane.axis) mass.inertia(i, plane.axis) = mass.inertia(plane.axis, i) = 0;
    halves_.push_back("the " + name + " is cut by " + plane.words() + ": it moves in the plane, and its " +
                      number(mass.mass) + " kg are the mass of the part that is in the model");
    if (velocity.cwiseProduct(moves) != velocity || spin.cwiseProduct(turns) != spin)
      throw Error("velocity: the " + name + " is cut by " + plane.words() +
                  ": expected a velocity in the plane and a spin about its normal alone");
  }
  const auto held = state_.model.interactions().held(*body.given);
  for (int i = 0; i < 3; ++i) {
    if (held.moves[static_cast<std::size_t>(i)]) moves[i] = 0;
    if (!held.turns[static_cast<std::size_t>(i)]) continue;
    turns[i] = 0;  // what holds it takes up the torque, so that it turns about the other axes alone
    for (int j = 0; j < 3; ++j)
      if (i != j) mass.inertia(i, j) = mass.inertia(j, i) = 0;
  }
  if (velocity.cwiseProduct(moves) != velocity || spin.cwiseProduct(turns) != spin)
    throw Error("velocity: the " + name + " is held (m:fix) in a direction in which it has a velocity");
  const contact::FreeBody free(mass, velocity, spin);
  BodyState::Free out{free, free, {}, {}, 0};
  out.cut = moves != Vec3::Ones() || turns != Vec3::Ones();
  out.planes = planes;
  out.moves = moves;
  out.turns = turns;
  return out;
}

bool Bodies::any_driven() const {
  return std::any_of(state_.bodies.begin(), state_.bodies.end(),
                     [](const BodyState::Body& b) { return b.motion != nullptr || b.moving.has_value(); });
}

void Bodies::place(const BodyState::Body& body, double time, std::span<Vec3> x) const {
  if (body.moving) return body.moving->at(time, x);
  const contact::Pose pose = state_.driven(body, time);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = pose(state_.reference[body.first + i]);
}

std::vector<Vec3> Bodies::places(std::size_t i, double time) const {
  const BodyState::Body& body = state_.bodies[i];
  std::vector<Vec3> x(body.count);
  try {
    place(body, time, x);
  } catch (const Error&) {
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] = 2 * state_.target[body.first + k] - state_.committed[body.first + k];
  }
  return x;
}

void Bodies::set_time(double from, double to) {
  state_.from = from;
  state_.to = to;
  for (BodyState::Body& body : state_.bodies) {
    if (body.free >= 0) continue;
    if (body.motion != nullptr || body.moving)
      place(body, to, std::span(state_.target).subspan(body.first, body.count));
    if (body.motion != nullptr && body.motion->turn)
      body.turned = BodyState::rotation(state_.driven(body, from).turn, state_.driven(body, to).turn);
  }
  rollback();
}

bool Bodies::jumps() const {
  constexpr double rounding = 1e-9;  // of what is farthest from the origin
  double far = 0, most = 0;
  for (std::size_t i = 0; i < state_.target.size(); ++i) {
    far = std::max(far, state_.target[i].norm());
    most = std::max(most, (state_.target[i] - state_.committed[i]).norm());
  }
  return most > rounding * far;
}

void Bodies::settle() {
  state_.committed = state_.target;
  state_.from = state_.to;
  set_time(state_.to, state_.to);
}

void Bodies::rollback() {
  state_.loaded = false;
  for (BodyState::Free& free : state_.free) {
    free.end = free.iterate = state_.start_of(free);
    free.way = {};
  }
  state_.fly();
}

void Bodies::go_static(double reach, double rise) {
  state_.implicit = state_.statics = true;
  state_.rise = rise;
  state_.reach = kReach * reach;
  for (BodyState::Free& free : state_.free) {
    free.committed.rest();
    free.predicted = free.committed;
    free.end = free.iterate = {};
  }
}

// To the forces at the start of the run, or at the end of the step.
void Bodies::add_gas(const BodyState::Body& body, BodyState::Free& free) const {
  if (state_.gas.empty()) return;
  const auto part = [&](const contact::FreeBody& at, const std::vector<Vec3>& x, const std::vector<Vec3>& f) {
    return wrench_on(at, std::span(x).subspan(body.first, body.count),
                     std::span(f).subspan(body.first, body.count));
  };
  const contact::Wrench before = part(free.committed, state_.committed, state_.gas);
  if (!state_.loaded) {
    free.wrench.force += before.force;
    free.wrench.torque += before.torque;
    return;
  }
  const double share = state_.share_of_end();
  const contact::Wrench after = part(free.predicted, state_.target, state_.trial_gas);
  free.trial.force += share * after.force + (1 - share) * before.force;
  free.trial.torque += share * after.torque + (1 - share) * before.torque;
}

void Bodies::begin(std::span<const Vec3> force) {
  std::copy(force.begin(), force.end(), state_.force.begin());
  for (const BodyState::Body& body : state_.bodies) {
    if (body.free < 0) continue;
    BodyState::Free& free = state_.free[body.free];
    free.wrench =
        wrench_on(free.committed, std::span<const Vec3>(state_.committed).subspan(body.first, body.count),
                  force.subspan(body.first, body.count));
    add_gas(body, free);
  }
  loads_.begin();
}

void Bodies::load(std::span<const Vec3> force, std::span<const Vec3> torque) {
  std::copy(force.begin(), force.end(), state_.trial_force.begin());
  state_.loaded = true;
  for (BodyState::Body& body : state_.bodies) {
    body.trial_torque.setZero();
    for (const Vec3& part : torque.subspan(body.first, body.count)) body.trial_torque += part;
    if (body.free < 0) continue;
    BodyState::Free& free = state_.free[body.free];
    free.trial =
        wrench_on(free.predicted, std::span<const Vec3>(state_.target).subspan(body.first, body.count),
                  force.subspan(body.first, body.count));
    free.trial.torque += body.trial_torque;
    add_gas(body, free);
  }
  loads_.apply();
}

void Bodies::commit() {
  loads_.commit();
  for (BodyState::Free& free : state_.free) {
    free.committed = state_.kicked(free);
    if (state_.loaded) free.wrench = free.trial;
    free.predicted = free.committed;
    free.end = free.iterate = state_.start_of(free);
  }
  if (state_.loaded) state_.force = state_.trial_force;
  if (state_.loaded && !state_.gas.empty()) state_.gas = state_.trial_gas;
  for (BodyState::Body& body : state_.bodies)
    if (state_.loaded) body.torque = body.trial_torque;
  state_.committed = state_.target;
  state_.from = state_.to;
  state_.loaded = false;
}

void Bodies::keep(Archive& archive) {
  for (BodyState::Free& free : state_.free) {
    free.committed.keep(archive);
    archive.filled({free.wrench.force.data(), 3});
    archive.filled({free.wrench.torque.data(), 3});
  }
  if (!state_.committed.empty()) {
    archive.filled({state_.committed.front().data(), 3 * state_.committed.size()});
    archive.filled({state_.force.front().data(), 3 * state_.force.size()});
    if (!state_.gas.empty()) archive.filled({state_.gas.front().data(), 3 * state_.gas.size()});
    for (BodyState::Body& body : state_.bodies) archive.filled({body.torque.data(), 3});
  }
  loads_.keep(archive);
  archive(state_.to);
  if (!archive.reading()) return;
  state_.from = state_.to;
  state_.target = state_.committed;
  state_.loaded = false;
  for (BodyState::Free& free : state_.free) {
    if (state_.statics) free.committed.rest();
    free.predicted = free.committed;
    free.end = free.iterate = state_.start_of(free);
  }
}

}  // namespace fabricsh::mechanics
