// What can be said of a run before or while it goes wrong, in words: loads that jump, bending that no cloth
// has, strain beyond what was tested, supports that leave a mechanism.
#pragma once
#include <string>
#include <vector>

#include "mechanics/assembly.hpp"
#include "model/model.hpp"
#include "run/values.hpp"

namespace fabricsh::run {

// "the warp of element 12 is strained to E11 = 0.31, the card was tested to 0.26"
std::string beyond_text(const Beyond& beyond);

// Empty, or the loads that are there at once at time 0, each with how to ramp it over the run.
std::string jump_warning(const model::Model& model, double duration);

// Empty, or how far the bending rigidity that the model's cards imply is from that of cloth. Only where some
// node may leave the surface: a flat sheet that is held in its plane does not bend.
std::string bending_warning(const model::Model& model, const mechanics::Assembly& assembly);

// The ways in which the sheet can move as a rigid body, as its supports and springs let it.
struct Mechanism {
  std::string words;    // "turn about the line through (0, 0.1, 0) m along (1, 0, 0)"; empty: there is none
  int ways = 0;         // in how many
  bool driven = false;  // do the loads of a time do work on it
  // A small support against it: N/m along a global axis, 0 x to 2 z, in all; it yields by half the sheet's
  // size under all of the load.
  double stiffness = 0;
  int axis = 2;
};
// times: whose loads are looked at.
Mechanism find_mechanism(const model::Model& model, const mechanics::Assembly& assembly,
                         const std::vector<double>& times);

}  // namespace fabricsh::run
