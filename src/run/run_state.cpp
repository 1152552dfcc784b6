// Messages on the state of a run; the content of its snapshots and checkpoints, and returning to them.
#include "run/run_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/ordered_sum.hpp"
#include "geometry/node_view.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

namespace {

// Work by the trapezoidal rule from the committed to the trial configuration.
double trapezoid(std::span<const double> before, std::span<const double> now, std::span<const double> from,
                 std::span<const double> to) {
  return ordered_sum(now.size(), [&](std::size_t i) { return (before[i] + now[i]) / 2 * (to[i] - from[i]); });
}

// Half of what the change of the forces would work over the displacement: the trapezoidal rule's work plus
// and minus this is that of either state's forces alone.
double half_change(std::span<const double> before, std::span<const double> now, std::span<const double> from,
                   std::span<const double> to) {
  return ordered_sum(now.size(), [&](std::size_t i) { return (now[i] - before[i]) / 2 * (to[i] - from[i]); });
}

// J, of the supports that turn in a step: along the arcs on which they go, with forces that turn with them,
// and along the chords; and half of what the change of the forces would work.
struct TurningWork {
  double arcs = 0, chords = 0, change = 0;
};

TurningWork work_of_turning(const mechanics::Assembly& assembly, const std::vector<TurningSupport>& before,
                            const std::vector<TurningSupport>& now) {
  TurningWork sum;
  const auto& freedoms = assembly.dofs().freedoms();
  const auto& state = assembly.state();
  const auto from = state.committed_kinematics(), to = state.x();
  mechanics::Index history = -1;
  double turn = 0;  // rad, in the step
  for (std::size_t i = 0; i < now.size(); ++i) {
    const auto& node = freedoms.nodes[now[i].node];
    const auto& motion = freedoms.motions[mechanics::motion_of(node.equation[3])];
    if (std::exchange(history, motion.history) != motion.history) {
      const auto angle = [&](double t) { return motion.of(freedoms.histories[history].value(t)); };
      turn = angle(assembly.trial().time) - angle(state.time());
    }
    const Vec3 chord = at(to, now[i].node) - at(from, now[i].node), axis = *node.turn_axis;
    const double half = std::sin(turn / 2), longer = std::abs(half) > 1e-9 ? turn / 2 / half - 1 : 0;
    const Vec3 arc = chord + longer * (chord - axis.dot(chord) * axis);
    const Mat3 half_turn = Eigen::AngleAxisd(turn / 2, axis).toRotationMatrix();
    const Vec3 first = half_turn * before[i].force, last = half_turn.transpose() * now[i].force;
    const double moment = (before[i].moment + now[i].moment) / 2;
    sum.arcs += moment * turn + (first + last).dot(arc) / 2;
    sum.chords += moment * std::sin(turn) + (before[i].force + now[i].force).dot(chord) / 2;
    // What turns with the support changes by the first, what keeps its direction by the second.
    const double turns = (last - first).dot(arc) / 2, stays = (now[i].force - before[i].force).dot(chord) / 2;
    sum.change +=
        (now[i].moment - before[i].moment) / 2 * turn + (std::abs(turns) < std::abs(stays) ? turns : stays);
  }
  return sum;
}

bool turns_about_centre(const mechanics::Freedoms& freedoms, mechanics::Index node) {
  const auto equation = freedoms.nodes[node].equation[0];
  return equation != mechanics::tied && equation <= mechanics::driven(0) &&
         freedoms.motions[mechanics::motion_of(equation)].kind == mechanics::DrivenFreedom::FreedomKind::arm;
}

bool any_load(std::span<const double> dead) {
  return std::any_of(dead.begin(), dead.end(), [](double f) { return f != 0; });
}

// Whether the working forces are only dead loads that are constant in time.
bool is_constant(const mechanics::Assembly& assembly) {
  const auto followers = assembly.terms().all<mechanics::FollowerLoad>();
  return assembly.dofs().driven_nodes().empty() && assembly.terms().constant_loads() &&
         std::none_of(followers.begin(), followers.end(), [](const auto* load) {
           return load->follows_positions() || load->follows_directors();
         });
}

}  // namespace

