#include "run/explicit.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "mechanics/rate_bound.hpp"
#include "mechanics/terms/contact.hpp"
#include "mechanics/terms/seams.hpp"
#include "mechanics/terms/tears.hpp"
#include "run/step_control.hpp"

namespace fabricsh::run {

namespace {

constexpr double kUsual = 0.7;             // fraction of the nominal step
constexpr double kOfBound = 0.9;           // fraction of the bound that holds whatever the mesh and the loads
constexpr double kSame = 0.995;            // a bound above this fraction of the nominal step confirms it
constexpr double kReportedFraction = 0.5;  // a smaller fraction of the usual step is reported, with its cause
constexpr double kJump = 0.1;      // fraction of the smallest element: a larger motion in one step is a jump
constexpr int kStretchEvery = 16;  // number of steps between two checks of the stretch
constexpr int kLoadsEvery = 256;   // the same of the stiffness of springs and loads
constexpr int kBlock = 64;         // number of steps of equal size, with contact
constexpr double kPieces = 8;      // a split step is the usual one over so many eighths
constexpr int kBarrierFreeBlocks = 4;  // blocks without need of it, after which a halved step is doubled
constexpr int kHalvings = 12;          // largest number of halvings of the step for contact
constexpr int kCostly = 5;             // halvings from which on the run is much longer than it seemed
constexpr int kCostlySteps = 1000;     // such steps after which it says how long

}  // namespace

Explicit::Explicit(std::shared_ptr<model::Model> model, const DynamicOptions& options,
                   std::shared_ptr<Notices> notices, const Beginning& beginning)
    : Dynamic(std::move(model), options, std::move(notices), beginning),
      motion_(assembly_->lumped_mass(scaled_), options_.gamma, [this] { return driven_rates(); }),
      problem_(*assembly_, motion_, unpolled_) {
  const double undamped = stable_;
  bound_step();
  assembly_->terms().find<mechanics::Cloth>()->update_in_place();
  if (auto* const contacts = assembly_->terms().find<mechanics::Contacts>())
    contact_ = &contacts->go_explicit();
  if (tears_ != nullptr) tears_->go_explicit();
  if (const auto* const before = dynamic_cast<const Explicit*>(beginning.from))
    left_velocities_ = before->motion_.velocities();
  take_beginning();
  report_contacts();
  check_stable_step(undamped);
  choose_step();
  report_step_bound();
  lead_drawn_seams();
  farthest_ = {smallest_, std::numbers::pi / 2};
  list_unknowns();
  set_motion(initial_rates());  // to be read before the first step
}

void Explicit::list_unknowns() {
  turns_.clear();
  turns_.reserve(motion_.residual().size());
  for (mechanics::Index i = 0; i < assembly_->dofs().unknowns(); ++i)
    turns_.push_back(assembly_->dofs().turns(i) ? 1 : 0);
  added_inertia_ = added_inertia();
}

void Explicit::resize() {
  weight_of_acceleration_ = motion_.weight_of_acceleration();
  motion_.resize(assembly_->lumped_mass(scaled_));
  list_unknowns();
  rates_version_ = 0;
}

// As a run begins: with velocities and accelerations of the same time. The energy that central differences
// conserve contains the accelerations, which jump.
void Explicit::take(const mechanics::Transfer&, const std::vector<double>& rates) {
  if (!started()) return set_motion(initial_rates());
  const double weight = weight_of_acceleration_, dt = conserved_.dt;
  motion_.start(rates);
  problem_.set_time(committed_time());
  if (problem_.begin_step() != Answer::ok)
    throw NumericalFailure("dynamic: the fabric law failed where joints changed", committed_time());
  problem_.weigh(motion_.residual());
  motion_.accelerate(assembly_->terms().on_mass().velocity);
  motion_.begin();
  conserved_.moved += dt * dt / 8 * (motion_.weight_of_acceleration() - weight);
}

// Mass damping does not reduce the stable step. Stiffness damping, whose velocity is half a step old,
// multiplies it by sqrt(1 + xi^2) - xi, where xi = b omega / 2 at the highest frequency, omega = 2 / step.
double Explicit::damped(double step) const {
  const double xi = options_.stiffness_damping / step;
  return of_gamma() * step * (std::sqrt(1 + xi * xi) - xi);
}

// Newmark's method with beta = 0 is stable up to omega dt = sqrt(2 / gamma) [hughes2000].
double Explicit::of_gamma() const { return std::sqrt(0.5 / options_.gamma); }

// The nominal step, of waves that cross the smallest element, is what regular meshes of cloth take. The bound
// holds for all shapes, springs and loads.
void Explicit::bound_step() {
  nominal_ = damped(stable_);
  added_ = mechanics::added_rates(*assembly_, scaled_);
  bound_ = bound_of(mechanics::rate_bound(*assembly_, scaled_, added_));
  stable_ = bound_ >= kSame * nominal_ ? nominal_ : bound_;
}

bool Explicit::is_of_waves() const { return kOfBound * bound_ >= kUsual * nominal_; }

void Explicit::report_step_bound() {
  const double ratio = kOfBound * bound_ / (kUsual * nominal_);
  if (options_.step || ratio >= kReportedFraction) return;
  const auto highest = mechanics::fastest_element(*assembly_, scaled_, added_, mechanics::At::trial);
  warn("step", "dynamic: the step of " + number(now_.step) + " s is " + number(ratio) +
                   " of what waves in the cloth allow, because of " +
                   (2 * highest.added > highest.rate ? "the springs or loads at "
                                                     : "the shape or the shear stiffness of ") +
                   shape_text(highest.element));
}

// Each edge has half of the speed at which the gap closes. Time shortens it in proportion.
bool Explicit::lead_drawn_seams() {
  bool led = false;
  if (contact_ == nullptr || seams_ == nullptr) return led;
  for (const auto& through : contact_->drawn_through()) {
    if (seams_->is_led(through.stitch)) continue;
    const double speed = seams_->closing_speed(through.stitch) / 2;
    seams_->lead_around(through.stitch, 2 * std::min(speed, through.stopped));
    const bool is_led = seams_->is_led(through.stitch);  // not a seam with a stiffness of its own
    led = led || is_led;
    if (speed <= through.stopped || (!is_led && started())) continue;
    const model::Seam& seam = assembly_->dofs().seams()[assembly_->dofs().stitches()[through.stitch].seam];
    warn("seam", "warning: dynamic: the straight way of the seam " + seam.name() + " passes through the " +
                     through.body + ": its edges are drawn against it with up to " + number(speed, 3) +
                     " m/s, and contact stops cloth that comes with " + number(through.stopped, 3) +
                     " m/s anywhere on it: expected 'over' of at least " +
                     number(*seam.over * speed / through.stopped, 2) +
                     " s, or more 'thickness' of m:contact, got " + number(*seam.over) +
                     " s; it is drawn no faster than that, and closes when its edges meet");
  }
  return led;
}

void Explicit::check_stable_step(double undamped) const {
  if ((options_.step && options_.force) || duration_ / usual_step() <= most_steps) return;
  const bool damped = duration_ / (kUsual * undamped) <= most_steps;
  throw Error("dynamic: field '" + std::string(damped ? "damping.stiffness" : "duration") + "': " +
              (damped ? number(options_.stiffness_damping) + " s brings the stable step from " +
                            number(undamped) + " s to " + number(stable_) + " s, with which "
                      : "the stable step of this mesh and card is " + number(stable_) + " s, with which ") +
              number(duration_) + " s would take more than " + number(most_steps) + " steps: expected less " +
              (damped ? "damping" : "time") + ", or scheme=\"implicit\"");
}

double Explicit::usual_step() const {
  if (contact_ == nullptr) return std::min(kUsual * nominal_, kOfBound * bound_);
  const double of_cloth = kOfBound * bound_ * contact_->share_of_cloth(bound_) / kUsual;
  return std::min({kUsual * nominal_, of_gamma() * contact_->largest_step(scaled_), of_cloth});
}

void Explicit::choose_step() {
  const double usual = usual_step();
  now_.step = options_.step.value_or(usual);
  if (options_.force || now_.step <= usual * (1 + 1e-12)) return;
  if (contact_ != nullptr)
    throw Error("dynamic: field 'step': expected at most " + number(usual) +
                " s, the largest step that contact allows (0.6 to 0.7 of the stable step of mesh and card, " +
                number(stable_) + " s, and less where contact is stiff), got " + number(now_.step) +
                " s (where contact is stiff, a smaller 'stiffness' of m:contact allows more; force=true uses "
                "this step all the same)");
  // Supports can make a step stable that is above the bound: where the usual one is that of the waves, steps
  // up to theirs are accepted.
  if (const double most = is_of_waves() ? nominal_ : stable_; now_.step > most)
    throw Error("dynamic: field 'step': expected at most " + number(most) +
                " s, the stable step of this mesh and card, got " + number(now_.step) +
                " s (step=\"auto\" takes " + number(usual) + " s; force=true uses this step all the same)");
  warn("step", "dynamic: the step of " + number(now_.step) + " s is above " + number(usual / stable_) +
                   " of the stable one, " + number(stable_) + " s");
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
  problem_.set_time(began());
  if (problem_.begin_step() != Answer::ok || problem_.residual(motion_.residual()) != Answer::ok)
    throw NumericalFailure("dynamic: the fabric law failed at time " + number(began()), began(),
                           assembly_->outcome().element);
  motion_.accelerate(assembly_->terms().on_mass().velocity);
  motion_.begin();
  problem_.start();
}

// Velocities that go from unknowns to nodes and back are the same but for rounding. Those of the run from
// which this one begins are taken as they are where they are these, so that both go on with the same bits.
void Explicit::set_motion(const mechanics::NodalRates& rates) {
  constexpr double rounding = 1e-12;
  std::vector<double> velocities = assembly_->dofs().collect_rates(rates);
  const auto largest = [](const std::vector<double>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0,
                           [](double most, double v) { return std::max(most, std::abs(v)); });
  };
  if (left_velocities_.size() == velocities.size()) {
    std::vector<double> apart(velocities.size());
    for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = velocities[i] - left_velocities_[i];
    if (largest(apart) <= rounding * largest(velocities)) velocities = left_velocities_;
  }
  motion_.start(std::move(velocities));
}

