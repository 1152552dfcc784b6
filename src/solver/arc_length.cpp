#include "solver/arc_length.hpp"

#include <algorithm>
#include <cmath>

namespace fabricsh::solver {

using linear::all_finite;
using linear::dot;

// delta_r = K^-1 r, delta_t = K^-1 q.
bool ArcLength::factorise() {
  if (K_.size() == 0) return true;
  return linear_->factorise(K_) && linear_->solve(K_, r_, delta_r_) && linear_->solve(K_, q_, delta_t_) &&
         all_finite(delta_r_) && all_finite(delta_t_);
}

// Along delta_t by the given length, in the last step's direction; limited by the largest time step.
ArcLength::ArcStep ArcLength::predictor(const PathProblem& problem, const ArcOptions& arc,
                                        ArcResult& result) {
  const double speed = std::sqrt(problem.product(delta_t_, delta_t_));
  result.length = arc.length;
  double dt = speed > 0 && arc.length > 0 ? arc.length / speed : arc.largest_step;
  dt = std::min(dt, arc.largest_step);
  const double opening = problem.opening(delta_t_);  // of what tears
  const bool back =
      !direction_.empty() && (opening != 0 ? opening : problem.product(direction_, delta_t_)) < 0;
  if (!back) dt = std::min(dt, arc.landing - arc.time);
  result.length = dt * speed;
  return {back ? -dt : dt, dt > 0};
}

ArcLength::ArcStep ArcLength::correction(const PathProblem& problem, const ArcOptions& arc,
                                         const ArcResult& result) const {
  if (result.landed) return {arc.landing - result.time, true};
  const double along = problem.product(increment_, delta_t_);
  const double excess = problem.product(increment_, increment_) - result.length * result.length;
  const double dt = -(excess / 2 + problem.product(increment_, delta_r_)) / along;
  return {dt, std::isfinite(dt)};
}

// Moves along delta = delta_r + step delta_t until |g(a)| <= |g(0)| / 2 with g(a) =
// delta_r . r(a), as in Newton's method. Since K is the tangent, g(a) = (1 - a) g(0) up
// to nonlinear terms, whatever the step in time. The predictor starts in equilibrium, so
// that there is no residual to reduce; it is taken as far as the problem's limit allows.
Searched ArcLength::move(PathProblem& problem, double from, double step, bool search) {
  for (std::size_t i = 0; i < delta_.size(); ++i) delta_[i] = delta_r_[i] + step * delta_t_[i];
  problem.set_time(from + step);  // the limit refers to the whole step
  const auto move_by = [&](double a) -> TriedFraction {
    if (a != 1) {
      problem.set_time(from + a * step);
      if (!problem.is_safe(delta_, a)) return {Answer::cut};
    }
    problem.apply_increment(delta_, a);
    const Answer answer = checked(problem.residual(trial_r_), trial_r_);
    return {answer, answer == Answer::ok ? dot(delta_r_, trial_r_) : 0};
  };
  const LineSearch how{search, search, problem.limit(delta_)};
  const Searched found = line_search(dot(delta_r_, r_), how, move_by);
  if (found.answer != Answer::ok) return found;
  r_.swap(trial_r_);
  for (std::size_t i = 0; i < delta_.size(); ++i) increment_[i] += found.fraction * delta_[i];
  problem.accept();
  return found;
}

// Whether the solution lies on the path, and not on the opposite side of the sphere or on a distant branch.
bool ArcLength::followed(const PathProblem& problem) const {
  const double predicted = problem.product(predicted_, predicted_), opening = problem.opening(increment_);
  return (opening != 0 ? opening : problem.product(predicted_, increment_)) >= 0 &&
         problem.product(increment_, increment_) <= 9 * predicted;
}

ArcResult ArcLength::solve(PathProblem& problem, const NewtonOptions& options, const ArcOptions& arc) {
  ArcResult result;
  const auto stop = [&](NewtonStatus status) {
    result.status = status;
    return result;
  };
  result.time = arc.time;
  result.length = arc.length;
  const auto unknowns = static_cast<std::size_t>(problem.size());
  for (auto* v : {&r_, &trial_r_, &q_, &delta_r_, &delta_t_, &delta_}) v->resize(unknowns);
  increment_.assign(unknowns, 0.0);
  problem.set_time(arc.time);
  if (const Answer answer = problem.start(K_, r_, q_); answer != Answer::ok) return stop(status_of(answer));
  for (int i = 0; i < options.max_iterations; ++i) {
    if (!factorise()) return stop(NewtonStatus::singular);
    ++result.iterations;
    result.negative_pivots = linear_->report().negative_pivots;
    ArcStep step = i == 0 ? predictor(problem, arc, result) : correction(problem, arc, result);
    if (!step.possible) return stop(NewtonStatus::diverged);
    // Histories may have a kink at the landing: no iterate goes beyond it, and no tiny remainder is left.
    constexpr double kRemainder = 1e-6;  // of the way to the landing: a step that small has no direction
    const double left = kRemainder * (arc.landing - arc.time);
    if (result.landed || result.time + step.time >= arc.landing - left) {
      result.landed = true;
      step.time = arc.landing - result.time;
    }
    if (!(result.time + step.time > 0)) return stop(NewtonStatus::turned_back);
    const auto [fraction, answer] = move(problem, result.time, step.time, options.line_search && i > 0);
    if (answer != Answer::ok) return stop(status_of(answer));
    result.time = result.landed && fraction == 1 ? arc.landing : result.time + fraction * step.time;
    if (i == 0) predicted_ = increment_;
    const auto [size, where] = problem.largest(r_);
    if (!std::isfinite(size)) return stop(NewtonStatus::diverged);
    const double relative = compared(size, problem.force_scale());
    result.residuals.push_back(relative);
    result.worst = where;
    const bool there = !result.landed || result.time == arc.landing;
    const bool balanced = there && (relative <= options.tolerance || size <= problem.rounding_floor(K_));
    if (balanced) return stop(followed(problem) ? NewtonStatus::converged : NewtonStatus::diverged);
    if (!(relative < 1e12)) return stop(NewtonStatus::diverged);
    if (const Answer next = problem.tangent_and_rate(K_, q_); next != Answer::ok)
      return stop(status_of(next));
  }
  return stop(NewtonStatus::too_many_iterations);
}

}  // namespace fabricsh::solver
