// Opening and closing joints between the steps of a run.
#include <algorithm>

#include "base/error.hpp"
#include "base/number.hpp"
#include "mechanics/terms/tears.hpp"
#include "run/place_text.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

namespace {

using Edges = std::vector<mechanics::Joints::Edge>;
constexpr double kWithin = 1e-6;  // mean edges: how far apart nodes are that meet without a distance given

// The number of joints at places with several nodes.
std::size_t count(const mechanics::Joints& joints) {
  std::size_t number = 0;
  for (mechanics::Index n = 0; n < static_cast<mechanics::Index>(joints.leaders().size()); ++n)
    number += joints.leads(n) ? 1 : 0;
  return number;
}

}  // namespace

Edges Run::edges_along(const Along& along, const char* call) const {
  const std::string of = std::string(call) + ": ";
  if (stepping_) throw Error(of + "expected between two steps, as in a hook or an event's action");
  const auto& joints = assembly_->joints();
  if (!joints.any())
    throw Error(of + "the model has no tearable zone: expected m:tearable(set) before the run");
  const Edges edges =
      along.set.empty() ? joints.edges_on(along.line) : joints.edges_between(model_->mesh().set(along.set));
  if (edges.empty())
    throw Error(of +
                (along.set.empty() ? std::string("no edge between two elements of a zone lies on the line")
                                   : "set '" + along.set + "' has no edge between two elements of a zone") +
                ": expected edges that joints can open along");
  return edges;
}

std::size_t Run::cut(const Along& along) {
  const Edges more = edges_along(along, "cut"), &opened = assembly_->joints().opened();
  Edges all;
  std::set_union(opened.begin(), opened.end(), more.begin(), more.end(), std::back_inserter(all));
  const std::size_t before = count(assembly_->joints());
  rejoin(std::move(all), 0);
  return count(assembly_->joints()) - before;
}

std::size_t Run::join(const Along& along, std::optional<double> within) {
  const Edges less = edges_along(along, "join"), &opened = assembly_->joints().opened();
  Edges all;
  std::set_difference(opened.begin(), opened.end(), less.begin(), less.end(), std::back_inserter(all));
  const std::size_t before = count(assembly_->joints());
  try {
    rejoin(std::move(all), within.value_or(kWithin * assembly_->dofs().length()));
  } catch (const Error& error) {
    throw Error(std::string("join: ") + error.what());
  }
  return before - count(assembly_->joints());
}

void Run::tear() {
  mechanics::Tears* const tears = assembly_->tears();
  if (tears == nullptr) return;
  const auto worst = tears->worst();
  if (!(worst.share >= 1)) return;
  const double step = tear_step();
  if (!(step > 0)) {
    const std::string text = "at time " + number(time()) + " s the " + worst.yarn + " about " +
                             place_text(worst.at) + " has reached its strength, " + number(worst.strength) +
                             " N/m: a tear that runs away has no balance next to this one";
    fail(NumericalFailure(std::string(kind()) + ": " + text +
                              ".\nTry: fabric.dynamic with scheme=\"explicit\", which shows where it goes.",
                          time()),
         text);
  }
  Edges all = tears->let_go(step);
  const Edges& opened = assembly_->joints().opened();
  all.insert(all.end(), opened.begin(), opened.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  rejoin(std::move(all), 0);
}

// Velocities and positions stay as they are where joints open.
void Run::rejoin(Edges edges, double within) {
  const std::vector<double> rates = unknown_rates();
  const Energy before = energy();
  const auto change = assembly_->open(std::move(edges), within);
  if (!change) return;
  resize();
  take(*change, rates.empty() ? rates : change->apply(rates));
  hooked_ = true;
  averages_.clear();
  if (!started_ || !change->closes()) return;
  const Energy after = energy();
  assembly_->lose(before.kinetic - after.kinetic);
  work_.add(after.internal() - before.internal());
}

}  // namespace fabricsh::run
