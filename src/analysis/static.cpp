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
}

}  // namespace

Static::Static(std::shared_ptr<model::Model> model, const StaticOptions& options,
               std::shared_ptr<Notices> notices)
    : model_(std::move(model)), options_(options), notices_(std::move(notices)) {
  check(options_);
  model_->validate();
  assembly_ = std::make_unique<assembly::Assembly>(*model_);
  model_->seal();
  problem_ = std::make_unique<Problem>(*assembly_);
  newton_ = std::make_unique<solver::Newton>(solver::make_unsymmetric_solver(), assembly_->pattern());
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

double Static::plan(double limit) const {
  const double landing = next_landing(limit), left = landing - time();
  const double steps = std::ceil(left / current_step_ - 1e-9);
  return steps <= 1 ? landing : time() + left / steps;
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
  double target = plan(limit);
  while (!attempt(target, report)) {
    if (++report.cuts > options_.max_cuts) give_up(report);
    current_step_ = (target - assembly_->state().time()) / 2;
    target = plan(limit);
  }
  land_on_event(target, report);
  commit(std::move(report));
}

bool Static::attempt(double target, StepReport& report) {
  problem_->aim(target);
  last_ = newton_->solve(*problem_, {options_.tolerance, options_.max_iterations, options_.line_search});
  report.iterations += last_.iterations;
  report.residuals = last_.residuals;
  report.step = target - assembly_->state().time();
  report.time = target;
  const bool converged = last_.status == solver::NewtonStatus::converged;
  if (!converged) assembly_->state().rollback();
  trial_time_ = converged ? target : assembly_->state().time();
  return converged;
}

// The Illinois variant of regula falsi on the step's end time, each trial a full Newton solve from the
// committed state.
bool Static::land_on_event(double target, StepReport& report) {
  for (auto& event : events_) {
    event.fired = false;
    double high = event.value(*this), low = event.last;
    if (!std::isfinite(high))
      throw Error("event: field 'value': expected a finite number, got " + number(high));
    event.largest = std::max(event.largest, std::abs(low));
    const double tolerance = event.tolerance * event.largest;
    if (low == 0 || std::abs(low) <= tolerance || (low > 0) == (high > 0)) continue;
    double t_low = assembly_->state().time(), t_high = target, value = high;
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
  return true;
}

void Static::commit(StepReport report) {
  assembly_->state().commit(report.time);
  trial_time_ = report.time;
  problem_->committed();
  add_external_work();
  if (report.cuts == 0 && report.iterations <= 12) current_step_ = std::min(largest_step_, 2 * current_step_);
  reports_.push_back(std::move(report));
  run_hooks();
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

void Static::give_up(const StepReport& report) const {
  const double now = assembly_->state().time();
  std::ostringstream text;
  text.precision(6);
  text << "static: no step beyond time " << now << " s: " << solver::describe(last_.status)
       << " in a step of " << report.step << " s after " << report.cuts - 1 << " halvings";
  assembly::Index element = assembly_->failed_element();
  if (last_.worst >= 0) {
    element = assembly_->element_of_unknown(last_.worst);
    text << "; the residual " << (last_.residuals.empty() ? 0 : last_.residuals.back()) << " (tolerance "
         << options_.tolerance << ") sits at node " << assembly_->node_of_unknown(last_.worst) + 1;
  }
  std::string yarn;
  if (element >= 0) {
    text << ", element " << element + 1;
    yarn = switching_yarn(element);
    if (!yarn.empty()) text << ", where the " << yarn << " is switching";
  }
  text << ".\nTry: a smaller step, supports that leave no part free to move (the out-of-plane of a slack "
          "sheet), or a larger "
          "tolerance.";
  throw NumericalFailure(text.str(), now, element, yarn);
}

}  // namespace fabricsh::analysis
