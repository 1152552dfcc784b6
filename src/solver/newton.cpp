#include "solver/newton.hpp"

#include <cmath>
#include <numeric>

namespace fabricsh::solver {

namespace {

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

bool all_finite(std::span<const double> v) {
  for (const double x : v)
    if (!std::isfinite(x)) return false;
  return true;
}

}  // namespace

const char* describe(NewtonStatus status) {
  switch (status) {
    case NewtonStatus::converged:
      return "converged";
    case NewtonStatus::law_failed:
      return "the fabric law failed (strain not finite)";
    case NewtonStatus::singular:
      return "the tangent is singular (a part can move freely, or has buckled)";
    case NewtonStatus::diverged:
      return "the residual grew without bound";
    case NewtonStatus::turned_back:
      return "the path turned back to time 0";
    default:
      return "too many iterations";
  }
}

Newton::Newton(std::unique_ptr<LinearSolver> linear, SparseMatrix pattern)
    : linear_(std::move(linear)), K_(std::move(pattern)), r_(K_.size), delta_(K_.size), trial_r_(K_.size) {}

bool Newton::direction(std::span<const double> r) {
  if (K_.size == 0) return true;
  if (!analysed_) analysed_ = linear_->analyse(K_);
  return analysed_ && linear_->factorise(K_) && linear_->solve(K_, r, delta_) && all_finite(delta_);
}

// Steps along delta until |g(a)| <= |g(0)| / 2 with g(a) = delta . r(d + a delta) (regula falsi on a
// bracketed zero, else halving). Leaves r_ at the trial configuration. False: the law failed even on a short
// step.
bool Newton::search(Problem& problem, bool line_search) {
  const double g0 = dot(delta_, r_);
  double low = 0, g_low = g0, a = 1;
  for (int attempt = 0; attempt < 10; ++attempt) {
    problem.retract(delta_, a);
    if (!problem.residual(trial_r_) || !all_finite(trial_r_)) {
      a = low + (a - low) / 4;
      continue;
    }
    const double g = dot(delta_, trial_r_);
    r_.swap(trial_r_);
    if (!line_search || std::abs(g) <= std::abs(g0) / 2 || attempt == 9) return true;
    const bool crossed = (g > 0) != (g_low > 0);
    if (!crossed) return true;  // still descending at the full step: Newton goes on from there
    const double next = low + (a - low) * g_low / (g_low - g);
    a = std::max(next, 0.1 * a);
  }
  return false;
}

namespace {
NewtonResult failed(NewtonStatus status) {
  NewtonResult result;
  result.status = status;
  return result;
}
}  // namespace

NewtonResult Newton::solve(Problem& problem, const NewtonOptions& options) {
  if (!problem.predict(K_, r_) || !all_finite(r_)) return failed(NewtonStatus::law_failed);
  return iterate(problem, options, true);
}

NewtonResult Newton::correct(Problem& problem, const NewtonOptions& options) {
  problem.accept();
  if (!problem.tangent(K_) || !problem.residual(r_) || !all_finite(r_))
    return failed(NewtonStatus::law_failed);
  return iterate(problem, options, false);
}

// predicted: the residual in hand carries the supports' move linearised, so the first step is taken whole
// where it can be.
NewtonResult Newton::iterate(Problem& problem, const NewtonOptions& options, bool predicted) {
  NewtonResult result;
  const auto stop = [&](NewtonStatus status) {
    result.status = status;
    return result;
  };
  for (int i = 0; i < options.max_iterations; ++i) {
    if (!direction(r_)) return stop(NewtonStatus::singular);
    ++result.iterations;
    result.negative_pivots = linear_->report().negative_pivots;
    if (!search(problem, options.line_search && !(predicted && i == 0)))
      return stop(NewtonStatus::law_failed);
    problem.accept();
    const auto [size, where] = problem.largest(r_);
    if (!std::isfinite(size)) return stop(NewtonStatus::diverged);
    const double relative = size == 0 ? 0 : size / problem.force_scale();
    result.residuals.push_back(relative);
    result.worst = where;
    if (relative <= options.tolerance || size <= problem.rounding_floor(K_))
      return stop(NewtonStatus::converged);
    if (!(relative < 1e12)) return stop(NewtonStatus::diverged);
    if (!problem.tangent(K_)) return stop(NewtonStatus::law_failed);
  }
  return stop(NewtonStatus::too_many_iterations);
}

}  // namespace fabricsh::solver
