// Readings of rigid bodies, in the trial state if its forces are known, otherwise in the committed state.
#pragma once
#include "mechanics/terms/body_loads.hpp"

namespace fabricsh::mechanics {

class BodyReadings {
 public:
  BodyReadings(const BodyState& state, const BodyLoads& loads) : state_(state), loads_(loads) {}
  double kinetic() const;  // J, of the free bodies
  // External work on cloth and bodies in the step: that of driven bodies, and that of gravity on free ones.
  StepWork step_work() const;
  Vec3 force(std::size_t i) const;  // N, of the cloth on body i
  Vec3 held(std::size_t i) const;   // N, with which m:fix holds body i: zero in the directions left free
  // 1/kg, an upper bound of the inverse effective mass of a vertex.
  double inverse_mass(std::size_t i) const;
  // 1/kg, the same of what pressing meets; a ball has all of its mass there.
  double inverse_mass_pressed(std::size_t i) const;
  // The planes of symmetry that cut a free body, one bit each; 0 for others.
  unsigned char planes_through(std::size_t i) const;
  // m: of its surface from its centre, a rod's or disc's radius; 0 for a plane.
  double size(std::size_t i) const;
  double fastest_free() const;  // m/s, of the centres of free bodies

 private:
  StepWork work_of_gas(const BodyState::Body& body) const;

  const BodyState& state_;
  const BodyLoads& loads_;
};

}  // namespace fabricsh::mechanics