// With contact a step may have to be repeated with half the size, together with its whole block.
double Explicit::try_step(double limit, StepReport& report) {
  const bool touches = contact_ != nullptr;
  if (touches) open_block();
  for (;;) {
    if (now_.steps % kStretchEvery == 0) split();
    const double whole = end_of_step(committed_time(), next_landing(limit), block_step());
    const std::optional<double> size = try_shorter(whole, report);
    if (size && (!touches || step_acceptable(report.step))) return *size;
    redo(report);
  }
}

// A step of the given size, halved as often as a term asks for a shorter one; the following steps are not
// affected. Empty: contact is in an impossible state.
std::optional<double> Explicit::try_shorter(double size, StepReport& report) {
  const double now = committed_time();
  while (!attempt(size, report)) {
    if (contact_ != nullptr && end_ == End::forces && contact_->blocked()) return {};
    const bool shorter =
        end_ == End::limited || (end_ == End::forces && assembly_->outcome().answer == Answer::cut);
    if (!shorter || ++report.cuts > options_.max_cuts) give_up(report);
    size = now + (size - now) / 2;
  }
  return size;
}

void Explicit::open_block() {
  if (!block_.start.empty() && !hooked_ && block_.steps < kBlock) return;
  const bool whole = block_.watched >= kBlock;
  if (whole && contact_->guarded()) lead_drawn_seams();
  if (block_.guarded) block_.barrier_free_blocks = 0;
  if (whole && block_.halved > 0 && !block_.guarded && ++block_.barrier_free_blocks >= kBarrierFreeBlocks) {
    --block_.halved;
    block_.barrier_free_blocks = 0;
  }
  block_.uneased = block_.uneased && block_.struck;
  block_.struck = false;
  block_.start.clear();
  block_.steps = 0;
  if (whole) {
    block_.watched = 0;
    block_.guarded = false;
  }
  hooked_ = false;
  block_.start = save_state();
}

