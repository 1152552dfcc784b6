#include "run/dynamic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/box.hpp"
#include "mechanics/terms/contact.hpp"
#include "mechanics/terms/damping.hpp"
#include "mechanics/terms/seams.hpp"
#include "run/explicit.hpp"
#include "run/flat.hpp"
#include "run/implicit.hpp"
#include "run/settings.hpp"

namespace fabricsh::run {

namespace {

constexpr int kChecks = 200;            // checks of the ledger in a run
constexpr int kApart = 16;              // least number of explicit steps between checks: one costs a step
constexpr int kYoung = 50;              // steps until the trapezoidal rule gives a reliable work
constexpr double kYoungPart = 0.1;      // of the duration of a driven implicit run
constexpr double kYoungLimit = 10;      // factor on the limit for implicit steps until then
constexpr double kWarning = 1e-3;       // created energy over the external work
constexpr double kShortWarning = 1e-2;  // the same in a run of fewer than kYoung steps
constexpr double kHeavy = 0.05;   // fraction of the kinetic energy in scaled rotary inertia that is tolerated
constexpr int kLooksForRest = 8;  // in the window of rest
constexpr double kStill = 1e-3;   // of the size of the cloth: the way of a node at rest
constexpr double kRestPart = 1.0 / 3;  // of the time since it was led: so long it has to be calm at least
constexpr double kCreep = 0.25;  // of that way within the window, at the speed of the whole: nothing begins
constexpr double kRateStep = 1e-6;  // s, for differences of prescribed motions

void refuse(const char* field, const char* expected, double got) {
  throw Error(std::string("dynamic: field '") + field + "': expected " + expected + ", got " + number(got));
}

void check_radius(const DynamicOptions& o) {
  if (o.scheme == Scheme::explicit_steps)
    throw Error("dynamic: field 'spectral_radius': unknown for scheme=\"explicit\", which damps nothing");
  if (o.gamma != 0.5 || o.beta || o.hht)
    throw Error(
        "dynamic: field 'spectral_radius': expected without 'gamma', 'beta' and 'hht', which choose the "
        "scheme in another way");
}

void check_slow(const DynamicOptions& o) {
  if (o.scheme == Scheme::explicit_steps)
    throw Error("dynamic: field 'slow': expected with scheme=\"implicit\": explicit steps follow every wave");
  if (o.spectral_radius)
    throw Error("dynamic: field 'slow': expected without 'spectral_radius', which it sets to 0");
}

void check_options(const DynamicOptions& o) {
  const bool is_explicit = o.scheme == Scheme::explicit_steps;
  const double hht = o.hht.value_or(0);
  field::require("dynamic", dynamic_options(), o);
  if (o.step) check_step("dynamic", *o.step, o.duration);
  if (is_explicit && o.beta.value_or(0) != 0) refuse("beta", "0 (scheme=\"explicit\")", *o.beta);
  if (is_explicit && o.linear != Symmetry::automatic)
    throw Error("dynamic: field 'linear': unknown for scheme=\"explicit\", which solves no equations");
  if (!is_explicit && o.beta && !(*o.beta >= 0.25 * (0.5 + o.gamma) * (0.5 + o.gamma) * (1 - 1e-12)))
    refuse("beta", "at least (1/2 + gamma)^2/4, below which steps are only conditionally stable", *o.beta);
  if (is_explicit && hht != 0) refuse("hht", "0 (scheme=\"explicit\")", hht);
  if (hht != 0 && (o.gamma != 0.5 || o.beta))
    refuse("hht", "0 beside gamma or beta, which it sets itself", hht);
  if (o.spectral_radius) check_radius(o);
  if (o.until_rest && !(o.until_rest->window < o.duration))
    refuse("until_rest.window", ("less than the duration, " + number(o.duration) + " s").c_str(),
           o.until_rest->window);
}

// The options, checked, with what those that stand for another one set.
DynamicOptions checked(DynamicOptions options) {
  if (options.slow) {
    check_slow(options);
    options.spectral_radius = 0;
  }
  check_options(options);
  return options;
}

// Whether any of the histories changes between two times: at their middle or end.
struct Driven : model::DeclarationVisitor {
  double begin, end;
  bool any;
  Driven(double from, double to, bool at_once) : begin(from), end(to), any(at_once) {}
  void history(const char*, const std::optional<history::History>& h, auto...) {
    if (h) any = any || h->value((begin + end) / 2) != h->value(begin) || h->value(end) != h->value(begin);
  }
  void components(const model::Components& value, auto...) {
    for (const auto& h : value) history("", h);
  }
};

// Cloth that is moved or loaded slowly has next to no kinetic energy, and does not rest.
bool driven(const Run& run, double look) {
  const model::Model& model = run.model();
  const double from = run.time() - look, to = run.time();
  Driven seen{from, to, run.released_over() > 0 && from < run.began() + run.released_over()};
  model.declarations().each_kind([&seen]<class D>(const std::vector<D>& all) {
    for (const D& one : all)
      if constexpr (std::is_same_v<D, model::GasPointer>)
        seen.any = seen.any || (one->inflow && one->inflow->value(seen.end) != 0);
      else
        D::tell(one, seen);
  });
  for (const auto& body : model.interactions().bodies())
    if (const auto* shapes = body->moving(); shapes != nullptr && !shapes->times.empty())
      seen.any = seen.any || from < shapes->times.back();
  return seen.any;
}

}  // namespace

Dynamic::Dynamic(std::shared_ptr<model::Model> model, const DynamicOptions& options,
                 std::shared_ptr<Notices> notices, const Beginning& beginning)
    : Run(std::move(model), options.duration, std::move(notices), "dynamic", beginning),
      options_(checked(options)),
      given_(options_) {
  if (options_.limit == Limit::stop) stop_beyond();
  if (const auto* const contact = assembly_->terms().find<mechanics::Contacts>();
      contact != nullptr && !contact->bodies().without_mass().empty())
    throw Error("dynamic: forces, springs or supports place the " + contact->bodies().without_mass() +
                ", which has no mass: expected mass= where it is made (fabric.static needs none)");
  scaled_ = options_.scaled.value_or(options_.scheme == Scheme::explicit_steps);
  using namespace mechanics;
  // A state that is gone on from stays at rest with the masses that it has.
  const auto* const before = dynamic_cast<const Dynamic*>(beginning.from);
  moves_mass_ = scaled_ && (beginning.from == nullptr || (before != nullptr && before->moves_mass_));
  if (scaled_) assembly_->terms().elements().scale_mass(!moves_mass_);
  if (auto* const contacts = assembly_->terms().find<Contacts>(); contacts != nullptr && moves_mass_)
    contacts->masses_changed();
  inertia_ = &assembly_->terms().add(
      std::make_unique<Inertia>(assembly_->cloth().mass(), assembly_->cloth().rotary_inertia(scaled_)));
  if (options_.mass_damping > 0)
    assembly_->terms().add(std::make_unique<MassDamping>(*assembly_, options_.mass_damping));
  if (options_.stiffness_damping > 0)
    assembly_->terms().add(std::make_unique<StiffnessDamping>(*assembly_, options_.stiffness_damping));
  stable_ = assembly_->terms().stable_step(scaled_);
  smallest_ = assembly_->cloth().rates().smallest_size();
  now_.led_until = began();
  if (options_.until_rest) every(options_.until_rest->window / kLooksForRest, [this](Run&) { watch_rest(); });
}

bool Dynamic::is_calm(const EnergyAccount& e) const {
  return e.stored > 0 && e.kinetic <= options_.until_rest->calm * e.stored;
}

bool Dynamic::is_led() const {
  return (seams_ != nullptr && seams_->draws()) || driven(*this, options_.until_rest->window / kLooksForRest);
}

double Dynamic::still() const {
  const double size = box_of(assembly_->dofs().reference()).size().norm();
  return options_.until_rest->still.value_or(kStill * size);
}

double Dynamic::rests_after() const {
  return std::max(options_.until_rest->window, kRestPart * (time() - now_.led_until)) * (1 - 1e-9);
}

// Energies alone do not tell: seams and contact may store much, and a slow swing is calm where it turns
// around. What moves little in a third of the time moves little in the time to come, unless it begins to.
void Dynamic::watch_rest() {
  if (now_.rested) return;
  const EnergyAccount e = energy();
  const auto x = std::as_const(*assembly_).state().x();
  if (is_led()) now_.led_until = time();
  if (now_.led_until == time() || !is_calm(e)) {
    now_.calm_since = -1;
    return;
  }
  const auto from_here = [&] {
    now_.calm_since = time();
    now_.calm_kinetic = e.kinetic;
    now_.calm_places.assign(x.begin(), x.end());
  };
  double way = 0;
  if (now_.calm_since >= 0)
    for (std::ptrdiff_t n = 0; 3 * n < static_cast<std::ptrdiff_t>(x.size()); ++n)
      way = std::max(way, (at(x, n) - at(now_.calm_places, n)).norm());
  if (now_.calm_since < 0 || way > still()) from_here();
  if (time() - now_.calm_since < rests_after()) return;
  const auto& masses = assembly_->cloth().mass();
  const double creep = kCreep * still() / options_.until_rest->window;
  if (e.kinetic > now_.calm_kinetic &&
      2 * e.kinetic > std::accumulate(masses.begin(), masses.end(), 0.0) * creep * creep)
    return from_here();
  now_.rested = true;
  watch_loss(e);
  if (const std::vector<double> kinks = model().kinks(); !kinks.empty() && time() < kinks.back())
    notices().remark("dynamic: at rest at " + number(time()) + " s; loads or motions of the model go on to " +
                     number(kinks.back()) + " s, and are not waited for");
  stop("at rest");
}

void Dynamic::report_unrest(const EnergyAccount& e) {
  if (!options_.until_rest || now_.rested) return;
  std::string why;
  if (seams_ != nullptr && seams_->draws()) why = "seams are still drawn together";
  if (driven(*this, options_.until_rest->window / kLooksForRest))
    why += (why.empty() ? "" : ", ") + std::string("loads or motions still change");
  if (!is_calm(e))
    why += (why.empty() ? "" : ", ") + std::string("the kinetic energy is ") +
           number(e.stored > 0 ? e.kinetic / e.stored : e.kinetic, 3) +
           (e.stored > 0 ? " of that stored" : " J, and none is stored") + " (calm is up to " +
           number(options_.until_rest->calm) + ")";
  if (why.empty())
    why = "no node has moved by more than " + number(still(), 3) + " m for " +
          number(time() - std::max(now_.calm_since, began()), 3) + " s only, of " + number(rests_after(), 3) +
          " s";
  warn("rest", "warning: dynamic: not at rest at the end, " + number(time()) + " s: " + why +
                   "; a longer duration or more damping would do");
}

std::string Dynamic::method() const {
  const auto& o = options_;
  std::ostringstream text;
  text << std::boolalpha << (o.scheme == Scheme::explicit_steps ? "explicit" : "implicit") << " with gamma "
       << number(o.gamma) << ", beta " << number(o.beta.value_or(-1)) << ", hht " << number(o.hht.value_or(0))
       << ", damping " << number(o.mass_damping) << " and " << number(o.stiffness_damping)
       << ", scaled inertia " << scaled_ << ", line search " << o.line_search << ", force " << o.force
       << solver_text(o.solver);
  if (o.spectral_radius || radius_ < 1) text << ", spectral radius " << number(radius_);
  text << decided_text(dynamic_options(), o);
  if (o.until_rest)
    text << ", until rest " << number(o.until_rest->calm) << " for " << number(o.until_rest->window)
         << " s within " << number(o.until_rest->still.value_or(-1)) << " m";
  if (o.linear != Symmetry::automatic) text << ", linear " << static_cast<int>(o.linear);
  return text.str();
}

void Dynamic::set(const Settings& settings) {
  for (const Setting& setting : settings)
    if (const std::string why = refused_option(options_, setting.name); !why.empty())
      throw Error("set: field '" + setting.name + "': " + why);
  const DynamicOptions options = with_settings(options_, dynamic_options(), settings);
  check_options(options);
  take_options(options);
}

void Dynamic::keep_settings(Archive& archive) {
  DynamicOptions options = options_;
  run::keep_settings(archive, dynamic_options(), given_, options);
  if (archive.reading()) take_options(options);
}

void Dynamic::begin() {
  const double start = began();
  const auto targets = assembly_->dofs().targets(start);
  if (origin() != 0) {
    if (const std::string jump = jump_of_motions(); !jump.empty())
      warn("jump",
           "dynamic: " + jump + " where the state of the other run has it; the sheet starts with it there");
  } else if (std::any_of(targets.begin(), targets.end(), [](double t) { return t != 0; })) {
    warn("jump", "dynamic: a motion is not zero at time 0; the sheet starts with its nodes there");
  }
  const std::vector<double> still(assembly_->dofs().unknowns(), 0);
  assembly_->begin_iterate();
  assembly_->apply_increment(still, 1, targets);
  assembly_->set_time(start);
  if (!assembly_->forces({start, 0}))
    throw NumericalFailure("dynamic: the fabric law failed at time " + number(start), start,
                           assembly_->outcome().element);
  assembly_->commit(start);
  assembly_->terms().external(start, dead_);
  const mechanics::NodalRates rates = initial_rates();
  set_motion(rates);
  report_dropped_rates(rates);
  work_.start(*assembly_, dead_);
  now_.driven_kinetic_at_0 = driven_kinetic();
  now_.next_check = next_look(start);
}

mechanics::NodalRates Dynamic::initial_rates() const {
  const auto& X = assembly_->dofs().reference();
  if (!left_rates().x.empty()) return left_rates();
  mechanics::NodalRates rates{std::vector<double>(3 * X.size(), 0), std::vector<double>(3 * X.size(), 0)};
  const auto d = std::as_const(*assembly_).state().d();
  for (const auto& given : model_->all<model::InitialVelocity>())
    for (const auto n : model_->mesh().set(given.set)) {
      const model::RigidVelocity here = given.at(X[n]);
      const Vec3 v = here.linear + here.spin.cross(X[n] - here.centre);
      const Vec3 w = here.spin.cross(at(d, n));
      for (int i = 0; i < 3; ++i) {
        rates.x[3 * n + i] = v[i];
        rates.d[3 * n + i] = w[i];
      }
    }
  return rates;
}

// The nodes with an initial velocity along a held or driven degree of freedom; `axes` marks the directions.
std::vector<bool> Dynamic::dropped_nodes(const mechanics::NodalRates& rates,
                                         std::array<bool, 3>& axes) const {
  std::vector<bool> dropped(assembly_->dofs().reference().size(), false);
  for (std::size_t n = 0; n < dropped.size(); ++n) {
    const auto& freedoms = assembly_->dofs().freedoms().nodes[n];
    const Vec3 v = freedoms.frame * at(rates.x, static_cast<std::ptrdiff_t>(n));
    for (std::size_t i = 0; i < 3; ++i) {
      const auto equation = freedoms.equation[i];
      if (v[static_cast<int>(i)] == 0 || equation >= 0 || equation == mechanics::tied) continue;
      dropped[n] = axes[i] = true;
    }
  }
  return dropped;
}

// Gives one notice for all sets together.
void Dynamic::report_dropped_rates(const mechanics::NodalRates& rates) {
  constexpr std::size_t most = 3;  // number of sets named
  std::array<bool, 3> axes{};
  const auto dropped = dropped_nodes(rates, axes);
  const auto nodes = std::count(dropped.begin(), dropped.end(), true);
  if (nodes == 0) return;
  std::vector<std::string> sets;
  for (const auto& given : model_->all<model::InitialVelocity>()) {
    const auto& set = model_->mesh().set(given.set);
    const bool touched = std::any_of(set.begin(), set.end(), [&](auto n) { return dropped[n]; });
    if (touched && std::find(sets.begin(), sets.end(), given.set) == sets.end()) sets.push_back(given.set);
  }
  std::string names = sets.empty()       ? "the velocities of the run before"
                      : sets.size() == 1 ? "the velocity of set "
                                         : "the velocities of sets ",
              along;
  for (std::size_t i = 0; i < std::min(most, sets.size()); ++i)
    names += (i == 0 ? "'" : i + 1 == sets.size() ? " and '" : ", '") + sets[i] + "'";
  if (sets.size() > most) names += " and " + std::to_string(sets.size() - most) + " more";
  for (std::size_t i = 0; i < 3; ++i)
    if (axes[i]) along += std::string(" ") + "xyz"[i];
  warn("dropped", "dynamic: " + names + (sets.size() == 1 ? " is" : " are") + " dropped along" + along +
                      " at " + std::to_string(nodes) + (sets.size() == 1 ? " of its" : " of their") +
                      " nodes, which are fixed or moved there");
}

void Dynamic::watch_jump(const std::vector<double>& from, const std::vector<double>& to, double time,
                         double most) {
  if (now_.reported_jump) return;
  const auto& motions = assembly_->dofs().freedoms().motions;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const double moved = std::abs(to[i] - from[i]);
    if (motions[i].component > 2 || !(moved > most)) continue;
    now_.reported_jump = true;
    return warn("jump", "dynamic: the motion of node " + std::to_string(motions[i].node + 1) + " jumps by " +
                            number(moved) + " m within the step that ends at time " + number(time) +
                            " s: this is an impact, and the energy ledger will show it; use fabric.ramp for "
                            "a gradual motion");
  }
}

