#include "solver/arc_length.hpp"

#include <algorithm>
#include <cmath>

namespace fabricsh::solver {

namespace {

bool all_finite(std::span<const double> v) {
  return std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

ArcLength::ArcLength(std::unique_ptr<LinearSolver> linear, SparseMatrix pattern)
    : linear_(std::move(linear)), K_(std::move(pattern)) {
  for (auto* v : {&r_, &q_, &delta_r_, &delta_t_, &delta_, &increment_}) v->assign(K_.size, 0.0);
}

// delta_r = K^-1 r, delta_t = K^-1 q.
bool ArcLength::factorise() {
  if (K_.size == 0) return true;
  if (!analysed_) analysed_ = linear_->analyse(K_);
  return analysed_ && linear_->factorise(K_) && linear_->solve(K_, r_, delta_r_) &&
         linear_->solve(K_, q_, delta_t_) && all_finite(delta_r_) && all_finite(delta_t_);
}

// Along delta_t for the length, on the side of the last step; never more than the largest time step.
ArcLength::Step ArcLength::predictor(const PathProblem& problem, const ArcOptions& arc, ArcResult& result) {
  const double speed = std::sqrt(problem.product(delta_t_, delta_t_));
  result.length = arc.length;
  double dt = speed > 0 && arc.length > 0 ? arc.length / speed : arc.largest_step;
  dt = std::min(dt, arc.largest_step);
  const bool back = !direction_.empty() && problem.product(direction_, delta_t_) < 0;
  if (!back) dt = std::min(dt, arc.landing - arc.time);
  result.length = dt * speed;
  return {back ? -dt : dt, dt > 0};
}

ArcLength::Step ArcLength::correction(const PathProblem& problem, const ArcOptions& arc,
                                      const ArcResult& result) const {
  if (result.landed) return {arc.landing - result.time, true};
  const double along = problem.product(increment_, delta_t_);
  const double excess = problem.product(increment_, increment_) - result.length * result.length;
  const double dt = -(excess / 2 + problem.product(increment_, delta_r_)) / along;
  return {dt, std::isfinite(dt)};
}

// delta = delta_r + time delta_t, taken. False: the law failed.
bool ArcLength::move(PathProblem& problem, double along, double time) {
  for (std::size_t i = 0; i < delta_.size(); ++i) {
    delta_[i] = delta_r_[i] + along * delta_t_[i];
    increment_[i] += delta_[i];
  }
  problem.aim(time);
  problem.retract(delta_, 1);
  if (!problem.residual(r_) || !all_finite(r_)) return false;
  problem.accept();
  return true;
}

// Is the solution on the path, and not round the back of the sphere or on another branch far off?
bool ArcLength::followed(const PathProblem& problem) const {
  const double predicted = problem.product(predicted_, predicted_);
  return problem.product(predicted_, increment_) >= 0 &&
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
  std::fill(increment_.begin(), increment_.end(), 0.0);
  problem.aim(arc.time);
  if (!problem.start(K_, r_, q_)) return stop(NewtonStatus::law_failed);
  for (int i = 0; i < options.max_iterations; ++i) {
    if (!factorise()) return stop(NewtonStatus::singular);
    ++result.iterations;
    result.negative_pivots = linear_->report().negative_pivots;
    Step step = i == 0 ? predictor(problem, arc, result) : correction(problem, arc, result);
    if (!step.possible) return stop(NewtonStatus::diverged);
    // Histories may have a kink at the landing: no iterate looks beyond, and no sliver is left.
    const double left = 1e-6 * (arc.landing - arc.time);
    if (result.landed || result.time + step.time >= arc.landing - left) {
      result.landed = true;
      step.time = arc.landing - result.time;
    }
    result.time = result.landed ? arc.landing : result.time + step.time;
    if (!(result.time > 0)) return stop(NewtonStatus::turned_back);
    if (!move(problem, step.time, result.time)) return stop(NewtonStatus::law_failed);
    if (i == 0) predicted_ = increment_;
    const auto [size, where] = problem.largest(r_);
    const double relative = size == 0 ? 0 : size / problem.force_scale();
    result.residuals.push_back(relative);
    result.worst = where;
    const bool balanced = relative <= options.tolerance || size <= problem.rounding_floor(K_);
    if (balanced) return stop(followed(problem) ? NewtonStatus::converged : NewtonStatus::diverged);
    if (!(relative < 1e12)) return stop(NewtonStatus::diverged);
    if (!problem.tangent_and_rate(K_, q_)) return stop(NewtonStatus::law_failed);
  }
  return stop(NewtonStatus::too_many_iterations);
}

}  // namespace fabricsh::solver
