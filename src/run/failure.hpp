// Why a step could not be done: where, which yarn, how the iterations went, and what to try.
#pragma once
#include <string>
#include <vector>

#include "law/law.hpp"
#include "mechanics/assembly.hpp"
#include "run/foresight.hpp"
#include "solver/newton.hpp"

namespace fabricsh::run {

// A line on what touches, for why(); empty without contact.
std::string touching_text(const mechanics::Assembly& assembly);

// What carried the residual of a failed attempt; to be looked up before the state is rolled back.
struct Blame {
  mesh::Index node = -1, element = -1;
  std::string yarn;       // "warp", "weft", "shear" where its branch changes within the step; or empty
  bool rotation = false;  // of the node's director, not a displacement
  Vec3 x = Vec3::Zero(), centre = Vec3::Zero();  // m, of the node and the element in the failed iterate
  // Of the point of the element that switches, else the one that is strained most, in the failed iterate:
  double E11 = 0, E22 = 0, E12 = 0;  // tensor
  law::Internal before, after;       // at the step's beginning, in the iterate
  double stiffness_ratio = 0;        // stiffest over softest direction of the in-plane tangent; 0: not known
  std::int64_t switching = 0, slack = 0,
               elements = 0;  // elements with a yarn that switches, with both slack; all
  mesh::Index inverted = -1;  // an element turned inside out
  std::string reason;         // what a term says that could not compute its forces; empty: none, or the law
};

// Compares the failed iterate with the committed state, to which it then goes back. Of the elements about the
// node with the largest residual, the first that switches is named.
Blame find_blame(mechanics::Assembly& assembly, const mesh::Mesh& mesh, const solver::NewtonResult& last);

// "; the residual 0.1 (tolerance 1e-10) sits at node 3, element 2, where the warp is switching"
std::string describe(const Blame& blame, const solver::NewtonResult& last, double tolerance);
// What ended the attempt: the term's reason, else the solver's.
std::string cause(const Blame& blame, const solver::NewtonResult& last);

// One attempt at a step that failed.
struct Try {
  double step = 0;  // s
  solver::NewtonStatus status = solver::NewtonStatus::diverged;
  std::vector<double> residuals;
  std::string reason = {};  // of the term that could not compute its forces; empty: none
};

// A step that could not be done, with all its attempts.
struct Failure {
  double time = 0;  // s, the last committed time
  std::vector<Try> tries;
  Blame blame;
  std::int64_t negative_pivots = 0;  // of the last tangent
  double moved = 0,
         size = 0;  // m: the farthest that a support moves in the first attempt; the smallest element
  card::Tested tested;
  Mechanism mechanism;  // of a static run
  bool broken = false;  // no step is possible, however short
  bool dynamic = false, arc = false, stabilised = false, turned_back = false;
};

// "no step beyond time 0.1 s: too many iterations in a step of 0.01 s"; where the forces are broken, whatever
// the step, "stopped at time ...".
std::string headline(const Failure& failure, const solver::NewtonResult& last, double step);

// m, the farthest that a driven displacement goes from one time to another.
double farthest_move(const mechanics::Assembly& assembly, double from, double to);

// What to try, the likeliest first, each with what was measured: "stabilise=true (3 negative pivots)".
std::vector<std::string> advice(const Failure& failure);
// All of it, in lines.
std::string report(const Failure& failure);

}  // namespace fabricsh::run
