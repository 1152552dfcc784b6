// Why a step failed: where, which yarn, the course of the iterations, and what to try.
#pragma once
#include <string>
#include <vector>

#include "law/law.hpp"
#include "mechanics/assembly.hpp"
#include "model/model.hpp"
#include "run/foresight.hpp"
#include "solver/newton.hpp"

namespace fabricsh::run {

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
  mesh::Index turned = -1;    // a node whose director is turned over, at sound elements
  std::string reason;         // why a term could not compute its forces; empty: no failure, or that of a law
};

// Compares the failed iterate with the committed state, which is then restored. Among the elements at the
// node with the largest residual the first one that switches is named.
ResidualSite find_residual_site(mechanics::Assembly& assembly, const mesh::Mesh& mesh,
                                const solver::NewtonResult& last);

// "; the residual 0.1 (tolerance 1e-10) sits at node 3, element 2, where the warp is switching"
std::string describe(const ResidualSite& site, const solver::NewtonResult& last, double tolerance);
// The reason for the end of the attempt: the term's, or else the solver's.
std::string cause(const ResidualSite& site, const solver::NewtonResult& last);

// One failed attempt at a step.
struct Try {
  double step = 0;  // s
  solver::NewtonStatus status = solver::NewtonStatus::diverged;
  std::vector<double> residuals;
  std::string reason = {};  // why a term could not compute its forces; empty: it could
};

// A step that failed, with all its attempts.
struct Failure {
  double time = 0;  // s, the last committed time
  std::vector<Try> tries;
  ResidualSite site;
  std::int64_t negative_pivots = 0;  // of the last tangent
  double moved = 0,
         size = 0;  // m: largest motion of a support in the first attempt; smallest element
  card::Tested tested;
  Mechanism mechanism;  // of a static run
  bool broken = false;  // no step is possible, however short
  bool dynamic = false, arc = false, stabilised = false, turned_back = false;
  bool jumps = false;    // a static run whose loads or motions are there in full at time 0, in its first step
  Jumps jump = {};       // those loads and motions; none: of a term that a program has added
  bool bends = false;    // cloth with bending of its own, which relaxation takes along the overdamped path
  bool relaxed = false;  // relaxation has been tried
};

// The report of a failed step, for every run that iterates. time: s, the last committed one.
Failure failure_of(const model::Model& model, const mechanics::Assembly& assembly, double time,
                   std::vector<Try> tries, const ResidualSite& site, const solver::NewtonResult& last);

// What is at full value at time 0, if anything: "loads", "motion" or "loads and motions".
std::string jumping(const Failure& failure);

// "no step beyond time 0.1 s: too many iterations in a step of 0.01 s"; or, if the forces cannot be computed
// with any step, "stopped at time ...".
std::string headline(const Failure& failure, const solver::NewtonResult& last, double step);

// The message of the error: the headline, the last step tried with the largest one allowed, where the
// residual sits, and the best advice.
std::string message(const Failure& failure, const solver::NewtonResult& last, double step, double largest,
                    int cuts, double tolerance);

// m, the largest change of a driven displacement between two times.
double farthest_move(const mechanics::Assembly& assembly, double from, double to);

// What to try, the most promising first, each with its evidence: "stabilise=true (3 negative pivots)".
std::vector<std::string> advice(const Failure& failure);
// The whole report, in lines.
std::string report(const Failure& failure);

}  // namespace fabricsh::run
