#include "mechanics/terms/contact_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/shares.hpp"
#include "geometry/node_view.hpp"

namespace fabricsh::mechanics {

BodyTies::BodyTies(const ContactSurfaces& surfaces, const Cloth& cloth) {
  const BodyState& state = surfaces.bodies().state();
  for (const Bodies::TiedNode& tied : surfaces.bodies().tied()) {
    const auto body = std::find_if(state.bodies.begin(), state.bodies.end(),
                                   [&](const auto& b) { return tied.point < b.first + b.count; });
    Tie tie{static_cast<std::size_t>(tied.node), surfaces.nodes() + tied.point,
            cloth.mass()[static_cast<std::size_t>(tied.node)] / (surfaces.step() * surfaces.step())};
    const auto* rod = std::get_if<model::Cylinder>(&body->given->shape());
    if (body->free < 0 && (rod != nullptr || std::holds_alternative<model::Sphere>(body->given->shape()))) {
      tie.body = &*body;
      tie.from = tie.to = surfaces.nodes() + body->first;
      if (rod != nullptr) {
        const Vec3 axis = rod->to - rod->from, arm = state.reference[tied.point] - rod->from;
        tie.share = std::clamp(arm.dot(axis) / axis.squaredNorm(), 0.0, 1.0);
        ++tie.to;
      }
    }
    ties_.push_back(tie);
  }
}

double BodyTies::add_forces(std::span<const Vec3> x, std::span<Vec3> force) const {
  double energy = 0;
  for (const Tie& tie : ties_) {
    const Vec3 apart = x[tie.point] - x[tie.node], pull = stiffness(tie) * apart;
    force[tie.node] += pull;
    force[tie.point] -= pull;
    energy += pull.dot(apart) / 2;
  }
  return energy;
}

double BodyTies::work_of_pressure(std::span<const Vec3> start, std::span<const Vec3> x,
                                  std::span<const Vec3> force, const contact::Contact& pairs) const {
  const BodyState::Body* marked_for = nullptr;
  std::vector<char> pressed;
  const auto way = [&](std::size_t point) -> Vec3 { return x[point] - start[point]; };
  double work = 0;
  for (const Tie& tie : ties_) {
    if (tie.body == nullptr || tie.body->turned.isZero(0)) continue;
    if (std::exchange(marked_for, tie.body) != tie.body) {
      pressed.assign(x.size(), 0);
      pairs.mark_pressed(static_cast<std::int32_t>(tie.from), static_cast<std::int32_t>(tie.to) + 1, false,
                         pressed);
    }
    if (pressed[tie.node] != 0) continue;
    const Vec3 pressure = force[tie.node] - stiffness(tie) * (x[tie.point] - x[tie.node]),
               axis = (1 - tie.share) * way(tie.from) + tie.share * way(tie.to), arc = way(tie.point) - axis;
    const double angle = tie.body->turned.norm();
    work += pressure.dot(arc - Eigen::AngleAxisd(angle, tie.body->turned / angle) * arc) / 2;
  }
  return work;
}

ContactState::ContactState(ContactSurfaces& surfaces, const Configuration& configuration, const Cloth& cloth)
    : surfaces(surfaces),
      configuration(configuration),
      pairs(surfaces.scene()),
      ties(surfaces, cloth),
      x(surfaces.scene().reference()),
      start(x),
      force(x.size(), Vec3::Zero()),
      torque(force),
      turning(force) {}

void ContactState::positions(std::span<const double> of_nodes, double share, std::vector<Vec3>& out) const {
  const std::size_t nodes = surfaces.nodes();
  for_each_index(nodes, nodes >= many_nodes,
                 [&](std::size_t n) { out[n] = at(of_nodes, static_cast<Index>(n)); });
  const auto &from = surfaces.bodies().state().committed, &to = surfaces.bodies().state().target;
  for (std::size_t v = 0; v < from.size(); ++v)
    out[nodes + v] = share >= 1 ? to[v] : share <= 0 ? from[v] : Vec3(from[v] + share * (to[v] - from[v]));
}

void ContactState::place(const Trial& trial) {
  positions(trial.configuration.x(), share, x);
  positions(configuration.committed_kinematics(), 0, start);
}

contact::Way ContactState::turn_bodies() {
  if (!surfaces.rubs()) return {};
  const Bodies& bodies = surfaces.bodies();
  const double part = std::clamp(share, 0.0, 1.0);
  for (std::size_t b = 0; b < bodies.count(); ++b) {
    const auto [first, last] = bodies.vertices(b);
    std::fill(turning.begin() + static_cast<std::ptrdiff_t>(surfaces.nodes() + first),
              turning.begin() + static_cast<std::ptrdiff_t>(surfaces.nodes() + last),
              part * bodies.state().bodies[b].turned);
  }
  return {start, turning};
}

contact::Totals ContactState::add_forces(const contact::Way& way) {
  if (surfaces.any()) return pairs.add_forces(x, force, way, torque);
  contact::Totals none;
  none.gap = std::numeric_limits<double>::infinity();
  return none;
}

void ContactState::begin() {
  if (!overlaps.empty()) return;  // from where no run begins
  positions(configuration.x(), 0, x);
  std::fill(force.begin(), force.end(), Vec3::Zero());
  committed = add_forces({});
  committed_tied = trial_tied = ties.add_forces(x, force);
  surfaces.bodies().begin(std::span(force).subspan(surfaces.nodes()));
}

// --- overlaps that settle

void SettlingOverlaps::open_to(double time) {
  if (!(state_.surfaces.opened_at() > 0)) return;
  const auto& meetings = state_.surfaces.meetings();
  shares_.assign(meetings.size(), 1);
  for (std::size_t i = 0; i < meetings.size(); ++i)
    if (const auto& settle = meetings[i].settle; settle && time < *settle) {
      const double s = std::max(time, 0.0) / *settle;
      shares_[i] = s * s * (3 - 2 * s);
    }
  state_.pairs.open_to(shares_);
}

double SettlingOverlaps::energy(std::span<const Vec3> x, double time) {
  open_to(time);
  const contact::Totals totals = state_.pairs.add_forces(x, state_.force);
  return totals.contact + totals.guard;
}

// The work of opening in a time dt, J, from its rate at `time`, with all positions fixed.
double SettlingOverlaps::pace(std::span<const Vec3> x, double time, double dt) {
  constexpr double small = 1e-3;
  const double more = energy(x, time + small * dt), less = energy(x, time - small * dt);
  return (more - less) / (2 * small);
}

bool SettlingOverlaps::opens() const { return state_.configuration.time() < state_.surfaces.opened_at(); }

bool SettlingOverlaps::find_work() {
  work_ = {};
  const double from = state_.configuration.time(), dt = state_.dt();
  if (!opens() || !(dt > 0)) return true;
  const double first = pace(state_.start, from, dt), last = pace(state_.x, state_.time, dt);
  work_ = {(first + last) / 2, std::abs(last - first) / 2};
  open_to(state_.time);
  return std::isfinite(work_.work);
}

}  // namespace fabricsh::mechanics
