#include "run/problem.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "geometry/node_view.hpp"
#include "linear/linear_solver.hpp"
#include "mechanics/terms/tears.hpp"

namespace fabricsh::run {

EquilibriumProblem::EquilibriumProblem(mechanics::Assembly& assembly, mechanics::Motion* motion,
                                       Newmark* newmark, double small_time, const Poll& poll)
    : assembly_(assembly),
      motion_(motion == nullptr ? still_ : *motion),
      newmark_(newmark),
      poll_(poll),
      small_time_(small_time),
      lead_(assembly.dofs().targets(0).size()) {
  assembly_.set_motion(&motion_);
  resize();
}

void EquilibriumProblem::resize() {
  if (iterates())
    for (auto* v : {&product_, &ahead_, &balance_})
      v->assign(static_cast<std::size_t>(assembly_.dofs().unknowns()), 0);
  memory_.balance.clear();
  memory_.before.clear();
  memory_.earlier.clear();
  lumped_.clear();
}

EquilibriumProblem::EquilibriumProblem(mechanics::Assembly& assembly, double small_time, const Poll& poll)
    : EquilibriumProblem(assembly, nullptr, nullptr, small_time, poll) {
  assembly.terms().external(0, external_);  // a history that is not finite is refused before the run begins
}
EquilibriumProblem::EquilibriumProblem(mechanics::Assembly& assembly, Newmark& newmark, const Poll& poll)
    : EquilibriumProblem(assembly, &newmark, &newmark, 0, poll) {}
EquilibriumProblem::EquilibriumProblem(mechanics::Assembly& assembly, mechanics::Motion& motion,
                                       const Poll& poll)
    : EquilibriumProblem(assembly, &motion, nullptr, 0, poll) {}

// --- steps

void EquilibriumProblem::set_time(double time) {
  trial_time_ = time;
  motion_.set_dt(time - std::as_const(assembly_).state().time());
  targets_ = assembly_.dofs().targets(time);
  if (external_.empty() || !assembly_.terms().constant_loads()) assembly_.terms().external(time, external_);
  assembly_.set_time(time);
}

void EquilibriumProblem::start() {
  memory_.driven = targets_;
  remember();
}

void EquilibriumProblem::start(const mechanics::NodalRates& velocities) {
  newmark_->start(velocities);
  memory_.before.clear();
  memory_.earlier.clear();
  balance(0, 0, balance_);
  newmark_->set_accelerations(accelerations(balance_));
  start();
}

// Of all nodes, from forces on the unknowns: M a = r with the mass matrix on the unknowns, with ties L^T M L.
mechanics::NodalRates EquilibriumProblem::accelerations(std::span<const double> r) {
  linear::Matrix M(assembly_.pattern());
  assembly_.add_diagonal(newmark_->inertia().mass(), newmark_->inertia().rotary(), M);
  std::vector<double> a(r.size(), 0);
  // Ties alone couple unknowns here: the pattern of the tangent would make factors of its size.
  const linear::Matrix few = linear::without_zeros(M);
  const auto linear = linear::make_symmetric_solver();
  if (!a.empty() && !(linear->factorise(few) && linear->solve(few, r, a)))
    throw NumericalFailure("dynamic: the mass of the unknowns is singular", 0);
  mechanics::NodalRates accelerations;
  assembly_.dofs().spread_rates(a, std::vector<double>(lead_.size(), 0), accelerations);
  return accelerations;
}

void EquilibriumProblem::commit(double time) {
  if (newmark_ != nullptr) look_back();
  assembly_.commit(time);
  if (newmark_ != nullptr) {
    newmark_->commit();
    forget_step_end();
  }
  memory_.driven = targets_;
  remember();
}

std::vector<double> EquilibriumProblem::places(mechanics::OwnUnknowns::Places which) const {
  const auto& state = std::as_const(assembly_).state();
  const auto nodes = which == mechanics::OwnUnknowns::Places::after
                         ? state.x()
                         : state.committed_kinematics().first(3 * state.nodes());
  std::vector<double> x(nodes.begin(), nodes.end());
  for (const auto* const term : assembly_.terms().all<mechanics::OwnUnknowns>()) term->add_places(which, x);
  return x;
}

// Remembers the places before the step.
void EquilibriumProblem::look_back() {
  memory_.earlier = std::exchange(memory_.before, places(mechanics::OwnUnknowns::Places::before));
  memory_.step_before = std::exchange(memory_.last_step, motion_.dt());
}

// The way from these places in the step, along the parabola through the last three, or, where these are not
// known, with the velocities and accelerations. Returns how far a smooth motion is off then, in dt^3 times
// the third derivative of the places.
double EquilibriumProblem::goes_on(std::span<const double> from, std::vector<double>& way) const {
  const double dt = motion_.dt();
  if (memory_.earlier.size() != from.size()) {
    const auto& motion = newmark_->committed();
    way = places(mechanics::OwnUnknowns::Places::ahead);
    for (std::size_t i = 0; i < motion.v.x.size(); ++i)
      way[i] = dt * (motion.v.x[i] + dt / 2 * motion.a.x[i]);
    for (std::size_t i = motion.v.x.size(); i < way.size(); ++i) way[i] -= from[i];
    return 1.0 / 6;
  }
  const double h = memory_.last_step, both = h + memory_.step_before;
  const double first = dt * (dt + both) / (h * (h - both)), second = dt * (dt + h) / (both * (both - h));
  way.resize(from.size());
  for (std::size_t i = 0; i < way.size(); ++i)
    way[i] = first * (memory_.before[i] - from[i]) + second * (memory_.earlier[i] - from[i]);
  return (dt + h) * (dt + both) / (6 * dt * dt);
}

// A scheme of second order is off by a known part of the difference from the parabola, one of the first order
// by nearly all of it.
double EquilibriumProblem::error_of_step() const {
  const std::size_t n = 3 * std::as_const(assembly_).state().nodes();
  const auto old = places(mechanics::OwnUnknowns::Places::before);
  const auto now = places(mechanics::OwnUnknowns::Places::after);
  mechanics::NodalRates off{{}, std::vector<double>(n)};
  const double parabola = goes_on(old, off.x);
  for (std::size_t i = 0; i < old.size(); ++i) off.x[i] = now[i] - old[i] - off.x[i];
  double largest = 0, of_bodies = 0;
  for (std::size_t i = n; i < off.x.size(); ++i) of_bodies = std::max(of_bodies, std::abs(off.x[i]));
  off.x.resize(n);
  const auto unknowns = assembly_.dofs().collect_rates(off);
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    if (!assembly_.dofs().turns(static_cast<mechanics::Index>(i)))
      largest = std::max(largest, std::abs(unknowns[i]));
  for (const auto& body : assembly_.dofs().freedoms().bodies)
    for (const auto node : body.nodes) of_bodies = std::max(of_bodies, at(off.x, node).cwiseAbs().maxCoeff());
  const auto& scheme = newmark_->scheme();
  const double own = std::abs(1.0 / 6 - scheme.beta + scheme.hht / 2), midpoint = 1.0 / 12;
  if (std::abs(scheme.gamma + scheme.hht - 0.5) < 1e-9) largest *= own / (own + parabola);
  if (scheme.late == 0.5) of_bodies *= midpoint / (midpoint + parabola);
  return std::max(largest, of_bodies);
}

// A step has some forces at its end alone: the next one begins without them.
void EquilibriumProblem::forget_step_end() {
  const auto terms = assembly_.terms().all<mechanics::AtStepEnd>();
  if (std::none_of(terms.begin(), terms.end(), [](const auto* term) { return term->acts(); })) return;
  const double weight = newmark_->scheme().weight_at_end(),
               impulse = newmark_->scheme().missing_at_end() / weight * motion_.dt();
  std::vector<double> without(balance_.size()), push(balance_.size());
  balance(0, 0, without);
  balance(0, weight, push);
  for (std::size_t i = 0; i < push.size(); ++i) push[i] -= without[i];
  if (assembly_.dofs().has_ties()) return newmark_->take_off(accelerations(push), impulse);
  if (lumped_.empty()) lumped_ = assembly_.lumped_mass(false);
  for (std::size_t i = 0; i < push.size(); ++i) push[i] /= lumped_[i];
  mechanics::NodalRates accelerations;
  assembly_.dofs().spread_rates(push, std::vector<double>(lead_.size(), 0), accelerations);
  newmark_->take_off(accelerations, impulse);
}

// Stores the data of this step that the next one needs, for example to recognise a reversal.
void EquilibriumProblem::remember() {
  if (!iterates()) return;
  if (newmark_ != nullptr) {
    balance(0, 0, balance_);
    remember_bodies();
    memory_.balance = balance_;
  } else {
    memory_.lead = lead_;
    memory_.push = push_;
    memory_.external = external_;
  }
  memory_.peak = force_scale();
}

// Stores the forces F^ of the step, of which the first one has no earlier.
void EquilibriumProblem::remember_bodies() {
  const double alpha = newmark_->scheme().hht;
  const auto& before = memory_.balance.empty() ? balance_ : memory_.balance;
  memory_.on_bodies.clear();
  for (const auto& body : assembly_.dofs().freedoms().bodies)
    for (auto i = static_cast<std::size_t>(body.equation); i < static_cast<std::size_t>(body.equation) + 6;
         ++i)
      memory_.on_bodies.push_back((1 + alpha) * balance_[i] - alpha * before[i]);
}

void EquilibriumProblem::keep(Archive& archive) {
  archive(memory_);
  if (archive.reading()) set_time(std::as_const(assembly_).state().time());
}

law::Step EquilibriumProblem::step(law::AtSwitch at) const {
  const double now = std::as_const(assembly_).state().time();
  return {now, trial_time_ - now, at};
}

Answer EquilibriumProblem::begin_step() { return made(assembly_.begin_step()); }

// --- forces

// f_ext - f_int - C v - inertia M a on the unknowns, with the forces of step ends (AtStepEnd) `at_end` times.
void EquilibriumProblem::balance(double inertia, double at_end, std::span<double> r) {
  if (newmark_ == nullptr) {
    assembly_.residual(external_, r);
  } else {
    const auto on = assembly_.terms().on_mass();
    const auto& motion = newmark_->trial();
    const auto &mass = newmark_->inertia().mass(), &rotary = newmark_->inertia().rotary();
    const double part = inertia * on.acceleration;
    on_x_.resize(external_.size());
    on_d_.resize(external_.size());
    const auto& freedoms = assembly_.dofs().freedoms();
    for (std::size_t i = 0; i < external_.size(); ++i) {
      const double own = freedoms.body(static_cast<mechanics::Index>(i / 3)) < 0 ? part : 0;
      on_x_[i] = external_[i] - mass[i / 3] * (on.velocity * motion.v.x[i] + own * motion.a.x[i]);
      on_d_[i] = -rotary[i / 3] * (on.velocity * motion.v.d[i] + own * motion.a.d[i]);
    }
    // A rigid body takes the impulse of such a force by gamma; its way follows from its velocities.
    const double missing = newmark_->scheme().missing_at_end();
    const double on_body = at_end == 0 || missing == 0 ? at_end : at_end / (1 - missing);
    for (const auto* const term : assembly_.terms().all<mechanics::AtStepEnd>()) {
      if (at_end == 1) break;
      const auto forces = term->nodal_forces();
      for (std::size_t n = 0; n < forces.size(); ++n) {
        const double times = freedoms.body(static_cast<mechanics::Index>(n)) < 0 ? at_end : on_body;
        at(on_x_, n) += (times - 1) * forces[n];
      }
    }
    assembly_.residual(on_x_, r, on_d_);
  }
}

// The residual of the scheme; for Newmark (1 + alpha) f+ - alpha f - M a+.
void EquilibriumProblem::weigh(std::span<double> r) {
  if (newmark_ == nullptr) return balance(0, 1, r);
  newmark_->update();
  const double alpha = newmark_->scheme().hht;
  balance(1 / (1 + alpha), newmark_->weight_at_step_end(), r);
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = (1 + alpha) * r[i] - alpha * memory_.balance[i];
  move_bodies(r);
}

// The inertia of rigid bodies, see newmark.hpp; r has the forces F^+ on their unknowns.
void EquilibriumProblem::move_bodies(std::span<double> r) {
  const auto& bodies = assembly_.dofs().freedoms().bodies;
  const double gamma = newmark_->scheme().gamma, on = assembly_.terms().on_mass().acceleration;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto rate = newmark_->rate_of_momentum(bodies[b]);
    for (std::size_t i = 0; i < rate.size(); ++i) {
      double& force = r[static_cast<std::size_t>(bodies[b].equation) + i];
      force += ((1 - gamma) * memory_.on_bodies[6 * b + i] - on * rate[i]) / gamma;
    }
  }
}

