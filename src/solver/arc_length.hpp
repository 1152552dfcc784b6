// Path following: time, on which loads and supports depend, is an additional unknown, and a step has a
// given length along the path. The method passes limit points, where time turns back, and snap-through.
//
// Constraint: the spherical one of [crisfield1981] without time in the length, linearised and solved by
// Newton's method together with equilibrium, so that there is no choice of roots:
//   K delta_r = r,  K delta_t = q = dr/dt,  delta = delta_r + dt delta_t,
//   dt = -((|D|^2 - L^2) / 2 + D . delta_r) / (D . delta_t)      D: the step's increment so far
// and where a stretch of time ends the constraint is t = landing.
#pragma once
#include "base/archive.hpp"
#include "solver/line_search.hpp"
#include "solver/newton.hpp"

namespace fabricsh::solver {

class PathProblem : public Problem {
 public:
  virtual void set_time(double time) = 0;  // of supports and loads, for the next start() or increment
  // At the committed configuration and the time last given to set_time(): K, r and q = dr/dt.
  virtual Answer start(Matrix& K, std::span<double> r, std::span<double> q) = 0;
  virtual Answer tangent_and_rate(Matrix& K, std::span<double> q) = 0;  // at the trial configuration
  // Scalar product by which lengths are measured: displacements only, no rotations.
  virtual double product(std::span<const double> a, std::span<const double> b) const = 0;
  // By how much what is breaking opens along an increment, m; 0: nothing breaks. A path goes on to where it
  // opens, also where that is back in time, as of a body that stores more than a break takes.
  virtual double opening(std::span<const double>) const { return 0; }
};

struct ArcOptions {
  double time = 0;          // s, of the committed configuration
  double landing = 0;       // s, > time: a step that would pass this time ends there
  double length = 0;        // of the step; 0: the length of a first step of `largest_step`
  double largest_step = 0;  // s, limit of the predictor
};

struct ArcResult : NewtonResult {
  double time = 0;    // s, reached
  double length = 0;  // that was tried
  bool landed = false;
};

class ArcLength {
 public:
  explicit ArcLength(std::unique_ptr<LinearSolver> linear) : linear_(std::move(linear)) {}
  ArcResult solve(PathProblem& problem, const NewtonOptions& options, const ArcOptions& arc);
  // To be called after a commit: the next step continues in the direction of the step just
  // solved. After forget() (at a kink of a history) the next step starts forwards in time.
  void committed() { direction_ = increment_; }
  void forget() { direction_.clear(); }
  // Changes the direction when the problem has got other unknowns.
  template <class Change>
  void turn(Change change) {
    if (!direction_.empty()) change(direction_);
  }
  void keep(Archive& archive) { archive(direction_); }

 private:
  struct ArcStep {  // of the predictor or of one correction
    double time = 0;
    bool possible = true;
  };
  bool factorise();
  ArcStep predictor(const PathProblem& problem, const ArcOptions& arc, ArcResult& result);
  ArcStep correction(const PathProblem& problem, const ArcOptions& arc, const ArcResult& result) const;
  bool followed(const PathProblem& problem) const;
  Searched move(PathProblem& problem, double from, double step, bool search);

  std::unique_ptr<LinearSolver> linear_;
  Matrix K_;
  linear::Vector r_, trial_r_, q_, delta_r_, delta_t_, delta_, increment_, direction_, predicted_;
};

}  // namespace fabricsh::solver
