// How far Newton's iterations and steps may go so that no surface passes through another.
#pragma once
#include <optional>
#include <vector>

#include "mechanics/facets.hpp"
#include "mechanics/terms/contact_state.hpp"

namespace fabricsh::mechanics {

class ContactPassing final : public StepLimiter {
 public:
  ContactPassing(ContactState& state, const Freedoms& freedoms);
  // Explicit steps have a check of their own, see ExplicitContact.
  void go_explicit() { explicit_ = true; }
  bool limits() const override { return !explicit_ && state_.surfaces.any(); }
  void mark(const Trial& trial) override;
  double safe_fraction(const Trial& trial) override;
  // The share during which nothing moves farther than a few elements, relative to the mean motion.
  double near_share(const Trial& trial) override;
  // Until then the straight ways of the bodies stand for their paths: they leave them by no more than the
  // smallest distance that contact allows, so that what a body passes over on its path it would also come
  // that near to on its straight way.
  double latest_end(double to) const override;
  // Whether points whose motion is given pass through each other in the step.
  bool given_motions_meet();
  void begin_step() { met_.reset(); }

 private:
  ContactState& state_;
  std::vector<Vec3> marked_, by_;
  // Whether the motion of a point is given: nodes that are held or driven, vertices of bodies that are not
  // free. Empty: nothing of that kind moves towards cloth of that kind.
  std::vector<char> driven_;
  std::optional<bool> met_;  // whether such points meet in the step; empty: not yet known
  bool explicit_ = false;
};

}  // namespace fabricsh::mechanics