// The tangent of the scheme from that of the forces: weighted, with damping and inertia.
void EquilibriumProblem::close(linear::Matrix& K) {
  if (weight() != 1) K.scale(weight());
  assembly_.terms().add_resistance(assembly_.trial(), K);
  if (newmark_ == nullptr) return;
  const auto& scheme = newmark_->scheme();
  const auto on = assembly_.terms().on_mass();
  const double dt = motion_.dt();
  add_mass(K, (on.acceleration / scheme.beta / dt + weight() * on.velocity * scheme.gamma / scheme.beta) / dt,
           (on.acceleration / scheme.gamma / dt + weight() * on.velocity) / scheme.late / dt);
}

void EquilibriumProblem::add_inertia(linear::Matrix& K, double times) {
  if (newmark_ == nullptr) return;
  const double dt = motion_.dt(), part = times * assembly_.terms().on_mass().acceleration / dt / dt;
  const auto& scheme = newmark_->scheme();
  add_mass(K, part / scheme.beta, part / scheme.late / scheme.gamma);
}

// The mass matrix c times, that of rigid bodies of_body times.
void EquilibriumProblem::add_mass(linear::Matrix& K, double c, double of_body) {
  std::vector<double> on_x = newmark_->inertia().mass(), on_d = newmark_->inertia().rotary();
  for (std::size_t n = 0; n < on_x.size(); ++n) {
    const double factor =
        assembly_.dofs().freedoms().body(static_cast<mechanics::Index>(n)) < 0 ? c : of_body;
    on_x[n] *= factor;
    on_d[n] *= factor;
  }
  assembly_.add_diagonal(on_x, on_d, K);
}

