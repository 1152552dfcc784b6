// Explicit steps through the guard of contact with bodies whose motion is given.
//
// Central differences are stable where dt^2 K <= 4 M. The guard's stiffness S, which rises without bound, is
// met by inertia along its normal: M + dt^2 S / 2 takes the place of M in M a = r, with the S of the same
// positions as r. That is a linearly implicit step of the guard alone. Where r is zero, nothing changes: what
// is pressed between tools has the balance that it has in short steps. The rest of r, which the inertia holds
// back, does a work that comes back as the nodes leave the guard; the account of the guard has it.
#include <unordered_map>
#include <utility>

#include "mechanics/terms/contact.hpp"

namespace fabricsh::mechanics {

namespace {
constexpr double kEased = 0.5;  // dt^2 S over the inertia that meets it
}

// The inertia acts on single nodes: none may follow others. A body that forces or its mass move would have a
// share of the inertia, too.
void Contacts::ease_guards() {
  if (dofs_.has_ties() || joints_.any() || !dofs_.stitches().empty()) return;
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    const int body = scene_.interactions()[i].second - static_cast<int>(sheets_.size());
    if (meetings_[i].bodies || body < 0 || bodies_.inverse_mass_pressed(static_cast<std::size_t>(body)) > 0)
      continue;
    scene_.ease(i);
  }
}

// Takes from the residual of the unknowns (N) what the inertia of the guards holds back.
void Contacts::hold_back(std::span<double> residual) {
  held_.clear();
  const double dt = trial_time_ - configuration_.time();
  if (!(trial_.guard > 0) || !(dt > 0)) return;
  std::vector<std::pair<Index, Mat3>> inertia;    // by node, in the order of the pairs
  std::unordered_map<Index, std::size_t> places;  // in it
  contact_->barriers([&](std::int32_t node, double stiffness, const Vec3& n) {
    const auto [place, added] = places.try_emplace(node, inertia.size());
    if (added) inertia.push_back({node, Mat3::Zero()});
    inertia[place->second].second += kEased * dt * dt * stiffness * n * n.transpose();
  });
  for (const auto& [node, added] : inertia) {
    const NodeFreedoms& freedoms = freedoms_.nodes[static_cast<std::size_t>(node)];
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
double Contacts::held_work() const {
  double work = 0;
  for (const auto* all : {&held_, &held_before_})
    for (const HeldBack& held : *all)
      work += held.force.dot(x_[static_cast<std::size_t>(held.node)] -
                             start_[static_cast<std::size_t>(held.node)]) /
              2;
  return work;
}

void Contacts::HeldBack::keep(Archive& archive) { archive(node, force[0], force[1], force[2]); }

}  // namespace fabricsh::mechanics
