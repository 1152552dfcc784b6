#include "mechanics/terms/damping.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/assembly.hpp"
#include "mechanics/terms/cloth.hpp"

namespace fabricsh::mechanics {

// --- stiffness

Outcome StiffnessDamping::begin_step(const Motion& motion) {
  product_.resize(static_cast<std::size_t>(assembly_.dofs().unknowns()));
  // Explicit steps are too short for a turn to matter.
  const bool turns = motion.damping_weight() > 0 && motion.dt() > 0;
  if (turns) {
    const Trial trial = assembly_.trial();
    assembly_.apply_increment(motion.rates(), motion.dt(), assembly_.dofs().targets(trial.time), 0);
  }
  const bool done = assembly_.material_tangent(K_, motion.driven_rates(), product_);
  if (turns) assembly_.state().rollback();
  return done ? Outcome() : assembly_.outcome();
}

void StiffnessDamping::resist(const Trial& trial, std::span<double> r) {
  const auto v = trial.motion->rates();
  force_.assign(r.size(), 0);
  for (std::size_t i = 0; i < product_.size(); ++i) force_[i] = b_ * product_[i];
  const linear::Pattern& pattern = *K_.pattern;
  for (Index column = 0; column < K_.size(); ++column)
    for (auto k = pattern.column[column]; k < pattern.column[column + 1]; ++k)
      force_[pattern.row[k]] += b_ * K_.value[k] * v[column];
  for (std::size_t i = 0; i < r.size(); ++i) r[i] -= force_[i];
  if (trial.motion->dt() == 0) before_ = force_;  // the value before the first step
}

void StiffnessDamping::add_resistance(const Trial& trial, linear::Matrix& K) {
  K_.change_pattern(K.pattern);  // the pattern may have grown in the step
  const double c = trial.motion->damping_weight();
  for (std::size_t k = 0; k < K.value.size(); ++k) K.value[k] += c * b_ * K_.value[k];
}

void StiffnessDamping::finish_step(const Motion& motion) {
  work_ += motion.work(before_, force_);
  lost_ = std::max(lost_, work_);
}

void StiffnessDamping::add_energies(const Trial&, std::vector<Energy>& out) const {
  out.push_back({"stiffness damping", Account::damping, lost_});
}

// --- stabilisation

Stabilisation::Stabilisation(const Assembly& assembly, double fraction)
    : assembly_(assembly), fraction_(fraction) {
  list_freedoms();
}

void Stabilisation::list_freedoms() {
  freedoms_.clear();
  const auto& nodes = assembly_.dofs().freedoms().nodes;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (int c = 0; c < 3; ++c) {
      const auto eq = nodes[n].equation[c];
      if (eq < 0) continue;
      freedoms_.push_back({eq, static_cast<Index>(n), c});
    }
}

namespace {
double length_of(const Motion& motion) { return motion.dt() > 0 ? motion.dt() : 1; }  // s
}  // namespace

double Stabilisation::moved(const Freedom& f) const {
  const auto& state = assembly_.state();
  const auto x = state.x(), x0 = state.committed_kinematics();
  const Vec3 u(x[3 * f.node] - x0[3 * f.node], x[3 * f.node + 1] - x0[3 * f.node + 1],
               x[3 * f.node + 2] - x0[3 * f.node + 2]);
  return assembly_.dofs().freedoms().nodes[f.node].frame.row(f.component).dot(u);
}

void Stabilisation::resist(const Trial& trial, std::span<double> r) {
  const double dt = length_of(*trial.motion);
  for (const auto& f : freedoms_) r[f.equation] -= factor_ * assembly_.cloth().mass()[f.node] * moved(f) / dt;
}

void Stabilisation::add_resistance(const Trial& trial, linear::Matrix& K) {
  const double dt = length_of(*trial.motion);
  if (!(factor_ > 0)) {
    double stiffness = 0, mass = 0;
    for (const auto& f : freedoms_) {
      if (assembly_.dofs().joints().leads(f.node))
        stiffness += std::abs(K.value[K.pattern->slot(f.equation, f.equation)]);
      mass += assembly_.cloth().mass()[f.node];
    }
    if (mass > 0) factor_ = fraction_ * stiffness / mass * dt;
  }
  for (const auto& f : freedoms_)
    K.add(f.equation, f.equation, factor_ * assembly_.cloth().mass()[f.node] / dt);
}

void Stabilisation::add_energies(const Trial&, std::vector<Energy>& out) const {
  out.push_back({"stabilisation", Account::damping, lost_});
}

double Stabilisation::work(const Motion& motion) const {
  double sum = 0;
  for (const auto& f : freedoms_) sum += assembly_.cloth().mass()[f.node] * moved(f) * moved(f);
  return factor_ * sum / length_of(motion);
}

// Towards fraction * work, by a factor of at most ten a step.
void Stabilisation::adapt(double lost, double step_work) {
  if (lost > 0) factor_ *= std::clamp(fraction_ * std::abs(step_work) / lost, 0.1, 10.0);
}

}  // namespace fabricsh::mechanics