double EquilibriumProblem::work_of_balance() {
  balance(0, 0, balance_);
  double work = motion_.work(memory_.balance, balance_);
  for (const auto* const term : assembly_.terms().all<mechanics::AtStepEnd>()) work += term->work_on_cloth();
  return work;
}

double EquilibriumProblem::force_scale() const {
  double largest = std::max(memory_.peak, assembly_.largest_force());
  for (const auto* const term : assembly_.terms().all<mechanics::OwnUnknowns>())
    largest = std::max(largest, term->largest_own_force());
  if (newmark_ == nullptr) return largest;
  return std::max(largest, newmark_->largest_inertia());
}

// --- Newton

void EquilibriumProblem::return_to_commit() {
  assembly_.rollback();
  assembly_.begin_iterate();
  arrived_ = memory_.driven;
}

// Sets the increments of the driven degrees of freedom in the step.
void EquilibriumProblem::lead_to_targets() {
  for (std::size_t i = 0; i < lead_.size(); ++i) lead_[i] = targets_[i] - memory_.driven[i];
  if (newmark_ == nullptr) return;
  // The step begins with the motion of its beginning, whatever was tried before.
  const NodalMotion before = newmark_->committed();
  newmark_->start(before.v);
  newmark_->set_accelerations(before.a);
  // The rates of the driven freedoms at its end, from its last part alone: a kink lies at its beginning.
  const double h = 1e-3 * motion_.dt();
  auto rates = assembly_.dofs().targets(trial_time_ - h);
  for (std::size_t i = 0; i < rates.size(); ++i) rates[i] = (targets_[i] - rates[i]) / h;
  newmark_->drive(std::move(rates));
}