RunState::RunState(std::shared_ptr<model::Model> model, double duration, std::shared_ptr<Notices> notices)
    : model_(std::move(model)), duration_(duration), notices_(std::move(notices)) {}

RunState::~RunState() = default;

void RunState::note(const char* code, const std::string& text, mesh::Index element) {
  constexpr std::string_view prefix = "warning: ";
  const bool serious = warning_kind(code).serious || (stops_beyond_ && code == std::string_view("beyond"));
  warnings_->push_back(
      {code, text.starts_with(prefix) ? text.substr(prefix.size()) : text, time(), element, serious});
}

void RunState::warn(const char* code, const std::string& text, mesh::Index element) {
  note(code, text, element);
  notices_->say(text);
}

bool RunState::warned(std::string_view code) const {
  return std::any_of(warnings_->begin(), warnings_->end(), [&](const Warning& w) { return w.code == code; });
}

std::string RunState::advice(const std::string& own, double step) const {
  if (step_field_ == StepField::of_run) return ": " + own;
  if (step_field_ == StepField::none || step == 0) return "";
  return step_field_ == StepField::step ? ": step=" + number(step) : ": more steps=";
}

struct Run::Snapshot {
  const Run* owner;
  std::string bytes;
};

Run::Busy::Busy(Run& run, const char* call) : run_(run) {
  if (run.busy_) throw Error(std::string(call) + ": not from a hook of the same run");
  run.busy_ = true;
}

void Run::keep_assembly(Archive& archive) {
  if (assembly_->keep(archive)) resize();
}

void Run::keep(Archive& archive) {
  keep_assembly(archive);
  if (archive.reading()) {
    trial_time_ = committed_time();
    assembly_->set_time(trial_time_);
  }
  archive.section("ledger", [&] { archive(dead_, initial_energy_, work_, reports_, accounts_); });
  archive.section("progress",
                  [&] { archive(started_, stopped_, stop_reason_, beyond_, *warnings_, thrown_); });
  archive.section(kind(), [&] { memory(archive); });
  archive.section("hooks", [&] { keep_schedule(archive, !busy_); });
}

void Run::keep_motion(Archive& archive) {
  keep_assembly(archive);
  std::uint64_t steps = reports_.size();
  archive(dead_, work_, beyond_, accounts_, steps);
  memory(archive);
  if (!archive.reading()) return;
  trial_time_ = committed_time();
  assembly_->set_time(trial_time_);
  reports_.resize(steps);
}

std::string Run::save_state() {
  Archive archive;
  keep_motion(archive);
  return archive.bytes();
}

void Run::go_back(const std::string& save_state) {
  Archive archive(save_state);
  keep_motion(archive);
}

std::shared_ptr<const Run::Snapshot> Run::snapshot() {
  return std::make_shared<Snapshot>(Snapshot{this, kept()});
}

void Run::restore(const Snapshot& snapshot) {
  if (snapshot.owner != this) throw Error("restore: this snapshot was taken of another analysis");
  const Busy busy(*this, "restore");
  Archive archive(snapshot.bytes);
  keep(archive);
  for (const auto& hook : restored_) hook(*this);
}

std::string Run::kept() {
  Archive archive;
  keep(archive);
  return archive.bytes();
}

void Run::resume(const std::string& bytes) {
  const Busy busy(*this, "restart");
  const std::string before = kept();
  const std::vector<Warning> said = *warnings_;
  Archive archive(bytes);
  try {
    keep(archive);
    if (!archive.at_end()) throw Error("there are more bytes than the run has");
  } catch (...) {
    Archive back(before);
    keep(back);
    throw;
  }
  for (const Warning& w : said)  // of the restart itself
    if (!std::any_of(warnings_->begin(), warnings_->end(),
                     [&](const Warning& kept) { return kept.text == w.text; }))
      warnings_->push_back(w);
}

