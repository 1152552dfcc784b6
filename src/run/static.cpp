// The quasi-static run: steps, cuts and notices.
#include "run/static.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/box.hpp"
#include "mechanics/terms/contact.hpp"
#include "mechanics/terms/directors.hpp"
#include "mechanics/terms/gas.hpp"
#include "mechanics/terms/tears.hpp"
#include "run/flat.hpp"
#include "run/settings.hpp"

namespace fabricsh::run {

namespace {

void check_options(const StaticOptions& o) {
  field::require("static", static_options(), o);
  if (o.step) check_step("static", *o.step, o.duration);
  if (o.min_step > o.step.value_or(o.duration))
    throw Error("static: field 'min_step': expected a time in s from 0 to the largest step, got " +
                number(o.min_step));
  if (o.path && o.control == Control::arc)
    throw Error("static: field 'path': expected control=\"load\": steps along an arc are not compared");
  if (o.control == Control::arc &&
      (o.stabilise > 0 || o.method == Method::relaxation || o.method == Method::either))
    throw Error(
        "static: field 'control': \"arc\" works with Newton's method only: leave out 'stabilise' and "
        "'method'");
}

bool takes_symmetric(const StaticOptions& o, const mechanics::Assembly& assembly) {
  return takes_symmetric(o.linear, assembly.terms().symmetric());
}

StepControl control_of(const StaticOptions& o, const mechanics::Assembly& assembly) {
  StepControl control{o.step.value_or(o.duration / 20), o.min_step, o.max_cuts, kStaticIterations};
  // Nor need steps shrink further where relaxation takes over from Newton's method.
  if (assembly.terms().find<mechanics::Contacts>() != nullptr || o.method == Method::either)
    control.expect_friction();
  return control;
}

constexpr double kLedger =
    0.05;  // fraction of the external work taken by relaxation above which a warning says so

constexpr double kDissipated = 0.01;  // such a fraction of what the cloth has dissipated

// Relaxation is tried, if it is permitted, where a cut would make the step smaller than this part of the
// largest. Cuts of earlier steps count: in front of a load that jumps every step needs some, and none many.
constexpr double kPatience = 0.125;

// Where the deck leaves the default: a step with more is better cut.
constexpr int kNewtonIterations = 50;

// Cuts after which Newton's method tries a step; the equilibrium that it reaches must be stable, too.
constexpr int kOtherWay = 3;

// Cuts of a step after which it leaves an unstable equilibrium in one direction: near its bifurcation, so
// that the shape does not depend on the step; and those after which it leaves one in whatever direction.
constexpr int kNear = 3;
constexpr int kSeparating = 6;
// Of the usual turns, in a shape that has buckled before: the next one is near.
constexpr double kBuckled = 0.2;

constexpr int many_descents = 4000;  // linear solves of a step's overdamped motion

// Linear solves after which Newton's method hands over, and turns of both.
constexpr int kFirstTurn = 50, kTurns = 3;

bool some(const std::vector<double>& v) {
  return std::any_of(v.begin(), v.end(), [](double t) { return t != 0; });
}

bool bends_by_itself(const model::Model& model) {
  const auto& regions = model.regions();
  return std::any_of(regions.begin(), regions.end(),
                     [](const auto& r) { return r.card.bending.has_value(); });
}

// Whether a model has neither loads nor motions, nor anything to touch.
bool loads_nothing(const model::Model& m, const mechanics::Assembly& assembly) {
  const auto& g = m.gravity();
  const bool weighs = std::any_of(g.begin(), g.end(), [](const auto& history) { return bool(history); });
  bool loaded = false;
  m.declarations().each_kind(
      [&loaded]<class D>(const std::vector<D>& all) { loaded |= model::is_load<D> && !all.empty(); });
  return !weighs && !loaded && m.all<model::PrescribedMotion>().empty() &&
         m.all<model::GasPointer>().empty() && assembly.terms().find<mechanics::Contacts>() == nullptr;
}

bool has_free_bodies(const mechanics::Assembly& assembly) {
  const mechanics::Contacts* contact = assembly.terms().find<mechanics::Contacts>();
  return contact != nullptr && contact->bodies().any_free();
}

}  // namespace

Static::Static(std::shared_ptr<model::Model> model, const StaticOptions& options,
               std::shared_ptr<Notices> notices, const Beginning& beginning)
    : Run(std::move(model), options.duration, std::move(notices), "static", beginning),
      options_(options),
      given_(options),
      remembers_path_(depends_on_path()),
      places_bodies_(has_free_bodies(*assembly_)),
      has_energy_(assembly_->cloth().symmetric() && !places_bodies_),
      near_symmetric_(takes_unsymmetric() && options_.linear == Symmetry::automatic && !options_.solver &&
                      options_.control == Control::load && assembly_->terms().symmetric_but_apart()),
      now_{control_of(options, *assembly_)} {
  check_options(options_);
  if (options_.limit == Limit::stop) stop_beyond();
  check_bodies();
  if (places_bodies_)
    assembly_->terms().find<mechanics::Contacts>()->go_static(
        beginning.from != nullptr ? 0 : now_.step.largest());
  problem_ = std::make_unique<EquilibriumProblem>(*assembly_, 1e-7 * options_.duration, poll_);
  if (options_.stabilise > 0)
    stabilisation_ =
        &assembly_->terms().add(std::make_unique<mechanics::Stabilisation>(*assembly_, options_.stabilise));
  auto linear = make_linear();
  if (!takes_unsymmetric() && !options_.solver) assembly_->keep_upper();  // one of the user's may read both
  if (near_symmetric_) assembly_->keep_apart();
  if (options_.control == Control::arc && assembly_->cloth().is_rate_dependent())
    throw Error(
        "static: field 'control': \"arc\" follows the path of the loads, not the time: expected \"load\" "
        "with a card whose stress changes in time");
  const auto* const gas = assembly_->terms().find<mechanics::Gas>();
  if (options_.control == Control::arc && gas != nullptr && gas->flows())
    throw Error(
        "static: field 'control': \"arc\" follows the path of the loads, not the time in which gas flows: "
        "expected \"load\", or gas without inflow, vents and leakage");
  if (options_.control == Control::arc)
    arc_ = std::make_unique<solver::ArcLength>(std::move(linear));
  else
    stable_ = std::make_unique<solver::TrustRegion>(
        std::move(linear), near_symmetric_ || assembly_->terms().symmetric(), judge_of(*model_, *assembly_));
  if (arc_ && tears_ != nullptr) tears_->follow_path();
  if (!arc_) newton_ = std::make_unique<solver::Newton>(make_linear());
  if (options_.method == Method::automatic && !arc_ && has_energy_)
    helper_ = std::make_unique<solver::Descent>(make_linear());
  if (options_.method != Method::newton && !arc_ && !places_bodies_) {
    relaxation_ = std::make_unique<solver::Relaxation>();
    if (bends_by_itself(*model_)) descent_ = std::make_unique<solver::Descent>(make_linear());
  }
  take_beginning();
  report_contacts();
}

Static::~Static() = default;

std::unique_ptr<linear::LinearSolver> Static::make_linear() const {
  return make_solver(options_.solver, !takes_unsymmetric(), near_symmetric_);
}

bool Static::takes_unsymmetric() const { return !takes_symmetric(options_, *assembly_); }

std::string Static::method() const {
  std::ostringstream text;
  text << std::boolalpha << "static with control " << (arc_ ? "arc" : "load") << ", method "
       << static_cast<int>(options_.method) << ", linear " << static_cast<int>(options_.linear)
       << ", line search " << options_.line_search << ", stabilise " << number(options_.stabilise)
       << ", min_step " << number(options_.min_step) << ", path " << number(options_.path.value_or(0))
       << decided_text(static_options(), options_) << solver_text(options_.solver);
  return text.str();
}

void Static::set(const Settings& settings) {
  const StaticOptions options = with_settings(options_, static_options(), settings);
  check_options(options);
  options_ = options;
  const auto sizes = [](const Setting& s) { return s.name == "step" || s.name == "max_cuts"; };
  if (std::any_of(settings.begin(), settings.end(), sizes)) now_.step = control_of(options_, *assembly_);
}

void Static::keep_settings(Archive& archive) {
  const auto step = options_.step;
  const int max_cuts = options_.max_cuts;
  run::keep_settings(archive, static_options(), given_, options_);
  if (step != options_.step || max_cuts != options_.max_cuts) now_.step = control_of(options_, *assembly_);
}

void Static::begin() {
  problem_->set_time(began());
  problem_->start();
  dead_ = problem_->external();
  work_.start(*assembly_, dead_);
  note_energy();
  note_shape();
  if (origin() != 0) return begin_loaded();
  WorkingForces loads;
  find_working_forces(*assembly_, dead_, loads);
  const Jumps jumps = find_jumps(*model_, options_.duration);
  // A term that a program has added may push, too, and has no history.
  const auto* const gas = std::as_const(*assembly_).terms().find<mechanics::Gas>();
  now_.jumps = jumps.any() || some(loads.on_x) || some(loads.on_d) || (gas != nullptr && gas->pushes());
  if (!jumps.motions.empty())
    warn("jump", "static: a motion is not zero at time 0; all of it is applied in the first step");
  // If one step is the whole run, a ramp would also be applied at once.
  if (now_.step.largest() >= options_.duration) return;
  if (const std::string words = warning_text(jumps, options_.duration); !words.empty())
    warn("jump", "warning: static: " + words);
}

// Forces that are not in balance any more act as a load that is there from the beginning on.
void Static::begin_loaded() {
  const std::string jump = jump_of_motions();
  now_.jumps = (is_let_go() && !(released_over() > 0)) || !jump.empty();
  if (!jump.empty())
    warn("jump", "static: " + jump +
                     " where the state of the other run has it; all of it is applied in the first step");
}

double Static::no_size() const { return arc_ ? 0 : committed_time(); }
double Static::tried_size(double size) const { return arc_ ? now_.tried_length : size; }

double Static::plan(double limit) {
  now_.landing = next_landing(limit, now_.step.current());
  if (arc_) return now_.arc_length;
  return now_.step.end(committed_time(), now_.landing);
}

// Restores the settings of the step control after a step that fails, as if it had not been tried.
class Static::Trace {
 public:
  explicit Trace(Static& run) : run_(run), now_(run.now_), factor_(run.damping_factor()) {}
  ~Trace() {
    if (kept_) return;
    run_.now_ = now_;
    if (run_.stabilisation_ != nullptr) run_.stabilisation_->set_factor(factor_);
  }
  void keep() { kept_ = true; }

