#include "solver/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fabricsh::solver {

namespace {
constexpr int kRefresh = 200;  // iterations after which the masses are renewed even without a peak
constexpr double kGrown = 2;   // growth of the residual since the last renewal that causes another one
}  // namespace

void Relaxation::resize(Index size) {
  for (auto* v : {&r_, &mass_, &velocity_}) v->resize(static_cast<std::size_t>(size));
}

// With a time step of 1 the motion is stable below omega_max = 2; Gershgorin: omega^2 <=
// max_i sum_j |K_ij| / m_i. A margin of a tenth allows for stiffening between two renewals.
Answer Relaxation::masses(Problem& problem, double least) {
  if (const Answer answer = problem.tangent(K_); answer != Answer::ok) return answer;
  linear::absolute_sums(K_, mass_);
  const double most = mass_.empty() ? 0 : *std::max_element(mass_.begin(), mass_.end());
  for (double& m : mass_) m = 1.1 * std::max(m, least * most) / 4;
  return !mass_.empty() && mass_.front() > 0 ? Answer::ok : Answer::cut;
}

NewtonResult Relaxation::solve(Problem& problem, const RelaxationOptions& options) {
  resize(problem.size());
  std::fill(velocity_.begin(), velocity_.end(), 0.0);
  if (const Answer answer = problem.predict(K_, r_, mass_); answer != Answer::ok) {
    NewtonResult result;
    result.status = status_of(answer);
    return result;
  }
  problem.apply_increment(velocity_, 0);
  return go_on(problem, options);
}

NewtonResult Relaxation::go_on(Problem& problem, const RelaxationOptions& options) {
  NewtonResult result;
  const auto stop = [&](NewtonStatus status) {
    result.status = status;
    return result;
  };
  resize(problem.size());
  std::fill(velocity_.begin(), velocity_.end(), 0.0);
  problem.accept();
  if (problem.size() > 0)
    if (const Answer answer = masses(problem, options.least_mass); answer != Answer::ok)
      return stop(status_of(answer));
  // Without loads the residual is rounding alone. Taken where the step begins: a sheet that flies apart later
  // would raise it without bound.
  const double rounding = problem.size() > 0 ? problem.rounding_floor(K_) : 0;
  double before = 0, renewed = std::numeric_limits<double>::infinity();  // residual when the masses were
  bool starts = true;  // from rest, the first step of the leapfrog scheme is half a step
  for (int since = 0; result.iterations < options.max_iterations; ++result.iterations, ++since) {
    if (const Answer answer = problem.residual(r_); answer != Answer::ok) return stop(status_of(answer));
    const auto [size, where] = problem.largest(r_);
    const double relative = size == 0 ? 0 : size / problem.force_scale();
    result.worst = where;
    if (!std::isfinite(size) || !(relative < 1e12)) return stop(NewtonStatus::diverged);
    if (problem.at_target() && (relative <= options.tolerance || size <= rounding)) {
      result.residuals.push_back(relative);
      return stop(NewtonStatus::converged);
    }
    double energy = 0;
    for (std::size_t i = 0; i < r_.size(); ++i) {
      velocity_[i] += (starts ? 0.5 : 1.0) * r_[i] / mass_[i];
      energy += mass_[i] * velocity_[i] * velocity_[i];
    }
    // After a peak, or when the cloth has stiffened so much that the masses are too small for stability.
    const bool stiffer = size > kGrown * renewed;
    starts = energy < before || stiffer;
    if (starts) {
      std::fill(velocity_.begin(), velocity_.end(), 0.0);
      result.residuals.push_back(relative);
      energy = 0;
    }
    before = energy;
    if (starts || since >= kRefresh) {
      since = 0;
      renewed = size;
      if (const Answer answer = masses(problem, options.least_mass); answer != Answer::ok)
        return stop(status_of(answer));
    }
    if (starts) continue;
    const double fraction = problem.limit(velocity_);
    if (!(fraction > 0)) return stop(NewtonStatus::law_failed);
    problem.apply_increment(velocity_, fraction);
    problem.accept();
    if (fraction < 1) {  // as far as is safe, then from rest: to continue would meet the same limit
      std::fill(velocity_.begin(), velocity_.end(), 0.0);
      before = 0;
      starts = true;
    }
  }
  return stop(NewtonStatus::too_many_iterations);
}

}  // namespace fabricsh::solver