void find_working_forces(const mechanics::Assembly& assembly, std::span<const double> dead,
                         WorkingForces& out) {
  out.on_x.assign(dead.begin(), dead.end());
  out.on_d.clear();
  const auto& dofs = assembly.dofs();
  const auto& nodes = dofs.freedoms().nodes;
  const auto followers = assembly.terms().all<mechanics::FollowerLoad>();
  if (std::any_of(followers.begin(), followers.end(), [](const auto* l) { return l->follows_directors(); }))
    out.on_d.assign(dead.size(), 0);
  const mechanics::Trial trial = assembly.trial();
  for (const auto* const load : followers) load->add_follower(trial.time, trial, out.on_x, out.on_d);
  const auto internal = assembly.internal();
  const auto d = assembly.state().d();
  out.turning.clear();
  for (const auto n : dofs.driven_nodes()) {
    const Vec3 force = dofs.support_force(n, internal.on_x, dead);
    const auto& axis = nodes[n].turn_axis;
    const bool circles = axis && turns_about_centre(dofs.freedoms(), n);
    if (!circles) at(out.on_x, n) += force;
    if (axis)
      out.turning.push_back(
          {n, circles ? force : Vec3::Zero(), axis->dot(at(d, n).cross(at(internal.on_d, n)))});
  }
}

void ExternalWork::start(mechanics::Assembly& assembly, std::span<const double> dead) {
  find_working_forces(assembly, dead, before_);
  loaded_.reset();
}

mechanics::StepWork ExternalWork::of_step(mechanics::Assembly& assembly, std::span<const double> dead,
                                          bool bounded) {
  const mechanics::Configuration& now = assembly.state();
  const std::size_t n = 3 * now.nodes();
  const auto from = now.committed_kinematics();
  mechanics::StepWork sum = assembly.terms().step_work();
  if (is_constant(assembly)) {  // only dead loads that are constant
    if (!loaded_) loaded_ = any_load(dead);
    sum.work += *loaded_ ? trapezoid(dead, dead, from.first(n), now.x()) : 0;
    return sum;
  }
  find_working_forces(assembly, dead, now_);
  double work = trapezoid(before_.on_x, now_.on_x, from.first(n), now.x());
  double change = bounded ? half_change(before_.on_x, now_.on_x, from.first(n), now.x()) : 0;
  if (!now_.on_d.empty()) {
    work += trapezoid(before_.on_d, now_.on_d, from.subspan(n, n), now.d());
    if (bounded) change += half_change(before_.on_d, now_.on_d, from.subspan(n, n), now.d());
  }
  // Forces of the cloth turn with its supports. Those of weights do not, and beside pressures only chords
  // close the balance of what turns as a whole; there the work is uncertain by the difference.
  TurningWork turning;
  if (!now_.turning.empty()) {
    turning = work_of_turning(assembly, before_.turning, now_.turning);
    const bool loaded = assembly.terms().find<mechanics::FollowerLoad>() != nullptr || any_load(dead);
    work += loaded ? turning.chords : turning.arcs;
  }
  change += turning.change;
  sum += {work, std::abs(change) + std::abs(turning.arcs - turning.chords), change};
  std::swap(before_, now_);
  return sum;
}

void ExternalWork::add(mechanics::Assembly& assembly, std::span<const double> dead) {
  add(of_step(assembly, dead, false).work);
}

mechanics::StepWork ExternalWork::bounded(mechanics::Assembly& assembly, std::span<const double> dead,
                                          double theta) {
  mechanics::StepWork step = of_step(assembly, dead, true);
  step.work += (2 * theta - 1) * step.change;
  return step;
}

void ExternalWork::add(double work) {
  total_ += work;
  largest_ = std::max(largest_, std::abs(total_));
}

}  // namespace fabricsh::run
