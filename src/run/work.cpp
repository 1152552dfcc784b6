#include "run/work.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/ordered_sum.hpp"

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

}  // namespace

void ExternalWork::start(mechanics::Assembly& assembly, std::span<const double> dead) {
  assembly.working_forces(dead, before_);
  loaded_.reset();
}

ExternalWork::Bounded ExternalWork::of_step(mechanics::Assembly& assembly, std::span<const double> dead,
                                            bool bounded) {
  const mechanics::Configuration& now = assembly.state();
  const std::size_t n = 3 * now.nodes();
  const auto from = now.committed_kinematics();
  if (assembly.constant_work()) {  // only dead loads that are constant
    if (!loaded_) loaded_ = std::any_of(dead.begin(), dead.end(), [](double f) { return f != 0; });
    const double work = *loaded_ ? trapezoid(dead, dead, from.first(n), now.x()) : 0;
    return {work + assembly.step_work()};
  }
  assembly.working_forces(dead, now_);
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
