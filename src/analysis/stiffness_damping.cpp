#include "analysis/stiffness_damping.hpp"

namespace fabricsh::analysis {

StiffnessDamping::StiffnessDamping(mechanics::Assembly& assembly, double b) : assembly_(assembly), b_(b) {
  if (!on()) return;
  product_.assign(assembly.unknowns(), 0);
}

bool StiffnessDamping::start(std::span<const double> driven) {
  return !on() || assembly_.material_tangent(K_, driven, product_);
}

void StiffnessDamping::force(std::span<const double> v, std::vector<double>& f) const {
  f.assign(v.size(), 0);
  if (!on()) return;
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = b_ * product_[i];
  const linear::Pattern& pattern = *K_.pattern;
  for (linear::Index column = 0; column < K_.size(); ++column)
    for (auto k = pattern.column[column]; k < pattern.column[column + 1]; ++k)
      f[pattern.row[k]] += b_ * K_.value[k] * v[column];
}

void StiffnessDamping::add(double c, linear::Matrix& K) const {
  if (!on()) return;
  for (std::size_t k = 0; k < K.value.size(); ++k) K.value[k] += c * b_ * K_.value[k];
}

}  // namespace fabricsh::analysis
