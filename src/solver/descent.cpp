#include "solver/descent.hpp"

#include <algorithm>
#include <cmath>

namespace fabricsh::solver {

using linear::all_finite;
using linear::dot;

namespace {
constexpr double kFirst = 1e-3, kLeast = 1e-14, kMost = 1e4;  // of the viscosity's factor m
constexpr double kRise = 8, kFall = 0.25, kBent = 2;          // after a failed, a whole and a shortened step
constexpr double kShortest = 0.02;  // fraction of a step along which the energy falls, below which m rises
constexpr double kGone = 1e3;  // growth of what rounding makes, with the coordinates, of a part that has gone
}  // namespace

// delta_ = (K + m D)^-1 r_, if that matrix is positive and r_ is reduced along it. What is at rest while a
// rigid body is on its way has nothing to reduce.
bool Descent::direction(Problem& problem, double m) {
  linear::add_diagonal(K_, m, D_, A_);
  if (!linear_->factorise(A_) || linear_->report().negative_pivots > 0) return false;
  const auto solve = [this](std::span<const double> b, std::span<double> x) {
    return linear_->solve(A_, b, x) && all_finite(x);
  };
  return solve(r_, delta_) && problem.finish_direction(solve, delta_) && all_finite(delta_) &&
         (dot(delta_, r_) > 0 || !problem.at_target());
}

// Goes along delta_ as far as is safe. The energy falls by the mean of the forces along the step, by the
// trapezoidal rule; where it would not, yarns have met their far stiffer unloading on the way, and the step
// is shortened to where a line through both forces vanishes, which costs no factorisation.
// Where no fraction above kShortest does (cut), the step is undone. A rigid body that moves does work on the
// cloth, so that the energy may rise meanwhile.
Answer Descent::lower(Problem& problem) {
  uphill_ = false;
  const bool on_its_way = !problem.at_target();
  double fraction = problem.limit(delta_);
  shortened_ = false;
  if (!(fraction > 0)) return Answer::cut;
  const double g0 = dot(delta_, r_), least = kShortest * fraction;
  for (;;) {
    problem.apply_increment(delta_, fraction);
    const Answer answer = checked(problem.residual(trial_r_), trial_r_);
    const double g = answer == Answer::ok ? dot(delta_, trial_r_) : 0;
    uphill_ = answer == Answer::ok && !on_its_way && !(g0 + g > 0);
    if (answer == Answer::ok && !uphill_) return answer;
    fraction = uphill_ ? std::max(fraction * g0 / (g0 - g), 0.1 * fraction) : 0;
    if (fraction < least) {
      problem.apply_increment(delta_, 0);
      return answer == Answer::ok ? Answer::cut : answer;
    }
    shortened_ = true;
  }
}

NewtonResult Descent::solve(Problem& problem, const RelaxationOptions& options) {
  NewtonResult result;
  const auto stop = [&](NewtonStatus status) {
    result.status = status;
    return result;
  };
  for (auto* v : {&r_, &delta_, &trial_r_}) v->assign(static_cast<std::size_t>(problem.size()), 0.0);
  if (const Answer answer = problem.predict(K_, r_, trial_r_); answer != Answer::ok)
    return stop(status_of(answer));
  problem.apply_increment(delta_, 0);  // the supports to their targets
  if (const Answer answer = checked(problem.residual(r_), r_); answer != Answer::ok)
    return stop(status_of(answer));
  problem.accept();
  double m = kFirst, at_first = 0;
  while (result.iterations < options.max_iterations) {
    if (const Answer answer = problem.tangent(K_); answer != Answer::ok) return stop(status_of(answer));
    linear::absolute_sums(K_, D_);
    const auto [size, where] = problem.largest(r_);
    const double relative = compared(size, problem.force_scale());
    result.residuals.push_back(relative);
    result.worst = where;
    const double floor = problem.rounding_floor(K_);
    if (result.residuals.size() == 1) at_first = floor;
    if (floor > kGone * at_first && relative > options.tolerance) return stop(NewtonStatus::singular);
    const bool rounding = size <= floor;
    if (problem.at_target() && (rounding || relative <= options.tolerance))
      return stop(NewtonStatus::converged);
    for (;; m *= kRise) {
      if (m > kMost) return stop(uphill_ ? NewtonStatus::too_many_iterations : NewtonStatus::law_failed);
      if (result.iterations++ >= options.max_iterations) return stop(NewtonStatus::too_many_iterations);
      const Answer answer = direction(problem, m) ? lower(problem) : Answer::cut;
      if (answer == Answer::broken) return stop(NewtonStatus::broken);
      if (answer == Answer::ok) break;
    }
    r_.swap(trial_r_);
    problem.accept();
    m = std::clamp((shortened_ ? kBent : kFall) * m, kLeast, kMost);
  }
  return stop(NewtonStatus::too_many_iterations);
}

}  // namespace fabricsh::solver