Answer EquilibriumProblem::predict(linear::Matrix& K, std::span<double> r, std::span<double> lead) {
  return_to_commit();
  lead_to_targets();
  if (newmark_ == nullptr) set_push(external_, memory_.external);
  const bool turns = newmark_ == nullptr && reverses();
  if (const Answer answer = begin_step(); answer != Answer::ok) return answer;
  const auto at = turns ? law::AtSwitch::unloading : law::AtSwitch::loading;
  const auto branches = has_branches() ? mechanics::Cloth::Branches::anew : mechanics::Cloth::Branches::own;
  if (!tangent_with(branches, step(at), K, lead_, product_)) return made(false);
  weigh(r);
  for (std::size_t i = 0; i < r.size(); ++i) lead[i] = -(weight() * product_[i]);
  close(K);
  return Answer::ok;
}

Answer EquilibriumProblem::residual(std::span<double> r) {
  if (poll_) poll_();
  if (!assembly_.forces(step())) return made(false);
  weigh(r);
  return Answer::ok;
}

Answer EquilibriumProblem::tangent(linear::Matrix& K) {
  if (!assembly_.tangent(step(), K, {}, {})) return made(false);
  close(K);
  return Answer::ok;
}

double EquilibriumProblem::turn_of(std::span<const double> delta) const {
  mechanics::NodalRates way;
  assembly_.dofs().spread_rates(delta, std::vector<double>(lead_.size(), 0), way);
  return assembly_.cloth().readings().largest_turn(way);
}

