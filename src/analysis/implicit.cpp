#include "analysis/implicit.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/newmark.hpp"
#include "analysis/stiffness_damping.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "base/ordered_sum.hpp"
#include "tensor/node_view.hpp"

namespace fabricsh::analysis {

namespace {

NewmarkScheme scheme_of(const DynamicOptions& o) {
  NewmarkScheme s{o.gamma, o.beta.value_or(0.25 * (0.5 + o.gamma) * (0.5 + o.gamma)), o.hht};
  if (o.hht != 0) {  // [hilbert1977]
    s.gamma = 0.5 - o.hht;
    s.beta = (1 - o.hht) * (1 - o.hht) / 4;
  }
  return s;
}

StepControl control_of(const DynamicOptions& o) { return {o.step.value_or(o.duration / 200), 0, o.max_cuts}; }

}  // namespace

// What Newton sees of one step: forces, inertia and damping at the trial configuration.
class Implicit::Problem final : public solver::Problem {
 public:
  Problem(mechanics::Assembly& assembly, const DynamicOptions& options, bool scaled,
          const std::function<void()>& poll)
      : assembly_(assembly),
        poll_(poll),
        scheme_(scheme_of(options)),
        damping_(options.mass_damping),
        mass_(assembly.nodal_mass()),
        rotary_(assembly.rotary_inertia(scaled)),
        stiffness_(assembly, options.stiffness_damping),
        r_(assembly.unknowns()),
        product_(assembly.unknowns()),
        lead_(assembly.targets(0).size()) {}

  struct Memory {
    NodalMotion motion;                   // of the committed state
    std::vector<double> driven, balance;  // driven freedoms then; f_ext - f_int - C v then, per unknown
    std::vector<double> damping;          // b K_M v then, per unknown
    double peak = 0;                      // N, largest nodal force so far
    void keep(Archive& archive) { archive(motion, driven, balance, damping, peak); }
  };
  Memory memory;
  const NodalMotion& trial() const { return trial_; }
  const NewmarkScheme& scheme() const { return scheme_; }
  const std::vector<double>& external() const { return external_; }
  // J, lost to stiffness damping in the step, by the trapezoid.
  double stiffness_work() const {
    if (!stiffness_.on()) return 0;
    const auto before = assembly_.collect_rates(memory.motion.v), after = assembly_.collect_rates(trial_.v);
    double sum = 0;
    for (std::size_t i = 0; i < after.size(); ++i)
      sum += (memory.damping[i] + damping_force_[i]) / 2 * (before[i] + after[i]) / 2 * dt_;
    return sum;
  }

  // J, of f_ext - f_int - C v in the step, by the trapezoid.
  double balance_work() {
    const auto before = assembly_.collect_rates(memory.motion.v), after = assembly_.collect_rates(trial_.v);
    balance(0);
    double sum = 0;
    for (std::size_t i = 0; i < after.size(); ++i)
      sum += (memory.balance[i] + r_[i]) / 2 * (before[i] + after[i]) / 2 * dt_;
    return sum;
  }

  void aim(double time, double dt) {
    time_ = time;
    dt_ = dt;
    targets_ = assembly_.targets(time);
    assembly_.external(time, external_);
    assembly_.aim(time);
  }

  // The acceleration with which the run starts: M a = f; held and driven freedoms have none.
  void start(const mechanics::NodalRates& rates) {
    memory.driven = targets_;
    memory.motion.v = rates;
    const std::size_t n = mass_.size();
    memory.motion.a = {std::vector<double>(3 * n, 0), std::vector<double>(3 * n, 0)};
    trial_ = memory.motion;
    balance(0);
    // The mass on the unknowns, through ties: L^T M L.
    linear::Matrix M(assembly_.pattern());
    assembly_.add_diagonal(mass_, rotary_, M);
    std::vector<double> a(r_.size(), 0);
    const auto linear = linear::make_unsymmetric_solver();
    if (!a.empty() && !(linear->factorise(M) && linear->solve(M, r_, a)))
      throw NumericalFailure("dynamic: the mass of the unknowns is singular", 0);
    assembly_.spread_rates(a, std::vector<double>(lead_.size(), 0), memory.motion.a);
    committed();
  }