std::vector<double> Dynamic::driven_rates() const {
  // Not beyond the end of the run, where a history of the deck may not be defined.
  const double width = std::min(kRateStep, 1e-3 * now_.step);
  const double from = std::max(0.0, time() - width), to = time() >= duration_ ? time() : time() + width;
  auto later = assembly_->dofs().targets(to);
  const auto before = assembly_->dofs().targets(from);
  for (std::size_t i = 0; i < later.size(); ++i) later[i] = (later[i] - before[i]) / (to - from);
  return later;
}

double Dynamic::energy_of_corner() const {
  const auto& freedoms = assembly_->dofs().freedoms();
  const double now = time(), width = std::min(kRateStep, 1e-3 * now_.step);
  if (freedoms.motions.empty() || now + width > duration_) return 0;
  const bool first = now <= began();
  const auto initial = first ? initial_rates() : mechanics::NodalRates{};
  const auto before = assembly_->dofs().targets(first ? now : now - width),
             at_it = assembly_->dofs().targets(now), after = assembly_->dofs().targets(now + width);
  // What a smooth motion gains within the width is next to nothing of what it does in a step.
  const double step = std::min(now_.step, duration_ - now);
  const auto later = assembly_->dofs().targets(now + step);
  double jump = 0, fastest = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto& m = freedoms.motions[i];
    if (m.component > 2) continue;
    fastest =
        std::max({fastest, std::abs(at_it[i] - before[i]) / width, std::abs(later[i] - at_it[i]) / step});
    const double from = first ? freedoms.nodes[m.node].frame.row(m.component).dot(at(initial.x, m.node))
                              : (at_it[i] - before[i]) / width;
    jump = std::max(jump, std::abs((after[i] - at_it[i]) / width - from));
  }
  const auto& masses = assembly_->cloth().mass();
  return jump > 0.1 * fastest ? std::accumulate(masses.begin(), masses.end(), 0.0) * jump * jump / 2 : 0;
}