// Whether the step just tried is acceptable: its motion cannot have passed through a surface, and it is
// stable for the stiffness of contact at its end.
bool Explicit::step_acceptable(double dt) {
  if ((contact_->struck() && !block_.uneased) || contact_->may_have_passed() || contact_->turns_too_far())
    return false;
  return !contact_->needs_short_steps() || (block_.halved > 0 && dt <= contact_->largest_contact_step());
}

void Explicit::redo(const StepReport& report) {
  if (block_.halved >= kHalvings) give_up(report);
  const bool same_steps =
      contact_->struck() && !block_.uneased;  // of which the guards alone are met otherwise
  block_.uneased = block_.uneased || same_steps;
  RepeatableBlock block;
  std::swap(block, block_);
  const DynamicState reported = now_;
  go_back(block.start);
  now_.keep_reported(reported);  // notices are not repeated
  block_ = std::move(block);
  block_.halved += same_steps ? 0 : 1;
  block_.barrier_free_blocks = 0;
  block_.steps = block_.watched = 0;
  block_.guarded = true;
  // A seam whose way passed the body by at first may be drawn against it by now.
  if (!lead_drawn_seams()) return;
  block_.start.clear();
  block_.start = save_state();
}

void Explicit::report_guard() {
  ++block_.steps;
  ++block_.watched;
  block_.guarded = block_.guarded || contact_->needs_short_steps();
  block_.struck = block_.struck || contact_->struck();
  if (!contact_->guarded() || block_.reported) return;
  block_.reported = true;
  const auto nearest = contact().readings().nearest();
  warn("guard", "dynamic: at time " + number(time()) + " s " + contact().surfaces().words(nearest.point) +
                    " are pressed into the last quarter above the smallest distance that contact allows (" +
                    number(nearest.gap) +
                    " m above it): a barrier keeps them apart (its energy: a.energy.guard) and " +
                    (contact_->needs_short_steps() ? "the step is halved meanwhile"
                                                   : "inertia that it adds to them keeps the step"));
}