  void committed() {
    if (dt_ > 0) {
      memory.motion = trial_;
      memory.driven = targets_;
      drive();
    }
    balance(0);
    memory.balance = r_;
    memory.damping = damping_force_;
    memory.peak = std::max(memory.peak, force_scale());
  }

  solver::Index size() const override { return assembly_.unknowns(); }
  bool predict(linear::Matrix& K, std::span<double> r) override {
    assembly_.rollback();
    assembly_.begin_iterate();
    for (std::size_t i = 0; i < lead_.size(); ++i) lead_[i] = (targets_[i] - memory.driven[i]) / dt_;
    if (!stiffness_.start(lead_)) return false;
    for (double& l : lead_) l *= dt_;
    if (!assembly_.tangent(step(), K, lead_, product_)) return false;
    weigh(r);
    for (std::size_t i = 0; i < r.size(); ++i) r[i] -= (1 + scheme_.hht) * product_[i];
    add_inertia(K);
    return true;
  }
  void retract(std::span<const double> delta, double scale) override {
    assembly_.retract(delta, scale, targets_);
  }
  void accept() override { assembly_.begin_iterate(); }
  bool residual(std::span<double> r) override {
    if (poll_) poll_();
    if (!assembly_.forces(step())) return false;
    weigh(r);
    return true;
  }
  bool tangent(linear::Matrix& K) override {
    if (!assembly_.tangent(step(), K, {}, {})) return false;
    add_inertia(K);
    return true;
  }
  std::pair<double, solver::Index> largest(std::span<const double> r) const override {
    return assembly_.largest_residual(r);
  }
  double force_scale() const override {
    double inertia = 0;
    for (std::size_t i = 0; i < mass_.size(); ++i)
      for (int c = 0; c < 3; ++c) inertia = std::max(inertia, mass_[i] * std::abs(trial_.a.x[3 * i + c]));
    return std::max({memory.peak, assembly_.largest_force(), inertia});
  }
  double rounding_floor(const linear::Matrix& K) const override { return assembly_.rounding_floor(K); }

 private:
  fabric::Step step() const { return {time_ - dt_, dt_}; }
  // Driven displacements have the rate of their motion up to now: at a kink the formulas would ring.
  void drive() {
    const double h = 1e-3 * dt_;
    const auto earlier = assembly_.targets(time_ - h);
    const auto& motions = assembly_.freedoms().motions;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const auto& m = motions[i];
      if (m.component > 2) continue;
      const Vec3 along = assembly_.freedoms().nodes[m.node].frame.row(m.component).transpose();
      auto v = at(memory.motion.v.x, m.node), a = at(memory.motion.a.x, m.node);
      v += ((targets_[i] - earlier[i]) / h - v.dot(along)) * along;
      a -= a.dot(along) * along;
    }
  }
  // r_ = f_ext - f_int - C v - inertia M a on the unknowns.
  void balance(double inertia) {
    on_x_.resize(external_.size());
    on_d_.resize(external_.size());
    for (std::size_t i = 0; i < external_.size(); ++i) {
      on_x_[i] = external_[i] - mass_[i / 3] * (damping_ * trial_.v.x[i] + inertia * trial_.a.x[i]);
      on_d_[i] = -rotary_[i / 3] * (damping_ * trial_.v.d[i] + inertia * trial_.a.d[i]);
    }
    assembly_.residual(on_x_, r_, on_d_);
    if (!stiffness_.on()) return;
    stiffness_.force(assembly_.collect_rates(trial_.v), damping_force_);
    for (std::size_t i = 0; i < r_.size(); ++i) r_[i] -= damping_force_[i];
  }
  // r = (1 + alpha) f+ - alpha f - M a+.
  void weigh(std::span<double> r) {
    newmark_update(scheme_, dt_, std::as_const(assembly_).state(), memory.motion, trial_);
    const double alpha = scheme_.hht;
    balance(1 / (1 + alpha));
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = (1 + alpha) * r_[i] - alpha * memory.balance[i];
  }
  void add_inertia(linear::Matrix& K) {
    const double alpha = scheme_.hht;
    for (double& k : K.value) k *= 1 + alpha;
    stiffness_.add((1 + alpha) * scheme_.gamma / scheme_.beta / dt_, K);
    const double c = (1 / scheme_.beta / dt_ + (1 + alpha) * damping_ * scheme_.gamma / scheme_.beta) / dt_;
    std::vector<double> on_x = mass_, on_d = rotary_;
    for (double& m : on_x) m *= c;
    for (double& m : on_d) m *= c;
    assembly_.add_diagonal(on_x, on_d, K);
  }

