#include "mechanics/terms/contact_schemes.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/shares.hpp"
#include "contact/advance.hpp"

namespace fabricsh::mechanics {

// --- implicit steps

void ImplicitContact::set_weight(double weight, double late) {
  state_.weight = weight;
  state_.surfaces.bodies().set_late(late);
  if (used_) return;
  used_ = true;
  state_.surfaces.bodies().go_implicit();
  state_.surfaces.soften(false);
  state_.begin();
}

contact::Way ImplicitContact::way(double dt) {
  contact::Way way = state_.turn_bodies();
  if (!way.start.empty()) way.dt = dt;
  return way;
}

// J, that the trial step takes from what presses: the energy that contact gives up less the work of its
// forces at the end of the step. A convex energy falls by at least that work, so that this is not negative
// but for what the geometry bends within a step; the latter stays an error of the ledger.
void ImplicitContact::evaluated() {
  const ContactState& s = state_;
  double work = s.trial.work;
  for (std::size_t i = 0; i < s.x.size(); ++i) work += s.force[i].dot(s.x[i] - s.start[i]);
  for (std::size_t i = s.surfaces.nodes(); i < s.x.size(); ++i) work += s.torque[i].dot(s.turning[i]);
  // The work of friction has its own account; the damping of approach belongs to this one.
  const double given = s.committed.contact + s.committed.guard + s.committed_tied - s.trial.contact -
                       s.trial.guard - s.trial_tied;
  taken_ = std::max(0.0, settling_.work().work + given - work);
}

double ImplicitContact::work_on_cloth() const {
  double work = 0;
  for (std::size_t i = 0; i < state_.surfaces.nodes(); ++i)
    if (inverse_mass_[i] > 0) work += state_.force[i].dot(state_.x[i] - state_.start[i]);
  return work;
}

// --- explicit steps

void ExplicitContact::use() {
  used_ = true;
  state_.surfaces.soften(true);
  state_.ties.go_explicit();
  barriers_.allow();
  refuse_films();
  state_.begin();
}

contact::Way ExplicitContact::way(double dt) {
  contact::Way way = state_.turn_bodies();
  if (dt > 0 && !way.start.empty())
    way = {way.start, way.turn, dt, joints_.inverse_masses(), joints_.planes()};
  return way;
}

// The largest motion of any point in the step so far.
void ExplicitContact::evaluated() {
  const auto &x = state_.x, &start = state_.start;
  moved_ = std::sqrt(largest_of(x.size(), x.size() >= many_nodes,
                                [&](std::size_t i) { return (x[i] - start[i]).squaredNorm(); }));
}

bool ExplicitContact::may_have_passed() {
  const auto &x = state_.x, &start = state_.start;
  if (state_.blocked) return true;
  if (!state_.surfaces.any()) return false;
  if (contact::cannot_meet(moved_, state_.trial.gap) &&
      state_.pairs.vertex_motion_bounds_surface_motion(start, x))
    return false;
  by_.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) by_[i] = x[i] - start[i];
  return state_.pairs.may_have_passed(start, by_, state_.trial.gap);
}

bool ExplicitContact::turns_too_far() const {
  return state_.surfaces.bodies().paths().turned_most() > (1 + 1e-6) * BodyPaths::largest_turn;
}

// A film that an explicit step does not carry would have to be thinned, and would then not be what was given.
void ExplicitContact::refuse_films() const {
  constexpr double carried = 0.1;  // of areal mass over step: facets and both faces of a ply add up to more
  const ContactSurfaces& surfaces = state_.surfaces;
  const double most = carried * surfaces.least_areal() / surfaces.step();
  for (std::size_t i = 0; i < surfaces.meetings().size(); ++i) {
    const double drag = surfaces.scene().interactions()[i].film.viscous;
    if (drag > most)
      throw Error("contact: field 'film': " + surfaces.meetings()[i].names + ": explicit steps of " +
                  number(surfaces.step()) + " s carry a viscosity over thickness of at most " + number(most) +
                  " Pa s/m, got " + number(drag) +
                  ": a run that is faster than the process by a factor needs a viscosity that is smaller by "
                  "it (or scheme=\"implicit\")");
  }
}

}  // namespace fabricsh::mechanics
