// Warnings in words, before or during a run: loads that begin with a jump, unrealistic bending, strain beyond
// the tested range, supports that leave a mechanism.
#pragma once
#include <string>
#include <vector>

#include "mechanics/assembly.hpp"
#include "model/model.hpp"
#include "run/values.hpp"

namespace fabricsh::run {

// "the warp of element 12 is strained to E11 = 0.31, the card was tested to 0.26"
std::string beyond_text(const Beyond& beyond);

// A load or a motion of a support that is at full value at time 0, or directly after it.
struct Jump {
  std::string words;  // "gravity (z = -9.81 m/s^2)"
  double value = 0;
};
struct Jumps {
  std::vector<Jump> loads, motions;
  bool any() const { return !loads.empty() || !motions.empty(); }
};
Jumps find_jumps(const model::Model& model, double duration);
// The rigid bodies that their motion has moved at time 0 already; or empty.
std::string moved_bodies_text(const model::Model& model);
// The loads among them, and how to ramp each over the run; or empty.
std::string warning_text(const Jumps& jumps, double duration);
// All of them, "gravity (z = -9.81 m/s^2) and the motion of 'top' (z = 0.01 m) are".
std::string full_text(const Jumps& jumps);

// One line for each component of a force or traction that supports take up, because they fix or move its
// nodes along it: at more than half of the nodes of edges and points, as at the end of an edge that is usual;
// at all nodes of a set with whole elements, whose rim is often held.
// Loads that are zero throughout are not named. duration: of the run, s.
std::vector<std::string> idle_loads(const model::Model& model, const mechanics::Assembly& assembly,
                                    double duration);

// How far the bending rigidity of the model's cards is from that of cloth; or empty. Given only if some node
// can leave the surface, because a flat sheet held in its plane does not bend.
std::string bending_warning(const model::Model& model, const mechanics::Assembly& assembly);

// The rigid motions of the sheet that its supports and springs permit.
struct Mechanism {
  std::string words;    // "turn about the line through (0, 0.1, 0) m along (1, 0, 0)"; empty: none
  int ways = 0;         // number of independent motions
  bool driven = false;  // whether the loads at any of the times do work on it
  // A small support against the mechanism: N/m along a global axis (0 x to 2 z), in total. Under the full
  // load it yields by half the size of the sheet.
  double stiffness = 0;
  int axis = 2;
};
// times: the times whose loads are considered.
Mechanism find_mechanism(const model::Model& model, const mechanics::Assembly& assembly,
                         const std::vector<double>& times);

}  // namespace fabricsh::run
