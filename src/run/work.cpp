#include "run/work.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/ordered_sum.hpp"
#include "geometry/node_view.hpp"

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

// Whether the working forces are only dead loads that are constant in time.
bool is_constant(const mechanics::Assembly& assembly) {
  const auto followers = assembly.all<mechanics::FollowerLoad>();
  return assembly.dofs().driven_nodes().empty() && assembly.constant_loads() &&
         std::none_of(followers.begin(), followers.end(), [](const auto* load) {
           return load->follows_positions() || load->follows_directors();
         });
}

}  // namespace

void find_working_forces(const mechanics::Assembly& assembly, std::span<const double> dead,
                         WorkingForces& out) {
  out.on_x.assign(dead.begin(), dead.end());
  out.on_d.clear();
  const auto& dofs = assembly.dofs();
  const auto& nodes = dofs.freedoms().nodes;
  const auto followers = assembly.all<mechanics::FollowerLoad>();
  bool turns =
      std::any_of(followers.begin(), followers.end(), [](const auto* l) { return l->follows_directors(); });
  for (const auto n : dofs.driven_nodes()) turns = turns || nodes[n].turn_axis;
  if (turns) out.on_d.assign(dead.size(), 0);
  const mechanics::Trial trial = assembly.trial();
  for (const auto* const load : followers) load->add_follower(trial.time, trial, out.on_x, out.on_d);
  const auto internal = assembly.internal();
  for (const auto n : dofs.driven_nodes()) {
    at(out.on_x, n) += dofs.support_force(n, internal.on_x, dead);
    if (nodes[n].turn_axis) at(out.on_d, n) += at(internal.on_d, n);
  }
}

void ExternalWork::start(mechanics::Assembly& assembly, std::span<const double> dead) {
  find_working_forces(assembly, dead, before_);
  loaded_.reset();
}

ExternalWork::Bounded ExternalWork::of_step(mechanics::Assembly& assembly, std::span<const double> dead,
                                            bool bounded) {
  const mechanics::Configuration& now = assembly.state();
  const std::size_t n = 3 * now.nodes();
  const auto from = now.committed_kinematics();
  if (is_constant(assembly)) {  // only dead loads that are constant
    if (!loaded_) loaded_ = std::any_of(dead.begin(), dead.end(), [](double f) { return f != 0; });
    const double work = *loaded_ ? trapezoid(dead, dead, from.first(n), now.x()) : 0;
    return {work + assembly.step_work()};
  }
  find_working_forces(assembly, dead, now_);
  double work = trapezoid(before_.on_x, now_.on_x, from.first(n), now.x());
  if (!now_.on_d.empty()) work += trapezoid(before_.on_d, now_.on_d, from.subspan(n, n), now.d());
  double half = 0;
  if (bounded) {
    half = half_change(before_.on_x, now_.on_x, from.first(n), now.x());
    if (!now_.on_d.empty()) half += half_change(before_.on_d, now_.on_d, from.subspan(n, n), now.d());
  }
  std::swap(before_, now_);
  return {work + assembly.step_work(), std::abs(half)};
}

void ExternalWork::add(mechanics::Assembly& assembly, std::span<const double> dead) {
  add(of_step(assembly, dead, false).work);
}

ExternalWork::Bounded ExternalWork::add_bounded(mechanics::Assembly& assembly, std::span<const double> dead) {
  const Bounded step = of_step(assembly, dead, true);
  add(step.work);
  return step;
}

void ExternalWork::add(double work) {
  total_ += work;
  largest_ = std::max(largest_, std::abs(total_));
}

}  // namespace fabricsh::run
