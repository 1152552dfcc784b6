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

}  // namespace

void ExternalWork::start(mechanics::Assembly& assembly, std::span<const double> dead) {
  assembly.working_forces(dead, before_);
  loaded_.reset();
}

void ExternalWork::add(mechanics::Assembly& assembly, std::span<const double> dead) {
  const mechanics::Configuration& now = assembly.state();
  const std::size_t n = 3 * now.nodes();
  const auto from = now.committed_kinematics();
  if (assembly.constant_work()) {  // only dead loads that are constant
    if (!loaded_) loaded_ = std::any_of(dead.begin(), dead.end(), [](double f) { return f != 0; });
    add((*loaded_ ? trapezoid(dead, dead, from.first(n), now.x()) : 0) + assembly.step_work());
    return;
  }
  assembly.working_forces(dead, now_);
  double work = trapezoid(before_.on_x, now_.on_x, from.first(n), now.x());
  if (!now_.on_d.empty()) work += trapezoid(before_.on_d, now_.on_d, from.subspan(n, n), now.d());
  add(work + assembly.step_work());
  std::swap(before_, now_);
}

void ExternalWork::add(double work) {
  total_ += work;
  largest_ = std::max(largest_, std::abs(total_));
}

}  // namespace fabricsh::run