double Dynamic::driven_kinetic() const {
  const auto& motions = assembly_->dofs().freedoms().motions;
  if (motions.empty()) return 0;
  const auto rates = driven_rates();
  double sum = 0;
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (motions[i].component < 3) sum += assembly_->cloth().mass()[motions[i].node] * rates[i] * rates[i] / 2;
  return sum;
}

// From the way up to now alone: where a history has a kink, what comes after it has not happened.
Vec3 Dynamic::inertia(mesh::Index node) const {
  Vec3 force = Vec3::Zero();
  const auto& freedoms = assembly_->dofs().freedoms();
  const auto on = assembly_->terms().on_mass();
  for (int c = 0; c < 3; ++c) {
    const auto equation = freedoms.nodes[node].equation[c];
    if (equation >= mechanics::held || equation == mechanics::tied) continue;
    const auto& m = freedoms.motions[mechanics::motion_of(equation)];
    const auto& history = freedoms.histories[m.history];
    const double h = std::max(1e-5, 1e-4 * now_.step), t = std::max(time(), 2 * h);
    const double earlier = m.of(history.value(t - 2 * h)), before = m.of(history.value(t - h)),
                 now = m.of(history.value(t));
    const double a = (earlier - 2 * before + now) / (h * h), v = (3 * now - 4 * before + earlier) / (2 * h);
    force += assembly_->cloth().mass()[node] * (on.acceleration * a + on.velocity * v) *
             assembly_->dofs().freedoms().nodes[node].frame.row(m.component).transpose();
  }
  return force;
}

