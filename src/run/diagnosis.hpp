// The diagnosis of a run, in words. Before it: loads that begin with a jump or move nothing, unrealistic
// bending, supports that leave a mechanism. During it: strain beyond the tested range. Where a step fails:
// why, where, which yarn, the course of the iterations, and what to try.
#pragma once
#include <string>
#include <vector>

#include "law/law.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/contact.hpp"
#include "model/model.hpp"
#include "run/values.hpp"
#include "solver/newton.hpp"

namespace fabricsh::run {

// --- before and during a run (foresight.cpp)

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
// Of each rigid surface of facets that the law of contact counts in places more than once: where, and why.
std::vector<std::string> crowding_texts(const mechanics::Contacts& contact);
// Two held or driven bodies that press the cloth between them from the start, and what to do.
std::string nip_text(const std::string& run, const mechanics::Nip& nip);
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

// Error: what acts on a part of a model is not symmetric about a plane that cuts it: gravity across the
// plane, which would push the part that is left out the other way; or a rigid body that the plane cuts and
// that is moved across it or turned about another axis than its normal. A sheet that lies in the plane as a
// whole is no part. duration: of the run, s.
void check_symmetric_loads(const model::Model& model, double duration);

// How far the bending rigidity of the model's cards is from that of cloth; or empty. Given only if some node
// can leave the surface, because a flat sheet held in its plane does not bend.
std::string bending_warning(const model::Model& model, const mechanics::Assembly& assembly);

// Where moduli of transverse shear that are derived from other numbers of a card make a sheet that is
// integrated through its thickness softer in bending by more than 1 %: by how much, in a strip from the
// middle of the sheet to its rim; or empty.
std::string shear_warning(const model::Model& model, const mechanics::Assembly& assembly);

// Where quadrilaterals are long across fibres that are much stiffer than all else: the radius of bending from
// which the directors splay, and the sheet loses its stability; or empty if that is sharper than the sheet is
// large.
std::string splay_warning(const model::Model& model, const mechanics::Assembly& assembly);

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

// --- a step that failed (diagnosis.cpp, diagnosis_words.cpp)

// A line about contact for why(); empty without contact.
std::string touching_text(const mechanics::Assembly& assembly);

// The cause of the residual in a failed attempt; to be determined before the state is rolled back.
struct ResidualSite {
  mesh::Index node = -1, element = -1;
  std::string yarn;       // "warp", "weft" or "shear" if its branch changes within the step; or empty
  bool rotation = false;  // of the node's director, not a displacement
  Vec3 x = Vec3::Zero(), centre = Vec3::Zero();  // m, of the node and the element in the failed iterate
  // At the switching point of the element, or else at the one with the largest strain, in the failed iterate:
  double E11 = 0, E22 = 0, E12 = 0;  // tensor
  law::Internal before, after;       // at the beginning of the step, in the iterate
  double stiffness_ratio = 0;        // largest over smallest eigenvalue of the in-plane tangent; 0: not known
  std::int64_t switching = 0, slack = 0,
               elements = 0;  // elements with a switching yarn; with both yarns slack; all
  mesh::Index inverted = -1;  // an inverted element
  // The element with the largest shear angle at the beginning of the step, and that angle in degrees: at 90
  // warp and weft lie on each other and the element has no area.
  mesh::Index sheared = -1;
  double shear_angle = 0;
  mesh::Index turned = -1;  // a node whose director is turned over, at sound elements
  std::string reason;       // why a term could not compute its forces; empty: no failure, or that of a law
};

// One failed attempt at a step.
struct Try {
  double step = 0;  // s
  solver::NewtonStatus status = solver::NewtonStatus::diverged;
  std::vector<double> residuals;
  std::string reason = {};  // why a term could not compute its forces; empty: it could
};

// The attempts at a step of a run that iterates, and what is known of the last one that failed.
struct Diagnosis {
  solver::NewtonResult last;  // of the last attempt
  std::vector<Try> tries;     // those that failed
  ResidualSite site;          // of the last one that failed
  // Completed where the run gives the step up:
  double time = 0;   // s, the last committed time
  double moved = 0;  // m, largest motion of a support in the first attempt
  double size = 0;   // m, smallest element
  card::Tested tested;
  Mechanism mechanism;  // of a static run
  bool dynamic = false, arc = false, stabilised = false;
  bool jumps = false;    // a static run whose loads or motions are there in full at time 0, in its first step
  Jumps jump = {};       // those loads and motions; none: of a term that a program has added
  double sliding = 0;    // N, friction of the pairs that slide, if these have most of it; 0: they have not
  std::string slides;    // the pair of them with the largest force, in words
  std::string nearest;   // the two surfaces that are nearest to each other, in words; empty: none are
  double aspect = 0;     // of the element with the residual: its longest side over its shortest
  bool bends = false;    // cloth with bending of its own, which relaxation takes along the overdamped path
  std::string loose;     // the rigid bodies that nothing holds, in words
  bool relaxed = false;  // relaxation has been tried
  bool both = false;     // Newton's method and relaxation have been tried in turn

  bool broken() const { return last.status == solver::NewtonStatus::broken; }  // no step is possible
  // Takes an attempt up; step: s. Returns whether it has converged. If not, the failed iterate is compared
  // with the committed state, which is then restored; among the elements at the node with the largest
  // residual the first one that switches is named.
  bool take(const solver::NewtonResult& result, double step, mechanics::Assembly& assembly,
            const mesh::Mesh& mesh);
  void complete(const model::Model& model, const mechanics::Assembly& assembly, double committed);
  // The message of the error: the reason, the last step tried with the largest one allowed, where the
  // residual sits, and the best advice.
  std::string message(double step, double largest, int cuts, double tolerance) const;
  // Remedies, the most promising first, each with its evidence: "stabilise=true (3 negative pivots)".
  std::vector<std::string> advice() const;
  std::string report() const;  // the whole of it, in lines
};

}  // namespace fabricsh::run
