// Driving a run: steps and where they end.
#include "run/run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <variant>

#include "base/number.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/facets.hpp"
#include "mechanics/terms/contact.hpp"
#include "mechanics/terms/directors.hpp"
#include "mechanics/terms/gas.hpp"
#include "mechanics/terms/seams.hpp"
#include "mechanics/terms/tears.hpp"
#include "model/outlook.hpp"
#include "model/parts.hpp"
#include "run/breaks.hpp"
#include "run/diagnosis.hpp"
#include "run/folds.hpp"
#include "run/place_text.hpp"
#include "run/result_fields.hpp"

namespace fabricsh::run {

namespace {

// The tested range of a card is the mean strain of a strip between grips. In a simulation of that test some
// elements are strained one or two per cent more, which is not reported.
constexpr double kBeyondTested = 1.02;

// The memory of the further nodes of tearable zones; empty: there are none.
std::string zones_text(const model::Model& model) {
  constexpr double bytes = 1e3;  // of a node, measured; one in a run of 1e5 elements
  const mesh::Mesh& mesh = model.mesh();
  if (!mesh.whole || mesh.hinged) return {};
  const auto further = mesh.nodes.size() - mesh.whole->nodes.size();
  return "tearable zones: " + std::to_string(further) + " further nodes at the corners of elements, about " +
         number(1e-6 * bytes * static_cast<double>(further), 2) + " MB" +
         (mechanics::Tears::possible(model) ? "" : "; no card has a rupture, so they open by a:cut alone");
}

}  // namespace

Run::Run(std::shared_ptr<model::Model> model, double duration, std::shared_ptr<Notices> notices,
         const char* kind, const Beginning& beginning)
    : Readings(std::move(model), duration, std::move(notices)), Schedule(*this), beginning_(beginning) {
  if (!(duration > 0) || !std::isfinite(duration))
    throw Error(std::string(kind) + ": field 'duration': expected a positive time in s, got " +
                number(duration));
  if (beginning_.from != nullptr) {
    began_ = beginning_.from->time();
    duration_ += began_;
  }
  model_->validate();
  check_symmetric_loads(*model_, duration_);
  model_->divide_zones();
  if (beginning_.from != nullptr) check_beginning(kind);
  assembly_ = std::make_unique<mechanics::Assembly>(*model_);
  model_->seal();
  kinks_ = model_->kinks();
  if (const std::string words = zones_text(*model_); !words.empty()) notices_->remark(words);
  tears_ = assembly_->terms().find<mechanics::Tears>();
  seams_ = assembly_->terms().find<mechanics::Seams>();
  if (tears_ != nullptr)
    for (const std::string& words : tears_->describe()) notices_->once(words, words);
  if (seams_ != nullptr) {
    for (const std::string& words : seams_->describe()) notices_->remark(words);
    if (const auto* const contact = assembly_->terms().find<mechanics::Contacts>()) seams_->feel(*contact);
  }
  for (const std::string& words : model::unconnected(*model_)) {
    notices_->once(words, "warning: " + words);
    note("mesh", words);
  }
  if (const std::string words = bending_warning(*model_, *assembly_); !words.empty()) {
    notices_->once("bending of card " + model_->card().name, "warning: " + words);
    note("bending", words);
  }
}

Run::~Run() = default;

void Run::report_contacts() {
  const auto* contact = assembly_->terms().find<mechanics::Contacts>();
  if (contact == nullptr) return;
  for (const std::string& words : contact->surfaces().describe()) notices_->remark("contact: " + words);
  for (const std::string& words : contact->surfaces().dependent()) note("nodes", words);
  for (const std::string& words : crowding_texts(*contact))
    warn("facets", "warning: " + std::string(kind()) + ": " + words);
  for (const auto& nip : contact->readings().nips()) {
    const bool fits = std::isfinite(nip.pressure);
    note("nip", nip_text(kind(), nip));
    warnings_->back().serious = !fits;
    notices_->say(nip_text(kind(), nip));
  }
}

void Run::add(std::unique_ptr<mechanics::Term> term) {
  if (started_) throw Error(std::string("a term '") + term->name() + "': expected before the run begins");
  if (!term->symmetric() && !takes_unsymmetric())
    throw Error(std::string("a term '") + term->name() + "': expected one with a symmetric tangent" +
                (std::string(kind()) == "static" ? ", or the option linear = unsymmetric" : ""));
  const auto shows = term->shows();
  std::set<std::string> names;
  for (const mechanics::TermField& shown : shows)
    if (is_field(*this, shown.name) || !names.insert(shown.name).second)
      throw Error(std::string("a term '") + term->name() + "': its field '" + shown.name +
                  "' has the name of another field");
  for (const mechanics::TermField& shown : shows)
    shown_.push_back(std::make_shared<const ResultField>(field_of(shown)));
  assembly_->terms().add(std::move(term));
}

void Run::stop(const std::string& reason) {
  stopped_ = true;
  stop_reason_ = reason;
}

void Run::start() {
  if (started_) return;
  for (const std::string& words : idle_loads(*model_, *assembly_, duration_)) {
    const std::string text = "warning: " + std::string(kind()) + ": " + words;
    warned_idle_ ? note("idle", text) : warn("idle", text);
  }
  for (const model::Outlook& region : model::outlook(*model_))
    if (const std::string words = model::warning_of(region); !words.empty()) {
      const std::string text = "warning: " + std::string(kind()) + ": " + words;
      warned_idle_ ? note("oblique", text, region.yarns.worst) : warn("oblique", text, region.yarns.worst);
    }
  const std::pair<const char*, std::string> doubts[] = {{"shear", shear_warning(*model_, *assembly_)},
                                                        {"splay", splay_warning(*model_, *assembly_)}};
  for (const auto& [code, words] : doubts) {
    if (words.empty()) continue;
    const std::string text = "warning: " + std::string(kind()) + ": " + words;
    warned_idle_ ? note(code, text) : warn(code, text);
  }
  if (const std::string words = moved_bodies_text(*model_); !words.empty()) {
    const std::string text = std::string(kind()) + ": " + words;
    warned_idle_ ? note("jump", text) : warn("jump", text);
  }
  warned_idle_ = true;
  begin();
  initial_energy_ = energy().taken_over();
  begin_schedule();
  started_ = true;
  windows_.sample(*this);
}

void Run::prepare() {
  start();
  run_pending();
  for (std::size_t i = 0; i < ready_.size(); ++i) ready_[i](*this);
}

void Run::advance(double to) {
  if (!std::isfinite(to)) throw Error("advance: expected a finite time in s, got " + number(to));
  if (to < time() - same_time * duration_)
    throw Error("advance: expected a time from " + number(time()) + " s, where the run is, got " +
                number(to) + " s (restore(snapshot) goes back)");
  if (!((to - time()) / largest_step() <= most_steps))
    throw Error("advance: expected a time up to " + number(time() + most_steps * largest_step()) + " s (" +
                number(most_steps) + " steps of " + number(largest_step()) + " s from here), got " +
                number(to) + " s");
  const Busy busy(*this, "advance");
  stopped_ = false;
  stop_reason_.clear();
  prepare();
  while (!stopped_ && time() < to - same_time * duration_) advance_to(to);
  watch_shape();
  watch_compression();
  refuse_serious();
}

void Run::step() {
  const Busy busy(*this, "step");
  stopped_ = false;
  stop_reason_.clear();
  prepare();
  if (!stopped_ && time() < duration_ - same_time * duration_) advance_to(duration_);
}

namespace {

// s, up to `to`: until then the turn is at most a quarter of a circle. The directors of a longer step would
// go by the shorter way, and lose whole turns.
double end_of_turn(const model::History& angle, double from, double to) {
  constexpr double quarter = 90;  // degrees
  const int looks = angle.is_straight() ? 1 : 32;
  return mechanics::latest_end(from, to, [&](double end) {
    double most = 0;
    for (int i = 1; i <= looks; ++i)
      most = std::max(most, std::abs(angle.value(from + (end - from) * i / looks) - angle.value(from)));
    return most / quarter;
  });
}

}  // namespace

double Run::next_landing(double limit, double step) {
  const double now = committed_time(), landing = next_landing(limit);
  const double whole = std::min(landing, now + step);
  double turned = whole;
  for (const auto& turn : model_->all<model::PrescribedTurn>()) turned = end_of_turn(turn.angle, now, turned);
  double end = turned;
  for (const auto* const term : assembly_->terms().all<mechanics::StepLimiter>()) end = term->latest_end(end);
  if (end >= whole) return landing;
  const std::string what = end < turned ? ": contact follows the bodies that turn or fly in steps of "
                                        : ": nodes turn by at most 90 degrees in a step: steps of ";
  notices_->once(end < turned ? "contact follows" : "turns",
                 std::string(kind()) + what + number(end - now) + " s from time " + number(now) + " s on");
  return end;
}

void Run::fail(NumericalFailure failure, const std::string& why) {
  std::string strained;
  if (const auto far = beyond())
    strained = "\nbeyond     " + beyond_text(*far) + ", " + number(far->strain_ratio) + " times as far, at " +
               number(far->time) + " s";
  why_ = failure.why = std::string(kind()) + ": " + why + strained + touching_text(*assembly_) +
                       "\nrun        to " + number(duration_) + " s, card " + model_->card().name + ", " +
                       std::to_string(model_->mesh().elements.size()) + " elements";
  throw NumericalFailure(failure);
}

void Run::fail(const Diagnosis& step, const StepReport& report, double largest) {
  const std::string text =
      std::string(kind()) + ": " + step.message(report.step, largest, report.cuts, tolerance());
  fail(NumericalFailure(text, step.time, step.site.element, step.site.yarn), step.report());
}

void Run::rollback() {
  assembly_->rollback();
  trial_time_ = committed_time();
}

bool Run::finds_step(double limit, StepReport& report) {
  const auto again = [this](bool failed) {
    rollback();
    return stepping_ = tries_again(failed);
  };
  stepping_ = true;
  report = {};
  try {
    land(try_step(limit, report), report);
    return true;
  } catch (const NumericalFailure&) {
    if (!again(true)) throw;
  } catch (...) {
    if (!again(false)) throw;
  }
  return false;
}

StepReport Run::make_step(double limit) {
  StepReport report;
  while (!finds_step(limit, report)) {
  }
  commit(report);
  return report;
}

void Run::advance_to(double limit) {
  StepReport report = make_step(limit);
  while (takes_back()) report = make_step(limit);
  stepping_ = false;
  trial_time_ = report.time;
  reports_.push_back(std::move(report));
  watch_strain();
  tear();
  burst();
  sew();
  settle();
  run_pending();
  check();
  refuse_serious();
  for (std::size_t i = 0; i < settled_.size(); ++i) settled_[i](*this);
}

void Run::watch_strain() {
  constexpr double reached = 1 + 1e-6;
  const double strain_ratio = assembly_->cloth().strains().largest_ratio(), before = beyond_.strain_ratio;
  if (!(strain_ratio > std::max(reached, before))) return;
  const mechanics::Strained most = assembly_->cloth().strains().most();
  const char* const yarns[] = {"warp", "weft", "shear"};
  const double first = before > 0 ? beyond_.first : time();
  beyond_ = {strain_ratio, yarns[most.yarn], most.element, time(), first, most.strain, most.tested};
  if (stops_beyond_ && before <= kBeyondTested && strain_ratio > kBeyondTested)
    stop("strain beyond what was tested: " + beyond_text(beyond_));
  if (warned("beyond") || before > kBeyondTested || strain_ratio <= kBeyondTested) return;
  const std::string text =
      "warning: " + std::string(kind()) + ": at time " + number(time()) + " s " + beyond_text(beyond_) +
      ", about " + place_text(assembly_->cloth().readings().centre(most.element)) +
      ": from here on the card extrapolates; warned once, the largest excess is in a.beyond and run.json";
  warned_beyond_ ? note("beyond", text, most.element) : warn("beyond", text, most.element);
  warned_beyond_ = true;
}

void Run::watch_guard(const EnergyAccount& e) {
  constexpr double shows = 0.01;
  if (!(e.directors > shows * e.stored) || warned("lean")) return;
  warn("lean",
       "warning: " + std::string(kind()) + ": at time " + number(time()) +
           " s the guard of the directors has " + number(100 * e.directors / e.stored, 2) +
           " % of the stored energy, and the answer depends on it as much: the cloth folds more sharply than "
           "its elements show, or these are long across stiff fibres; expected at most 1 %, with smaller "
           "elements");
}

// Explicit steps tell it themselves, with what they do about it.
void Run::watch_barrier(const EnergyAccount& e) {
  constexpr double shows = 0.1;
  const auto* const contact = std::as_const(*assembly_).terms().find<mechanics::Contacts>();
  if (contact == nullptr || !(e.guard > shows * e.contact) || warned("guard")) return;
  const auto nearest = contact->readings().nearest();
  note("guard", std::string(kind()) + ": at time " + number(time()) + " s " +
                    contact->surfaces().words(nearest.point) +
                    " are pressed farther than the law of their contact: a barrier keeps them apart, " +
                    number(nearest.gap) + " m above the smallest distance (its energy: a.energy.guard)");
}

// The potential energy at equilibrium changes with the logarithm of a stiffness by the energy that it stores.
void Run::watch_pressed(const EnergyAccount& e) {
  constexpr double shows = 0.01;
  const auto* const contact = std::as_const(*assembly_).terms().find<mechanics::Contacts>();
  if (contact == nullptr || !contact->surfaces().assumes_stiffness() || !(e.contact > shows * e.stored) ||
      warned("pressed"))
    return;
  warn(
      "pressed",
      std::string(kind()) + ": at time " + number(time()) + " s contact has " +
          number(100 * e.contact / e.stored, 3) +
          " % of the stored energy, and its stiffness was assumed: forces and ways of what is pressed depend "
          "on it as much; give stiffness=, or the card compression=, as measured");
}

// Crack faces touch each other only once they have been apart, and what is cut where it is pressed may come
// through before.
void Run::watch_crossings() {
  const auto* const contact = std::as_const(*assembly_).terms().find<mechanics::Contacts>();
  if (contact == nullptr || warned("crossing")) return;
  const auto found = contact->readings().crossings();
  if (found.empty()) return;
  const auto deepest = std::min_element(found.begin(), found.end(),
                                        [](const auto& a, const auto& b) { return a.gap < b.gap; });
  warn("crossing", "warning: " + std::string(kind()) + ": at time " + number(time()) + " s " +
                       std::to_string(found.size()) + (found.size() == 1 ? " edge passes" : " edges pass") +
                       " through facets, the deepest by " + number(-deepest->gap, 3) +
                       " m: " + contact->surfaces().words(deepest->point) +
                       ": the results about there are doubtful, as where cloth is cut while it is pressed");
}

namespace {
// Where the rim of a volume of gas is apart from the body that closes it; empty: nowhere by much.
std::string open_rim(const mechanics::Assembly& assembly, const model::Model& model) {
  constexpr double much = 0.5;  // of the rim's edges
  const auto* const gas = assembly.terms().find<mechanics::Gas>();
  if (gas == nullptr) return {};
  const auto gap = gas->farthest_rim(assembly.trial());
  if (!(gap.apart > much * gap.size)) return {};
  return "node " + std::to_string(gap.node + 1) + " of the rim of a gas volume has moved by " +
         number(gap.apart, 3) + " m against the " + model.interactions().name_of(*gap.body) +
         " that closes it, about " + place_text(at(assembly.state().x(), gap.node)) +
         ": the gas is enclosed there as if a strip joined the two; hold the rim at the body, as by m:tie";
}
}  // namespace

void Run::watch_shape() {
  if (const std::string words = open_rim(*assembly_, *model_); !words.empty() && !warned("rim"))
    warn("rim", "warning: " + std::string(kind()) + ": at time " + number(time()) + " s " + words);
  watch_folds();
  if (!moves()) watch_compression();
  const bool warned_inverted = warned("inverted"), warned_turned = warned("director");
  if (warned_inverted && warned_turned) return;
  const auto shape =
      assembly_->terms().find<mechanics::Directors>()->overturned(std::as_const(*assembly_).state());
  const std::string then = " at time " + number(time()) + " s: the results from here on are " +
                           (moves() ? "doubtful" : "not valid");
  if (!warned_inverted && shape.inverted >= 0)
    warn("inverted",
         "warning: " + std::string(kind()) + ": element " + model_->element_name(shape.inverted) +
             " is turned inside out" + then,
         shape.inverted);
  if (!warned_turned && shape.turned >= 0)
    warn("director",
         "warning: " + std::string(kind()) + ": the director at node " + std::to_string(shape.turned + 1) +
             ", about " + place_text(at(std::as_const(*assembly_).state().x(), shape.turned)) +
             ", is turned over: it is more than 90 degrees from the normal of the sheet, whose elements "
             "there are sound," +
             then);
}

namespace {
// Whether what yarns dissipate can only rise: the comparison laws have no stored energy, and say themselves
// what they create.
bool yarns_are_dissipative(const model::Model& model) {
  const auto rises = [](const card::Card& card) {
    const auto* const woven = std::get_if<card::Woven>(&card.law);
    return woven == nullptr || woven->law == card::LawKind::potential;
  };
  return std::all_of(model.regions().begin(), model.regions().end(), [&](const auto& region) {
    const auto& plies = region.options.plies;
    return plies.empty()
               ? rises(region.card)
               : std::all_of(plies.begin(), plies.end(), [&](const auto& p) { return rises(p.card); });
  });
}
}  // namespace

void Run::watch_accounts(const EnergyAccount& energies, double scale, double of_scheme) {
  constexpr double rounding = 5e-4;  // of the trapezoidal rule, too, by which explicit friction is summed
  EnergyAccount rising = energies;
  if (!yarns_are_dissipative(*model_))
    std::erase_if(rising.lost, [](const EnergyPart& part) {
      return part.name == "warp" || part.name == "weft" || part.name == "shear";
    });
  const auto fall = accounts_.look(rising, time(), rounding * scale, std::max(rounding, of_scheme) * scale);
  if (!fall) return;
  const std::string caught = caught_text();
  const std::string text =
      "stopped at time " + number(time()) + " s: the energy '" + fall->name + "', which can only rise, is " +
      number(fall->by) + " J below the " + number(fall->to + fall->by) + " J of time " + number(fall->since) +
      " s (" + number(100 * fall->by / scale) +
      " % of the run's energies): the results from there on are wrong" +
      (caught.empty()
           ? ".\nTry: a smaller step"
           : "; " + caught +
                 ".\nTry: a longer field 'over' of m:seam; explicit motion leads seams around bodies");
  fail(NumericalFailure(std::string(kind()) + ": " + text + ".", time()), text);
}

// Cloth in motion folds on many things for a moment, so there it is noted without a line.
void Run::watch_folds() {
  constexpr double degree = std::numbers::pi / 180, fine = 20;
  const auto* const contact = assembly_->terms().find<mechanics::Contacts>();
  if (contact == nullptr || !contact->readings().any_touched() || warned("fold")) return;
  if (folds_ == nullptr) folds_ = std::make_unique<const Folds>(model_->mesh());
  const auto fold = folds_->sharpest(std::as_const(*assembly_).state().x(), contact->readings());
  if (!fold) return;
  const double angle = fold->angle / degree;
  const std::string text =
      "warning: " + std::string(kind()) + ": at time " + number(time()) + " s the cloth turns by " +
      number(angle, 2) + " degrees between elements " + model_->element_name(fold->element) + " and " +
      model_->element_name(fold->other) + ", about " + place_text(fold->place) +
      ", where contact presses on it: the forces across such an edge depend on the mesh; elements of " +
      number(1e3 * fold->size * fine / angle, 2) + " mm there (now " + number(1e3 * fold->size, 2) +
      " mm), or a body there that is rounded to " + number(1e3 * fold->size / (fine * degree), 2) +
      " mm or more, make that " + number(fine) + " degrees";
  moves() ? note("fold", text, fold->element) : warn("fold", text, fold->element);
}

void Run::refuse_serious() {
  if (!strict_) return;
  const auto found = std::find_if(warnings_->begin() + static_cast<std::ptrdiff_t>(thrown_), warnings_->end(),
                                  [](const Warning& w) { return w.serious; });
  if (found == warnings_->end()) return;
  thrown_ = static_cast<std::uint64_t>(found - warnings_->begin()) + 1;
  const std::string text = found->text + " (an error under --strict)", own = std::string(kind()) + ": ";
  fail(NumericalFailure(text, time(), found->element),
       text.starts_with(own) ? text.substr(own.size()) : text);
}

// Shortens the step until no event has crossed zero beyond its tolerance. If a value jumps across zero, the
// step ends after the jump.
double Run::land(double size, StepReport& report) {
  std::vector<const Event*> jumped;
  for (auto& event : events_) measure(event);
  for (std::size_t tries = 0; tries <= 2 * events_.size(); ++tries) {
    const auto beyond = std::find_if(events_.begin(), events_.end(), [&](const Event& e) {
      return e.crossed() && std::find(jumped.begin(), jumped.end(), &e) == jumped.end();
    });
    if (beyond == events_.end()) break;
    size = search(*beyond, size, report);
    for (auto& event : events_) measure(event);
    if (beyond->crossed()) jumped.push_back(&*beyond);
  }
  const double shorter = land_at_break(land_at_limit(size, report), report);
  if (shorter != size)
    for (auto& event : events_) measure(event);
  return shorter;
}

// Where the run is to stop beyond the tested range, the step ends right behind it.
double Run::land_at_limit(double size, StepReport& report) {
  constexpr double tolerance = 1e-4, limit_ratio = kBeyondTested * (1 + 2 * tolerance);
  if (!stops_beyond_ || beyond_.strain_ratio > kBeyondTested ||
      !(assembly_->cloth().strains().largest_ratio() > limit_ratio))
    return size;
  Event limit{
      [](Run& run) { return run.assembly_->cloth().strains().largest_ratio() - limit_ratio; }, tolerance, {}};
  limit.last = beyond_.strain_ratio - limit_ratio;
  limit.largest = limit_ratio;
  limit.side = -1;
  measure(limit);
  if (limit.near()) return size;
  if (committed_time() > 0) return search(limit, size, report);
  // Loads or motions at full value at time 0 strain the cloth no less in a shorter step.
  const auto try_size = [&](double s) {
    if (!attempt(s, report)) give_up(report);
    measure(limit);
  };
  const double from = no_size(), to = tried_size(size);
  try_size(from + 1e-6 * (to - from));
  const bool jump = limit.crossed();
  try_size(to);
  return jump ? size : search(limit, size, report);
}

// A yarn, or a stitch, breaks at its strength, not at what the end of a step happens to reach. Where the
// force jumps, as over a tear that runs, there is no such step.
double Run::land_at_break(double size, StepReport& report) {
  constexpr double tolerance = 1e-4, limit_ratio = 1 + tolerance;
  if (tear_step() > 0) return size;
  const NearestBreak nearest = nearest_break(*assembly_);
  if (!(nearest.trial > limit_ratio + tolerance)) return size;
  Event breaks{[](Run& run) { return nearest_break(run.assembly()).trial - limit_ratio; }, tolerance, {}};
  breaks.last = std::min(0.0, nearest.committed - limit_ratio);
  breaks.largest = limit_ratio;
  breaks.side = -1;
  measure(breaks);
  const double landed = search(breaks, size, report);
  refuse_runaway();
  return landed;
}

// The Illinois variant of regula falsi for the size of the step; each trial is a full solution from the
// committed state. Ends near zero, or on the far side of a jump.
double Run::search(Event& event, double size, StepReport& report) {
  double from = no_size(), to = tried_size(size), low = event.last, high = event.now, at = to;
  const double least = 1e-9 * (to - from);  // of the step: a jump is located to this accuracy
  int kept = 0;                             // the end that was kept in the last iteration
  const auto try_size = [&](double s) {
    at = s;
    if (!attempt(s, report)) give_up(report);
    measure(event);
  };
  for (int i = 0; i < 80 && !event.near(); ++i) {
    const double next = i % 8 == 7 ? (from + to) / 2 : from + (to - from) * low / (low - high);
    if (next == from || next == to || to - from <= least) break;
    try_size(next);
    if (!event.crossed()) {
      from = next;
      low = event.now;
      if (kept == -1) high /= 2;
      kept = -1;
    } else {
      to = next;
      high = event.now;
      if (kept == 1) low /= 2;
      kept = 1;
    }
  }
  if (!event.near() && at != to) try_size(to);
  return at;
}

}  // namespace fabricsh::run