// A support that accelerates its nodes supplies their kinetic energy.
double Dynamic::driven_work() const { return driven_kinetic() - now_.driven_kinetic_at_0; }

// The element in which a law created most energy; otherwise the one with the largest energy density.
mesh::Index Dynamic::suspect() const {
  mesh::Index maker = 0, densest = 0;
  double most = 0, density = -1;
  for (mesh::Index e = 0; e < assembly_->cloth().elements(); ++e) {
    double created = 0, stored = 0, volume = 0;
    assembly_->cloth().readings().visit(
        e, [&](double w, const law::Law& law, const double* E, const double* state) {
          const auto energy = law::energy(law, E, state);
          created += w * energy.created;
          stored += w * (energy.stored + energy.dissipated());
          volume += w;
        });
    if (created > most) {
      most = created;
      maker = e;
    }
    if (!(stored / volume <= density)) {
      density = stored / volume;
      densest = e;
    }
  }
  return most > 0 ? maker : densest;
}

// Above the stable step the energy grows without limit; other runs may continue with a larger limit.
std::string Dynamic::remedy(const EnergyAccount& e) const {
  if (options_.scheme == Scheme::explicit_steps && now_.step > stable_)
    return "step=\"auto\" (the step of " + number(now_.step) + " s is above the stable one, " +
           number(stable_) + " s, of the cloth at rest)";
  if (const std::string advice = against_long_step(); !advice.empty()) return advice;
  return finer_elements() + "a smaller step (now " + number(now_.step) + " s)" +
         (e.created > 0 ? "; or law=\"potential\", which creates no energy" : "") +
         "; ledger_limit=" + number(10 * options_.ledger_limit) + " goes on";
}

