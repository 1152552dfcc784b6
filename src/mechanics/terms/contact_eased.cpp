// Explicit steps through the barrier of contact with bodies whose motion is given.
//
// Central differences are stable where dt^2 K <= 4 M. The barrier's stiffness S, which rises without bound,
// is met by inertia along its normal: M + dt^2 S / 2 takes the place of M in M a = r, with the S of the same
// positions as r. That is a linearly implicit step of the barrier alone. Where r is zero, nothing changes:
// what is pressed between tools has the balance that it has in short steps. The rest of r, which the inertia
// holds back, does a work that comes back as the nodes leave the barrier; the account of the barrier has it.
#include <unordered_map>
#include <utility>

#include "mechanics/terms/contact_schemes.hpp"

namespace fabricsh::mechanics {

namespace {
constexpr double kEased = 0.5;  // dt^2 S over the inertia that meets it
}

// The inertia acts on single nodes: none may follow others. A body that forces or its mass move would have a
// share of the inertia, too.
void BarrierInertia::allow() {
  ContactSurfaces& surfaces = state_.surfaces;
  if (dofs_.has_ties() || dofs_.joints().any() || !dofs_.stitches().empty()) return;
  for (std::size_t i = 0; i < surfaces.meetings().size(); ++i) {
    const int body = surfaces.body_of(surfaces.scene().interactions()[i].second);
    if (surfaces.meetings()[i].bodies || body < 0 ||
        surfaces.bodies().inverse_mass_pressed(static_cast<std::size_t>(body)) > 0)
      continue;
    surfaces.scene().ease(i);
  }
}

void BarrierInertia::hold_back(std::span<double> residual) {
  held_.clear();
  const double dt = state_.dt();
  if (!(state_.trial.guard > 0) || !(dt > 0)) return;
  std::vector<std::pair<Index, Mat3>> inertia;    // by node, in the order of the pairs
  std::unordered_map<Index, std::size_t> places;  // in it
  state_.pairs.barriers([&](std::int32_t node, double stiffness, const Vec3& n) {
    const auto [place, added] = places.try_emplace(node, inertia.size());
    if (added) inertia.push_back({node, Mat3::Zero()});
    inertia[place->second].second += kEased * dt * dt * stiffness * n * n.transpose();
  });
  for (const auto& [node, added] : inertia) {
    const NodeFreedoms& freedoms = dofs_.freedoms().nodes[static_cast<std::size_t>(node)];
    Mat3 in_frame = freedoms.frame * added * freedoms.frame.transpose();
    Vec3 force = Vec3::Zero();
    for (int c = 0; c < 3; ++c) {
      if (freedoms.equation[static_cast<std::size_t>(c)] >= 0) {
        force[c] = residual[static_cast<std::size_t>(freedoms.equation[static_cast<std::size_t>(c)])];
        continue;
      }
      in_frame.row(c).setZero();
      in_frame.col(c).setZero();
    }
    const double mass = cloth_.mass()[static_cast<std::size_t>(node)];
    const Mat3 whole = mass * Mat3::Identity() + in_frame;
    const Vec3 moving = mass * whole.llt().solve(force), rest = force - moving;
    for (int c = 0; c < 3; ++c)
      if (const Index e = freedoms.equation[static_cast<std::size_t>(c)]; e >= 0)
        residual[static_cast<std::size_t>(e)] = moving[c];
    held_.push_back({node, freedoms.frame.transpose() * rest});
  }
}

// J, in the trial step, by the trapezoidal rule as that of the kinetic energy.
double BarrierInertia::work() const {
  double work = 0;
  for (const auto* all : {&held_, &before_})
    for (const HeldBack& held : *all) {
      const auto n = static_cast<std::size_t>(held.node);
      work += held.force.dot(state_.x[n] - state_.start[n]) / 2;
    }
  return work;
}

void BarrierInertia::commit() {
  energy_ += work();
  std::swap(before_, held_);
  held_.clear();
}

}  // namespace fabricsh::mechanics