 private:
  Static& run_;
  const StaticState now_;
  double factor_;
  bool kept_ = false;
};

double Static::try_step(double limit, StepReport& report) {
  Trace trace(*this);
  step_.tries.clear();
  double size = solve_step(limit, report);
  while (!follows_path(size, report)) {
    const StepControl control = now_.step;
    if (++report.cuts > options_.max_cuts || !cut(size)) {
      now_.step = control;  // note_path() says it
      break;
    }
    size = solve_step(limit, report);
  }
  if (stabilisation_ != nullptr && reports_.empty()) calibrate(size, report);
  trace.keep();
  return size;
}

double Static::solve_step(double limit, StepReport& report) {
  double size = plan(limit);
  const double whole = size;
  const StepControl control = now_.step;
  settling_ = false;
  bool tried = false;
  cutting_ = true;
  for (bool solved = attempt(size, report); !solved; solved = attempt(size, report)) {
    if (settle_jump(size, report)) break;
    if (step_.broken()) give_up(report);
    const bool possible = ++report.cuts <= options_.max_cuts && cut(size);
    const bool short_of_patience =
        !tried && now_.step.current() <= (1 + same_time) * kPatience * now_.step.largest();
    tried = tried || short_of_patience;
    const bool near = helper_ && step_.last.status == solver::NewtonStatus::unstable;
    if (((short_of_patience && !near) || !possible) && rescue(whole, report)) {
      size = whole;
      if (descent_) now_.step = control;  // it made the whole step, so that the cuts do not limit the next
      break;
    }
    if (!possible) give_up(report);
    size = plan(limit);
  }
  cutting_ = false;
  return size;
}

// Repeats the first step until its damping dissipates at most the permitted energy, or less damping fails.
void Static::calibrate(double size, StepReport& report) {
  auto& damping = *stabilisation_;
  for (int i = 0; i < 8; ++i) {
    const double lost = damping.work(problem_->motion()), work = energy().internal() + lost,
                 factor = damping.factor();
    if (lost <= 2 * options_.stabilise * work) return;
    damping.adapt(lost, work);
    if (attempt(size, report)) continue;
    damping.set_factor(factor);
    if (!attempt(size, report)) give_up(report);
    return;
  }
}

// Halves the size. False: it is then below the smallest size, which is the largest one halved max_cuts times
// (or min_step), however many steps the cuts have been spread over.
bool Static::cut(double size) {
  if (arc_) {
    now_.arc_length = now_.tried_length / 2;
    return step_.last.status != solver::NewtonStatus::turned_back ||
           now_.arc_length > 0.01 * now_.longest_length;
  }
  if (stabilisation_ != nullptr && stabilisation_->lost() < 0.01 * work_.largest()) stabilisation_->raise();
  return now_.step.cut(size - committed_time());
}

bool Static::attempt(double size, StepReport& report) {
  solver::NewtonOptions options{options_.tolerance, options_.max_iterations, options_.line_search};
  if (!has_energy_ && options.max_iterations == StaticOptions{}.max_iterations)
    options.max_iterations = kNewtonIterations;
  // Cuts of earlier steps count, too: the step is not halved towards a bifurcation again and again.
  const double part = now_.step.current() * (1 - same_time);
  const auto as_cut = [&](int n) { return report.cuts >= n || part <= std::ldexp(now_.step.largest(), -n); };
  options.most_unstable = !cutting_ || as_cut(kSeparating) ? problem_->size() : as_cut(kNear) ? 1 : 0;
  if (now_.reported_pivots) options.turns = kBuckled;
  if (arc_) {
    const auto arc =
        arc_->solve(*problem_, options, {committed_time(), now_.landing, size, now_.step.largest()});
    now_.tried_length = arc.length;
    return finish(arc, arc.time, report);
  }
  problem_->set_time(size);
  const auto solve = [&] {
    if (places_bodies_) return newton_->solve(*problem_, options);
    if (!has_energy_) return left_if_unstable(newton_->solve(*problem_, options), options);
    auto result = helper_ ? arrive(options) : stable_->solve(*problem_, options);
    if (result.status == solver::NewtonStatus::singular && model_->membrane()) {
      auto other = lifted(options);
      if (other.status == solver::NewtonStatus::converged) return other;
    }
    if (result.status != solver::NewtonStatus::too_many_iterations || report.cuts < kOtherWay) return result;
    const auto other = newton_->solve(*problem_, {options_.tolerance, kNewtonIterations});
    return other.status == solver::NewtonStatus::converged ? complete(other, options) : result;
  };
  relaxing_ = options_.method == Method::relaxation;
  crept_ = false;
  return finish(relaxing_ ? relax(options) : solve(), size, report);
}

// A try is not given up for its number of iterations while it loses energy. Where the trust region is slow,
// as in the flat valleys of limp cloth, the overdamped motion goes on from the least energy so far; it
// converges as Newton's method in the end, which then checks that the shape is stable.
solver::NewtonResult Static::arrive(const solver::NewtonOptions& options) {
  using enum solver::NewtonStatus;
  const bool bounded = options_.max_iterations != StaticOptions{}.max_iterations;
  solver::NewtonOptions turn = options;
  turn.max_iterations = std::min(kFirstTurn, options.max_iterations);
  solver::NewtonResult result = stable_->solve(*problem_, turn);
  int left = result.left_unstable;
  for (int i = 0; i < kTurns; ++i) {
    const bool slow = result.status == too_many_iterations || result.status == law_failed;
    const int rest = (bounded ? options.max_iterations : many_descents) - result.iterations;
    if (!slow || rest <= 0 || !problem_->at_target() || step_.broken()) break;
    solver::NewtonOptions more = options;
    more.max_iterations = rest;
    crept_ = true;
    auto crept = helper_->go_on(*problem_, more);
    crept.iterations += result.iterations;
    if (crept.status != converged) {
      crept.left_unstable = left;
      return crept;
    }
    turn.max_iterations = std::max(kFirstTurn, std::min(options.max_iterations, rest));
    result = stable_->correct(*problem_, turn);
    result.iterations += crept.iterations;
    left += result.left_unstable;
  }
  result.left_unstable = left;
  return result;
}

// A flat membrane has no stiffness across its plane, so that no step can be found; bent a little as the loads
// push it, it is taut.
solver::NewtonResult Static::lifted(const solver::NewtonOptions& options) {
  constexpr double kLift = 0.02;  // rad
  solver::NewtonResult result;
  linear::Matrix K;
  linear::Vector r(static_cast<std::size_t>(problem_->size())), lead(r.size());
  if (problem_->predict(K, r, lead) != Answer::ok) return result;
  const double turn = problem_->turn_of(r);
  if (!(turn > 0)) return result;
  problem_->apply_increment(r, kLift / turn);
  if (problem_->residual(lead) != Answer::ok) return result;
  return stable_->correct(*problem_, options);
}

// Loads at full value at time 0 are the same in a shorter step, so cutting does not help. An overdamped
// motion goes to where they leave the cloth, with any card; and it sees at once that cloth at rest stays so
// under loads that do not change, where Newton's method may swing between branches.
bool Static::settle_jump(double size, StepReport& report) {
  const auto first = [this] {
    return now_.jumps && reports_.empty() && find_jumps(*model_, options_.duration).motions.empty();
  };
  if (!(now_.settled || first()) || report.cuts > 0 || arc_ || places_bodies_ || descent_ ||
      stabilisation_ != nullptr || step_.broken())
    return false;
  settling_ = true;
  const Diagnosis before = step_;
  solver::Descent descent(make_linear());
  problem_->set_time(size);
  const bool solved = finish(descent.solve(*problem_, {options_.tolerance, many_descents}), size, report);
  if (!solved) {  // as if it had not been tried
    rollback();
    step_ = before;
    report.residuals = step_.last.residuals;
    report.negative_pivots = step_.last.negative_pivots;
    return false;
  }
  if (!now_.settled)
    warn("relaxed",
         "static: the first step, which has the whole of the loads that are there at time 0, was relaxed " +
             std::string(
                 options_.method == Method::relaxation
                     ? "by an overdamped motion, since dynamic relaxation does not get there"
                     : "as by method=\"relaxation\", since Newton's method does not get there in one step") +
             "; later steps in which it fails are relaxed, too");
  now_.settled = true;
  return true;
}

bool Static::rescue(double size, StepReport& report) {
  if (descent_ == nullptr && relaxation_ == nullptr) return false;  // along an arc
  if (options_.method != Method::either && options_.method != Method::automatic) return false;
  // A part that loads move freely does so in relaxation, too, without end, and a free motion is a forgotten
  // support. A turn about one axis, on which no load works, is that of a body as round as its loads; one that
  // loads with a potential drive ends where they have least of it, as of a strip that hangs.
  Mechanism free;
  if (options_.method == Method::automatic && step_.last.status == solver::NewtonStatus::singular) {
    free = find_mechanism(*model_, *assembly_, {size, duration_});
    if (free.ways != 1 || !free.words.starts_with("turn ")) return false;
    if (free.driven && !(descent_ && assembly_->terms().symmetric())) return false;
  }
  relaxing_ = true;
  problem_->set_time(size);
  const Diagnosis before = step_;
  if (finish(relax({options_.tolerance, options_.max_iterations, options_.line_search, problem_->size()}),
             size, report)) {
    if (free.driven && !warned("relaxed"))
      warn("relaxed", "static: the supports leave the sheet free to " + free.words +
                          ", and the loads drive it: it was relaxed to where they leave it, at time " +
                          number(size) + " s");
    return true;
  }
  if (options_.method == Method::either) return false;
  rollback();  // as if it had not been tried
  step_ = before;
  report.residuals = step_.last.residuals;
  report.negative_pivots = step_.last.negative_pivots;
  return false;
}

// Dynamic relaxation gets near at low accuracy, then Newton's method solves accurately; if that fails,
// relaxation continues from where it was. The overdamped motion is completed by the search for the least
// energy, which checks that the shape is stable.
solver::NewtonResult Static::relax(solver::NewtonOptions options) {
  solver::NewtonResult result;
  if (descent_) {
    result = descent_->solve(*problem_, {options_.tolerance, many_descents});
    return result.status == solver::NewtonStatus::converged ? complete(result, options) : result;
  }
  solver::RelaxationOptions coarse;
  coarse.tolerance = std::max(options_.tolerance, 1e-3);
  if (model_->membrane()) coarse.least_mass = 0.1;
  options.max_iterations = kStaticIterations.many;
  result = relaxation_->solve(*problem_, coarse);
  while (result.status == solver::NewtonStatus::converged && coarse.tolerance > options_.tolerance) {
    problem_->save_iterate();
    auto polished = newton_->correct(*problem_, options);
    polished.iterations += result.iterations;
    polished = left_if_unstable(polished, {options_.tolerance, options_.max_iterations, options_.line_search,
                                           options.most_unstable, options.turns});
    if (polished.status == solver::NewtonStatus::converged) return polished;
    problem_->restore_iterate();
    coarse.tolerance = std::max(options_.tolerance, 1e-2 * coarse.tolerance);
    result = relaxation_->go_on(*problem_, coarse);
    result.iterations += polished.iterations;
  }
  return result;
}

solver::NewtonResult Static::complete(const solver::NewtonResult& relaxed,
                                      const solver::NewtonOptions& options) {
  auto result = has_energy_ ? stable_->correct(*problem_, options)
                            : left_if_unstable(newton_->correct(*problem_, options), options);
  result.iterations += relaxed.iterations;
  return result;
}

// Newton's method, which solves for laws without energy and completes dynamic relaxation, takes whatever
// equilibrium it meets.
solver::NewtonResult Static::left_if_unstable(const solver::NewtonResult& found,
                                              const solver::NewtonOptions& options) {
  if (found.status != solver::NewtonStatus::converged) return found;
  const auto there = std::as_const(*assembly_).state().kinematics();
  const std::vector<double> kinematics(there.begin(), there.end());
  auto result = stable_->correct(*problem_, options);
  result.iterations += found.iterations;
  const bool cut_first = options.most_unstable < problem_->size();
  if (result.status == solver::NewtonStatus::converged || has_energy_ || cut_first) return result;
  // A law without an energy may have an indefinite tangent in a state that nothing leaves, as at a switch.
  std::copy(kinematics.begin(), kinematics.end(), assembly_->state().kinematics().begin());
  assembly_->state().touch();
  linear::Vector r(static_cast<std::size_t>(problem_->size()));
  if (problem_->residual(r) != Answer::ok) return result;
  solver::NewtonResult stays = found;
  stays.iterations = result.iterations;
  stays.negative_pivots = result.negative_pivots;
  stays.stability = solver::Stability::unstable;
  return stays;
}

bool Static::turns_inside_out() const {
  const auto shape =
      assembly_->terms().find<mechanics::Directors>()->overturned(std::as_const(*assembly_).state());
  return (!now_.inverted && shape.inverted >= 0) || (!now_.turned && shape.turned >= 0);
}

void Static::note_shape() {
  const auto shape =
      assembly_->terms().find<mechanics::Directors>()->overturned(std::as_const(*assembly_).state());
  now_.inverted = shape.inverted >= 0;
  now_.turned = shape.turned >= 0;
}

solver::Stability Static::judge() {
  if (!check_) {
    if (!judging_) judging_ = make_solver(options_.solver, !takes_unsymmetric());
    check_ = std::make_unique<solver::StabilityCheck>(*judging_, assembly_->terms().symmetric(),
                                                      judge_of(*model_, *assembly_));
  }
  linear::Matrix K;
  linear::Vector D;
  if (problem_->tangent(K) != Answer::ok) return solver::Stability::unchecked;
  linear::absolute_sums(K, D);
  const solver::Stability cloth = check_->of(K, D);
  return places_bodies_ && cloth == solver::Stability::stable ? judge_bodies(K) : cloth;
}

bool Static::finish(solver::NewtonResult result, double end, StepReport& report) {
  if (result.status == solver::NewtonStatus::converged && flies_away())
    result.status = solver::NewtonStatus::singular;
  if (result.status == solver::NewtonStatus::converged && result.stability == solver::Stability::unchecked &&
      (arc_ || places_bodies_ || (relaxing_ && !descent_)))
    result.stability = judge();
  report.iterations += result.iterations;
  report.residuals = result.residuals;
  report.negative_pivots = result.negative_pivots;
  report.stability = result.stability;
  report.step = end - committed_time();
  report.time = end;
  if (result.status == solver::NewtonStatus::converged && !arc_ && (descent_ || !relaxing_) &&
      turns_inside_out())
    result.status = solver::NewtonStatus::inverted;
  const bool converged = step_.take(result, report.step, *assembly_, model_->mesh());
  trial_time_ = converged ? end : committed_time();
  return converged;
}

void Static::commit(StepReport& report) {
  const double damped = stabilisation_ == nullptr ? 0 : stabilisation_->work(problem_->motion());
  const double before = work_.total(), internal_before = now_.internal;
  dead_ = problem_->external();
  assembly_->finish_step();
  note_energy();
  const auto done = work_.bounded(*assembly_, dead_);
  const double excess = now_.internal - internal_before - done.work;
  const bool fell = left_shape();
  const bool jumps = now_.jumps && reports_.empty();
  // Along equilibria loads and supports work what the cloth stores and loses. That tells their work where
  // their forces at both ends leave it open, as where yarns unload or stiffen within the step.
  const double open = std::clamp(excess, fell || jumps ? 0.0 : -done.spread, done.spread);
  work_.add(done.work + open);
  now_.relaxed += std::max(0.0, open - excess);
  if (fell && !jumps && !(report.path <= usual_path)) now_.fallen += std::max(0.0, -excess);
  const double made = std::max(0.0, excess - done.spread);
  now_.made += made;
  // Of a step in which bodies move or seams are drawn: see check_balance().
  if (assembly_->terms().step_work().work != 0) now_.unsure += made;
  note_shape();
  problem_->commit(report.time);
  if (stabilisation_ != nullptr) stabilisation_->adapt(damped, work_.total() - before);
  note_path(report);
  grow(report);
  report_notices(report);
}

// Adapts the step to the iterations of the last one: after many iterations it becomes smaller, after few it
// grows back to the largest.
void Static::grow(const StepReport& report) {
  if (arc_) return grow_arc(report);
  // By relaxation: its iterations say nothing about the step.
  const bool many = step_.last.iterations > options_.max_iterations;
  if (relaxing_ && many && !descent_) return;
  // Nor do those of a search for the least energy.
  constexpr double kRoom =
      0.25;  // of the error that the path allows: a step twice as long errs four times as much
  now_.step.grow(!has_energy_ && !now_.settled ? step_.last.iterations : 1,
                 report.cuts > 0 || now_.path_ratio > kRoom);
}

void Static::grow_arc(const StepReport& report) {
  const bool kink = is_kink(report.time);
  // A run may begin with a jump of its loads, whose direction has no meaning for the path.
  if (kink || reports_.empty())
    arc_->forget();
  else
    arc_->committed();
  problem_->at_kink(kink);
  const double factor =
      std::clamp(std::sqrt(kStaticIterations.wanted / std::max(1.0, 1.0 * step_.last.iterations)), 0.5, 1.5);
  now_.longest_length = std::max(now_.longest_length, now_.tried_length);
  // A step shortened to end at a given time does not determine the next length.
  const bool landed = std::abs(report.time - now_.landing) <= same_time * options_.duration;
  now_.arc_length = factor * (landed && report.cuts == 0 ? std::max(now_.tried_length, now_.arc_length)
                                                         : now_.tried_length);
}

void Static::report_notices(const StepReport& report) {
  if (report.negative_pivots > 0 && !now_.reported_pivots) {
    now_.reported_pivots = true;
    warn("pivots", "static: the tangent has " + std::to_string(report.negative_pivots) +
                       " negative pivots at time " + number(report.time) +
                       " s: a limit or bifurcation point has been passed");
  }
  if (step_.last.left_unstable > 0 && !now_.reported_pivots) {
    now_.reported_pivots = true;
    warn("pivots",
         "static: by time " + number(report.time) +
             " s the shape has become unstable, as where a sheet buckles or wrinkles, and the run "
             "goes on with one to which the energy falls: its mirror image, or another pattern with "
             "other steps, may be as good");
  }
  now_.left += step_.last.left_unstable;
  if (now_.left > 1 && !warned("branches"))
    warn("branches", "static: by time " + number(report.time) +
                         " s the shape has become unstable again after the run had left an unstable one "
                         "before: from there on it has several stable shapes, and which of them this run "
                         "reaches may depend on its steps, mesh and solver");
  if (report.stability == solver::Stability::unstable && !arc_ && !warned("unstable")) {
    const std::string loose = loose_bodies();
    warn("unstable", "static: the shape at time " + number(report.time) +
                         " s is an equilibrium but not stable, and no stable one was found beside it: real "
                         "cloth leaves it for another; fabric.dynamic with damping shows which" +
                         (loose.empty() ? "" : "; " + loose));
  }
  const double lost = stabilisation_ == nullptr ? 0 : stabilisation_->lost();
  if (lost > 0.01 * work_.largest() && !now_.reported_damping) {
    now_.reported_damping = true;
    warn("stabilise", "static: stabilisation has taken " + number(100 * lost / work_.largest()) +
                          " % of the external work by time " + number(report.time) +
                          " s: use smaller steps or a smaller 'stabilise'");
  }
}

void Static::note_energy() {
  const EnergyAccount e = energy();
  now_.internal = e.internal() + e.damping;
  now_.stored = e.stored;
  now_.most_stored = std::max(now_.most_stored, e.stored);
}

namespace {

// J: what rounding can store in cloth without load, where strains are rounded to 1e-12 at most, and what it
// can work where supports carry the cloth over about its size, with forces rounded to 1e-14 of its stiffness.
// A wave crosses about an element, and less than the whole cloth, in a stable step: the mass times the square
// of that speed is about, and above, the cloth's stiffness.
double energy_of_rounding(const mechanics::Assembly& assembly) {
  const auto& masses = assembly.cloth().mass();
  const double mass = std::accumulate(masses.begin(), masses.end(), 0.0);
  const double speed = box_of(assembly.dofs().reference()).size().norm() / assembly.cloth().stable_step(true);
  return mass * speed * speed * (1e-24 / 2 + 1e-14 / static_cast<double>(masses.size()));
}

}  // namespace

// The balance of a path of equilibria: loads and supports do as much work as cloth stores and dissipates, or
// more where it falls or snaps, or where the step does not follow a stiffening; relaxation takes that away.
// It cannot be less than the work of the largest of a step's forces, whatever the way. Only the forces on
// bodies that move change otherwise than between those at both ends, where a ball slides over the cloth: such
// a step says how uncertain the work is, and not that the shape is wrong.
void Static::check_balance() {
  // The work of moments about the normals of rigid sets is not counted.
  if (!model_->all<model::MomentLoad>().empty() && !assembly_->dofs().freedoms().bodies.empty()) return;
  const double scale = std::max({work_.largest(), now_.internal, energy_of_rest()}),
               made = now_.made - now_.unsure;
  if (!(scale > 0) || now_.made <= options_.ledger_limit * scale || scale <= energy_of_rounding(*assembly_))
    return;
  if (made <= options_.ledger_limit * scale) {
    if (!std::exchange(now_.reported_balance, true))
      warn("ledger",
           "static: by time " + number(time()) + " s cloth stores " + number(100 * now_.made / scale) +
               " % more energy than what moves can have given it by its forces at both ends of the "
               "steps, which change much within a step: the external work is as uncertain" +
               advice("use smaller steps, step=" + number(now_.step.largest() / 4), now_.step.largest() / 4));
    return;
  }
  const std::string text =
      "stopped at time " + number(time()) + " s: cloth stores " + number(100 * made / scale) +
      " % more energy than loads and supports can have given it, as after a jump to another shape"
      ".\nTry: smaller steps, step=" +
      number(now_.step.largest() / 4) + "; ledger_limit=" + number(10 * options_.ledger_limit) + " goes on.";
  fail(NumericalFailure("static: " + text, time()), text);
}

// Says at the end how much of the work relaxation has taken away where the cloth fell, unless two halves of
// the step end at the same shape; and if the cloth has dissipated something: else the shape is a function of
// the loads, whatever the way. A load that is present from the beginning does more work than the cloth
// stores, which is no measure of the steps.
void Static::check() {
  watch_shape();
  const EnergyAccount e = energy();
  watch_barrier(e);
  check_balance();
  watch_accounts(
      e, std::max({work_.largest(), now_.internal, energy_of_rest(), energy_of_rounding(*assembly_)}));
  const bool end = stopped() || std::abs(time() - duration_) <= same_time * duration_;
  if (end) {
    watch_path();
    watch_guard(e);
    watch_pressed(e);
    watch_crossings();
  }
  if (end && work_.largest() == 0 && e.internal() == 0 && loads_nothing(*model_, *assembly_) &&
      !warned("idle"))
    warn("idle",
         "warning: static: nothing loads or moves the cloth in this run: it has done nothing. Expected a "
         "force, pressure, gravity or a motion, m:move(set, { x=fabric.ramp(way, duration) })");
  const double lost = now_.fallen, scale = std::max(work_.largest(), energy_of_rest());
  if (!end || now_.reported_error || !(scale > 0) || lost <= kLedger * scale) return;
  if (e.dissipated <= kDissipated * scale || scale <= energy_of_rounding(*assembly_)) return;
  now_.reported_error = true;
  warn("relaxed",
       "static: relaxation has taken " + number(100 * lost / scale) + " % of the " +
           (scale > work_.largest() ? "cloth's weight times its thickness" : "external work") + " by time " +
           number(time()) + " s, in " + std::to_string(reports_.size()) +
           " steps: the cloth fell or snapped on the way; where yarns dissipate, repeat with smaller "
           "steps to see whether the result depends on them");
}

void Static::give_up(const StepReport& report) {
  const double now = committed_time();
  step_.complete(*model_, *assembly_, now);
  step_.mechanism = find_mechanism(*model_, *assembly_, {now + report.step, options_.duration});
  step_.arc = arc_ != nullptr;
  step_.jumps = now_.jumps && reports_.empty();
  if (step_.jumps) step_.jump = find_jumps(*model_, options_.duration);
  step_.bends = bends_by_itself(*model_);
  // Nothing is advised that bodies which forces place would refuse.
  step_.relaxed = relaxation_ != nullptr || helper_ || settling_ || places_bodies_;
  step_.both = options_.method == Method::either || options_.method == Method::automatic || places_bodies_;
  step_.stabilised = stabilisation_ != nullptr || places_bodies_;
  step_.loose = loose_bodies();
  fail(step_, report, now_.step.largest());
}

void Static::take(const mechanics::Transfer& change, const std::vector<double>&) {
  if (arc_) arc_->turn([&](linear::Vector& way) { way = change.apply(way); });
  if (started()) note_energy();
}

void Static::memory(Archive& archive) {
  archive(now_);
  problem_->keep(archive);
  if (arc_) arc_->keep(archive);
}

}  // namespace fabricsh::run
