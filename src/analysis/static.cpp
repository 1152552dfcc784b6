// The quasi-static run: steps, cuts, landings, events, hooks.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "analysis/analysis.hpp"
#include "analysis/problem.hpp"
#include "base/error.hpp"

namespace fabricsh::analysis {

namespace {

constexpr double kSameTime = 1e-12;  // of the duration: two times this close are one

std::string number(double v) {
  std::ostringstream text;
  text.precision(6);
  text << v;
  return text.str();
}

void check(const StaticOptions& o) {
  if (!(o.duration > 0) || !std::isfinite(o.duration))
    throw Error("static: field 'duration': expected a positive time in s, got " + number(o.duration));
  if (o.step && !(*o.step > 0))
    throw Error("static: field 'step': expected a positive time in s, got " + number(*o.step));
  if (!(o.tolerance > 0) || !(o.tolerance < 1))
    throw Error("static: field 'tolerance': expected a number between 0 and 1, got " + number(o.tolerance));
  if (o.max_iterations < 1) throw Error("static: field 'max_iterations': expected 1 or more");
  if (o.max_cuts < 0) throw Error("static: field 'max_cuts': expected 0 or more");
  if (!(o.min_step >= 0) || o.min_step > o.step.value_or(o.duration))
    throw Error("static: field 'min_step': expected a time in s from 0 to the largest step, got " +
                number(o.min_step));
  if (!(o.stabilise >= 0) || !(o.stabilise < 1))
    throw Error("static: field 'stabilise': expected true or a fraction of the work from 0 to 1, got " +
                number(o.stabilise));
  if (o.control == Control::arc && (o.stabilise > 0 || o.method != Method::newton))
    throw Error(
        "static: field 'control': \"arc\" goes with Newton alone: leave out 'stabilise' and 'method'");
}

bool takes_symmetric(const StaticOptions& o, const assembly::Assembly& assembly, const model::Model& model) {
  return o.linear == Linear::symmetric ||
         (o.linear == Linear::automatic && model.section().symmetric && assembly.symmetric_loads());
}

// Iterations that a step of the right size takes, and those from which the next one had better be smaller.
constexpr int kWanted = 6, kMany = 12;
// Cuts after which relaxation is tried, where it is allowed.
constexpr int kPatience = 3;

}  // namespace

Static::Static(std::shared_ptr<model::Model> model, const StaticOptions& options,
               std::shared_ptr<Notices> notices)
    : model_(std::move(model)), options_(options), notices_(std::move(notices)) {
  check(options_);
  model_->validate();
  assembly_ = std::make_unique<assembly::Assembly>(*model_);
  model_->seal();
  problem_ = std::make_unique<Problem>(*assembly_, 1e-7 * options_.duration, options_.stabilise);
  auto linear = takes_symmetric(options_, *assembly_, *model_) ? solver::make_symmetric_solver()
                                                               : solver::make_unsymmetric_solver();
  if (options_.control == Control::arc)
    arc_ = std::make_unique<solver::ArcLength>(std::move(linear), assembly_->pattern());
  else
    newton_ = std::make_unique<solver::Newton>(std::move(linear), assembly_->pattern());
  if (options_.method != Method::newton)
    relaxation_ = std::make_unique<solver::Relaxation>(assembly_->pattern());
  largest_step_ = options_.step.value_or(options_.duration / 20);
  current_step_ = largest_step_;
  kinks_ = model_->kinks();
}

Static::~Static() = default;

double Static::time() const { return trial_time_; }

void Static::every_step(Hook hook) { timed_.push_back({0, 1, std::move(hook)}); }

void Static::every(double interval, Hook hook) {
  if (!(interval > 0) || !std::isfinite(interval))
    throw Error("every: expected a positive time in s or \"step\", got " + number(interval));
  const auto passed = static_cast<std::int64_t>(std::floor(time() / interval + 1e-9));
  timed_.push_back({interval, passed + 1, std::move(hook)});
}

void Static::event(std::function<double(Static&)> value, double tolerance, Hook hook) {
  if (!(tolerance > 0))
    throw Error("event: field 'tolerance': expected a positive number, got " + number(tolerance));
  events_.push_back({std::move(value), tolerance, 0, 0, std::move(hook), false});
}

void Static::stop(const std::string& reason) {
  stopped_ = true;
  stop_reason_ = reason;
}

void Static::start() {
  if (started_) return;
  started_ = true;
  problem_->aim(0);
  problem_->committed();
  add_external_work();
  for (auto& event : events_) event.last = event.value(*this);
  const auto hooks = timed_;
  for (const auto& timed : hooks) timed.hook(*this);
}

double Static::next_landing(double limit) const {
  const double now = time(), after = now + kSameTime * options_.duration;
  double landing = limit;
  const auto kink = std::upper_bound(kinks_.begin(), kinks_.end(), after);
  if (kink != kinks_.end()) landing = std::min(landing, *kink);
  for (const auto& timed : timed_)
    if (timed.interval > 0) {
      const double t = static_cast<double>(timed.count) * timed.interval;
      if (t > after) landing = std::min(landing, t);
    }
  return landing;
}

double Static::plan(double limit) {
  landing_ = next_landing(limit);
  if (arc_) return arc_length_;
  const double left = landing_ - time();
  const double steps = std::ceil(left / current_step_ - 1e-9);
  return steps <= 1 ? landing_ : time() + left / steps;
}

void Static::advance(double to) {
  if (!std::isfinite(to)) throw Error("advance: expected a finite time in s, got " + number(to));
  start();
  while (!stopped_ && time() < to - kSameTime * options_.duration) advance_to(to);
}

void Static::step() {
  start();
  if (!stopped_ && time() < options_.duration - kSameTime * options_.duration) advance_to(options_.duration);
}

void Static::advance_to(double limit) {
  StepReport report;
  double size = plan(limit);
  const double whole = size;
  while (!attempt(size, report)) {
    if (++report.cuts == kPatience && rescue(whole, report)) {
      size = whole;
      break;
    }
    const bool possible = cut(size);
    if (report.cuts > options_.max_cuts || (report.cuts > kPatience && !possible)) give_up(report);
    size = plan(limit);
  }
  if (problem_->damping().on() && reports_.empty()) calibrate(size, report);
  land_on_event(size, report);
  commit(std::move(report));
}

// The first step is done again until its damping loses no more than it may, or can't be done with less.
void Static::calibrate(double size, StepReport& report) {
  auto& damping = problem_->damping();
  for (int i = 0; i < 8; ++i) {
    const double lost = damping.work(), work = energy().internal() + lost, factor = damping.factor();
    if (lost <= 2 * options_.stabilise * work) return;
    damping.adapt(lost, work);
    if (attempt(size, report)) continue;
    damping.set_factor(factor);
    if (!attempt(size, report)) give_up(report);
    return;
  }
}

// Half the size. False: that is below the smallest step, and the cuts of one step after the other have added
// up to more than one step may take.
bool Static::cut(double size) {
  if (arc_) {
    arc_length_ = tried_length_ / 2;
    return last_.status != solver::NewtonStatus::turned_back || arc_length_ > 0.01 * longest_length_;
  }
  current_step_ = (size - assembly_->state().time()) / 2;
  if (problem_->damping().on() && damping_work_ < 0.01 * largest_external_work_) problem_->damping().raise();
  return current_step_ >= std::max(options_.min_step, std::ldexp(largest_step_, -options_.max_cuts));
}

bool Static::attempt(double size, StepReport& report) {
  const solver::NewtonOptions options{options_.tolerance, options_.max_iterations, options_.line_search};
  if (arc_) {
    const auto arc =
        arc_->solve(*problem_, options, {assembly_->state().time(), landing_, size, largest_step_});
    tried_length_ = arc.length;
    return finish(arc, arc.time, report);
  }
  problem_->aim(size);
  return finish(options_.method == Method::relaxation ? relax() : newton_->solve(*problem_, options), size,
                report);
}

bool Static::rescue(double size, StepReport& report) {
  if (options_.method != Method::either) return false;
  problem_->aim(size);
  return finish(relax(), size, report);
}

// Relaxation goes far at little accuracy, Newton the rest of the way; where it fails, relaxation goes on from
// where it stood.
solver::NewtonResult Static::relax() {
  solver::RelaxationOptions coarse;
  coarse.tolerance = std::max(options_.tolerance, 1e-3);
  solver::NewtonResult result = relaxation_->solve(*problem_, coarse);
  while (result.status == solver::NewtonStatus::converged && coarse.tolerance > options_.tolerance) {
    problem_->keep();
    auto polished = newton_->correct(*problem_, {options_.tolerance, kMany, options_.line_search});
    polished.iterations += result.iterations;
    if (polished.status == solver::NewtonStatus::converged) return polished;
    problem_->recall();
    coarse.tolerance = std::max(options_.tolerance, 1e-2 * coarse.tolerance);
    result = relaxation_->go_on(*problem_, coarse);
    result.iterations += polished.iterations;
  }
  return result;
}

bool Static::finish(const solver::NewtonResult& result, double end, StepReport& report) {
  last_ = result;
  report.iterations += last_.iterations;
  report.residuals = last_.residuals;
  report.negative_pivots = last_.negative_pivots;
  report.step = end - assembly_->state().time();
  report.time = end;
  const bool converged = last_.status == solver::NewtonStatus::converged;
  if (!converged) blame_ = find_blame();
  trial_time_ = converged ? end : assembly_->state().time();
  return converged;
}

// The Illinois variant of regula falsi on the step's size, each trial a full solve from the committed state.
void Static::land_on_event(double size, StepReport& report) {
  for (auto& event : events_) {
    event.fired = false;
    double high = event.value(*this), low = event.last;
    if (!std::isfinite(high))
      throw Error("event: field 'value': expected a finite number, got " + number(high));
    event.largest = std::max(event.largest, std::abs(low));
    const double tolerance = event.tolerance * event.largest;
    if (low == 0 || std::abs(low) <= tolerance || (low > 0) == (high > 0)) continue;
    double t_low = arc_ ? 0 : assembly_->state().time(), t_high = arc_ ? tried_length_ : size, value = high;
    int side = 0;
    for (int i = 0; i < 80 && std::abs(value) > tolerance; ++i) {
      const bool bisect = i % 8 == 7;
      const double t = bisect ? (t_low + t_high) / 2 : t_low + (t_high - t_low) * low / (low - high);
      if (!attempt(t, report)) give_up(report);
      value = event.value(*this);
      if ((value > 0) == (event.last > 0)) {
        t_low = t;
        low = value;
        if (side == -1) high /= 2;
        side = -1;
      } else {
        t_high = t;
        high = value;
        if (side == 1) low /= 2;
        side = 1;
      }
    }
    event.fired = true;
  }
}

void Static::commit(StepReport report) {
  const double damped = problem_->damping().on() ? problem_->damping().work() : 0;
  assembly_->state().commit(report.time);
  trial_time_ = report.time;
  problem_->committed();
  const double before = external_work_;
  add_external_work();
  damping_work_ += damped;
  problem_->damping().adapt(damped, external_work_ - before);
  grow(report);
  tell(report);
  reports_.push_back(std::move(report));
  run_hooks();
}

// From the iterations that the step took: a step that took many makes the next one smaller, one that took few
// lets it grow back to the largest.
void Static::grow(const StepReport& report) {
  const double iterations = std::max(1, last_.iterations);
  if (arc_) {
    const bool kink = std::any_of(kinks_.begin(), kinks_.end(), [&](double t) {
      return std::abs(t - report.time) <= kSameTime * options_.duration;
    });
    // A run may begin with a jump of its loads, whose direction says nothing about the path.
    if (kink || reports_.empty())
      arc_->forget();
    else
      arc_->committed();
    problem_->at_kink(kink);
    const double factor = std::clamp(std::sqrt(kWanted / iterations), 0.5, 1.5);
    longest_length_ = std::max(longest_length_, tried_length_);
    // A landing shortens a step for reasons of its own.
    const bool landed = std::abs(report.time - landing_) <= kSameTime * options_.duration;
    arc_length_ =
        factor * (landed && report.cuts == 0 ? std::max(tried_length_, arc_length_) : tried_length_);
    return;
  }
  if (relaxation_ && iterations > options_.max_iterations) return;  // relaxed: that says nothing of steps
  if (last_.iterations > kMany)
    current_step_ =
        std::max({0.5 * current_step_, options_.min_step, current_step_ * std::sqrt(kWanted / iterations)});
  else if (report.cuts == 0)
    current_step_ = std::min(largest_step_, current_step_ * std::clamp(2 * kWanted / iterations, 1.0, 2.0));
}

void Static::tell(const StepReport& report) {
  if (report.negative_pivots > 0 && !told_pivots_) {
    told_pivots_ = true;
    notices_->say("static: the tangent has " + std::to_string(report.negative_pivots) +
                  " negative pivots at time " + number(report.time) +
                  " s: a limit or bifurcation point has been passed");
  }
  if (damping_work_ > 0.01 * largest_external_work_ && !told_damping_) {
    told_damping_ = true;
    notices_->say("static: stabilisation has taken " + number(100 * damping_work_ / largest_external_work_) +
                  " % of the external work by time " + number(report.time) +
                  " s: smaller steps or a smaller 'stabilise' would take less");
  }
}

void Static::run_hooks() {
  for (auto& event : events_) event.last = event.value(*this);
  for (std::size_t i = 0; i < timed_.size(); ++i) {
    auto& timed = timed_[i];
    const double due = static_cast<double>(timed.count) * timed.interval;
    if (timed.interval > 0 && time() < due - kSameTime * options_.duration) continue;
    ++timed.count;
    const Hook hook = timed.hook;
    hook(*this);
  }
  for (std::size_t i = 0; i < events_.size(); ++i)
    if (events_[i].fired) {
      events_[i].fired = false;
      const Hook hook = events_[i].hook;
      if (hook) hook(*this);
    }
}

void Static::add_external_work() {
  const auto& state = std::as_const(*assembly_).state();
  const auto x = state.x();
  std::vector<double> force = problem_->external();
  for (std::size_t n = 0; n < state.nodes(); ++n) {
    const Vec3 r = assembly_->support_force(static_cast<assembly::Index>(n), problem_->external());
    for (int i = 0; i < 3; ++i) force[3 * n + i] += r[i];
  }
  for (std::size_t i = 0; i < previous_x_.size(); ++i)
    external_work_ += (previous_force_[i] + force[i]) / 2 * (x[i] - previous_x_[i]);
  largest_external_work_ = std::max(largest_external_work_, std::abs(external_work_));
  previous_x_.assign(x.begin(), x.end());
  previous_force_ = std::move(force);
}

}  // namespace fabricsh::analysis