bool EquilibriumProblem::tangent_with(mechanics::Cloth::Branches branches, const law::Step& step,
                                      linear::Matrix& K, std::span<const double> lead,
                                      std::span<double> product) {
  auto& cloth = *assembly_.terms().find<mechanics::Cloth>();
  cloth.take_branches(branches);
  const bool done = assembly_.tangent(step, K, lead, product, branches == mechanics::Cloth::Branches::kept);
  cloth.take_branches(mechanics::Cloth::Branches::own);
  return done;
}

Answer EquilibriumProblem::tangent_on_branches(linear::Matrix& K, std::span<double> r) {
  // Bodies that have gone a part of their way lead the cloth on the rest of it.
  const std::span<double> led = at_target() ? std::span<double>() : product_;
  if (!tangent_with(mechanics::Cloth::Branches::kept, step(), K, {}, led)) return made(false);
  weigh(r);
  for (std::size_t i = 0; i < led.size(); ++i) r[i] -= weight() * led[i];
  close(K);
  return Answer::ok;
}

Answer EquilibriumProblem::extrapolated_tangent(linear::Matrix& K) {
  if (!assembly_.tangent(step(), K, {}, {}, true)) return made(false);
  close(K);
  return Answer::ok;
}

// --- path following

Answer EquilibriumProblem::start(linear::Matrix& K, std::span<double> r, std::span<double> q) {
  return_to_commit();
  look_ahead();
  const auto at = memory_.kink && reverses() ? law::AtSwitch::unloading : law::AtSwitch::loading;
  const Answer answer = tangent_and_rate(at, K, q);
  if (answer == Answer::ok) assembly_.residual(external_, r);
  return answer;
}

Answer EquilibriumProblem::tangent_and_rate(linear::Matrix& K, std::span<double> q) {
  look_ahead();
  return tangent_and_rate(law::AtSwitch::loading, K, q);
}

double EquilibriumProblem::opening(std::span<const double> way) const {
  const auto* const tears = assembly_.terms().find<mechanics::Tears>();
  if (tears == nullptr || !tears->opens()) return 0;
  const auto& dofs = assembly_.dofs();
  mechanics::NodalRates moved;
  const std::vector<double> still(targets_.size(), 0.0);
  dofs.spread_rates(way, still, moved);
  return tears->opening(moved);
}

double EquilibriumProblem::product(std::span<const double> a, std::span<const double> b) const {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!assembly_.dofs().turns(static_cast<mechanics::Index>(i))) sum += a[i] * b[i];
  return sum;
}

void EquilibriumProblem::set_push(const std::vector<double>& to, const std::vector<double>& from) {
  push_.resize(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) push_[i] = to[i] - from[i];
}

// The changes of supports and dead loads within a small time after the trial time.
void EquilibriumProblem::look_ahead() {
  const double later = trial_time_ + small_time_;
  const auto moved = assembly_.dofs().targets(later);
  for (std::size_t i = 0; i < lead_.size(); ++i) lead_[i] = moved[i] - targets_[i];
  assembly_.terms().external(later, later_external_);
  set_push(later_external_, external_);
}

// K and q = dr/dt at fixed unknowns. Coupling with the driven freedoms comes from the tangent, the rate of
// follower loads from a difference of forces. Leaves the forces of the trial time.
Answer EquilibriumProblem::tangent_and_rate(law::AtSwitch at, linear::Matrix& K, std::span<double> q) {
  const auto& terms = assembly_.terms();  // the cloth is the first
  const auto loads = terms.all<mechanics::FollowerLoad>();
  const bool follower =
      std::any_of(terms.begin() + 1, terms.end(), [](const auto& t) { return !t->symmetric(); }) ||
      std::any_of(loads.begin(), loads.end(), [](const auto* load) { return load->follows_positions(); });
  if (follower) {
    assembly_.set_time(trial_time_ + small_time_);
    const bool done = assembly_.forces(step(at));
    assembly_.residual(later_external_, ahead_);
    assembly_.set_time(trial_time_);
    if (!done) return made(false);
  }
  if (!assembly_.tangent(step(at), K, lead_, product_)) return made(false);
  if (!follower) assembly_.residual(later_external_, ahead_);
  assembly_.residual(external_, q);
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = (ahead_[i] - q[i] - product_[i]) / small_time_;
  return Answer::ok;
}

// Whether this step moves supports and loads in the opposite direction to the last one.
bool EquilibriumProblem::reverses() const {
  double along = 0;
  for (std::size_t i = 0; i < memory_.lead.size(); ++i) along += memory_.lead[i] * lead_[i];
  for (std::size_t i = 0; i < memory_.push.size(); ++i) along += memory_.push[i] * push_[i];
  return along < 0;
}

}  // namespace fabricsh::run
