#include "mechanics/terms/bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/error.hpp"
#include "base/number.hpp"
#include "contact/scene.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kRadian = std::numbers::pi / 180;

// Force and torque about its centre from the forces on a free body's vertices.
contact::Wrench wrench_on(const contact::FreeBody& body, std::span<const Vec3> x,
                          std::span<const Vec3> force) {
  return contact::wrench(x, force, body.centre());
}

// The rotation from one orientation to another, rad.
Vec3 rotation(const Mat3& from, const Mat3& to) {
  const Eigen::AngleAxisd turned(Mat3(to * from.transpose()));
  return turned.angle() * turned.axis();
}

}  // namespace

Bodies::Bodies(const model::Model& model, contact::Scene& scene) : model_(model) {
  const auto& given = model.interactions();
  const std::size_t nodes = scene.reference().size();
  for (const auto& rigid : given.bodies()) {
    Body body{rigid};
    body.first = scene.reference().size() - nodes;
    body.surface = model::add_to(scene, *rigid);
    add_seats(body, scene);
    add_tied(body, scene);
    body.count = scene.reference().size() - nodes - body.first;
    body.motion = given.motion_of(*rigid);
    if (const auto* moving = rigid->moving()) body.moving.emplace(moving->times, moving->shapes);
    if (given.floats(*rigid)) {
      body.free = static_cast<int>(free_.size());
      free_.push_back(free_body(body, scene));
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
    free.arm = far;
    far += scene.surfaces()[static_cast<std::size_t>(body.surface)].radius;
    const double moment = Eigen::SelfAdjointEigenSolver<Mat3>(free.committed.inertia()).eigenvalues()[0];
    const double turning = free.turns.isZero(0) ? 0 : far * far / moment;
    // Of the whole body: the other part is pushed at the same time.
    free.bound = (1 / free.committed.mass() + turning) * std::exp2(-free.planes);
    free.size = far;
  }
  free_of_.assign(reference_.size(), -1);
  for (const Body& body : bodies_)
    std::fill_n(free_of_.begin() + static_cast<std::ptrdiff_t>(body.first), body.count, body.free);
  add_loads();
  add_springs();
  set_time(0, 0);
  committed_ = target_;
}

// The places at which the rims of volumes of gas lie on a body go along with it.
void Bodies::add_seats(const Body& body, contact::Scene& scene) {
  const auto& gases = model_.all<model::GasPointer>();
  const std::size_t nodes = model_.mesh().nodes.size();
  for (std::size_t g = 0; g < gases.size(); ++g) {
    if (gases[g]->bodies.empty()) continue;
    const auto lids = model::enclosure_of(model_, *gases[g]).bodies;
    seats_.resize(gases.size());
    seats_[g].resize(lids.size());
    for (std::size_t k = 0; k < lids.size(); ++k) {
      if (lids[k].body != body.given) continue;
      seats_[g][k] = scene.reference().size() - nodes;
      scene.add_followers(lids[k].seats);
    }
  }
}

void Bodies::add_tied(const Body& body, contact::Scene& scene) {
  for (const model::Tie& tie : model_.all<model::Tie>()) {
    if (tie.kind != model::TieKind::rigid || tie.partner != body.given->name()) continue;
    for (const Index n : model_.mesh().set(tie.set)) {
      tied_.push_back({n, scene.reference().size() - model_.mesh().nodes.size()});
      scene.add_followers(std::array<Vec3, 1>{model_.mesh().nodes[static_cast<std::size_t>(n)]});
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
bool Bodies::is_cut(const model::SymmetryPlane& plane, const Body& body, const contact::Mass& mass,
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
  throw Error("model: the " + model_.interactions().name_of(*body.given) + " is not symmetric about " +
              plane.words() +
              ", which cuts it: expected a body of the same shape on both sides, the centre of its "
              "mass in the plane (it is at " +
              std::string(1, "xyz"[plane.axis]) + " = " + number(mass.centre[plane.axis]) +
              " m), or one that ends in the plane or does not reach it");
}

Bodies::Free Bodies::free_body(const Body& body, const contact::Scene& scene) {
  contact::Mass mass = body.given->weigh();
  const std::string name = model_.interactions().name_of(*body.given);
  if (!body.given->free()) {  // statics need no mass
    without_mass_ = name;
    mass = {1, body.given->centre(), Mat3::Identity()};
  }
  const auto* start = model_.interactions().velocity_of(*body.given);
  const Vec3 velocity = start != nullptr ? start->linear : Vec3(Vec3::Zero()),
             spin = start != nullptr ? start->spin : Vec3(Vec3::Zero());
  Vec3 moves = Vec3::Ones(), turns = Vec3::Ones();
  int planes = 0;
  for (const auto& plane : model::symmetry_planes(model_)) {
    if (!is_cut(plane, body, mass, scene)) continue;
    ++planes;
    const Vec3 normal = Vec3::Unit(plane.axis);
    moves -= moves.cwiseProduct(normal);
    turns = turns.cwiseProduct(normal);
    // What the other part takes up: there is no spin but that about the normal.
    for (int i = 0; i < 3; ++i)
      if (i != plane.axis) mass.inertia(i, plane.axis) = mass.inertia(plane.axis, i) = 0;
    halves_.push_back("the " + name + " is cut by " + plane.words() + ": it moves in the plane, and its " +
                      number(mass.mass) + " kg are the mass of the part that is in the model");
    if (velocity.cwiseProduct(moves) != velocity || spin.cwiseProduct(turns) != spin)
      throw Error("velocity: the " + name + " is cut by " + plane.words() +
                  ": expected a velocity in the plane and a spin about its normal alone");
  }
  const auto held = model_.interactions().held(*body.given);
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
  Free out{free, free, {}, {}, 0};
  out.cut = moves != Vec3::Ones() || turns != Vec3::Ones();
  out.planes = planes;
  out.moves = moves;
  out.turns = turns;
  return out;
}

bool Bodies::any_free() const { return !free_.empty(); }
bool Bodies::any_driven() const {
  return std::any_of(bodies_.begin(), bodies_.end(),
                     [](const Body& b) { return b.motion != nullptr || b.moving.has_value(); });
}

Vec3 Bodies::displaced(const Body& body, double time) const {
  Vec3 moved = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
    if (const auto& h = body.motion->displacement[c]) moved[c] = h->value(time);
  return moved;
}

contact::Pose Bodies::driven(const Body& body, double time) const {
  contact::Pose pose;
  if (body.motion == nullptr) return pose;
  try {
    pose.place = displaced(body, time);
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

// --- what a step may be long, so that the straight ways from its beginning to its end stand for the paths

namespace {

constexpr int kLooks = 32;      // times within a step at which a path is looked at
constexpr int kTries = 60;      // a step becomes no shorter than by 2^-60
constexpr double kSame = 1e-9;  // shares of a limit that are the same

// m, from a point to the segment from a to b.
double off(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp(way.dot(p - a) / length, 0.0, 1.0) : 0;
  return (p - a - share * way).norm();
}

bool runs_straight(const model::BodyMotion& motion) {
  const auto is_table = [](const auto& h) { return !h || h->is_constant() || !h->kinks().empty(); };
  return std::all_of(motion.displacement.begin(), motion.displacement.end(), is_table) &&
         (!motion.turn || is_table(std::optional(motion.turn->angle)));
}

}  // namespace

// m: the largest distance of the body's points from the axis that it turns about. A plane that turns in
// itself has none; else it reaches as far as the cloth.
double Bodies::lever(const Body& body, const BoundingBox& cloth) const {
  if (body.free >= 0) return free_[body.free].arm;
  const auto& turn = *body.motion->turn;
  const Vec3 axis = turn.axis.normalized(), centre = turn.centre.value_or(body.given->centre());
  if (const auto* plane = std::get_if<model::Plane>(&body.given->shape())) {
    const bool in_itself = axis.cross(plane->normal.normalized()).norm() < kNear;
    return in_itself ? 0 : (cloth.middle() - centre).norm() + cloth.size().norm() / 2;
  }
  double most = 0;
  for (std::size_t i = body.first; i < body.first + body.count; ++i)
    most = std::max(most, axis.cross(reference_[i] - centre).norm());
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
Bodies::BodyPath Bodies::path(const Body& body, double from, double to, double near,
                              const BoundingBox& cloth) const {
  if (body.free >= 0) {
    const Free& free = free_[body.free];
    const Vec3 way = (to - from) * free.committed.velocity();
    const double spun = free.committed.spin().norm() * (to - from);
    const bool rolls = may_reach(cloth, free.committed.centre(), way, free.size);
    return {std::max(spun, rolls ? way.norm() / free.size : 0) / largest_turn,
            free.arm * spun * spun / 8 / near};
  }
  const Vec3 start = displaced(body, from), end = displaced(body, to);
  const auto& turn = body.motion->turn;
  const int looks = runs_straight(*body.motion) ? 1 : kLooks;
  double angle = 0, aside = 0, before = turn ? turn->angle.value(from) : 0;
  for (int k = 1; k <= looks; ++k) {
    const double time = k == looks ? to : from + (to - from) * k / looks;
    if (k < looks) aside = std::max(aside, off(displaced(body, time), start, end));
    if (!turn) continue;
    const double now = turn->angle.value(time);
    angle += kRadian * std::abs(now - before);
    before = now;
  }
  const double bend = angle > 0 ? lever(body, cloth) * angle * angle / 8 : 0;
  return {angle / largest_turn, (aside + bend) / near};
}

double Bodies::follows(std::size_t i, double from, double to, double near, const BoundingBox& cloth) const {
  const Body& body = bodies_[i];
  if (body.free < 0 && body.motion == nullptr) return to;
  double end = to;
  for (int tries = 0; tries < kTries; ++tries) {
    const double parts = path(body, from, end, near, cloth).parts();
    if (!(parts > 1 + kSame)) break;
    end = from + (end - from) / std::clamp(std::ceil(parts * (1 - kSame)), 2.0, 1e6);
  }
  return end;
}

double Bodies::turned_most() const {
  double most = 0;
  for (const Body& body : bodies_) most = std::max(most, body.turned.norm());
  for (const Free& free : free_) most = std::max(most, free.predicted.spin().norm() * (to_ - from_));
  return most;
}

void Bodies::place(const Body& body, double time, std::span<Vec3> x) const {
  if (body.moving) return body.moving->at(time, x);
  const contact::Pose pose = driven(body, time);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = pose(reference_[body.first + i]);
}

Vec3 Bodies::gravity(double time) const {
  Vec3 g = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
    if (const auto& h = model_.gravity()[c]) g[c] = h->value(time) - missing(time) * h->value(0);
  return g;
}

contact::Wrench Bodies::first_half(const Free& body) const {
  if (static_) return body.left(body.end);
  const double mass = body.committed.mass();
  if (!implicit_) return body.left({body.wrench.force + mass * gravity(from_), body.wrench.torque});
  return body.left({body.end.force + mass * (gravity(from_) + gravity(to_)) / 2, body.end.torque});
}

// Moves the free bodies to the end of the step.
void Bodies::fly() {
  const double dt = flight();
  for (Body& body : bodies_) {
    if (body.free < 0) continue;
    Free& free = free_[body.free];
    free.predicted = free.committed;
    if (dt != 0) {
      const contact::Wrench kick = first_half(free);
      free.predicted.kick(kick.force, kick.torque, dt / 2);
      free.predicted.drift(dt);
      if (static_) free.predicted.rest();
    }
    body.turned = rotation(free.committed.pose().turn, free.predicted.pose().turn);
    const contact::Pose pose = free.predicted.pose();
    const Vec3& origin = body.given->centre();
    for (std::size_t i = body.first; i < body.first + body.count; ++i)
      target_[i] = pose(reference_[i] - origin);
  }
}

void Bodies::set_time(double from, double to) {
  from_ = from;
  to_ = to;
  for (Body& body : bodies_) {
    if (body.free >= 0) continue;
    if (body.motion != nullptr || body.moving)
      place(body, to, std::span(target_).subspan(body.first, body.count));
    if (body.motion != nullptr && body.motion->turn)
      body.turned = rotation(driven(body, from).turn, driven(body, to).turn);
  }
  rollback();
}

bool Bodies::jumps() const {
  constexpr double rounding = 1e-9;  // of what is farthest from the origin
  double far = 0, most = 0;
  for (std::size_t i = 0; i < target_.size(); ++i) {
    far = std::max(far, target_[i].norm());
    most = std::max(most, (target_[i] - committed_[i]).norm());
  }
  return most > rounding * far;
}

void Bodies::settle() {
  committed_ = target_;
  from_ = to_;
  set_time(to_, to_);
}

void Bodies::rollback() {
  loaded_ = false;
  for (Free& free : free_) {
    free.end = free.iterate = start_of(free);
    free.way = {};
  }
  fly();
}

// --- implicit steps of free bodies

Eigen::VectorXd Bodies::residual() const {
  Eigen::VectorXd out(static_cast<Eigen::Index>(unknowns()));
  for (std::size_t f = 0; f < free_.size(); ++f) {
    const contact::Wrench& is = loaded_ ? free_[f].trial : free_[f].wrench;
    const auto row = static_cast<Eigen::Index>(6 * f);
    const contact::Wrench with = static_ ? contact::Wrench{} : free_[f].end;
    out.segment<3>(row) = is.force - with.force;
    out.segment<3>(row + 3) = is.torque - with.torque;
  }
  return out;
}

double Bodies::largest_residual() const {
  double most = 0;
  if (!implicit_ || !loaded_ || to_ == from_) return most;
  const Eigen::VectorXd all = residual();
  for (std::size_t f = 0; f < free_.size(); ++f) {
    const auto row = static_cast<Eigen::Index>(6 * f);
    most = std::max({most, all.segment<3>(row).lpNorm<Eigen::Infinity>(),
                     all.segment<3>(row + 3).lpNorm<Eigen::Infinity>() / free_[f].size});
  }
  return most;
}

double Bodies::largest_force() const {
  double most = 0;
  for (const Free& free : free_) {
    // Where all forces balance, each of them is compared with.
    if (static_) most = std::max(most, free.largest);
    if (static_) continue;
    const contact::Wrench& is = loaded_ ? free.trial : free.wrench;
    most =
        std::max({most, is.force.lpNorm<Eigen::Infinity>(), is.torque.lpNorm<Eigen::Infinity>() / free.size});
  }
  return most;
}

void Bodies::direct(std::span<const double> way) {
  for (std::size_t f = 0; f < free_.size(); ++f) {
    free_[f].way = free_[f].left(
        {Eigen::Map<const Vec3>(way.data() + 6 * f), Eigen::Map<const Vec3>(way.data() + 6 * f + 3)});
  }
}

void Bodies::begin_iterate() {
  for (Free& free : free_) {
    free.iterate = free.end;
    free.way = {};
  }
}

void Bodies::move(double scale) {
  if (!implicit_ || free_.empty()) return;
  for (Free& free : free_) {
    free.end.force = free.iterate.force + scale * free.way.force;
    free.end.torque = free.iterate.torque + scale * free.way.torque;
  }
  fly();
}

Bodies::Matrix6 Bodies::compliance(std::size_t free) const {
  const double dt = flight();
  Matrix6 out = Matrix6::Zero();
  out.topLeftCorner<3, 3>() = dt * dt / 2 / free_[free].committed.mass() * Mat3::Identity();
  out.bottomRightCorner<3, 3>() = dt * dt / 2 * free_[free].predicted.inertia().inverse();
  if (!free_[free].cut) return out;
  Eigen::Matrix<double, 6, 1> left;
  left << free_[free].moves, free_[free].turns;
  return left.asDiagonal() * out * left.asDiagonal();
}

// To the forces at the start of the run, or at the end of the step.
void Bodies::add_gas(const Body& body, Free& free) const {
  if (gas_.empty()) return;
  const auto part = [&](const contact::FreeBody& at, const std::vector<Vec3>& x, const std::vector<Vec3>& f) {
    return wrench_on(at, std::span(x).subspan(body.first, body.count),
                     std::span(f).subspan(body.first, body.count));
  };
  const contact::Wrench before = part(free.committed, committed_, gas_);
  if (!loaded_) {
    free.wrench.force += before.force;
    free.wrench.torque += before.torque;
    return;
  }
  const double share = share_of_gas();
  const contact::Wrench after = part(free.predicted, target_, trial_gas_);
  free.trial.force += share * after.force + (1 - share) * before.force;
  free.trial.torque += share * after.torque + (1 - share) * before.torque;
}

// J, in the step, on the cloth and what encloses the gas with it, of what drives the body.
StepWork Bodies::work_of_gas(const Body& body) const {
  StepWork sum;
  double change = 0;
  for (std::size_t i = body.first; i < body.first + body.count && !gas_.empty(); ++i) {
    const Vec3 way = target_[i] - committed_[i];
    sum.work -= (gas_[i] + trial_gas_[i]).dot(way) / 2;
    change += (gas_[i] - trial_gas_[i]).dot(way) / 2;
  }
  sum.spread = std::abs(change);
  return sum;
}

void Bodies::begin(std::span<const Vec3> force) {
  std::copy(force.begin(), force.end(), force_.begin());
  for (const Body& body : bodies_) {
    if (body.free < 0) continue;
    Free& free = free_[body.free];
    free.wrench = wrench_on(free.committed, std::span<const Vec3>(committed_).subspan(body.first, body.count),
                            force.subspan(body.first, body.count));
    add_gas(body, free);
  }
  begin_loads();
}

void Bodies::load(std::span<const Vec3> force, std::span<const Vec3> torque) {
  std::copy(force.begin(), force.end(), trial_force_.begin());
  loaded_ = true;
  for (Body& body : bodies_) {
    body.trial_torque.setZero();
    for (const Vec3& part : torque.subspan(body.first, body.count)) body.trial_torque += part;
    if (body.free < 0) continue;
    Free& free = free_[body.free];
    free.trial = wrench_on(free.predicted, std::span<const Vec3>(target_).subspan(body.first, body.count),
                           force.subspan(body.first, body.count));
    free.trial.torque += body.trial_torque;
    add_gas(body, free);
  }
  apply_loads();
}

contact::FreeBody Bodies::kicked(const Free& body) const {
  if (!loaded_) return body.committed;
  if (to_ == from_ || static_) return body.predicted;
  contact::FreeBody at = body.predicted;
  // The rest of the impulse: of the mean of both forces, or in implicit steps of the force at the end.
  const contact::Wrench first = first_half(body), &other = implicit_ ? body.trial : body.wrench;
  const contact::Wrench rest =
      body.left({other.force + body.trial.force + at.mass() * (gravity(from_) + gravity(to_)) - first.force,
                 other.torque + body.trial.torque - first.torque});
  at.kick(rest.force, rest.torque, (to_ - from_) / 2);
  return at;
}

void Bodies::commit() {
  for (Spring& spring : springs_) {
    if (!loaded_ || !spring.damper) continue;
    spring.lost += lost_in(spring);
    spring.force = spring.trial_force;
  }
  for (Free& free : free_) {
    free.committed = kicked(free);
    if (loaded_) free.wrench = free.trial;
    free.predicted = free.committed;
    free.end = free.iterate = start_of(free);
  }
  if (loaded_) force_ = trial_force_;
  if (loaded_ && !gas_.empty()) gas_ = trial_gas_;
  for (Body& body : bodies_)
    if (loaded_) body.torque = body.trial_torque;
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
    if (!gas_.empty()) archive.filled({gas_.front().data(), 3 * gas_.size()});
    for (Body& body : bodies_) archive.filled({body.torque.data(), 3});
  }
  for (Spring& spring : springs_)
    if (spring.damper) {
      archive.filled({spring.force.data(), 3});
      archive(spring.lost);
    }
  archive(to_);
  if (!archive.reading()) return;
  from_ = to_;
  target_ = committed_;
  loaded_ = false;
  for (Free& free : free_) {
    if (static_) free.committed.rest();
    free.predicted = free.committed;
    free.end = free.iterate = start_of(free);
  }
}

double Bodies::kinetic() const {
  double sum = 0;
  for (const Free& free : free_) sum += kicked(free).kinetic_energy();
  return sum;
}

StepWork Bodies::step_work() const {
  if (!loaded_) return {};
  StepWork sum = work_of_loads();
  for (const Body& body : bodies_) {
    if (body.free >= 0) {
      const Free& free = free_[body.free];
      const Vec3 moved = free.predicted.centre() - free.committed.centre();
      sum.work += body.given->mass().value_or(0) * (gravity(from_) + gravity(to_)).dot(moved) / 2;
      continue;
    }
    const auto& force = implicit_ ? trial_force_ : force_;
    const Vec3& torque = implicit_ ? body.trial_torque : body.torque;
    double change = (torque - body.trial_torque).dot(body.turned) / 2;
    for (std::size_t i = body.first; i < body.first + body.count; ++i) {
      const Vec3 way = target_[i] - committed_[i];
      sum.work -= (force[i] + trial_force_[i]).dot(way) / 2;
      change += (force[i] - trial_force_[i]).dot(way) / 2;
    }
    sum.work -= (torque + body.trial_torque).dot(body.turned) / 2;
    sum.spread += std::abs(change);
    sum += work_of_gas(body);
  }
  return sum;
}

Vec3 Bodies::force(std::size_t i) const {
  const auto& all = loaded_ ? trial_force_ : force_;
  Vec3 sum = Vec3::Zero();
  const auto gas = pressed();
  for (std::size_t k = bodies_[i].first; k < bodies_[i].first + bodies_[i].count; ++k)
    sum += gas.empty() ? all[k] : Vec3(all[k] + gas[k]);
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

Bodies::BodyKinematics Bodies::state(std::size_t i) const {
  const Body& body = bodies_[i];
  if (body.free >= 0) {
    const contact::FreeBody at = kicked(free_[body.free]);
    return {at.centre(), at.velocity(), at.spin()};
  }
  BodyKinematics state{body.given->centre(), Vec3::Zero(), Vec3::Zero()};
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

double Bodies::inverse_mass_pressed(std::size_t i) const {
  if (bodies_[i].free < 0) return 0;
  const Free& free = free_[bodies_[i].free];
  return free.arm > 0 ? free.bound : 1 / free.committed.mass();
}

double Bodies::size(std::size_t i) const {
  const model::RigidShape& shape = bodies_[i].given->shape();
  if (const auto* ball = std::get_if<model::Sphere>(&shape)) return ball->radius;
  if (const auto* rod = std::get_if<model::Cylinder>(&shape)) return rod->radius;
  if (std::holds_alternative<model::Plane>(shape)) return 0;
  double most = 0;
  const auto all = std::span(reference_).subspan(bodies_[i].first, bodies_[i].count);
  for (const Vec3& x : all) most = std::max(most, (x - bodies_[i].given->centre()).norm());
  return most;
}

double Bodies::fastest_free() const {
  double most = 0;
  for (const Free& free : free_) most = std::max(most, free.committed.velocity().norm());
  return most;
}

double Bodies::inverse_mass(std::size_t i) const {
  return bodies_[i].free < 0 ? 0 : free_[bodies_[i].free].bound;
}

unsigned char Bodies::planes_through(std::size_t i) const {
  unsigned char planes = 0;
  for (int axis = 0; axis < 3 && bodies_[i].free >= 0; ++axis)
    if (free_[bodies_[i].free].moves[axis] == 0) planes |= static_cast<unsigned char>(1 << axis);
  return planes;
}

}  // namespace fabricsh::mechanics