// A few times in a run: a factorisation each. Where a sheet moves fast, its inertia keeps it flat for a
// while.
void Dynamic::watch_flat(const EnergyAccount& e) {
  constexpr double at[] = {0.1, 0.25, 0.5, 0.75, 1 - same_time};  // of the duration
  const auto looks = static_cast<std::size_t>(now_.flat_looks);
  if (looks >= std::size(at) || time() - began() < at[looks] * (duration_ - began()) || warned("unstable"))
    return;
  now_.flat_looks = is_flat(*assembly_) ? now_.flat_looks + 1 : static_cast<int>(std::size(at));
  if (static_cast<std::size_t>(now_.flat_looks) != looks + 1 || !(e.stored > e.kinetic)) return;
  if (const auto place = leaves_its_plane(*model_, *assembly_))
    warn("unstable", "warning: dynamic: at time " + number(time()) +
                         " s the sheet is flat, but not stable: real cloth buckles, most at " + *place +
                         ". Nothing in the model leads it out of its plane, so that it stays flat for ever" +
                         advice("imperfection=" + number(1e-2 * model_->thickness(), 2) +
                                " (m) of fabric.model breaks the symmetry"));
}

bool Dynamic::is_end(double time) const { return std::abs(time - duration_) <= same_time * duration_; }