  mechanics::Assembly& assembly_;
  const std::function<void()>& poll_;
  NewmarkScheme scheme_;
  double damping_, time_ = 0, dt_ = 0;
  const std::vector<double>&mass_, &rotary_;
  StiffnessDamping stiffness_;
  NodalMotion trial_;
  std::vector<double> damping_force_;
  std::vector<double> r_, product_, lead_, targets_, external_, on_x_, on_d_;
};

Implicit::Implicit(std::shared_ptr<model::Model> model, const DynamicOptions& options,
                   std::shared_ptr<Notices> notices)
    : Dynamic(std::move(model), options, std::move(notices)),
      problem_(std::make_unique<Problem>(*assembly_, options_, scaled_, poll_)),
      newton_(assembly_->symmetric() ? linear::make_symmetric_solver() : linear::make_unsymmetric_solver()),
      control_(control_of(options)) {
  now_.step = control_.current();
  const std::vector<double> still(3 * assembly_->reference().size(), 0);
  problem_->memory.motion = {{still, still}, {still, still}};
}

Implicit::~Implicit() = default;

void Implicit::take_options(const DynamicOptions& options) {
  const bool changed = options.step != options_.step || options.max_cuts != options_.max_cuts;
  options_ = options;
  if (changed) control_ = control_of(options_);
  now_.step = control_.current();
}

void Implicit::begin() {
  problem_->aim(0, 0);
  Dynamic::begin();
}

void Implicit::set_motion(const mechanics::NodalRates& rates) {
  // Held and tied nodes have no velocity of their own.
  mechanics::NodalRates possible;
  assembly_->spread_rates(assembly_->collect_rates(rates), driven_rates(), possible);
  problem_->start(possible);
}

double Implicit::try_step(double limit, StepReport& report) {
  double size = control_.end(committed_time(), next_landing(limit));
  const StepControl before = control_;
  tries_.clear();
  while (!attempt(size, report)) {
    if (++report.cuts > options_.max_cuts || !control_.cut(size - committed_time())) {
      control_ = before;  // a step that fails leaves nothing behind
      give_up(report);
    }
    size = control_.end(committed_time(), next_landing(limit));
  }
  return size;
}

bool Implicit::attempt(double size, StepReport& report) {
  const double now = committed_time();
  problem_->aim(size, size - now);
  last_ = newton_.solve(*problem_, {options_.tolerance, options_.max_iterations, options_.line_search});
  report.iterations += last_.iterations;
  report.residuals = last_.residuals;
  report.negative_pivots = last_.negative_pivots;
  report.step = size - now;
  report.time = size;
  const bool converged = tried_ = last_.status == solver::NewtonStatus::converged;
  if (!converged) {
    blame_ = find_blame(*assembly_, model_->mesh(), last_);
    tries_.push_back({report.step, last_.status, last_.residuals});
  }
  trial_time_ = converged ? size : now;
  return converged;
}

