// Reading a run: nodes, elements, reactions, energies, snapshots.
#include <algorithm>
#include <cmath>

#include "analysis/run.hpp"
#include "base/error.hpp"

namespace fabricsh::analysis {

namespace {

using Member = double ElementValues::*;
struct Named {
  const char* name;
  Member member;
};
constexpr Named kValues[] = {{"E11", &ElementValues::E11},
                             {"E22", &ElementValues::E22},
                             {"E23", &ElementValues::E23},
                             {"E13", &ElementValues::E13},
                             {"E12", &ElementValues::E12},
                             {"S11", &ElementValues::S11},
                             {"S22", &ElementValues::S22},
                             {"S23", &ElementValues::S23},
                             {"S13", &ElementValues::S13},
                             {"S12", &ElementValues::S12},
                             {"stored", &ElementValues::stored},
                             {"dissipated", &ElementValues::dissipated},
                             {"residual1", &ElementValues::residual1},
                             {"residual2", &ElementValues::residual2},
                             {"slack1", &ElementValues::slack1},
                             {"slack2", &ElementValues::slack2}};

void check_index(mesh::Index i, std::size_t size, const char* what) {
  if (i < 0 || i >= static_cast<mesh::Index>(size))
    throw Error(std::string(what) + ": expected a number from 1 to " + std::to_string(size) + ", got " +
                std::to_string(i + 1));
}

void add(ElementValues& v, double w, const fabric::Law& law, const double* E, const double* state) {
  thread_local std::vector<double> scratch;
  scratch.resize(std::max(1, fabric::state_size(law)));
  double S[5];
  fabric::evaluate(law, fabric::AtSwitch::loading, E, state, scratch.data(), S, nullptr);
  const auto energy = fabric::energy(law, E, state);
  const auto in = fabric::internal(law, E, state);
  v.E11 += w * E[0];
  v.E22 += w * E[1];
  v.E23 += w * E[2] / 2;
  v.E13 += w * E[3] / 2;
  v.E12 += w * E[4] / 2;
  v.S11 += w * S[0];
  v.S22 += w * S[1];
  v.S23 += w * S[2];
  v.S13 += w * S[3];
  v.S12 += w * S[4];
  v.stored += w * energy.stored;
  v.dissipated += w * energy.dissipated();
  v.residual1 += w * in.residual1;
  v.residual2 += w * in.residual2;
  v.slack1 += w * in.slack1;
  v.slack2 += w * in.slack2;
}

}  // namespace

const std::vector<std::string>& element_value_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> n;
    for (const auto& v : kValues) n.emplace_back(v.name);
    return n;
  }();
  return names;
}

double element_value(const ElementValues& v, const std::string& name) {
  for (const auto& value : kValues)
    if (name == value.name) return v.*value.member;
  std::string known;
  for (const auto& value : kValues) known += std::string(known.empty() ? "" : " ") + value.name;
  throw Error("unknown element value '" + name + "', expected one of " + known);
}

Vec3 Run::reaction(const std::string& set) const {
  Vec3 sum = Vec3::Zero();
  const auto& nodes = model_->mesh().set(set);
  if (dead_.empty()) return sum;  // the run has not begun: no force has been computed
  for (const auto n : nodes) sum += assembly_->support_force(n, dead_) + inertia(n);
  return sum;
}

NodeValues Run::node(mesh::Index i) const {
  check_index(i, model_->mesh().nodes.size(), "node");
  const auto& state = std::as_const(*assembly_).state();
  NodeValues v;
  v.x = Eigen::Map<const Vec3>(state.x().data() + 3 * i);
  v.n = Eigen::Map<const Vec3>(state.d().data() + 3 * i);
  v.X = assembly_->reference()[i];
  v.u = v.x - v.X;
  v.v = velocity(i);
  return v;
}

const std::vector<ElementValues>& Run::elements() const {
  const auto version = std::as_const(*assembly_).state().version();
  if (cache_version_ == version) return cache_;
  cache_.assign(assembly_->elements(), {});
#pragma omp parallel for schedule(static) if (assembly_->elements() >= 256)
  for (mesh::Index e = 0; e < assembly_->elements(); ++e) {
    double volume = 0;
    ElementValues sum;
    assembly_->visit(e, [&](double w, const fabric::Law& law, const double* E, const double* state) {
      volume += w;
      add(sum, w, law, E, state);
    });
    for (const auto& value : kValues) sum.*value.member /= volume;
    cache_[e] = sum;
  }
  cache_version_ = version;
  return cache_;
}

ElementValues Run::element(mesh::Index i) const {
  check_index(i, model_->mesh().elements.size(), "element");
  return elements()[i];
}

double Run::mean(const std::string& name, const std::string& set) const {
  const auto inside = model_->mesh().elements_in(model_->mesh().set(set));
  if (inside.empty()) throw Error("mean: set '" + set + "' holds no whole element");
  const auto& values = elements();
  double sum = 0;
  for (const auto e : inside) sum += element_value(values[e], name);
  return sum / static_cast<double>(inside.size());
}

std::vector<double> Run::field(const std::string& name) const {
  std::vector<double> out;
  for (const auto& v : elements()) out.push_back(element_value(v, name));
  return out;
}

Energy Run::energy() const {
  Energy sum;
  for (const auto& energy : assembly_->energies()) {
    if (energy.account == mechanics::Account::stored) sum.stored += energy.value;
    if (energy.account == mechanics::Account::created) sum.created += energy.value;
    if (energy.account != mechanics::Account::dissipated) continue;
    if (energy.name == "warp") sum.dissipated_warp += energy.value;
    if (energy.name == "weft") sum.dissipated_weft += energy.value;
    if (energy.name == "shear") sum.dissipated_shear += energy.value;
    if (energy.name == "bending") sum.dissipated_bending += energy.value;
  }
  sum.dissipated = sum.dissipated_warp + sum.dissipated_weft + sum.dissipated_shear + sum.dissipated_bending;
  sum.kinetic = kinetic();
  sum.scaled = scaled_kinetic();
  sum.damping = damping_work();
  sum.external = work_.total() + driven_work();
  sum.initial = initial_energy_;
  const double scale = std::max(work_.largest(), initial_energy_);
  if (scale > 0) sum.error = std::abs(sum.surplus()) / scale;
  return sum;
}

}  // namespace fabricsh::analysis