double Dynamic::next_look(double after) const {
  const double apart = (duration_ - began()) / kChecks;
  return began() + apart * (std::floor((after - began()) / apart + 1e-9) + 1);
}

bool Dynamic::is_due(double time) const { return is_end(time) || time >= now_.next_check; }

bool Dynamic::looks_after(std::int64_t steps, double time) const {
  return is_end(time) || (is_due(time) && steps >= now_.looked + kApart);
}

// J: the kinetic energy that rounding alone can cause. Positions are rounded to about 1e-16 of the cloth's
// size; correcting such an error within one step gives a node a speed, and over many steps these speeds add
// up. The bound is the energy of the whole mass at 1e5 times that speed, some um/s, as in cloth at rest.
double energy_of_rounding(const mechanics::Assembly& assembly, double step) {
  const auto& masses = assembly.cloth().mass();
  const double mass = std::accumulate(masses.begin(), masses.end(), 0.0);
  const double speed =
      1e5 * std::numeric_limits<double>::epsilon() * box_of(assembly.dofs().reference()).size().norm() / step;
  return mass * speed * speed / 2;
}

// "3.8 % of the external work", or of what the error is compared with in its place.
std::string Dynamic::share_text(double made, const EnergyAccount& e, double scale) const {
  const char* of = scale <= work_.largest()            ? "the external work"
                   : scale <= e.initial                ? "the energy at the start"
                   : scale <= e.kinetic + e.internal() ? "the energy of the motion and the cloth"
                   : scale <= energy_of_rest()         ? "the cloth's weight times its thickness"
                                                       : "what rounding can cause";
  std::string text = number(100 * made / scale) + " % of " + of;
  if (scale > work_.largest() && work_.largest() > 0)
    text += " (" + number(made / work_.largest()) + " times the external work)";
  return text;
}

