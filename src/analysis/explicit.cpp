#include "analysis/explicit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/step_control.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "base/ordered_sum.hpp"

namespace fabricsh::analysis {

namespace {

constexpr double kUsual = 0.7;        // of the stable step
constexpr double kJump = 0.1;         // of the smallest element: a motion beyond in one step is a jump
constexpr int kStretchEvery = 16;     // steps between two looks at the stretch
constexpr std::size_t kShare = 4096;  // unknowns from which threads share a loop

}  // namespace

Explicit::Explicit(std::shared_ptr<model::Model> model, const DynamicOptions& options,
                   std::shared_ptr<Notices> notices)
    : Dynamic(std::move(model), options, std::move(notices)),
      stiffness_(*assembly_, options_.stiffness_damping),
      mass_(assembly_->lumped_mass(scaled_)) {
  // Damping of the masses takes nothing from the stable step; of the stiffness, whose velocity lags half a
  // step, sqrt(1 + xi^2) - xi with xi = b omega / 2 at the highest frequency, omega = 2 / dt0.
  const double xi = options_.stiffness_damping / stable_, undamped = stable_;
  stable_ *= std::sqrt(1 + xi * xi) - xi;
  check_stable_step(undamped);
  choose_step();
  const auto n = mass_.size();
  for (std::size_t i = 0; i < n; ++i)
    farthest_.push_back(assembly_->turns(static_cast<mechanics::Index>(i)) ? std::numbers::pi / 2
                                                                           : smallest_);
  for (auto* v : {&motion_.v, &motion_.a, &trial_.v, &trial_.a, &increment_, &residual_}) v->assign(n, 0);
}

void Explicit::check_stable_step(double undamped) const {
  if ((options_.step && options_.force) || duration_ / (kUsual * stable_) <= most_steps) return;
  const bool damped = duration_ / (kUsual * undamped) <= most_steps;
  throw Error("dynamic: field '" + std::string(damped ? "damping.stiffness" : "duration") + "': " +
              (damped ? number(options_.stiffness_damping) + " s brings the stable step from " +
                            number(undamped) + " s to " + number(stable_) + " s, with which "
                      : "the stable step of this mesh and card is " + number(stable_) + " s, with which ") +
              number(duration_) + " s would take more than " + number(most_steps) + " steps: expected less " +
              (damped ? "damping" : "time") + ", or scheme=\"implicit\"");
}

void Explicit::choose_step() {
  const double usual = kUsual * stable_;
  now_.step = options_.step.value_or(usual);
  if (options_.force || now_.step <= usual * (1 + 1e-12)) return;
  if (now_.step > stable_)
    throw Error("dynamic: field 'step': expected at most " + number(stable_) +
                " s, the stable step of this mesh and card, got " + number(now_.step) +
                " s (step=\"auto\" takes " + number(usual) + " s; force=true takes it all the same)");
  say("dynamic: the step of " + number(now_.step) + " s is above 0.7 of the stable one, " + number(stable_) +
      " s");
}

void Explicit::take_options(const DynamicOptions& options) {
  const DynamicOptions before = options_;
  options_ = options;
  if (options.step == before.step) return;
  try {
    choose_step();
  } catch (...) {
    options_ = before;
    throw;
  }
}

void Explicit::begin() {
  Dynamic::begin();
  trial_.v = motion_.v;
  if (!stiffness_.start(driven_rates()) || !accelerate(0, dead_))
    throw NumericalFailure("dynamic: the fabric law failed at time 0", 0, assembly_->failed_element());
  motion_.a = trial_.a;
  motion_.c = trial_.c;
}

void Explicit::set_motion(const mechanics::NodalRates& rates) { motion_.v = assembly_->collect_rates(rates); }

double Explicit::try_step(double limit, StepReport& report) {
  if (now_.steps % kStretchEvery == 0) split();
  const double size = end_of_step(committed_time(), next_landing(limit), now_.step);
  if (!attempt(size, report)) give_up(report);
  return size;
}

void Explicit::split() {
  const double stable = stable_ / std::max(1.0, assembly_->largest_stretch());
  const double wanted = options_.step.value_or(kUsual * stable_);
  now_.step = wanted;
  if (options_.force || wanted <= stable) return;
  now_.step = wanted / std::ceil(wanted / stable);
  if (now_.told_split) return;
  now_.told_split = true;
  say("dynamic: stretch has brought the stable step to " + number(stable) + " s at time " +
      number(committed_time()) + " s; the step of " + number(wanted) + " s is split from here on");
}

// Forces at the trial configuration and the acceleration that they make; trial_.v holds the predicted
// velocity and becomes the new one. False: the law failed.
bool Explicit::accelerate(double dt, const std::vector<double>& dead) {
  if (!assembly_->forces({trial_time_ - dt, dt})) return false;
  assembly_->residual(dead, residual_);
  const double damping = options_.mass_damping, kick = options_.gamma * dt;
  const double effective = 1 + kick * damping;
  if (stiffness_.on()) {
    stiffness_.force(trial_.v, trial_.c);
    for (std::size_t i = 0; i < residual_.size(); ++i) residual_[i] -= trial_.c[i];
  }
#pragma omp parallel for schedule(static) if (mass_.size() >= kShare)
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const double a = (residual_[i] / mass_[i] - damping * trial_.v[i]) / effective;
    trial_.a[i] = a;
    trial_.v[i] += kick * a;
  }
  return true;
}

