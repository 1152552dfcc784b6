#include "analysis/damping.hpp"

#include <algorithm>
#include <cmath>

namespace fabricsh::analysis {

Damping::Damping(const mechanics::Assembly& assembly, double fraction)
    : assembly_(assembly), fraction_(fraction) {
  if (!on()) return;
  const auto& nodes = assembly.freedoms().nodes;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (int c = 0; c < 3; ++c) {
      const auto eq = nodes[n].equation[c];
      if (eq < 0) continue;
      freedoms_.push_back({eq, static_cast<mechanics::Index>(n), c});
    }
}

double Damping::moved(const Freedom& f) const {
  const auto& state = assembly_.state();
  const auto x = state.x(), x0 = state.committed_kinematics();
  const Vec3 u(x[3 * f.node] - x0[3 * f.node], x[3 * f.node + 1] - x0[3 * f.node + 1],
               x[3 * f.node + 2] - x0[3 * f.node + 2]);
  return assembly_.freedoms().nodes[f.node].frame.row(f.component).dot(u);
}

void Damping::start(double dt, const linear::Matrix& K) {
  if (!on()) return;
  dt_ = dt > 0 ? dt : 1;
  if (factor_ > 0) return;
  double stiffness = 0, mass = 0;
  for (const auto& f : freedoms_) {
    stiffness += std::abs(K.value[K.pattern->slot(f.equation, f.equation)]);
    mass += assembly_.nodal_mass()[f.node];
  }
  if (mass > 0) factor_ = fraction_ * stiffness / mass * dt_;
}

void Damping::add_force(std::span<double> r) const {
  for (const auto& f : freedoms_) r[f.equation] -= factor_ * assembly_.nodal_mass()[f.node] * moved(f) / dt_;
}

void Damping::add_stiffness(linear::Matrix& K) const {
  for (const auto& f : freedoms_)
    K.add(f.equation, f.equation, factor_ * assembly_.nodal_mass()[f.node] / dt_);
}

double Damping::work() const {
  double sum = 0;
  for (const auto& f : freedoms_) sum += assembly_.nodal_mass()[f.node] * moved(f) * moved(f);
  return factor_ * sum / dt_;
}

// Towards fraction * work, by a factor of at most ten a step.
void Damping::adapt(double lost, double step_work) {
  if (on() && lost > 0) factor_ *= std::clamp(fraction_ * std::abs(step_work) / lost, 0.1, 10.0);
}

}  // namespace fabricsh::analysis