// At the beginning the work is almost zero, so the error is compared with the largest energies of the run,
// and at least with what rounding can cause, so that rounding is no error before anything moves, and with the
// weight over a thickness where cloth rests on something and hardly any work is done.
double Dynamic::ledger_scale(const EnergyAccount& e) const {
  return std::max({work_.largest(), e.initial, e.kinetic + e.internal(), energy_of_rest(),
                   energy_of_rounding(*assembly_, now_.step) / kWarning});
}

// A body that nothing has touched does no work.
bool Dynamic::is_driven() const {
  const mechanics::Contacts* contact = assembly_->terms().find<mechanics::Contacts>();
  return !assembly_->dofs().freedoms().motions.empty() ||
         (contact != nullptr && contact->bodies().any_driven() &&
          (now_.touched >= 0 || contact->readings().touching() > 0));
}

// If supports begin to move with a jump in velocity, the trapezoidal rule gives their work badly at first; so
// it does where a moved body comes to touch.
bool Dynamic::is_young() const {
  if (options_.scheme == Scheme::implicit_steps)
    return is_driven() && time() - began() < kYoungPart * (duration_ - began());
  return has_few_steps();
}

// The fewer the steps, the less work has been done after those. Implicit steps that were halved are no more
// work.
bool Dynamic::has_few_steps() const {
  return now_.steps < std::max<std::int64_t>(0, now_.touched) + kYoung ||
         (options_.scheme == Scheme::implicit_steps && time() - began() < kYoung * largest_step());
}

void Dynamic::check() {
  // The cost of a check is small compared with an implicit step, and the energy balance of implicit steps is
  // good from the first one on.
  const bool is_implicit = options_.scheme == Scheme::implicit_steps;
  const bool end = is_end(time());
  if (!is_implicit && !is_due(time())) return;
  const bool looks = is_implicit || looks_after(now_.steps, time());
  now_.next_check = next_look(time());
  if (!looks) return;
  watch_shape();
  now_.looked = now_.steps;
  const EnergyAccount e = energy();
  weigh_inertia(e.kinetic, e.scaled);
  watch_flat(e);
  if (is_implicit) watch_barrier(e);
  if (end) {
    watch_guard(e);
    watch_pressed(e);
    watch_crossings();
    watch_loss(e);
    watch_inertia();
    report_unrest(e);
  }
  const double scale = ledger_scale(e);
  const bool swings = options_.hht.value_or(0) != 0 || options_.beta || options_.spectral_radius ||
                      now_.damping != Damping::none;  // what alpha has given back stays so
  watch_accounts(e, scale, swings ? options_.ledger_limit : 0);
  const double made = imbalance(e, scale) + e.created;
  const mechanics::Contacts* contact = assembly_->terms().find<mechanics::Contacts>();
  if (now_.touched < 0 && contact != nullptr && contact->bodies().any_driven() &&
      contact->readings().touching() > 0)
    now_.touched = now_.steps;
  // A run of a few explicit steps is over before it is of age: what it ends with counts all the same.
  const bool is_short = !is_implicit && end && !is_driven();
  const bool is_lenient = is_implicit && is_driven() && (is_young() || has_few_steps());
  if (is_lenient) now_.early = std::max(0.0, made);
  now_.unsure = is_lenient ? std::clamp(made, 0.0, now_.unsure + off_) : now_.early;
  // What was made in steps in which that was allowed is judged at the end, when more work has been done.
  const double later = is_lenient || end ? made : made - now_.early;
  const double unsaid = !is_young()   ? (is_lenient && !end ? kShortWarning : kWarning)
                        : is_implicit ? kYoungLimit * options_.ledger_limit
                        : is_short    ? kShortWarning
                                      : std::numeric_limits<double>::infinity();
  // What no work that is badly known can have been, and the next step does not take back, is not waited for.
  const double sure = is_lenient && !end ? made - now_.unsure : 0;
  const bool unsaid_yet = std::isfinite(made) && (scale <= 0 || made <= unsaid * scale),
             was_sure = std::exchange(now_.was_sure, sure > kShortWarning * scale);
  if (unsaid_yet && !(was_sure && now_.was_sure)) {
    now_.was_over = false;
    return;
  }
  const std::string share = share_text(made, e, scale);
  // Alpha's loss is the work of its forces: what it does not know, is missing from the ledger.
  const bool may_damp = std::isfinite(made) && !end && (e.surplus() > 0 || now_.damping == Damping::hht);
  const double known = unsaid_yet ? sure : later;
  const std::string damping = may_damp && known > kWarning * scale ? begin_to_damp(known / scale) : "";
  if (!(now_.reported_error || unsaid_yet) || !damping.empty()) {
    now_.reported_error = true;
    now_.began = suspect();
    warn("ledger",
         "dynamic: the ledger's error is " + share + " at time " + number(time()) +
             " s, most of it about element " + std::to_string(now_.began + 1) + ": " + damping +
             "repeat with a smaller step to see whether the step is the cause",
         now_.began);
  }
  const double limit = (is_lenient ? kYoungLimit : 1) * options_.ledger_limit;
  const bool over = !(later <= limit * scale), twice = now_.was_over;
  now_.was_over = over;
  if (std::isfinite(made) && !(over && (twice || end))) return;
  const std::string accounts = "\nenergies   kinetic " + number(e.kinetic) + ", stored " + number(e.stored) +
                               ", dissipated " + number(e.dissipated) + ", damping " + number(e.damping) +
                               ", external " + number(e.external) + ", made by the law " + number(e.created) +
                               " J";
  const NumericalFailure failure("dynamic: stopped at time " + number(time()) + " s: the ledger's error is " +
                                     share + "; it began about element " + std::to_string(now_.began + 1) +
                                     ".\nTry: " + remedy(e) + ".",
                                 time(), now_.began);
  fail(failure, std::string(failure.what()).substr(std::string("dynamic: ").size()) + accounts);
}

