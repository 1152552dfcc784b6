#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/advance.hpp"
#include "geometry/box.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/contact_schemes.hpp"

namespace fabricsh::mechanics {

namespace {
constexpr double kFar = 5;  // mean edges, the farthest that one of Newton's steps goes
}

ContactPassing::ContactPassing(ContactState& state, const Freedoms& freedoms) : state_(state) {
  const Bodies& bodies = state.surfaces.bodies();
  const std::size_t nodes = state.surfaces.nodes();
  driven_.assign(state.x.size(), 0);
  bool moves = bodies.any_driven(), any = false;
  for (std::size_t n = 0; n < nodes; ++n) {
    const auto& eq = freedoms.nodes[n].equation;
    driven_[n] = std::all_of(eq.begin(), eq.begin() + 3, is_prescribed) ? 1 : 0;
    any = any || driven_[n] != 0;
    moves = moves ||
            (driven_[n] != 0 && std::any_of(eq.begin(), eq.begin() + 3, [](Index e) { return e < held; }));
  }
  for (std::size_t v = 0; nodes + v < driven_.size(); ++v)
    driven_[nodes + v] = bodies.state().free_of[v] < 0 ? 1 : 0;
  if (!any || !moves) driven_.clear();
}

void ContactPassing::mark(const Trial& trial) {
  marked_.resize(state_.x.size());
  by_.resize(state_.x.size());
  state_.positions(trial.configuration.x(), state_.share, marked_);
  marked_gap_ = state_.evaluated ? state_.trial.gap : 0;
}

double ContactPassing::near_share(const Trial& trial) {
  state_.positions(trial.configuration.x(), state_.share, by_);
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < by_.size(); ++i) mean += by_[i] - marked_[i];
  mean /= static_cast<double>(by_.size());
  double most = 0;
  for (std::size_t i = 0; i < by_.size(); ++i)
    most = std::max(most, (by_[i] - marked_[i] - mean).squaredNorm());
  const double far = kFar * state_.surfaces.edge();
  return far > 0 && most > far * far ? far / std::sqrt(most) : 1;
}

double ContactPassing::safe_fraction(const Trial& trial) {
  state_.positions(trial.configuration.x(), state_.share, by_);
  const bool vertex_motion_bounds_surface_motion =
      state_.pairs.vertex_motion_bounds_surface_motion(marked_, by_);
  double most = 0;
  for (std::size_t i = 0; i < by_.size(); ++i) {
    by_[i] -= marked_[i];
    most = std::max(most, by_[i].squaredNorm());
  }
  if (contact::cannot_meet(std::sqrt(most), marked_gap_) && vertex_motion_bounds_surface_motion) return 1;
  return state_.pairs.safe_fraction(marked_, by_);
}

// Newton's iterations take driven nodes and driven bodies to their ends one after the other, along ways on
// which they may miss each other. So the way of the whole step is looked at, once, when both have arrived.
bool ContactPassing::given_motions_meet() {
  const bool arrived = state_.share >= 1 || !state_.surfaces.moves();
  if (explicit_ || driven_.empty() || !arrived || !(state_.dt() > 0)) return false;
  if (met_) return *met_;
  by_.assign(state_.x.size(), Vec3::Zero());
  bool moved = false;
  for (std::size_t i = 0; i < by_.size(); ++i) {
    if (driven_[i] != 0) by_[i] = state_.x[i] - state_.start[i];
    moved = moved || !by_[i].isZero(0);
  }
  if (!moved) return false;
  met_ = state_.pairs.safe_fraction(state_.start, by_, driven_) < 1;
  return *met_;
}

double ContactPassing::latest_end(double to) const {
  const Configuration& cloth = state_.configuration;
  const double from = cloth.time();
  if (!state_.surfaces.moves() || !(to > from)) return to;
  BoundingBox box{at(cloth.x(), 0), at(cloth.x(), 0)};
  for (std::size_t n = 1; n < state_.surfaces.nodes(); ++n) {
    const Vec3 x = at(cloth.x(), static_cast<Index>(n));
    box.low = box.low.cwiseMin(x);
    box.high = box.high.cwiseMax(x);
  }
  const Bodies& bodies = state_.surfaces.bodies();
  for (std::size_t b = 0; b < bodies.count(); ++b) {
    double near = std::numeric_limits<double>::infinity();
    for (const auto& it : state_.surfaces.scene().interactions())
      if (it.first == bodies.state().bodies[b].surface || it.second == bodies.state().bodies[b].surface)
        near = std::min(near, it.law.floor());
    to = bodies.paths().latest_end(b, from, to, near, box);
  }
  return to;
}

}  // namespace fabricsh::mechanics
