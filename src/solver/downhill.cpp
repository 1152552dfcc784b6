#include "solver/downhill.hpp"

#include <algorithm>

namespace fabricsh::solver {

using linear::all_finite;
using linear::dot;

namespace {
constexpr double kGone = 1e3;  // growth of what rounding makes, with the coordinates, of a part that has gone
}

Downhill::Downhill(Problem& problem, const NewtonOptions& options, LinearSolver& linear, bool symmetric)
    : problem_(problem), options_(options), linear_(linear), symmetric_(symmetric) {
  for (auto* v : {&r_, &delta_, &trial_r_}) v->assign(static_cast<std::size_t>(problem.size()), 0.0);
}

NewtonResult Downhill::run(Answer begun) {
  const auto stop = [this](NewtonStatus status) {
    result_.status = status;
    return result_;
  };
  if (begun != Answer::ok) return stop(status_of(begun));
  for (;;) {
    if (balanced()) {
      if (const auto status = at_balance()) return stop(*status);
    } else if (const NewtonStatus status = out_of_balance(); status != NewtonStatus::converged) {
      return stop(status);
    }
    if (const NewtonStatus made = make_step(); made != NewtonStatus::converged)
      return stop(within_rounding_ && tangent_at_iterate() == Answer::ok ? NewtonStatus::converged : made);
    if (const Answer moved = move_on(); moved != Answer::ok) return stop(status_of(moved));
  }
}

// Records the residual; whether it vanishes. At first it may be a load, which is exact however small: what is
// below rounding then ends the iteration only if no step can be made, as where nothing holds a part.
bool Downhill::balanced() {
  const auto [size, where] = problem_.largest(r_);
  const double relative = compared(size, problem_.force_scale()), floor = problem_.rounding_floor(K_);
  result_.residuals.push_back(relative);
  result_.worst = where;
  const bool first = result_.residuals.size() == 1;
  if (first) first_floor_ = floor;
  gone_ = floor > kGone * first_floor_;
  const bool rounding = size <= floor && !gone_;
  within_rounding_ = first && rounding && problem_.at_target();
  return problem_.at_target() && (relative <= options_.tolerance || (rounding && !first));
}

bool Downhill::factorise(double m) {
  ++result_.iterations;
  if (K_.size() == 0) return true;
  linear::add_diagonal(K_, m, D_, A_);
  const bool done = linear_.factorise(A_);
  result_.negative_pivots = linear_.report().negative_pivots;
  return done && !(symmetric_ && result_.negative_pivots > 0);
}

bool Downhill::solve(std::span<const double> b, std::span<double> x) {
  return linear_.solve(A_, b, x) && all_finite(x);
}

bool Downhill::find_downhill() {
  const auto with = [this](std::span<const double> b, std::span<double> x) { return solve(b, x); };
  if (K_.size() > 0 && !solve(r_, delta_)) return false;
  if (!problem_.finish_direction(with, delta_) || !all_finite(delta_)) return false;
  work_ = dot(delta_, r_);
  return work_ > 0 || !problem_.at_target();
}

Answer Downhill::tangent_at_iterate() {
  std::fill(delta_.begin(), delta_.end(), 0.0);
  problem_.apply_increment(delta_, 0);
  Answer answer = checked(problem_.residual(r_), r_);
  if (answer == Answer::ok) answer = problem_.tangent(K_);
  linear::absolute_sums(K_, D_);
  return answer;
}

}  // namespace fabricsh::solver