// Near equilibrium a scheme that damps takes little of what goes through a run; of a fall it takes much.
// Where next to nothing moves, it gets what supports do more than the steps of their forces tell.
void Dynamic::watch_loss(const EnergyAccount& e) {
  constexpr double shows = 0.1, moves = 0.01;
  const double scale = ledger_scale(e);
  if (!(now_.loss > shows * scale && now_.kinetic > moves * now_.loss) || warned("damped")) return;
  warn("damped", "dynamic: up to time " + number(time()) + " s the time scheme has taken " +
                     share_text(now_.loss, e, scale) +
                     " (energy.damping): falls, impacts and vibrations lose what the cloth would keep" +
                     advice("shorter steps, or a larger spectral_radius=, take less"));
}

double Dynamic::scaled_kinetic() const {
  if (!scaled_) return 0;
  const auto &scaled = assembly_->cloth().rotary_inertia(true),
             &own = assembly_->cloth().rotary_inertia(false);
  const auto& nodes = assembly_->dofs().freedoms().nodes;
  const auto& w = rates().d;
  double sum = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (!nodes[n].turn_axis)
      sum += (scaled[n] - own[n]) * at(w, static_cast<std::ptrdiff_t>(n)).squaredNorm() / 2;
  return sum;
}

static constexpr const char* true_inertia = "inertia=\"true\" takes the thickness' own, with smaller steps";

void Dynamic::weigh_inertia(double kinetic, double scaled) {
  now_.kinetic = std::max(now_.kinetic, kinetic);
  if (!(scaled > 0) || kinetic <= energy_of_rounding(*assembly_, now_.step) || kinetic <= energy_of_rest())
    return;
  now_.scaled = std::max(now_.scaled, scaled / now_.kinetic);
  if (now_.reported_scaled || now_.scaled <= kHeavy) return;
  now_.reported_scaled = true;
  warn("inertia",
       "dynamic: " + number(100 * scaled / now_.kinetic) +
           " % of the kinetic energy is in rotary inertia that is scaled up for the step, at time " +
           number(time()) + " s" + advice(true_inertia));
}

// A share of scaled inertia that is too small to be said at once, but shows in the answer.
void Dynamic::watch_inertia() {
  constexpr double shows = 0.01;
  if (!now_.reported_scaled && now_.scaled > shows)
    warn("inertia",
         "dynamic: up to " + number(100 * now_.scaled, 2) +
             " % of the kinetic energy was in rotary inertia that is scaled up for the step, and motions are "
             "slower by half as much" +
             advice(true_inertia));
}

std::shared_ptr<Dynamic> make_dynamic(std::shared_ptr<model::Model> model, const DynamicOptions& options,
                                      std::shared_ptr<Notices> notices, const Beginning& beginning) {
  if (options.scheme == Scheme::explicit_steps)
    return std::make_shared<Explicit>(std::move(model), options, std::move(notices), beginning);
  return std::make_shared<Implicit>(std::move(model), options, std::move(notices), beginning);
}

}  // namespace fabricsh::run
