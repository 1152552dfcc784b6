#include "solver/newton.hpp"

#include <cmath>

#include "solver/line_search.hpp"

namespace fabricsh::solver {

using linear::all_finite;
using linear::dot;

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
    case NewtonStatus::unstable:
      return "the equilibrium found is not stable, and no lower one was found beside it";
    case NewtonStatus::inverted:
      return "an element turned inside out, or a director turned over, on the way";
    case NewtonStatus::broken:
      return "the forces cannot be computed, whatever the step";
    default:
      return "too many iterations";
  }
}

NewtonStatus status_of(Answer answer) {
  return answer == Answer::broken ? NewtonStatus::broken : NewtonStatus::law_failed;
}

Answer checked(Answer answer, std::span<const double> r) {
  return answer == Answer::ok && !all_finite(r) ? Answer::cut : answer;
}

void Newton::resize(Index size) {
  for (auto* v : {&r_, &delta_, &trial_r_}) v->resize(static_cast<std::size_t>(size));
}

bool Newton::direction(Problem& problem) {
  const auto solve = [this](std::span<const double> b, std::span<double> x) {
    return linear_->solve(K_, b, x) && all_finite(x);
  };
  if (K_.size() > 0 && !(linear_->factorise(K_) && solve(r_, delta_))) return false;
  return problem.finish_direction(solve, delta_) && all_finite(delta_);
}

// On return r_ is the residual at the trial configuration.
Answer Newton::search(Problem& problem, bool search) {
  const auto try_fraction = [&](double a) -> TriedFraction {
    problem.apply_increment(delta_, a);
    const Answer answer = checked(problem.residual(trial_r_), trial_r_);
    if (answer != Answer::ok) return {answer};
    r_.swap(trial_r_);
    return {answer, dot(delta_, r_)};
  };
  return line_search(dot(delta_, r_), {search, true, problem.limit(delta_)}, try_fraction).answer;
}

namespace {
NewtonResult failed(Answer answer) {
  NewtonResult result;
  result.status = status_of(answer);
  return result;
}
}  // namespace

NewtonResult Newton::solve(Problem& problem, const NewtonOptions& options) {
  resize(problem.size());
  const Answer answer = checked(problem.predict(K_, r_, trial_r_), r_);
  for (std::size_t i = 0; i < r_.size(); ++i) r_[i] += trial_r_[i];
  return answer == Answer::ok ? iterate(problem, options, true) : failed(answer);
}

NewtonResult Newton::correct(Problem& problem, const NewtonOptions& options) {
  resize(problem.size());
  problem.accept();
  Answer answer = problem.tangent(K_);
  if (answer == Answer::ok) answer = checked(problem.residual(r_), r_);
  return answer == Answer::ok ? iterate(problem, options, false) : failed(answer);
}

// predicted: the residual includes the linearised motion of the
// supports, so the first step is taken in full if possible.
NewtonResult Newton::iterate(Problem& problem, const NewtonOptions& options, bool predicted) {
  NewtonResult result;
  const auto stop = [&](NewtonStatus status) {
    result.status = status;
    return result;
  };
  for (int i = 0; i < options.max_iterations; ++i) {
    if (!direction(problem)) return stop(NewtonStatus::singular);
    ++result.iterations;
    result.negative_pivots = linear_->report().negative_pivots;
    const Answer found = search(problem, options.line_search && !(predicted && i == 0));
    if (found != Answer::ok) return stop(status_of(found));
    problem.accept();
    const auto [size, where] = problem.largest(r_);
    if (!std::isfinite(size)) return stop(NewtonStatus::diverged);
    const double relative = compared(size, problem.force_scale());
    result.residuals.push_back(relative);
    result.worst = where;
    if (problem.at_target() && (relative <= options.tolerance || size <= problem.rounding_floor(K_)))
      return stop(NewtonStatus::converged);
    if (!(relative < 1e12)) return stop(NewtonStatus::diverged);
    if (const Answer answer = problem.tangent(K_); answer != Answer::ok) return stop(status_of(answer));
  }
  return stop(NewtonStatus::too_many_iterations);
}

}  // namespace fabricsh::solver
