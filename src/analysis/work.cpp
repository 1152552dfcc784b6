#include "analysis/work.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fabricsh::analysis {

namespace {

double trapezoid(std::span<const double> before, std::span<const double> now, std::span<const double> from,
                 std::span<const double> to) {
  double sum = 0;
  for (std::size_t i = 0; i < now.size(); ++i) sum += (before[i] + now[i]) / 2 * (to[i] - from[i]);
  return sum;
}

}  // namespace

void ExternalWork::start(const assembly::Assembly& assembly, std::span<const double> dead) {
  assembly.working_forces(dead, before_);
  const auto x = assembly.state().x(), d = assembly.state().d();
  x_.assign(x.begin(), x.end());
  d_.assign(d.begin(), d.end());
}

void ExternalWork::add(const assembly::Assembly& assembly, std::span<const double> dead) {
  assembly.working_forces(dead, now_);
  const auto x = assembly.state().x(), d = assembly.state().d();
  add(trapezoid(before_.on_x, now_.on_x, x_, x) + trapezoid(before_.on_d, now_.on_d, d_, d));
  std::swap(before_, now_);
  std::copy(x.begin(), x.end(), x_.begin());
  std::copy(d.begin(), d.end(), d_.begin());
}

void ExternalWork::add(double work) {
  total_ += work;
  largest_ = std::max(largest_, std::abs(total_));
}

}  // namespace fabricsh::analysis