void Explicit::report_cost() {
  const double step = std::ldexp(now_.step, -block_.halved), left = duration_ - committed_time();
  const auto nearest = contact().readings().nearest();
  const std::string caught = caught_text(), near = contact().surfaces().words(nearest.point);
  warn("guard", "dynamic: contact has kept the step at " + number(step) + " s, " +
                    number(std::ldexp(1.0, block_.halved)) + " times as short as planned, for " +
                    std::to_string(kCostlySteps) + " steps by time " + number(committed_time()) + " s (" +
                    (near.empty() ? "nothing is near now"
                                  : near + ", " + number(nearest.gap) + " m above the smallest distance") +
                    "): if that lasts, the " + number(left) + " s that are left take " +
                    number(left / step, 2) + " more, in place of " + number(left / now_.step, 2) +
                    (caught.empty() ? "" : "; " + caught) +
                    ".\nTry: " + (caught.empty() ? "" : "a longer field 'over' of m:seam; or ") +
                    against_pressing() + ".");
}

void Explicit::split() {
  if (now_.steps % kLoadsEvery == 0) added_ = mechanics::added_rates(*assembly_, scaled_);
  const double stretched = nominal_ / std::max(1.0, assembly_->cloth().readings().largest_stretch());
  const double wanted = options_.step.value_or(usual_step());
  // A step that was accepted above the bound keeps its distance to it.
  const double above = is_of_waves() && wanted > bound_ ? nominal_ / bound_ : 1;
  const double bound = above * bound_of(mechanics::rate_bound(*assembly_, scaled_, added_)),
               stable = std::min(stretched, bound);
  now_.step = wanted;
  if (options_.force || wanted <= stable) return;
  now_.step = wanted * kPieces / std::ceil(kPieces * wanted / stable);
  if (now_.reported_split) return;
  now_.reported_split = true;
  warn("step", "dynamic: stretch has brought the stable step to " + number(stable) + " s at time " +
                   number(committed_time()) + " s; the step of " + number(wanted) +
                   " s is split from here on");
}