bool Explicit::attempt(double size, StepReport& report) {
  const double now = committed_time(), dt = size - now, early = (1 - options_.gamma) * dt;
  report.step = dt;
  report.time = now;
  if (dirty_) assembly_->rollback();
  dirty_ = true;
  tried_ = false;
  trial_time_ = now;
  bool away = false;
#pragma omp parallel for schedule(static) reduction(|| : away) if (mass_.size() >= kShare)
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    increment_[i] = dt * (motion_.v[i] + dt / 2 * motion_.a[i]);
    trial_.v[i] = motion_.v[i] + early * motion_.a[i];
    away = away || !(std::abs(increment_[i]) < farthest_[i]);
  }
  ran_away_ = away;
  if (ran_away_ || (stiffness_.on() && !stiffness_.start(driven_rates()))) return false;
  assembly_->begin_iterate();
  const auto targets = assembly_->targets(size);
  if (!targets.empty()) {
    if (targets_.empty()) targets_ = assembly_->targets(now);
    watch_jump(targets_, targets, size, kJump * smallest_);
    trial_targets_ = targets;
  }
  assembly_->retract(increment_, 1, targets);
  assembly_->aim(size);
  if (trial_dead_.empty() || !assembly_->constant_loads()) assembly_->external(size, trial_dead_);
  trial_time_ = size;
  if (!accelerate(dt, trial_dead_)) return false;
  report.time = size;
  tried_ = true;
  return true;
}

void Explicit::commit(StepReport& report) {
  const double damping = options_.mass_damping;
  if (damping > 0)
    now_.damping_work += ordered_sum(mass_.size(), [&](std::size_t i) {
      return damping * mass_[i] * (motion_.v[i] + trial_.v[i]) / 2 * increment_[i];
    });
  if (stiffness_.on())
    now_.damping_work += ordered_sum(
        mass_.size(), [&](std::size_t i) { return (motion_.c[i] + trial_.c[i]) / 2 * increment_[i]; });
  if (damps()) {
    // Work of all forces by the trapezoid, which the kinetic energy does not get.
    const double work = ordered_sum(mass_.size(), [&](std::size_t i) {
      return mass_[i] * (motion_.a[i] + trial_.a[i]) / 2 * increment_[i];
    });
    now_.damping_work += work - kinetic_of(trial_.v) + kinetic_of(motion_.v);
  }
  if (!assembly_->constant_loads()) dead_ = trial_dead_;
  work_.add(*assembly_, dead_);
  assembly_->commit(report.time);
  dirty_ = false;
  std::swap(motion_, trial_);
  targets_ = trial_targets_;
  tried_ = false;
  ++now_.steps;
}

double Explicit::kinetic_of(const std::vector<double>& v) const {
  return ordered_sum(v.size(), [&](std::size_t i) { return mass_[i] * v[i] * v[i] / 2; });
}

double Explicit::kinetic() const { return kinetic_of((tried_ ? trial_ : motion_).v) + driven_kinetic(); }

const mechanics::NodalRates& Explicit::rates() const {
  const auto version = std::as_const(*assembly_).state().version();
  if (rates_version_ != version)
    assembly_->spread_rates((tried_ ? trial_ : motion_).v, driven_rates(), rates_);
  rates_version_ = version;
  return rates_;
}

void Explicit::give_up(const StepReport& report) {
  const double now = committed_time();
  const mesh::Index element = ran_away_ ? -1 : assembly_->failed_element();
  std::string text = "dynamic: stopped at time " + number(now) + " s: ";
  text += ran_away_ ? "a node moves by more than an element in a step of "
                    : "a strain is not finite in a step of ";
  text += number(report.step) + " s";
  if (element >= 0) text += ", element " + std::to_string(element + 1);
  text += ".\nTry: a step below " + number(kUsual * stable_) + " s (the stable one is " + number(stable_) +
          " s); or loads and velocities that are in SI units.";
  std::string why = text.substr(std::string("dynamic: ").size());
  why += "\nstretch    the sheet is stretched to " + number(assembly_->largest_stretch()) +
         " times its length at most, the step in use is " + number(now_.step / stable_) +
         " of the stable one";
  if (const mesh::Index node = fastest_node(); node >= 0)
    why +=
        "\nfastest    node " + std::to_string(node + 1) + " with " + number(velocity(node).norm()) + " m/s";
  fail(NumericalFailure(text, now, element), why);
}

mesh::Index Explicit::fastest_node() const {
  mesh::Index fastest = -1;
  double most = 0;
  for (mesh::Index n = 0; n < static_cast<mesh::Index>(assembly_->reference().size()); ++n)
    if (const double v = velocity(n).norm(); v > most) {
      most = v;
      fastest = n;
    }
  return fastest;
}

void Explicit::memory(Archive& archive) {
  archive(now_, motion_);
  if (!archive.reading()) return;
  trial_dead_ = dead_;
  targets_.clear();
  dirty_ = tried_ = false;
  rates_version_ = 0;
}

}  // namespace fabricsh::analysis
