#include "analysis/stiffness_damping.hpp"

namespace fabricsh::analysis {

StiffnessDamping::StiffnessDamping(assembly::Assembly& assembly, double b) : assembly_(assembly), b_(b) {
  if (!on()) return;
  K_ = assembly.pattern();
  product_.assign(assembly.unknowns(), 0);
}

bool StiffnessDamping::start(std::span<const double> driven) {
  return !on() || assembly_.material_tangent(K_, driven, product_);
}

void StiffnessDamping::force(std::span<const double> v, std::vector<double>& f) const {
  f.assign(v.size(), 0);
  if (!on()) return;
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = b_ * product_[i];
  for (solver::Index column = 0; column < K_.size; ++column)
    for (auto k = K_.column[column]; k < K_.column[column + 1]; ++k)
      f[K_.row[k]] += b_ * K_.value[k] * v[column];
}

void StiffnessDamping::add(double c, solver::SparseMatrix& K) const {
  if (!on()) return;
  for (std::size_t k = 0; k < K.value.size(); ++k) K.value[k] += c * b_ * K_.value[k];
}

}  // namespace fabricsh::analysis
