#include "solver/trust_region.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "solver/downhill.hpp"
#include "solver/line_search.hpp"
#include "solver/stability.hpp"

namespace fabricsh::solver {

using linear::all_finite;
using linear::dot;

namespace {

constexpr double kWidest = 0.1;      // rad, largest radius of the trust region
constexpr double kNarrowest = 1e-9;  // rad, below which there is no way down
constexpr double kFirst = 1e-7;      // factor m with which regularisation begins
constexpr double kMost = 1e4;        // factor beyond which it has failed
constexpr double kLeast = 1e-3;      // least ratio of energy taken away to that of the quadratic model
constexpr double kPoor = 0.25, kGood = 0.75, kExact = 0.9;  // such ratios
constexpr double kLinear = 1e-5;  // rad: a step this small is judged by the forces at its end alone
constexpr int kTrials = 4;        // steps in a row that may end above the least energy so far
constexpr int kAgain = 8;         // steps that lower it, after which trials are allowed again
constexpr int kRenew = 3;         // rejections after which the plain tangent replaces the extrapolated one
constexpr double kSame = 0.999;   // ratio of two works from which on neither side is preferred

// rad, turns along the lowest mode from an unstable equilibrium to where the way down begins, one for each
// that a solve leaves. They are finite: just behind a bifurcation the energy falls by less than its rounding,
// but beyond the shapes beside it the forces lead back to them.

constexpr double kAway[] = {0.1, 0.3, 0.02, 0.6};

struct TrialStep {
  double turn = 0;   // rad, of the whole of delta
  double drop = 0;   // J, energy that it takes away
  double ratio = 0;  // of that to the quadratic model's
  Answer answer = Answer::cut;
};

// One solve.
class Walk final : public Downhill {
 public:
  Walk(Problem& problem, const NewtonOptions& options, LinearSolver& linear, bool symmetric, Judge judge)
      : Downhill(problem, options, linear, symmetric), check_(linear, symmetric, judge) {}
  // The supports go to their targets, while the cloth follows as it would follow small motions.
  Answer follow_supports();
  Answer begin_at_trial();

 private:
  std::optional<NewtonStatus> at_balance() override;
  NewtonStatus out_of_balance() const override {
    return result_.residuals.back() < 1e12 ? NewtonStatus::converged : NewtonStatus::diverged;
  }
  bool factorise_definite();
  bool is_free();
  bool find_direction(TrialStep& step);
  double next_factor(const TrialStep& step);
  double work_at(double fraction, TrialStep& step);
  void evaluate(TrialStep& step);
  void search(double fraction, bool moving, TrialStep& step);
  bool is_lowest(const TrialStep& step) const;
  bool accepts(const TrialStep& step) const;
  void adapt(const TrialStep& step);
  Answer move_on() override;
  NewtonStatus make_step() override;
  bool reject(const TrialStep& step);
  bool return_to_best();
  Stability judge();
  enum class Saddle { left, none, stays };
  bool take_mode();
  bool rises_on_both_sides();
  Saddle leave_saddle();
  double work_to_side(double turn);