bool Explicit::attempt(double size, StepReport& report) {
  const double now = committed_time();
  if (dirty_) assembly_->rollback();
  dirty_ = true;
  motion_.show_trial(false);
  trial_time_ = report.time = now;
  problem_.set_time(size);
  report.step = motion_.dt();
  const auto ends = [this](End end) {
    end_ = end;
    return false;
  };
  if (!motion_.predict(turns_, farthest_)) return ends(End::ran_away);
  if (problem_.begin_step() != Answer::ok) return ends(End::forces);
  problem_.accept();
  watch_jump(problem_.driven(), problem_.targets(), size, kJump * smallest_);
  if (assembly_->limits() && assembly_->limit(motion_.increments(), problem_.targets()) < 1)
    return ends(End::limited);
  problem_.advance_explicit(motion_.along(), motion_.reach());
  trial_time_ = size;
  if (contact_ != nullptr) contact_->barriers().ease(!block_.uneased, std::ldexp(report.step, block_.halved));
  assembly_->terms().expect_energies(looks_after(now_.steps + 1, size));
  if (problem_.residual(motion_.residual()) != Answer::ok) return ends(End::forces);
  if (contact_ != nullptr) contact_->barriers().hold_back(motion_.masses(), motion_.residual());
  motion_.accelerate(assembly_->terms().on_mass().velocity);
  motion_.show_trial(true);
  report.time = size;
  return true;
}

void Explicit::commit(StepReport& report) {
  assembly_->finish_step();
  if (const double dt = motion_.dt(); dt != conserved_.dt) {
    conserved_.moved += (dt * dt - conserved_.dt * conserved_.dt) / 8 * motion_.weight_of_acceleration();
    conserved_.dt = dt;
  }
  if (damps()) now_.loss += motion_.loss();
  if (!assembly_->terms().constant_loads()) dead_ = problem_.external();
  work_.add(*assembly_, dead_);
  if (contact_ != nullptr) report_guard();
  const bool enters = contact_ != nullptr && contact_->enters_guard();
  if (block_.halved >= kCostly && ++now_.short_steps == kCostlySteps) report_cost();
  problem_.commit(report.time);
  motion_.commit();
  motion_.show_trial(false);
  dirty_ = false;
  ++now_.steps;
  if (enters) lead_drawn_seams();
}

// Of a mode of frequency w the energies at the ends of steps oscillate by a fraction of (w dt / 2)^2, though
// none is made; what stays is v- . M v+ / 2, with the velocities in the middle of the steps before and after,
// and the potential energy [belytschko2014]. It also stays bounded where the step is too long, so that it
// does not show that.
double Explicit::hidden_energy() const {
  const double dt = conserved_.dt;
  if (!(dt <= bound_of(mechanics::rate_bound(*assembly_, scaled_, added_)))) return 0;
  return conserved_.moved - dt * dt / 8 * motion_.weight_of_acceleration();
}

const mechanics::NodalRates& Explicit::rates() const {
  const auto version = std::as_const(*assembly_).state().version();
  if (rates_version_ != version) assembly_->dofs().spread_rates(motion_.velocities(), driven_rates(), rates_);
  rates_version_ = version;
  return rates_;
}

// The frames of the directors are orthonormal, so that their rates need not be put together.
double Explicit::scaled_kinetic() const {
  if (!scaled_ || assembly_->dofs().has_ties()) return Dynamic::scaled_kinetic();
  return motion_.kinetic(added_inertia_);
}

// The inertia that scaling adds to each rotation of a director.
std::vector<CentralDifferences::Weight> Explicit::added_inertia() const {
  std::vector<CentralDifferences::Weight> added;
  if (!scaled_) return added;
  const auto &scaled = assembly_->cloth().rotary_inertia(true),
             &own = assembly_->cloth().rotary_inertia(false);
  const auto& nodes = assembly_->dofs().freedoms().nodes;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (int c = 3; c < 5; ++c)
      if (!nodes[n].turn_axis && nodes[n].equation[c] >= 0)
        added.push_back({nodes[n].equation[c], scaled[n] - own[n]});
  return added;
}

