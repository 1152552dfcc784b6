// Opening and closing joints between the steps of a run.
#include <algorithm>

#include "base/error.hpp"
#include "base/number.hpp"
#include "mechanics/terms/seams.hpp"
#include "mechanics/terms/tears.hpp"
#include "run/breaks.hpp"
#include "run/place_text.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

namespace {

using Edges = std::vector<mechanics::Joints::Edge>;
constexpr double kOvershot = 1.02;  // force over strength to which a step may jump when a yarn breaks
constexpr double kHeld = 1.2;       // force over strength beyond which yarns that a support holds are told of
constexpr double kWithin = 1e-6;    // mean edges: how far apart nodes are that meet without a distance given

// The number of joints at places with several nodes.
std::size_t count(const mechanics::Joints& joints) {
  std::size_t number = 0;
  for (mechanics::Index n = 0; n < static_cast<mechanics::Index>(joints.leaders().size()); ++n)
    number += joints.leads(n) ? 1 : 0;
  return number;
}

}  // namespace

Edges Run::edges_along(const Along& along, const char* call, bool sewn) const {
  const std::string of = std::string(call) + ": ";
  if (stepping_) throw Error(of + "expected between two steps, as in a hook or an event's action");
  const auto& joints = assembly_->dofs().joints();
  if (sewn && !joints.any()) return {};
  if (!joints.any())
    throw Error(of + (seams_ == nullptr
                          ? "the model has no tearable zone: expected m:tearable(set) before the run"
                          : "the model has no tearable zone, and no stitch of a seam is there: expected "
                            "m:tearable(set) before the run, or the set of a sewn edge"));
  const Edges edges =
      along.set.empty() ? joints.edges_on(along.line) : joints.edges_between(model_->mesh().set(along.set));
  if (edges.empty() && !sewn)
    throw Error(of +
                (along.set.empty() ? std::string("no edge between two elements of a zone lies on the line")
                                   : "set '" + along.set + "' has no edge between two elements of a zone") +
                ": expected edges that joints can open along");
  return edges;
}

std::size_t Run::cut(const Along& along) {
  const auto stitches = stitches_along(along);
  mechanics::Sewn sewn = assembly_->dofs().sewn();
  std::size_t opened = 0;
  for (const std::size_t i : stitches) {
    opened += sewn.parted[i] == 0 ? 1 : 0;
    sewn.closed[i] = 0;
    sewn.parted[i] = 1;
  }
  const Edges more = edges_along(along, "cut", !stitches.empty()),
              &opened_before = assembly_->dofs().joints().opened();
  Edges all;
  std::set_union(opened_before.begin(), opened_before.end(), more.begin(), more.end(),
                 std::back_inserter(all));
  const std::size_t before = count(assembly_->dofs().joints());
  if (opened > 0) resew(std::move(sewn), 0);
  rejoin(std::move(all), 0);
  return count(assembly_->dofs().joints()) - before + opened;
}

std::size_t Run::join(const Along& along, std::optional<double> within) {
  const double near = within.value_or(kWithin * assembly_->dofs().length());
  const auto stitches = stitches_along(along);
  mechanics::Sewn sewn = assembly_->dofs().sewn();
  std::size_t closed = 0;
  for (const std::size_t i : stitches) {
    if (sewn.parted[i] == 0 || seams_->has_burst(i)) continue;
    ++closed;
    sewn.closed[i] = assembly_->dofs().seams()[assembly_->dofs().stitches()[i].seam].stiffness ? 0 : 1;
    sewn.parted[i] = 0;
  }
  const Edges less = edges_along(along, "join", !stitches.empty()),
              &opened = assembly_->dofs().joints().opened();
  Edges all;
  std::set_difference(opened.begin(), opened.end(), less.begin(), less.end(), std::back_inserter(all));
  const std::size_t before = count(assembly_->dofs().joints());
  try {
    if (closed > 0) {
      seams_->decide_turning(sewn);
      resew(std::move(sewn), near);
    }
    rejoin(std::move(all), near);
  } catch (const Error& error) {
    throw Error(std::string("join: ") + error.what());
  }
  return before - count(assembly_->dofs().joints()) + closed;
}

// Where a joint opens its forces stay, so that in steps that iterate whatever breaks with it does so in the
// same state. Explicit steps go on and break the next ones in theirs.
void Run::tear() {
  if (tears_ == nullptr) return;
  if (tears_->supports_due() && !warned("held"))
    if (const auto worst = tears_->at_support(); worst.share > kHeld)
      warn("held", "warning: " + std::string(kind()) + ": at time " + number(time()) +
                       " s the cloth pulls on the " + worst.yarn + " about " + place_text(worst.at) +
                       " with " + number(worst.share) + " times its strength, " + number(worst.strength) +
                       " N/m, where a support holds it: nothing breaks there");
  const double step = tear_step();
  while (tears_->worst().share >= 1) {
    Edges all = tears_->let_go(step);
    const Edges& opened = assembly_->dofs().joints().opened();
    all.insert(all.end(), opened.begin(), opened.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    rejoin(std::move(all), 0);
    if (step > 0) return;
  }
}

NearestBreak nearest_break(const mechanics::Assembly& assembly) {
  NearestBreak nearest;
  if (const auto* tears = assembly.terms().find<mechanics::Tears>(); tears != nullptr)
    nearest = {tears->worst().share, tears->committed_share()};
  if (const auto* seams = assembly.terms().find<mechanics::Seams>(); seams != nullptr)
    nearest = {std::max(nearest.trial, seams->worst().share),
               std::max(nearest.committed, seams->committed_share())};
  return nearest;
}

void Run::refuse_runaway() {
  if (!(nearest_break(*assembly_).trial > kOvershot)) return;
  std::string what = "seam";
  double share = 0, strength = 0;
  Vec3 at = Vec3::Zero();
  if (seams_ != nullptr) {
    const auto worst = seams_->worst();
    what = "seam " + worst.seam;
    share = worst.share;
    strength = worst.strength;
    at = worst.at;
  }
  if (tears_ != nullptr && tears_->worst().share > share) {
    const auto worst = tears_->worst();
    what = worst.yarn;
    share = worst.share;
    strength = worst.strength;
    at = worst.at;
  }
  const std::string text = "at time " + number(time()) + " s the force on the " + what + " about " +
                           place_text(at) + " jumps to " + number(share) + " times its strength, " +
                           number(strength) + " N/m, however short the step: the tear runs away";
  const char* const path =
      moves() ? "" : "control=\"arc\", which follows the path of equilibria back in time; or ";
  fail(NumericalFailure(std::string(kind()) + ": " + text + ".\nTry: " + path +
                            "fabric.dynamic with scheme=\"explicit\", which shows where it goes.",
                        time()),
       text);
}

// Velocities and positions stay as they are where joints open.
void Run::change(const std::function<std::optional<mechanics::Transfer>()>& made) {
  const std::vector<double> rates = unknown_rates();
  const EnergyAccount before = energy();
  const auto change = made();
  if (!change) return;
  resize();
  take(*change, rates.empty() ? rates : change->apply(rates));
  hooked_ = true;
  averages_.clear();
  if (!started_ || !change->closes()) return;
  const EnergyAccount after = energy();
  assembly_->lose(before.kinetic - after.kinetic);
  work_.add(after.internal() - before.internal());
}

void Run::rejoin(Edges edges, double within) {
  change([&] { return assembly_->open(std::move(edges), within); });
}

}  // namespace fabricsh::run