  double m_ = 0, next_m_ = kFirst;     // present factor, and the one to try where 0 is too small
  double long_m_ = 0, long_turn_ = 0;  // of the last direction that was too long
  double radius_ = kWidest;            // rad
  double level_ = 0, fallen_ = 0;      // J, energy above the least so far; taken away so far
  int trials_ = 0;                     // steps since the configuration of least energy
  bool singular_ = false, began_free_ = false;
  StabilityCheck check_;
  int lowered_ = 0;      // steps in a row that have lowered the energy
  bool watches_ = true;  // whether steps may raise the energy on trial
  int rejections_ = 0;
  std::size_t saddles_ = 0;
};

// With the least regularisation that leaves no pivot negative.
bool Walk::factorise_definite() {
  for (double m = 0; m < kMost; m = m == 0 ? kFirst : 8 * m)
    if (factorise(m) && result_.negative_pivots == 0) return true;
  return false;
}

// The factor after a direction that turns by more than the radius: the softest part turns by c / (k + m),
// with c and k from the last two such directions.
double Walk::next_factor(const TrialStep& step) {
  double next = m_ == 0 ? next_m_ : m_ * step.turn / radius_;
  if (long_turn_ > step.turn && m_ > long_m_) {
    const double k = (m_ * step.turn - long_m_ * long_turn_) / (long_turn_ - step.turn);
    next = long_turn_ * (k + long_m_) / radius_ - k;
  }
  long_m_ = m_;
  long_turn_ = step.turn;
  return std::max(next, m_ == 0 ? next_m_ : 1.1 * m_);
}

// Whether the tangent at the start of the step is singular: a part is not held, and would go for ever. A
// body on its way, as a plate that presses the part, may come to hold it.
bool Walk::is_free() {
  const bool free = m_ == 0 && result_.residuals.size() == 1 && linear_.report().singular;
  began_free_ = began_free_ || free;
  singular_ = free && problem_.at_target();
  return singular_;
}

// Sets delta_, regularised as far as is needed. False: no regularisation helps, or too many iterations.
bool Walk::find_direction(TrialStep& step) {
  long_turn_ = 0;
  for (double next = m_;;) {
    m_ = next;
    if (m_ > kMost || result_.iterations >= options_.max_iterations) return false;
    next = m_ == 0 ? next_m_ : 8 * m_;
    const bool definite = factorise(m_);
    if (is_free()) return false;
    if (!definite || !find_downhill()) continue;
    step.turn = problem_.turn_of(delta_);
    if (step.turn <= 1.5 * radius_) return true;
    next = next_factor(step);
  }
}

// Moves along delta_ by a fraction; returns the work of the forces there along delta_.
double Walk::work_at(double fraction, TrialStep& step) {
  problem_.apply_increment(delta_, fraction);
  step.answer = checked(problem_.residual(trial_r_), trial_r_);
  return step.answer == Answer::ok ? dot(delta_, trial_r_) : 0;
}

// Goes along delta_ as far as is safe. The energy that this takes away is the work of the forces along the
// step, by Simpson's rule, which is exact for stresses that are linear in the Green-Lagrange strains.
void Walk::evaluate(TrialStep& step) {
  const bool moving = !problem_.at_target();
  const double fraction = problem_.limit(delta_);
  if (!(fraction > 0)) return;
  if (step.turn * fraction < kLinear) return search(fraction, moving, step);
  const double half = work_at(fraction / 2, step);
  if (step.answer != Answer::ok) return;
  const double end = work_at(fraction, step);
  step.drop = fraction * (work_ + 4 * half + end) / 6;
  double damped = 0;
  for (std::size_t i = 0; i < delta_.size(); ++i) damped += m_ * D_[i] * delta_[i] * delta_[i];
  const double model = fraction * (work_ - fraction / 2 * (work_ - damped));
  step.ratio = model > 0 ? step.drop / model : 0;
}

// A short step changes the forces linearly but for switches of yarns, which the line search finds. moving:
// something besides is on its way, for which the step is made, while the cloth may be in balance but for
// rounding.
void Walk::search(double fraction, bool moving, TrialStep& step) {
  double end = 0;
  const auto found = line_search(work_, {!moving, true, fraction}, [&](double s) -> TriedFraction {
    if (s != fraction && !problem_.is_safe(delta_, s)) return {Answer::cut};
    end = work_at(s, step);
    return {step.answer, end};
  });
  step.answer = found.answer;
  step.drop = found.fraction * (work_ + end) / 2;
  step.ratio = step.drop > 0 || work_ == 0 ? 1 : 0;
}

// Whether the step ends below the least energy so far, by more than rounding.
bool Walk::is_lowest(const TrialStep& step) const {
  return trials_ == 0 ? step.ratio > kLeast : step.drop - level_ > kLeast * step.drop;
}

// While something besides the supports is on its way it does work on the rest, and energies say nothing.
bool Walk::accepts(const TrialStep& step) const {
  if (step.answer != Answer::ok) return false;
  if (!problem_.at_target() || !options_.line_search) return true;
  if (is_lowest(step)) return true;
  return watches_ && trials_ < kTrials;
}

// The radius by how well the quadratic model predicted the energy, and m for a step of that size.
void Walk::adapt(const TrialStep& step) {
  const bool lowest = is_lowest(step);
  trials_ = lowest ? 0 : trials_ + 1;
  lowered_ = lowest ? lowered_ + 1 : 0;
  if (lowered_ >= kAgain) watches_ = true;
  level_ = lowest ? 0 : level_ - step.drop;
  fallen_ += step.drop;
  if (step.ratio > kGood) radius_ = std::min(kWidest, 2 * radius_);
  if (step.ratio < kPoor && !watches_) radius_ = std::min(radius_, step.turn) / 2;
  if (m_ > 0) next_m_ = m_ / 4;
  m_ = step.ratio > kExact && step.turn < radius_ / 3 ? 0 : m_ * std::clamp(step.turn / radius_, 0.1, 4.0);
}

// The trial configuration becomes the iterate, with the tangent for the stresses that the step predicted.
Answer Walk::move_on() {
  const Answer answer = problem_.extrapolated_tangent(K_);
  problem_.accept();
  linear::absolute_sums(K_, D_);
  if (trials_ == 0) problem_.save_iterate();
  return answer;
}

// To the configuration of least energy so far, where from now on every step must lower it.
bool Walk::return_to_best() {
  problem_.restore_iterate();
  problem_.accept();
  watches_ = false;
  trials_ = 0;
  level_ = m_ = 0;
  radius_ /= 4;
  return tangent_at_iterate() == Answer::ok;
}

// Prepares another attempt. False: there is none.
bool Walk::reject(const TrialStep& step) {
  if (trials_ > 0) return return_to_best();
  watches_ = false;
  radius_ = std::min(radius_, step.turn) / 2;
  m_ = m_ == 0 ? next_m_ : 2 * m_;
  return ++rejections_ != kRenew || tangent_at_iterate() == Answer::ok;
}

// converged: a step has been made. r_ is then the residual at the trial configuration.
NewtonStatus Walk::make_step() {
  for (rejections_ = 0; radius_ > kNarrowest;) {
    TrialStep step;
    if (!find_direction(step))
      return singular_ || began_free_ || m_ > kMost ? NewtonStatus::singular
                                                    : NewtonStatus::too_many_iterations;
    evaluate(step);
    if (step.answer == Answer::broken) return NewtonStatus::broken;
    if (accepts(step)) {
      adapt(step);
      r_.swap(trial_r_);
      return NewtonStatus::converged;
    }
    if (!reject(step)) return NewtonStatus::law_failed;
  }
  return NewtonStatus::law_failed;
}

Answer Walk::begin_at_trial() {
  problem_.accept();
  problem_.save_iterate();
  return tangent_at_iterate();
}

Answer Walk::follow_supports() {
  linear::Vector lead(r_.size());
  Answer answer = checked(problem_.predict(K_, r_, lead), r_);
  if (answer != Answer::ok) return answer;
  linear::absolute_sums(K_, D_);
  const bool driven = std::any_of(lead.begin(), lead.end(), [](double f) { return f != 0; });
  if (driven && !(factorise_definite() && solve(lead, delta_))) return Answer::cut;
  const double fraction = driven ? problem_.limit(delta_) : 0;
  if (driven && !(fraction > 0)) return Answer::cut;
  problem_.apply_increment(delta_, fraction);
  answer = checked(problem_.residual(r_), r_);
  if (answer == Answer::ok && driven) return move_on();
  problem_.accept();
  problem_.save_iterate();
  return answer;
}

// Of the plain tangent at this equilibrium.
Stability Walk::judge() {
  if (problem_.tangent(K_) != Answer::ok) return Stability::unchecked;
  linear::absolute_sums(K_, D_);
  const Stability answer = check_.of(K_, D_);
  result_.iterations += check_.factorisations();
  result_.negative_pivots = answer == Stability::stable ? 0 : check_.negative();
  return answer;
}

// J, of the forces at the end of a step along delta_.
double Walk::work_to_side(double turn) {
  problem_.apply_increment(delta_, turn);
  const Answer answer = checked(problem_.residual(trial_r_), trial_r_);
  return answer == Answer::ok ? turn * dot(delta_, trial_r_) : 0;
}

// Sets delta_ to the lowest mode, with a turn of 1 rad.
bool Walk::take_mode() {
  if (check_.mode().shape.size() != delta_.size()) return false;
  delta_ = check_.mode().shape;
  const double turn = problem_.turn_of(delta_);
  for (double& d : delta_) d /= turn;
  return turn > 0 && all_finite(delta_);
}

// At a switch of yarns the tangent is that of one side only, and the energy may rise on both sides of its
// lowest mode: by the square of the way. A stretch, which hides a fall just behind a bifurcation, grows with
// the fourth power.
bool Walk::rises_on_both_sides() {
  double before = 0;
  for (double turn = 1e-3; turn > 1e-7; turn /= 10) {
    const double sum = (work_to_side(turn) + work_to_side(-turn)) / (turn * turn);
    if (sum > 0) return false;
    if (before < 0 && sum < before / 2 && sum > 2 * before) return true;
    before = sum;
  }
  return false;
}

// From an unstable equilibrium by a finite turn along its lowest mode, to the side on which the energy is
// less.
Walk::Saddle Walk::leave_saddle() {
  if (!take_mode()) return Saddle::stays;
  if (rises_on_both_sides()) return tangent_at_iterate() == Answer::ok ? Saddle::none : Saddle::stays;
  if (check_.negative() > options_.most_unstable || saddles_ == std::size(kAway)) return Saddle::stays;
  const double turn = options_.turns * kAway[saddles_++];
  const auto end_of = [this](double way) {
    work_to_side(0);
    return way * problem_.limit(delta_, way);
  };
  const double end = end_of(turn), other_end = end_of(-turn);
  const double one = work_to_side(end), other = work_to_side(other_end);
  work_to_side(one >= kSame * other ? end : other_end);
  r_.swap(trial_r_);
  radius_ = kWidest;
  next_m_ = kFirst;
  level_ = fallen_ = m_ = 0;
  trials_ = 0;
  watches_ = true;
  ++result_.left_unstable;
  return move_on() == Answer::ok ? Saddle::left : Saddle::stays;
}

std::optional<NewtonStatus> Walk::at_balance() {
  if (level_ > 1e-3 * std::abs(fallen_)) {
    if (return_to_best()) return {};
    return NewtonStatus::unstable;
  }
  result_.stability = judge();
  if (result_.stability != Stability::unstable) return NewtonStatus::converged;
  const Saddle saddle = leave_saddle();
  if (saddle == Saddle::left) return {};
  if (saddle == Saddle::stays) return NewtonStatus::unstable;
  result_.stability = check_.negative() > 1 ? Stability::unchecked : Stability::stable;
  result_.negative_pivots = 0;
  return NewtonStatus::converged;
}

}  // namespace

NewtonResult TrustRegion::solve(Problem& problem, const NewtonOptions& options) {
  Walk walk(problem, options, *linear_, symmetric_, judge_);
  return walk.run(walk.follow_supports());
}

NewtonResult TrustRegion::correct(Problem& problem, const NewtonOptions& options) {
  Walk walk(problem, options, *linear_, symmetric_, judge_);
  return walk.run(walk.begin_at_trial());
}

}  // namespace fabricsh::solver