void Explicit::give_up(const StepReport& report) {
  const double now = committed_time();
  Culprit found = stuck() ? Culprit{} : culprit(report.step);
  // A term that gives a reason also names the place.
  if (const auto& said = assembly_->outcome(); end_ == End::forces && !said.why.empty())
    found.element = said.element;
  std::string text = "dynamic: stopped at time " + number(now) + " s: ";
  text += reason() + " in a step of ";
  text += number(report.step) + " s";
  if (found.element >= 0) text += ", about element " + std::to_string(found.element + 1);
  if (stuck())
    text += ".\nTry: " + against_passing() + "; or loads and velocities that are in SI units.";
  else
    text += ".\nTry: " + found.advice + ".";
  std::string why = text.substr(std::string("dynamic: ").size());
  why += "\nstretch    the sheet is stretched to " + number(assembly_->cloth().readings().largest_stretch()) +
         " times its length at most, the step in use is " + number(now_.step / stable_) +
         " of the stable one";
  if (found.element >= 0) why += "\nelement    " + shape_text(found.element);
  if (const mesh::Index node = fastest_node(); node >= 0)
    why +=
        "\nfastest    node " + std::to_string(node + 1) + " with " + number(velocity(node).norm()) + " m/s";
  fail(NumericalFailure(text, now, found.element), why);
}

// The stiffness that the mesh carries grows with the inverse square of its elements' size, and the speed that
// is stopped with its inverse. Bodies and nodes have lost speed since they came: the speed that they have now
// is a lower bound. Empty: the speed is stopped, or the stiffness was given.
std::string Explicit::finer_elements() const {
  if (contact_ == nullptr) return {};
  const auto stopped = contact_->speed_stopped();
  const mesh::Index node = fastest_node();
  const double speed =
      std::max(contact().bodies().readings().fastest_free(), node >= 0 ? velocity(node).norm() : 0);
  if (stopped.given || !(speed > stopped.flat)) return {};
  const double finer = std::ceil(speed / stopped.flat);
  return "elements that are " + number(finer) + " times as short, " +
         number(finer * finer * static_cast<double>(model_->mesh().elements.size())) + " in all, for the " +
         number(speed) + " m/s that there are; ";
}

std::string Explicit::against_passing() const {
  const auto stopped = contact_->speed_stopped();
  if (!std::isfinite(stopped.flat)) return "bodies that meet each other with less speed";
  return finer_elements() +
         "more thickness= or stiffness= of m:contact (as it is, it stops cloth that comes with " +
         number(stopped.anywhere) + " m/s anywhere, with " + number(stopped.flat) +
         " m/s where it meets something flat)";
}

// Cloth that tools pinch is pressed for as long as they do, so that the speed that contact stops says nothing
// about it. A stiffer law makes all steps shorter, but by the root of its stiffness: far less than the guard.
std::string Explicit::against_pressing() const {
  const auto nearest = contact().readings().nearest();
  const auto found = contact_->pressed(nearest.point, nearest.gap);
  if (!found) return against_passing();
  const double step = std::min(now_.step, found->step);
  if (!contact_->needs_short_steps())
    return "a wider gap, or a holder with m:force, in place of two tools in a fixed gap; on an edge elements "
           "no "
           "longer than its radius, or a rounder edge; or slower tools: these nodes are pressed with " +
           number(found->pressure, 2) + " Pa, contact as it is carries " + number(found->carried, 2) +
           " Pa before its barrier begins, and so near to the smallest distance a longer step might pass it";
  return "stiffness=" + number(found->stiffness, 2) + " in m:contact, with steps of " + number(step, 2) +
         " s: these nodes are pressed with " + number(found->pressure, 2) +
         " Pa, and contact as it is carries " + number(found->carried, 2) +
         " Pa before its barrier begins (between two tools in a fixed gap the pressure grows with the "
         "stiffness: there a wider gap, or a holder with m:force; on an edge elements no longer than its "
         "radius, more thickness= with tools set off by half of it, or a rounder edge); or, if the cloth "
         "comes fast, " +
         against_passing();
}

