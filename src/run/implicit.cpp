#include "run/implicit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/box.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/contact.hpp"
#include "run/flat.hpp"

namespace fabricsh::run {

namespace {

// The directors of a joint that opens in a bent sheet lose what balanced them, and no step resolves how they
// turn back. With Euler's backward rule, theta = 1, the two eigenvalues of what is much faster than the steps
// are zero [hughes2000]: after two steps nothing of it is left.
constexpr double kSettling = 1;
constexpr int kSettlingSteps = 2;
// Far from the way it then stands, a director can end a long step on the wrong side. That makes energy, which
// the rule never does; the step is repeated at half its size, so many times.
constexpr int kSettlingHalvings = 12;

// A support whose speed jumps, as that of a ramp does at its start and end, sends a wave into the cloth that
// no step resolves, and average acceleration and alpha carry it on with a multiple of its energy. So many
// steps behind the corner follow Euler's backward rule [rannacher1984], where the whole cloth with that jump
// of speed would have more than this share of the run's energies.
constexpr int kCornerSteps = 2;
constexpr double kCorner = 0.1;
// Where a stiff strip turns within a step, forces that alpha averages over it still make energy; those at the
// step's end do not. Leaves a third of the amplitude of what no step resolves after a step.
constexpr double kStrongGamma = 1;
// Share of the ledger's limit from which on hht, the rule beside contact, or that, is not enough.
constexpr double kTooMuch = 0.2;
// Contact acts at the step's end, the tension of cloth over a curve as a mean. On cloth that slides by the
// angle a in a step their sum pushes it on, (1 - theta) a times its tension. All forces at the end do not.
constexpr double kBackward = 1;
// A step whose error is more than this share of the ledger's limit is repeated at half its size, so many
// times.
constexpr double kErrorOfStep = 0.1;
constexpr int kMostHalvings = 3;
// Of the energy that a driven step makes: what half of it makes at most if that error is one of the step's
// size. It falls with the cube of the size, and more slowly where yarns switch.
constexpr double kFallsByHalf = 0.4;
// Strong damping takes energy of a turning, too, in each turn four times pi squared over the steps in it.
// Where the cloth turns by more than this in a step, 400 steps a turn, shorter steps go first; then by
// halves, down to a part of it.
constexpr double kTurn = 2 * std::numbers::pi / 400, kFurther = 4;
// Without damping, too, forces that are averaged over a turn make energy of it where stiff cloth turns
// further in a step: energy and angular momentum hold to some thousandths with a hundred steps a turn, and
// are lost with half as many. Where yarns switch between branches that takes half as many steps again.
constexpr double kStepsPerTurn = 100, kStepsWithKinks = 150;
constexpr double kTurning = 0.9;  // of the kinetic energy about the centre of mass
// With an error asked for: the part of the step that would just do, and the least and the most that one step
// is of the one before.
constexpr double kSafe = 0.9, kShrink = 0.2, kGrow = 2;
// Yarns of a cloth at rest switch between branches within any step. A residual that still is within so many
// tolerances when the iterations are over is of such, and shorter steps would not change it.
constexpr double kStanding = 100;

// With the modes of Newmark's method for gamma and the beta that damps most.
NewmarkScheme damping_by(double gamma, bool bodies_too = true) {
  return NewmarkScheme::trapezoidal((0.5 + gamma) / 2, bodies_too);
}

// The radius beside contact of a deck that chooses no scheme. Average acceleration would keep what buckles
// within a step on its saddle, and make energy where yarns or pairs switch.
constexpr double kBesideContact = 0.9;

bool has_contact(const mechanics::Assembly& assembly) {
  return assembly.terms().find<mechanics::Contacts>() != nullptr;
}

bool chooses_none(const DynamicOptions& o) {
  return !o.hht && !o.beta && !o.spectral_radius && o.gamma == 0.5;
}

double radius_of(const DynamicOptions& o, const mechanics::Assembly& assembly) {
  if (o.spectral_radius || !has_contact(assembly)) return o.spectral_radius.value_or(1);
  if (const double hht = o.hht.value_or(0); hht != 0) return (1 + hht) / (1 - hht);
  return chooses_none(o) && !o.error ? kBesideContact : 1;
}

// Hilbert, Hughes and Taylor's alpha has radii from 1/2 on and is of second order; below that only the
// generalised trapezoidal rule has, down to Euler's backward rule. Alpha's beta is not gamma / 2, so that
// contact would make a velocity of what a load changes in a step: beside it that rule has all radii. Bodies,
// whose forces all come at once, follow it at any radius that a deck asks for.
NewmarkScheme scheme_of_radius(double radius, bool contact, bool bodies_too) {
  const double theta = 1 / (1 + radius);
  if (radius < 0.5 || contact) return NewmarkScheme::trapezoidal(theta, bodies_too);
  auto scheme = NewmarkScheme::of_hht(-(1 - radius) / (1 + radius));
  scheme.late = theta;
  return scheme;
}

NewmarkScheme scheme_of(const DynamicOptions& o, const mechanics::Assembly& assembly) {
  if (const double radius = radius_of(o, assembly); radius < 1)
    return scheme_of_radius(radius, has_contact(assembly), !chooses_none(o));
  const double hht = o.hht.value_or(0);
  if (hht != 0) return NewmarkScheme::of_hht(hht);
  return o.beta ? NewmarkScheme::of_newmark(o.gamma, *o.beta) : damping_by(o.gamma);
}

// The forces of contact work in a step against velocities, those of the cloth against accelerations. In
// Newmark's method with more than the least beta the two mix, and contact could make energy.
void check_contact(const DynamicOptions& o, const mechanics::Assembly& assembly) {
  if (!o.beta || *o.beta == o.gamma / 2 || !has_contact(assembly)) return;
  throw Error("dynamic: field 'beta': expected none beside contact, or gamma/2 = " + number(o.gamma / 2) +
              ", got " + number(*o.beta) +
              ", with which contact makes energy (gamma alone damps there, too)");
}

double steps_per_turn(const model::Model& model) {
  for (const auto& section : model.sections())
    for (const auto& point : section.points)
      if (point.law->kind != law::CompiledKind::elastic) return kStepsWithKinks;
  return kStepsPerTurn;
}

StepControl control_of(const DynamicOptions& o, const mechanics::Assembly& assembly) {
  const double usual = o.duration / (o.error ? 20 : 200);
  return {o.step.value_or(usual), 0, o.max_cuts,
          has_contact(assembly) ? kContactIterations : kMotionIterations};
}

}  // namespace

Implicit::Implicit(std::shared_ptr<model::Model> model, const DynamicOptions& options,
                   std::shared_ptr<Notices> notices, const Beginning& beginning)
    : Dynamic(std::move(model), options, std::move(notices), beginning),
      newmark_(*assembly_, *inertia_, scheme_of(options_, *assembly_)),
      problem_(*assembly_, newmark_, poll_),
      newton_(make_solver(options_.solver, !takes_unsymmetric(), is_near_symmetric())),
      control_(control_of(options, *assembly_)) {
  radius_ = radius_of(options_, *assembly_);
  // Damping by stiffness multiplies its matrix, and a solver of one's own may read all of it.
  if (!takes_unsymmetric() && !(options_.stiffness_damping > 0) && !options_.solver) assembly_->keep_upper();
  if (is_near_symmetric()) assembly_->keep_apart();
  check_contact(options_, *assembly_);
  weigh_step_ends();
  take_beginning();
  report_contacts();
  now_.step = control_.current();
  extent_ = box_of(assembly_->dofs().reference()).size().norm();
  begin_free();
}

// So that velocities and kinetic energy can be read before the first step.
void Implicit::begin_free() {
  mechanics::NodalRates free;
  assembly_->dofs().spread_rates(assembly_->dofs().collect_rates(initial_rates()),
                                 std::vector<double>(assembly_->dofs().freedoms().motions.size(), 0), free);
  newmark_.start(free);
}

// The nodes keep their velocities but where joints close. Accelerations jump with the forces, but those of
// directors that a joint no longer balances would throw them far beyond where they come to rest: while these
// settle, the steps go on from the accelerations of before.
void Implicit::take(const mechanics::Transfer& change, const std::vector<double>& rates) {
  if (!started()) return begin_free();
  mechanics::NodalRates velocities = newmark_.velocities();
  if (change.closes()) assembly_->dofs().spread_rates(rates, driven_rates(), velocities);
  problem_.set_time(committed_time());
  if (problem_.begin_step() != Answer::ok)
    throw NumericalFailure("dynamic: the fabric law failed where joints changed", committed_time());
  mechanics::NodalRates before = newmark_.committed().a;
  problem_.start(velocities);
  if (change.closes() || !has_turning_directors()) return;
  newmark_.set_accelerations(std::move(before));
  now_.settling = kSettlingSteps;
  now_.settles = std::max(now_.settles, committed_time() + (kSettlingSteps - 0.5) * control_.current());
  now_.surplus = energy().surplus();
  take_scheme();
}

bool Implicit::has_turning_directors() const {
  for (mechanics::Index i = 0; i < assembly_->dofs().unknowns(); ++i)
    if (assembly_->dofs().turns(i)) return true;
  return false;
}

void Implicit::take_options(const DynamicOptions& options) {
  const bool changed = options.step != options_.step || options.max_cuts != options_.max_cuts;
  options_ = options;
  if (changed) control_ = control_of(options_, *assembly_);
  now_.step = control_.current();
}

void Implicit::begin() {
  problem_.set_time(began());
  Dynamic::begin();
  watch_corner();
}

void Implicit::set_motion(const mechanics::NodalRates& rates) {
  // Held and tied nodes have no velocities of their own.
  mechanics::NodalRates possible;
  assembly_->dofs().spread_rates(assembly_->dofs().collect_rates(rates), driven_rates(), possible);
  problem_.start(possible);
}

void Implicit::mark_repeatable() {
  repeatable_ = {};
  repeatable_.step = control_.current();
  repeatable_.start = save_state();
  repeatable_.surplus = energy().surplus();
  repeatable_.settling = now_.settling > 0;
  repeatable_.corner = now_.corner > 0;
}

// A repeated step that fails is made as at first; any other that ends without a result leaves no trace, and
// can be made later with the same bits.
bool Implicit::tries_again(bool failed) {
  using Try = Repeatable::Try;
  newmark_.show_trial(false);
  if (!repeats()) {
    control_.set(repeatable_.step);
    return false;
  }
  const bool again = failed && repeatable_.which != Try::first_again;
  return_to_start(again ? Try::first_again : Try::first);
  return again;
}

void Implicit::return_to_start(Repeatable::Try next) {
  const DynamicState reported = now_;
  go_back(repeatable_.start);
  now_.keep_reported(reported);
  repeatable_.which = next;
  repeatable_.halved = 0;
}

double Implicit::try_step(double limit, StepReport& report) {
  if (!repeats()) {
    watch_turning();
    mark_repeatable();
  }
  double size = control_.end(committed_time(), next_landing(limit, control_.current()));
  step_.tries.clear();
  for (;;) {
    const bool converged = attempt(size, report);
    if (converged && !errs(size)) break;
    ++report.cuts;
    if (!converged &&
        (step_.broken() || report.cuts > options_.max_cuts || !control_.cut(size - committed_time())))
      give_up(report);
    size = control_.end(committed_time(), next_landing(limit, control_.current()));
  }
  return size;
}

// A step whose error is more than what was asked for is made again, so much shorter that it will do.
bool Implicit::errs(double end) {
  if (!options_.error) return false;
  const double made = end - committed_time(), smallest = control_.smallest();
  const double error = problem_.error_of_step() / extent_, allowed = *options_.error;
  const double fits = kSafe * made * std::cbrt(allowed / error), current = std::max(made, control_.current());
  next_ = std::clamp(fits, kShrink * made, kGrow * current);
  if (error <= allowed) return false;
  if (made <= smallest * (1 + 1e-9)) {
    if (!warned("step"))
      warn("step", "dynamic: at time " + number(end) + " s the error of a step of " + number(made, 3) +
                       " s is " + number(error, 3) + " of the model's size, more than error=" +
                       number(allowed) + ", and smaller ones are not made: more max_cuts would allow them");
    return false;
  }
  control_.aim(std::max(next_, smallest));
  return true;
}

bool Implicit::attempt(double size, StepReport& report) {
  const double now = committed_time();
  problem_.set_time(size);
  auto result = newton_.solve(problem_, {options_.tolerance, options_.max_iterations, options_.line_search});
  if (result.status == solver::NewtonStatus::converged && result.negative_pivots > 0 && damps_unresolved())
    result = minimise(std::move(result), size, report);
  if (result.status == solver::NewtonStatus::too_many_iterations && problem_.at_target() &&
      result.residuals.back() <= std::min(1e-5, kStanding * options_.tolerance))
    result.status = solver::NewtonStatus::converged;
  report.iterations += result.iterations;
  report.residuals = result.residuals;
  report.negative_pivots = result.negative_pivots;
  report.step = size - now;
  report.time = size;
  newmark_.show_trial(result.status == solver::NewtonStatus::converged);
  const bool converged = step_.take(result, report.step, *assembly_, model_->mesh());
  trial_time_ = converged ? size : now;
  return converged;
}

// Whether the scheme is one of a spectral radius below 1, or Euler's rule.
bool Implicit::damps_unresolved() const {
  const auto& scheme = newmark_.scheme();
  const bool backward = now_.corner == 0 && scheme.is_trapezoidal() && scheme.gamma == kBackward;
  return now_.settling == 0 && (radius_ < 1 || backward);
}

// A step is a minimum of one potential, of the motion, the cloth, contact and the loads. Newton's method
// finds a saddle as well, as of a column that stands straight beyond Euler's load. From there the way leads
// to the side on which the potential is less, or a shorter step resolves how the cloth leaves its shape.
solver::NewtonResult Implicit::minimise(solver::NewtonResult found, double size, const StepReport& report) {
  if (report.cuts >= options_.max_cuts || size - committed_time() < 2 * control_.smallest()) {
    if (!warned("unstable"))
      warn("unstable", "dynamic: at time " + number(size) +
                           " s the cloth is in a shape that it would leave " +
                           "within the step, and shorter steps do not tell where to; the results from here " +
                           "on are doubtful: more max_cuts, or damping, may do");
    return found;
  }
  if (!downhill_)
    downhill_ = std::make_unique<solver::TrustRegion>(
        make_solver(options_.solver, !takes_unsymmetric(), is_near_symmetric()),
        is_near_symmetric() || assembly_->terms().symmetric(), judge_of(*model_, *assembly_));
  auto least = downhill_->correct(
      problem_, {options_.tolerance, options_.max_iterations, options_.line_search, problem_.size()});
  least.iterations += found.iterations;
  least.far = found.far;
  return least;
}

void Implicit::commit(StepReport& report) {
  newmark_.show_trial(false);
  const std::vector<double> driven_before = problem_.driven();
  assembly_->finish_step();
  const NewmarkScheme scheme = newmark_.scheme();
  const bool settling = now_.settling > 0, damps = this->damps() && !settling,
             swings = damps && !scheme.is_trapezoidal();
  const double kinetic = swings ? newmark_.kinetic() : 0, work = swings ? problem_.work_of_balance() : 0;
  if (swings)
    for (const auto* const term : assembly_->terms().all<mechanics::AtStepEnd>())
      now_.loss += term->lost_by_rule();
  dead_ = problem_.external();
  const mechanics::StepWork done =
      work_.bounded(*assembly_, dead_, damps && scheme.is_trapezoidal() ? scheme.gamma : 0.5);
  off_ = follows_corners() && now_.corner == 0 ? assembly_->terms().step_work().spread : done.spread;
  problem_.commit(report.time);
  double open = 0;
  // Euler's rule takes no more than the energy that the jump brings. What is missing beyond that a support
  // has not worked, whose force is another within the step than at its end.
  if (now_.corner > 0 && !settling) {
    const double lost = repeatable_.surplus - (energy().surplus() - done.work);
    open = std::clamp(lost - now_.jump, 0.0, 2 * done.spread);
    now_.jump -= std::clamp(lost, 0.0, now_.jump);
  }
  work_.add(done.work - open);
  // The generalised trapezoidal rule never adds energy: what is missing is its loss, and what there is more
  // of than at any time since it damps is an error of the ledger. Newmark's method and alpha conserve or
  // lower another sum; their loss is the work of all forces that does not become kinetic energy.
  if (swings)
    now_.loss += work - (newmark_.kinetic() - kinetic);
  else if (damps)
    now_.loss += std::max(0.0, now_.base - energy().surplus());
  if (settling) settle();
  if (now_.corner > 0 && --now_.corner == 0) {
    take_scheme();
    if (!newmark_.scheme().is_trapezoidal()) now_.base = now_.loss;
  }
  watch_corner();
  watch_jump(driven_before, problem_.driven(), report.time, smallest_);
  const bool was_cut = report.cuts > 0 || repeatable_.halved > 0;
  if (options_.error)
    control_.aim(was_cut ? std::min(next_, control_.current()) : next_);
  else {
    if (report.cuts > 0) control_.rest_after_failure();
    control_.grow(step_.last.far, was_cut);
  }
  now_.step = control_.current();
  ++now_.steps;
}

// Energy missing after a step in which directors settle was theirs. Shorter steps than before resolve
// how they turn and leave them some of their speed: there have to be more of these.
void Implicit::settle() {
  const double surplus = energy().surplus();
  now_.loss += std::max(0.0, now_.surplus - surplus);
  now_.surplus = energy().surplus();
  if (now_.settling > 1 || committed_time() >= now_.settles) --now_.settling;
  if (now_.settling == 0) take_scheme();
}

// A deck that chose average acceleration itself keeps it.
bool Implicit::follows_corners() const { return !options_.error && (chooses_scheme() || damps()); }

void Implicit::watch_corner() {
  const bool follows = now_.corner == 0 && newmark_.scheme().gamma == kBackward;
  if (follows || !follows_corners()) return;
  const double jump = energy_of_corner();
  if (!(jump > kCorner * work_.largest())) return;
  const EnergyAccount now = energy();
  if (!(jump > kCorner * ledger_scale(now))) return;
  if (!damps() || !newmark_.scheme().is_trapezoidal()) now_.base = now.surplus();
  now_.corner = kCornerSteps;
  now_.jump = jump;
  take_scheme();
}

bool Implicit::chooses_scheme() const { return chooses_none(options_); }

bool Implicit::takes_alpha() const { return chooses_scheme() && !has_contact(*assembly_); }

const mechanics::NodalRates& Implicit::rates() const { return newmark_.velocities(); }

// Average acceleration keeps the energy of linear systems alone: the kinks of a fabric's law feed frequencies
// that no step resolves, until they carry more than the motion [hughes1978]. The rule beside contact damps
// from the first step on, and its errors in a swing or an impact do not grow. Where cloth only seems to turn,
// since tension pushes it on along what it touches, shorter steps would go on pushing. In a young run the
// first stage begins with more.
std::string Implicit::begin_to_damp(double error) {
  if (!chooses_scheme() || now_.corner > 0 || now_.damping == Damping::backward) return {};
  const bool first = !damps();
  if (!first && error - now_.forgiven <= kTooMuch * options_.ledger_limit) return {};
  const auto* const contact = assembly_->terms().find<mechanics::Contacts>();
  if (!first || contact != nullptr || is_young()) now_.forgiven = std::max(now_.forgiven, error);
  if (!first && now_.damping < Damping::strong && (contact == nullptr || contact->readings().touching() == 0))
    if (std::string text = shorten_for_turning(); !text.empty()) return text;
  damp(first ? Damping::hht : now_.damping < Damping::strong ? Damping::strong : Damping::backward);
  return damping_text();
}

double Implicit::turn_per_step() const {
  const auto x = std::as_const(*assembly_).state().x();
  const auto& v = newmark_.velocities().x;
  const auto& mass = inertia_->mass();
  double whole = 0, kinetic = 0;
  Vec3 centre = Vec3::Zero(), momentum = Vec3::Zero(), angular = Vec3::Zero();
  for (std::size_t n = 0; n < mass.size(); ++n) {
    whole += mass[n];
    centre += mass[n] * at(x, n);
    momentum += mass[n] * at(v, n);
  }
  if (!(whole > 0)) return 0;
  centre /= whole;
  Eigen::Matrix3d about = Eigen::Matrix3d::Zero();
  for (std::size_t n = 0; n < mass.size(); ++n) {
    const Vec3 r = at(x, n) - centre, u = at(v, n) - momentum / whole;
    angular += mass[n] * r.cross(u);
    about += mass[n] * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
    kinetic += mass[n] * u.squaredNorm() / 2;
  }
  const Vec3 rate = about.ldlt().solve(angular);
  if (!rate.allFinite() || !(rate.dot(angular) / 2 > kTurning * kinetic)) return 0;
  return rate.norm() * control_.current();
}

std::string Implicit::shorten_for_turning() {
  const double turn = turn_per_step();
  if (!(turn > 1.01 * kTurn / kFurther)) return {};
  const std::string words = shorten(turn, std::min(kTurn / turn, 0.5));
  return words.empty() ? words : words + " and damping would take energy of the turning; ";
}

// To a part of the present step, in which the cloth turns by so many rad.
std::string Implicit::shorten(double turn, double part) {
  const double step = control_.current();
  control_.limit(step * part);
  if (!(control_.current() < step)) return {};
  now_.step = control_.current();
  return "from here on steps are at most " + number(control_.largest()) + " s, since the cloth turns by " +
         number(turn * 180 / std::numbers::pi, 2) + " degrees in one of " + number(step) + " s";
}

// Rigid sets keep energy and momentum at any step.
void Implicit::watch_turning() {
  if (options_.error || !assembly_->dofs().freedoms().bodies.empty()) return;
  const bool wanted = damps() && (!chooses_scheme() || now_.damping != Damping::none);
  const double turn = wanted ? 0 : turn_per_step();
  const double steps = steps_per_turn(*model_), wide = 2 * std::numbers::pi / steps;
  if (!(turn > 1.01 * wide)) return;
  const std::string words = shorten(turn, wide / turn);
  if (!words.empty() && !warned("step"))
    warn("step", "dynamic: at time " + number(committed_time()) + " s: " + words +
                     ", which would make energy of the turning: " + number(steps) +
                     " steps a turn keep it to some thousandths");
}

void Implicit::damp(Damping damping) {
  const EnergyAccount now = energy();
  now_.base = damping == Damping::hht && takes_alpha() ? now_.loss : now.surplus();
  if (damping != Damping::hht)
    now_.forgiven = std::max(now_.forgiven, (now.surplus() - now_.early) / ledger_scale(now));
  now_.damping = damping;
  take_scheme();
  // With average acceleration those of frequencies that no step resolves grow from step to step. Beside
  // contact they are damped, and what is pressed has those of its other forces.
  if (damping == Damping::strong && !has_contact(*assembly_)) newmark_.take_off(newmark_.committed().a);
  if (chooses_scheme()) return;
  // Alpha has those between two states.
  problem_.set_time(committed_time());
  problem_.begin_step();
  problem_.start(newmark_.velocities());
}

std::string Implicit::damping_text() const {
  return "from here on high frequencies are damped (" +
         (!chooses_scheme() ? "gamma=" + number(scheme_of(options_, *assembly_).gamma)
          : now_.damping == Damping::hht
              ? takes_alpha() ? "hht=" + number(kDampingAlpha) : "spectral_radius=" + number(kBesideContact)
          : now_.damping == Damping::strong ? "gamma=" + number(kStrongGamma)
                                            : "as with slow=true") +
         ", the loss is in energy.damping); ";
}

// A step that makes more energy than the ledger allows is repeated with strong damping, which is kept if that
// makes less than half as much, and no more than is allowed: the work of a support that begins to move with a
// jump, which the ledger does not know well, is no reason. Other steps with more than a small error are
// shortened, and those that damping does not help.
bool Implicit::takes_back() {
  using Try = Repeatable::Try;
  const Try which = std::exchange(repeatable_.which, Try::first);
  if (loss_falls() && leave_hht(which == Try::first && !repeatable_.start.empty())) return true;
  if (repeatable_.start.empty() || which == Try::first_again) return false;
  const EnergyAccount now = energy();
  const double energy_made = now.surplus() - repeatable_.surplus, made = energy_made / ledger_scale(now);
  if (repeatable_.settling) return shortens(std::max(0.0, made), energy_made, kSettlingHalvings);
  if (which == Try::first) {
    if (repeatable_.halved == 0) repeatable_.young = is_young();
    const bool may_damp =
        chooses_scheme() && !repeatable_.corner && now_.damping < Damping::strong && repeatable_.halved == 0;
    if (!(made > options_.ledger_limit && may_damp)) return shortens(made, energy_made, kMostHalvings);
    return_to_start(Try::first);
    if (const std::string text = shorten_for_turning(); !text.empty()) {
      warn("ledger", "dynamic: a step after time " + number(committed_time()) + " s would have made " +
                         number(100 * made) + " % of the energy there: " + text +
                         "repeat with a smaller step to see whether the step is the cause");
      return true;
    }
    repeatable_.made = made;
    repeatable_.energy = energy_made;
    repeatable_.which = Try::damped;
    damp(Damping::strong);
    return true;
  }
  if (!(made < repeatable_.made / 2) || (made > options_.ledger_limit && !repeatable_.young)) {
    const double end = committed_time();
    return_to_start(Try::first);
    halve(end);
    return true;
  }
  warn("ledger", "dynamic: a step to time " + number(committed_time()) + " s would have made " +
                     number(100 * repeatable_.made) + " % of the energy there and was repeated: " +
                     damping_text() + "repeat with a smaller step to see whether the step is the cause");
  return false;
}

// The loss of Newmark's method and alpha swings with what no step resolves. Where it gives back more than a
// little, the generalised trapezoidal rule takes over: of a deck's own choice that in which modes decay
// alike.
bool Implicit::loss_falls() {
  if (newmark_.scheme().is_trapezoidal()) return false;
  now_.base = std::max(now_.base, now_.loss);
  return now_.base - now_.loss > kTooMuch * options_.ledger_limit * ledger_scale(energy());
}

// Returns whether the step that gave it back is repeated.
bool Implicit::leave_hht(bool repeat) {
  if (repeat) return_to_start(Repeatable::Try::first);
  std::string text = shorten_for_turning();
  if (text.empty()) {
    damp(chooses_scheme() ? Damping::strong : Damping::hht);
    text = damping_text();
  } else {
    now_.base = now_.loss;
  }
  warn("ledger", "dynamic: at time " + number(committed_time()) + " s the loss of the scheme falls: " + text +
                     "repeat with a smaller step to see whether the step is the cause");
  return repeat;
}

// Where stiff elements turn far within a step, its error falls with its size; so it does where a support goes
// so far that the force on it is no line. The work of one that begins to move with a jump is no better known
// in half the step, which is then made whole, unless it makes more than that work can be off. error: over the
// ledger's scale; energy: the same in J.
bool Implicit::shortens(double error, double energy, int most) {
  const int halved = std::exchange(repeatable_.halved, 0);
  if (!(std::abs(error) > kErrorOfStep * options_.ledger_limit) || halved == most) return false;
  // What a rule that damps takes of what was made before, is no error.
  const double wrong =
      damps() && newmark_.scheme().is_trapezoidal() ? std::max(0.0, energy) : std::abs(energy);
  const bool sure =
      (wrong - off_) * std::abs(error) > kErrorOfStep * options_.ledger_limit * std::abs(energy);
  if (!repeatable_.settling && is_young() && !sure) {
    if (!repeatable_.young || (halved == 0 && !(std::abs(error) > options_.ledger_limit))) return false;
    if (halved > 0 && !(std::abs(energy) < kFallsByHalf * std::abs(repeatable_.energy))) {
      return_to_start(Repeatable::Try::first_again);
      return true;
    }
  }
  repeatable_.energy = energy;
  const double end = committed_time();
  return_to_start(Repeatable::Try::first);
  halve(end, halved);
  return true;
}

// The step that ended there and is repeated.
void Implicit::halve(double end, int halved) {
  control_.set((end - committed_time()) / 2);
  repeatable_.halved = halved + 1;
}

void Implicit::take_scheme() {
  newmark_.set_scheme(now_.settling > 0 ? NewmarkScheme::trapezoidal(kSettling, false)
                      : now_.corner > 0 ? NewmarkScheme::trapezoidal(kBackward, !chooses_scheme())
                      : now_.damping == Damping::backward ? NewmarkScheme::trapezoidal(kBackward)
                      : now_.damping == Damping::strong   ? damping_by(kStrongGamma, false)
                      : now_.damping == Damping::none     ? scheme_of(options_, *assembly_)
                      : takes_alpha()                     ? NewmarkScheme::of_hht(kDampingAlpha)
                      : chooses_scheme()                  ? scheme_of_radius(kBesideContact, true, false)
                                         : damping_by(scheme_of(options_, *assembly_).gamma));
  weigh_step_ends();
}

void Implicit::weigh_step_ends() {
  for (auto* const term : assembly_->terms().all<mechanics::AtStepEnd>())
    term->set_weight(newmark_.weight_at_step_end(), newmark_.scheme().late);
}

void Implicit::give_up(const StepReport& report) {
  step_.complete(*model_, *assembly_, committed_time());
  step_.dynamic = true;
  fail(step_, report, control_.largest());
}

void Implicit::memory(Archive& archive) {
  if (archive.reading()) {
    newmark_.show_trial(false);
    repeatable_.which = Repeatable::Try::first;
  }
  archive(now_, control_, newmark_);
  problem_.keep(archive);
  if (archive.reading()) take_scheme();
}

}  // namespace fabricsh::run
