#include "solver/newton.hpp"

#include <algorithm>
#include <cmath>

#include "solver/line_search.hpp"

namespace fabricsh::solver {

using linear::all_finite;
using linear::dot;

namespace {
constexpr int kMostOnBranches = 20;  // iterations
// rad, the turn in one of them: of the first one up to which it is permitted, as where directors settle, and
// of all others, or as far as the first.
constexpr double kFurthestFirst = 1, kFurthest = 0.3;
constexpr double kMostInertia = 100;
// On branches: directions until yarns have found most of theirs; the share of the residual's work along one
// that may be left at its end, and after how many in turn with more it is of no use to go on.
constexpr int kSettles = 3, kSwings = 2;
constexpr double kContracts = 0.5;
constexpr int kMoreTimes = 3;   // max_iterations, while the residual falls near a solution
constexpr double kNear = 1e-3;  // a residual near a solution
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
    case NewtonStatus::unstable:
      return "the equilibrium found is not stable, and no lower one was found beside it";
    case NewtonStatus::inverted:
      return "an element turned inside out, or a director turned over, on the way";
    case NewtonStatus::blocked:
      return "nothing can move on without surfaces passing through each other";
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
  return (K_.size() == 0 || linear_->factorise(K_)) && solve_with_factors(problem, r_);
}

bool Newton::solve_with_factors(Problem& problem, std::span<const double> r) {
  const auto solve = [this](std::span<const double> b, std::span<double> x) {
    return linear_->solve(K_, b, x) && all_finite(x);
  };
  if (K_.size() > 0 && !solve(r, delta_)) return false;
  return problem.finish_direction(solve, delta_) && all_finite(delta_);
}

// On return r_ is the residual at the trial configuration.
std::optional<NewtonStatus> Newton::search(Problem& problem, bool search) {
  const double largest = problem.limit(delta_);
  if (!(largest > 0)) return NewtonStatus::blocked;
  const auto try_fraction = [&](double a) -> TriedFraction {
    if (a != largest && !problem.is_safe(delta_, a)) return {Answer::cut};
    problem.apply_increment(delta_, a);
    const Answer answer = checked(problem.residual(trial_r_), trial_r_);
    if (answer != Answer::ok) return {answer};
    r_.swap(trial_r_);
    return {answer, dot(delta_, r_)};
  };
  const Answer answer = line_search(dot(delta_, r_), {search, true, largest}, try_fraction).answer;
  return answer == Answer::ok ? std::nullopt : std::optional(status_of(answer));
}

namespace {
NewtonResult failed(Answer answer) {
  NewtonResult result;
  result.status = status_of(answer);
  return result;
}

// Whether the iterations on branches end near a solution: the residual is small, and swings, as where lines
// of branches lead to each other in turn.
bool ends_near(std::span<const double> residuals) {
  constexpr double kFalls = 0.25;
  const std::size_t n = residuals.size();
  return n >= 3 && residuals[n - 1] < kNear && residuals[n - 1] > kFalls * residuals[n - 3];
}

// To the trial configuration a fraction of delta away, whose residual is then in `trial`; r: that of the
// iterate. shortens: where the forces there push back by more than they pushed, to a shorter one, as after a
// direction that is much too long. share: the work of the residual along delta there over that here.
Answer go(Problem& problem, std::span<const double> delta, std::span<const double> r, double fraction,
          bool shortens, std::span<double> trial, double& share) {
  constexpr int kTimes = 2;
  const double before = dot(delta, r);
  for (int i = 0;; ++i) {
    problem.apply_increment(delta, fraction);
    const Answer answer = checked(problem.residual(trial), trial);
    if (answer != Answer::ok) return answer;
    const double after = dot(delta, trial);
    share = after == 0 ? 0 : after / before;
    if (!shortens || i == kTimes || !(-after > std::abs(before))) return answer;
    fraction *= std::clamp(before / (before - after), 0.1, 0.5);
    if (!problem.is_safe(delta, fraction)) return Answer::cut;
  }
}

// Yarns without load that are all at their kinks let a residual fall slowly but surely.
bool still_falls(std::span<const double> residuals) {
  constexpr std::size_t kBack = 8;
  constexpr double kFalls = 0.8;
  const std::size_t n = residuals.size();
  return n > kBack && residuals[n - 1] < kNear && residuals[n - 1] < kFalls * residuals[n - 1 - kBack];
}
}  // namespace

Answer Newton::predict(Problem& problem) {
  const Answer answer = checked(problem.predict(K_, r_, trial_r_), r_);
  for (std::size_t i = 0; i < r_.size(); ++i) r_[i] += trial_r_[i];
  return answer;
}

NewtonResult Newton::solve(Problem& problem, const NewtonOptions& options) {
  resize(problem.size());
  if (const Answer answer = predict(problem); answer != Answer::ok) return failed(answer);
  if (!problem.has_branches() || !options.line_search) return iterate(problem, options, true);
  const NewtonResult followed = follow_branches(problem, options);
  if (followed.status == NewtonStatus::converged) return followed;
  // Branches as they are: from there, or, where there are no forces, in a step that begins anew.
  const bool there = followed.status == NewtonStatus::too_many_iterations;
  if (!there)
    if (const Answer answer = predict(problem); answer != Answer::ok) return failed(answer);
  NewtonResult result = there ? correct(problem, options) : iterate(problem, options, true);
  result.iterations += followed.iterations;
  result.far += followed.far;
  return result;
}

// Whether the residual at the trial configuration ends the iterations.
std::optional<NewtonStatus> Newton::judge(Problem& problem, std::span<const double> r, double tolerance,
                                          NewtonResult& result) const {
  const auto [size, where] = problem.largest(r);
  if (!std::isfinite(size)) return NewtonStatus::diverged;
  const double relative = compared(size, problem.force_scale());
  result.residuals.push_back(relative);
  if (relative > kNear) result.far = result.iterations;
  result.worst = where;
  if (problem.at_target() && (relative <= tolerance || size <= problem.rounding_floor(K_)))
    return NewtonStatus::converged;
  if (!(relative < 1e12)) return NewtonStatus::diverged;
  return std::nullopt;
}

// Close to a solution the tangent hardly changes any more: a direction by the factors of the last one leaves
// about the share of the residual that the last direction left. Negative pivots are to be those of the end.
std::optional<NewtonStatus> Newton::finish(Problem& problem, std::span<double> r, double tolerance,
                                           NewtonResult& result) {
  const auto& done = result.residuals;
  if (done.size() < 2 || result.negative_pivots > 0 || !problem.has_branches() || !problem.at_target() ||
      !(done.back() / done[done.size() - 2] * done.back() <= tolerance))
    return std::nullopt;
  problem.accept();
  if (!solve_with_factors(problem, r)) return NewtonStatus::singular;
  ++result.iterations;
  problem.apply_increment(delta_, problem.limit(delta_));
  if (const Answer answer = checked(problem.residual(r), r); answer != Answer::ok) return status_of(answer);
  return judge(problem, r, tolerance, result);
}

// Where parts buckle within the step a direction turns too far. The matrix then gets more inertia, as that of
// a shorter step has.
bool Newton::bring_within(double furthest, Problem& problem, NewtonResult& result) {
  double turn = problem.turn_of(delta_);
  for (double inertia = 1; turn > furthest && inertia < kMostInertia; inertia *= 4) {
    problem.add_inertia(K_, 3 * inertia);
    if (!direction(problem)) return false;
    ++result.iterations;
    result.negative_pivots = linear_->report().negative_pivots;
    turn = problem.turn_of(delta_);
  }
  if (turn > furthest)
    for (double& d : delta_) d *= furthest / turn;
  return true;
}

// Stresses that are linear about the strains predicted hardly need a line search: what a turn stretches
// falsely, and where a yarn goes beyond its branch, the next direction takes back. Where two in turn hardly
// do, yarns change their branches to and fro. Ends with too many iterations at a trial configuration from
// which others can go on, with law_failed where there is none.
NewtonResult Newton::follow_branches(Problem& problem, const NewtonOptions& options) {
  NewtonResult result;
  const auto failed = [&result] {
    result.status = NewtonStatus::law_failed;
    return result;
  };
  double furthest = 0;
  int swings = 0;
  for (int i = 0; i < std::min(kMostOnBranches, options.max_iterations); ++i) {
    if (!direction(problem)) return failed();
    ++result.iterations;
    result.negative_pivots = linear_->report().negative_pivots;
    if (i == 0) furthest = std::clamp(problem.turn_of(delta_), kFurthest, kFurthestFirst);
    if (!bring_within(furthest, problem, result)) return failed();
    const double fraction = problem.limit(delta_);
    if (!(fraction > 0)) return failed();
    const bool arrived = i > 0 && problem.at_target();
    double share = 0;
    if (go(problem, delta_, r_, fraction, arrived, trial_r_, share) != Answer::ok) return failed();
    swings = !arrived || i < kSettles || std::abs(share) <= kContracts ? 0 : swings + 1;
    std::optional<NewtonStatus> judged = judge(problem, trial_r_, options.tolerance, result);
    if (!judged) judged = finish(problem, trial_r_, options.tolerance, result);
    if (judged && judged != NewtonStatus::converged) return failed();
    if (judged) result.status = *judged;
    if (judged || swings == kSwings || ends_near(result.residuals)) break;
    if (checked(problem.tangent_on_branches(K_, r_), r_) != Answer::ok) return failed();
    problem.accept();
  }
  if (result.status == NewtonStatus::converged) problem.accept();
  return result;
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
  const int most = problem.has_branches() ? kMoreTimes * options.max_iterations : options.max_iterations;
  for (int i = 0; i < most && (i < options.max_iterations || still_falls(result.residuals)); ++i) {
    if (!direction(problem)) return stop(NewtonStatus::singular);
    ++result.iterations;
    result.negative_pivots = linear_->report().negative_pivots;
    if (const auto failed = search(problem, options.line_search && !(predicted && i == 0)))
      return stop(*failed);
    problem.accept();
    if (const auto judged = judge(problem, r_, options.tolerance, result)) return stop(*judged);
    const int before = result.iterations;
    const auto judged = finish(problem, r_, options.tolerance, result);
    if (result.iterations > before) problem.accept();
    if (judged) return stop(*judged);
    if (const Answer answer = problem.tangent(K_); answer != Answer::ok) return stop(status_of(answer));
  }
  return stop(NewtonStatus::too_many_iterations);
}

}  // namespace fabricsh::solver