// Where the reference configuration does not allow the step, its element is named: later all are torn.
std::optional<Explicit::Culprit> Explicit::frequency_above(double step) const {
  auto highest = mechanics::fastest_element(*assembly_, scaled_, added_, mechanics::At::reference);
  if (step <= bound_of(highest.rate))
    highest = mechanics::fastest_element(*assembly_, scaled_, added_, mechanics::At::trial);
  const double bound = bound_of(highest.rate);
  if (!(step > bound)) return {};
  const bool loads = 2 * highest.added > highest.rate;
  return Culprit{highest.element,
                 "a step below " + number(kOfBound * bound) + " s, which " + shape_text(highest.element) +
                     " allows; or " +
                     (loads ? "softer springs or loads there" : "a mesh without such an element")};
}

std::string Explicit::against_long_step() const {
  const auto found = frequency_above(now_.step);
  return found ? found->advice : std::string();
}

Explicit::Culprit Explicit::culprit(double step) const {
  if (step > nominal_)
    return {fastest_element(), "step=\"auto\" (the step is above the stable one, " + number(stable_) + " s)"};
  if (const auto found = frequency_above(step)) return *found;
  std::string advice =
      "a step below " + number(step / 2) + " s (the stable one is " + number(stable_) + " s)";
  if (const mesh::Index node = fastest_node(); node >= 0)
    advice += "; or loads and velocities that are in SI units (node " + std::to_string(node + 1) +
              " moves with " + number(velocity(node).norm()) + " m/s)";
  return {fastest_element(), advice};
}

// "element 12 (a triangle, 0.02 m long and 0.001 m high)"
std::string Explicit::shape_text(mesh::Index element) const {
  const auto& e = model_->mesh().elements[static_cast<std::size_t>(element)];
  const auto& X = assembly_->dofs().reference();
  const int n = mechanics::corners(e);
  double longest = 0;
  for (int a = 0; a < n; ++a) longest = std::max(longest, (X[e[(a + 1) % n]] - X[e[a]]).norm());
  return "element " + std::to_string(element + 1) + (n == 3 ? " (a triangle, " : " (") + number(longest) +
         " m long and " + number(mechanics::size(e, X)) + " m high)";
}

mesh::Index Explicit::fastest_element() const {
  const auto& X = assembly_->dofs().reference();
  mesh::Index fastest = -1;
  double most = 0;
  for (mesh::Index i = 0; i < assembly_->cloth().elements(); ++i) {
    const auto& e = model_->mesh().elements[static_cast<std::size_t>(i)];
    for (int a = 0, n = mechanics::corners(e); a < n; ++a) {
      const auto from = e[a], to = e[(a + 1) % n];
      const double rate = (velocity(to) - velocity(from)).norm() / (X[to] - X[from]).norm();
      if (!(rate > most)) continue;
      most = rate;
      fastest = i;
    }
  }
  return fastest;
}

bool Explicit::stuck() const {
  return contact_ != nullptr && block_.halved >= kHalvings && end_ != End::ran_away;
}

std::string Explicit::reason() const {
  if (stuck())
    return "surfaces are pressed together to the smallest distance, and a step adds more force than contact "
           "can carry";
  if (end_ == End::ran_away) return "a node moves by more than an element";
  if (end_ == End::limited) return "nodes move farther than is safe for what they meet";
  const std::string& why = assembly_->outcome().why;
  return why.empty() ? "a strain is not finite" : why;
}

mesh::Index Explicit::fastest_node() const {
  mesh::Index fastest = -1;
  double most = 0;
  for (mesh::Index n = 0; n < static_cast<mesh::Index>(assembly_->dofs().reference().size()); ++n)
    if (const double v = velocity(n).norm(); v > most) {
      most = v;
      fastest = n;
    }
  return fastest;
}

void Explicit::memory(Archive& archive) {
  archive(now_, motion_, added_, conserved_);
  problem_.keep(archive);
  if (contact_ != nullptr) archive(block_, hooked_);
  if (!archive.reading()) return;
  dirty_ = false;
  motion_.show_trial(false);
  rates_version_ = 0;
}

}  // namespace fabricsh::run
