#include "solver/descent.hpp"

#include <algorithm>

#include "solver/downhill.hpp"

namespace fabricsh::solver {

namespace {

constexpr double kFirstViscosity = 1e-3, kLeastViscosity = 1e-14,
                 kMostViscosity = 1e4;                // of the viscosity's factor m
constexpr double kRise = 8, kFall = 0.25, kBent = 2;  // after a failed, a whole and a shortened step
constexpr double kShortest = 0.02;  // fraction of a step along which the energy falls, below which m rises

// One solve.
class Creep final : public Downhill {
 public:
  using Downhill::Downhill;
  // The supports go to their targets; the cloth follows later.
  Answer begin() {
    Answer answer = problem_.predict(K_, r_, trial_r_);
    if (answer == Answer::ok) answer = tangent_at_iterate();
    problem_.accept();
    return answer;
  }
  Answer begin_at_saved() {
    problem_.restore_iterate();
    problem_.accept();
    return tangent_at_iterate();
  }

 private:
  NewtonStatus make_step() override;
  Answer move_on() override {
    problem_.accept();
    const Answer answer = problem_.tangent(K_);
    linear::absolute_sums(K_, D_);
    return answer;
  }
  NewtonStatus out_of_balance() const override {
    return gone_ && result_.residuals.back() > options_.tolerance ? NewtonStatus::singular
                                                                  : NewtonStatus::converged;
  }
  Answer lower();

  double m_ = kFirstViscosity;
  bool shortened_ = false;  // the last step, so that the energy falls
  bool uphill_ = false;     // why the last step was taken back: no less energy, and not what cannot be done
};

// Goes along delta_ as far as is safe. The energy falls by the mean of the forces along the step, by the
// trapezoidal rule; where it would not, yarns have met their far stiffer unloading on the way, and the step
// is shortened to where a line through both forces vanishes, which costs no factorisation.
// Where no fraction above kShortest does (cut), the step is undone. A rigid body that moves does work on the
// cloth, so that the energy may rise meanwhile.
Answer Creep::lower() {
  uphill_ = false;
  const bool on_its_way = !problem_.at_target();
  double fraction = problem_.limit(delta_);
  shortened_ = false;
  if (!(fraction > 0)) return Answer::cut;
  const double least = kShortest * fraction;
  for (;;) {
    const bool safe = !shortened_ || problem_.is_safe(delta_, fraction);
    problem_.apply_increment(delta_, fraction);
    const Answer answer = safe ? checked(problem_.residual(trial_r_), trial_r_) : Answer::cut;
    const double g = answer == Answer::ok ? linear::dot(delta_, trial_r_) : 0;
    uphill_ = answer == Answer::ok && !on_its_way && !(work_ + g > 0);
    if (answer == Answer::ok && !uphill_) return answer;
    fraction = uphill_ ? std::max(fraction * work_ / (work_ - g), 0.1 * fraction) : 0;
    if (fraction < least) {
      problem_.apply_increment(delta_, 0);
      return answer == Answer::ok ? Answer::cut : answer;
    }
    shortened_ = true;
  }
}

NewtonStatus Creep::make_step() {
  for (;; m_ *= kRise) {
    if (m_ > kMostViscosity) return uphill_ ? NewtonStatus::too_many_iterations : NewtonStatus::law_failed;
    if (result_.iterations >= options_.max_iterations) return NewtonStatus::too_many_iterations;
    const Answer answer = factorise(m_) && find_downhill() ? lower() : Answer::cut;
    if (answer == Answer::broken) return NewtonStatus::broken;
    if (answer == Answer::ok) break;
  }
  r_.swap(trial_r_);
  m_ = std::clamp((shortened_ ? kBent : kFall) * m_, kLeastViscosity, kMostViscosity);
  return result_.iterations < options_.max_iterations ? NewtonStatus::converged
                                                      : NewtonStatus::too_many_iterations;
}

}  // namespace

namespace {
NewtonResult creep_down(Creep& creep, Answer begun) {
  NewtonResult result = creep.run(begun);
  result.negative_pivots = 0;  // those counted are of K + m D
  return result;
}
}  // namespace

NewtonResult Descent::solve(Problem& problem, const NewtonOptions& options) {
  Creep creep(problem, options, *linear_, true);
  return creep_down(creep, creep.begin());
}

NewtonResult Descent::go_on(Problem& problem, const NewtonOptions& options) {
  Creep creep(problem, options, *linear_, true);
  return creep_down(creep, creep.begin_at_saved());
}

}  // namespace fabricsh::solver
