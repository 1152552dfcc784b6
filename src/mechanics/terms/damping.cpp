#include "mechanics/terms/damping.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/node_view.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/cloth.hpp"
#include "mechanics/terms/inertia.hpp"

namespace fabricsh::mechanics {

// --- mass

void MassDamping::finish_step(const Motion& motion) {
  const auto& state = std::as_const(assembly_).state();
  const auto& freedoms = assembly_.dofs().freedoms();
  driven_ = 0;
  for (const DrivenFreedom& m : freedoms.motions) {
    if (m.component > 2) continue;
    const double moved = freedoms.nodes[m.node]
                             .frame.row(m.component)
                             .dot(at(state.x(), m.node) - at(state.committed_kinematics(), m.node));
    driven_ += rate_ * assembly_.cloth().mass()[m.node] * moved * moved / motion.dt();
  }
  lost_ += motion.work_of_velocity(rate_) + driven_;
}

// --- stiffness

namespace {

constexpr Index kEntries = element::shell4_dofs * element::shell4_dofs;

bool is_supported(const NodeFreedoms& node) {
  return node.turn_axis || std::any_of(node.equation.begin(), node.equation.begin() + 3, is_prescribed);
}

}  // namespace

// Forces on tied nodes go to their leads, which may be supported.
void StiffnessDamping::list_supported() {
  if (!number_.empty()) return;
  const ElementTerm& elements = assembly_.terms().elements();
  const Freedoms& freedoms = assembly_.dofs().freedoms();
  number_.assign(elements.batches().size() * lanes, -1);
  supported_.clear();
  for (const BatchLane place : elements.places()) {
    const auto& nodes = elements.batches()[place.batch].nodes[place.lane];
    if (std::none_of(nodes.begin(), nodes.end(), [&](Index n) {
          return n >= 0 && (freedoms.ties(n) || is_supported(freedoms.nodes[n]));
        }))
      continue;
    number_[place.batch * lanes + place.lane] = static_cast<Index>(supported_.size());
    supported_.push_back(place);
  }
  stiffness_.assign(supported_.size() * kEntries, 0);
}

// The forces of the supports against b K_M v, and those on driven directors.
NodalRates StiffnessDamping::at_supports(const Motion& motion) const {
  if (supported_.empty()) return {};
  const Dofs& dofs = assembly_.dofs();
  const auto& state = std::as_const(assembly_).state();
  NodalRates v;
  dofs.spread_rates(motion.rates(), lead_, v);
  const std::vector<double> none(v.x.size(), 0);
  NodalRates force{none, none}, out{none, none};
  for (std::size_t e = 0; e < supported_.size(); ++e) {
    const Batch& batch = assembly_.terms().elements().batches()[supported_[e].batch];
    const auto& nodes = batch.nodes[supported_[e].lane];
    const auto axes = [&](int a) {
      Eigen::Matrix<double, 3, 2> both;
      both << at(state.b1(), nodes[a]), at(state.d(), nodes[a]).cross(at(state.b1(), nodes[a]));
      return both;
    };
    const Eigen::Map<const Eigen::MatrixXd> K(stiffness_.data() + e * kEntries, batch.kind->dofs,
                                              batch.kind->dofs);
    Eigen::VectorXd rate(batch.kind->dofs);
    for (int a = 0; a < batch.kind->corners; ++a) {
      rate.segment<3>(5 * a) = at(v.x, nodes[a]);
      rate.segment<2>(5 * a + 3) = axes(a).transpose() * at(v.d, nodes[a]);
    }
    const Eigen::VectorXd f = b_ * (K * rate);
    for (int a = 0; a < batch.kind->corners; ++a) {
      at(force.x, nodes[a]) += f.segment<3>(5 * a);
      at(force.d, nodes[a]) += axes(a) * f.segment<2>(5 * a + 3);
    }
  }
  for (std::size_t n = 0; n < state.nodes(); ++n) {
    const NodeFreedoms& node = dofs.freedoms().nodes[n];
    if (is_supported(node)) at(out.x, n) = dofs.support_force(static_cast<Index>(n), force.x, none);
    if (node.turn_axis) at(out.d, n) = at(force.d, n);
  }
  return out;
}

// J, of the supports in the step, with the forces before it, if there were any, and those at its end.
double StiffnessDamping::work_on_driven(const NodalRates& before, double late) const {
  if (supported_.empty()) return 0;
  const auto& state = std::as_const(assembly_).state();
  const auto old = state.committed_kinematics();
  const auto along = [&](const NodalRates& force, Index n) {
    if (force.x.empty()) return 0.0;
    return at(force.x, n).dot(at(state.x(), n) - at(old, n)) +
           at(force.d, n).dot(at(state.d(), n) - at(old.subspan(force.x.size()), n));
  };
  double sum = 0;
  for (const Index n : assembly_.dofs().driven_nodes())
    sum += (1 - late) * along(before, n) + late * along(supports_, n);
  return sum;
}

Outcome StiffnessDamping::begin_step(const Motion& motion) {
  product_.resize(static_cast<std::size_t>(assembly_.dofs().unknowns()));
  // Explicit steps are too short for a turn to matter.
  const bool turns = motion.damping_weight() > 0 && motion.dt() > 0;
  if (turns) {
    const Trial trial = assembly_.trial();
    assembly_.apply_increment(motion.rates(), motion.dt(), assembly_.dofs().targets(trial.time), 0);
  }
  list_supported();
  lead_ = motion.driven_rates();
  const Stiffness::Reader read = [this](Index b, const double* K) {
    const Batch& batch = assembly_.terms().elements().batches()[b];
    for (int l = 0; l < batch.used; ++l)
      if (const Index e = number_[b * lanes + l]; e >= 0)
        for (int i = 0; i < batch.kind->dofs * batch.kind->dofs; ++i)
          stiffness_[e * kEntries + i] = K[i * lanes + l];
  };
  const bool done = assembly_.material_tangent(K_, lead_, product_, supported_.empty() ? nullptr : &read);
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
  if (trial.motion->dt() > 0) return;
  before_ = force_;  // the values before the first step
  supports_ = at_supports(*trial.motion);
}

void StiffnessDamping::add_resistance(const Trial& trial, linear::Matrix& K) {
  K_.change_pattern(K.pattern);  // the pattern may have grown in the step
  const double c = trial.motion->damping_weight();
  for (std::size_t k = 0; k < K.value.size(); ++k) K.value[k] += c * b_ * K_.value[k];
}

void StiffnessDamping::finish_step(const Motion& motion) {
  const NodalRates before = std::exchange(supports_, at_supports(motion));
  driven_ = work_on_driven(before, motion.weight_of_end());
  work_ += motion.work(before_, force_) + driven_;
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