void Implicit::commit(StepReport& report) {
  tried_ = false;
  const auto& state = std::as_const(*assembly_).state();
  const NodalMotion before = problem_->memory.motion;
  const std::vector<double> driven_before = problem_->memory.driven;
  const auto& after = problem_->trial();
  const std::size_t n = 3 * state.nodes();
  const auto old = state.committed_kinematics();
  const auto& mass = assembly_->nodal_mass();
  const double damping = options_.mass_damping, kinetic_before = free_kinetic();
  double damped = 0, inertia = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double moved = state.x()[i] - old[i];
    damped += damping * mass[i / 3] * (before.v.x[i] + after.v.x[i]) / 2 * moved;
    inertia += mass[i / 3] * (before.a.x[i] + after.a.x[i]) / 2 * moved;
  }
  const auto& rotary = assembly_->rotary_inertia(scaled_);
  const auto old_d = old.subspan(n);
  for (std::size_t k = 0; k < state.nodes(); ++k) {
    const Vec3 from = at(old_d, k), to = at(state.d(), k), turned = carry(arc(from, to), from, to);
    damped += damping * rotary[k] * (carry(at(before.v.d, k), from, to) + at(after.v.d, k)).dot(turned) / 2;
    inertia += rotary[k] * (carry(at(before.a.d, k), from, to) + at(after.a.d, k)).dot(turned) / 2;
  }
  // What moves the driven freedoms overcomes their inertia and damping: its own account (see driven_work).
  for (const auto& m : assembly_->freedoms().motions) {
    if (m.component > 2) continue;
    const double moved = along(m, state.x()) - along(m, old), node_mass = mass[m.node];
    damped -= damping * node_mass * (along(m, before.v.x) + along(m, after.v.x)) / 2 * moved;
    inertia -= node_mass * (along(m, before.a.x) + along(m, after.a.x)) / 2 * moved;
  }
  now_.damping_work += damped + problem_->stiffness_work();
  const double balanced = options_.hht == 0 ? 0 : problem_->balance_work();
  dead_ = problem_->external();
  work_.add(*assembly_, dead_);
  assembly_->commit(report.time);
  problem_->committed();
  // Work of all forces, which the kinetic energy does not get. Under alpha the inertia is not the balance of
  // the forces at the step's end: their work in its place.
  if (damps())
    now_.damping_work += (options_.hht == 0 ? inertia : balanced) - (free_kinetic() - kinetic_before);
  watch_jump(driven_before, problem_->memory.driven, report.time, smallest_);
  control_.grow(last_.iterations, report.cuts > 0);
  now_.step = control_.current();
  ++now_.steps;
}

// Of a driven displacement's direction.
double Implicit::along(const mechanics::DrivenFreedom& m, std::span<const double> v) const {
  return assembly_->freedoms().nodes[m.node].frame.row(m.component).dot(at(v, m.node));
}

double Implicit::kinetic() const { return free_kinetic() + driven_kinetic(); }

// Without the displacements that are driven.
double Implicit::free_kinetic() const {
  const auto& v = rates();
  const auto &mass = assembly_->nodal_mass(), &rotary = assembly_->rotary_inertia(scaled_);
  double driven = 0;
  for (const auto& m : assembly_->freedoms().motions)
    if (m.component < 3) driven -= mass[m.node] * along(m, v.x) * along(m, v.x) / 2;
  return driven + ordered_sum(v.x.size(), [&](std::size_t i) {
           return (mass[i / 3] * v.x[i] * v.x[i] + rotary[i / 3] * v.d[i] * v.d[i]) / 2;
         });
}

const mechanics::NodalRates& Implicit::rates() const {
  return tried_ ? problem_->trial().v : problem_->memory.motion.v;
}

void Implicit::give_up(const StepReport& report) {
  const double now = committed_time();
  Failure failure;
  failure.time = now;
  failure.tries = tries_;
  failure.blame = blame_;
  failure.negative_pivots = last_.negative_pivots;
  failure.moved = farthest_move(*assembly_, now, now + (tries_.empty() ? 0 : tries_.front().step));
  failure.size = smallest_;
  if (const auto* woven = std::get_if<card::Woven>(&model_->card().law)) failure.tested = woven->tested;
  failure.dynamic = true;
  const std::string text = "dynamic: no step beyond time " + number(now) + " s: " + describe(last_.status) +
                           " in a step of " + number(report.step) + " s (the largest is " +
                           number(control_.largest()) + " s; " + std::to_string(report.cuts) + " tries)" +
                           describe(blame_, last_, options_.tolerance) +
                           ".\nTry: " + advice(failure).front() + ".";
  fail(NumericalFailure(text, now, blame_.element, blame_.yarn), analysis::report(failure));
}

void Implicit::memory(Archive& archive) {
  if (archive.reading()) {
    tried_ = false;
    problem_->aim(committed_time(), 0);
  }
  archive(now_, control_, problem_->memory);
  newton_.keep(archive);
}

}  // namespace fabricsh::analysis
