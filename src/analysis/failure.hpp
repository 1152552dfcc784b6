// Why a step could not be done: where, which yarn, how the iterations went, and what to try.
#pragma once
#include <string>
#include <vector>

#include "analysis/foresight.hpp"
#include "fabric/law.hpp"
#include "mechanics/assembly.hpp"
#include "solver/newton.hpp"

namespace fabricsh::analysis {

// What carried the residual of a failed attempt; to be looked up before the state is rolled back.
struct Blame {
  mesh::Index node = -1, element = -1;
  std::string yarn;       // "warp", "weft", "shear" where its branch changes within the step; or empty
  bool rotation = false;  // of the node's director, not a displacement
  Vec3 x = Vec3::Zero(), centre = Vec3::Zero();  // m, of the node and the element in the failed iterate
  // Of the point of the element that switches, else the one that is strained most, in the failed iterate:
  double E11 = 0, E22 = 0, E12 = 0;  // tensor
  fabric::Internal before, after;    // at the step's beginning, in the iterate
  double stiffness_ratio = 0;        // stiffest over softest direction of the in-plane tangent; 0: not known
  std::int64_t switching = 0, slack = 0,
               elements = 0;  // elements with a yarn that switches, with both slack; all
  mesh::Index inverted = -1;  // an element turned inside out
};

// Compares the failed iterate with the committed state, to which it then goes back. Of the elements about the
// node with the largest residual, the first that switches is named.
Blame find_blame(mechanics::Assembly& assembly, const mesh::Mesh& mesh, const solver::NewtonResult& last);

// "; the residual 0.1 (tolerance 1e-10) sits at node 3, element 2, where the warp is switching"
std::string describe(const Blame& blame, const solver::NewtonResult& last, double tolerance);

// One attempt at a step that failed.
struct Try {
  double step = 0;  // s
  solver::NewtonStatus status = solver::NewtonStatus::diverged;
  std::vector<double> residuals;
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
  bool dynamic = false, arc = false, stabilised = false, turned_back = false;
};

// m, the farthest that a driven displacement goes from one time to another.
double farthest_move(const mechanics::Assembly& assembly, double from, double to);

// What to try, the likeliest first, each with what was measured: "stabilise=true (3 negative pivots)".
std::vector<std::string> advice(const Failure& failure);
// All of it, in lines.
std::string report(const Failure& failure);

}  // namespace fabricsh::analysis
