// Stored and dissipated energy, and the outputs of a point, as functions of strain and state only.
#include <algorithm>

#include "law/data.hpp"
#include "law/energy_kernel.hpp"

namespace fabricsh::law {

namespace {

LoadBranch yarn_branch(double E, double m, double zero) {
  if (E >= m - switch_width) return LoadBranch::virgin;
  return E < zero ? LoadBranch::slack : LoadBranch::unloading;
}

Internal potential_internal(const WovenData& w, const double E[5], const double* s) {
  Internal out;
  const auto warp = yarn_point(w, 0, E[0], s);
  const auto weft = yarn_point(w, 1, E[1], s);
  out.residual1 = warp.residual;
  out.residual2 = weft.residual;
  out.slack1 = max(warp.residual - E[0], 0.0);
  out.slack2 = max(weft.residual - E[1], 0.0);
  out.warp = yarn_branch(E[0], s[0], warp.residual);
  out.weft = yarn_branch(E[1], s[1], weft.residual);
  if (w.friction.on) {
    const bool farthest = abs(E[4]) >= s[potential_state::gp] - switch_width;
    out.shear = farthest ? LoadBranch::virgin : LoadBranch::unloading;
    return out;
  }
  auto branch = load_shear(w.shear, s);
  const double before = branch.peak;
  shear_spring(w.shear, AtSwitch::loading, E[4], branch);
  const double r = branch.sign * (E[4] - branch.origin);
  out.shear =
      r >= before - switch_width || branch.peak <= switch_width ? LoadBranch::virgin : LoadBranch::unloading;
  return out;
}

}  // namespace

EnergyDensity energy(const Law& law, const double E[5], const double* s) {
  const auto e = energy_at(law, E, s);
  EnergyDensity out{e.stored, {}, e.created};
  std::copy_n(e.dissipated, dissipations, out.lost.begin());
  return out;
}

double folded(const Law& law, const double E[5], const double* s) {
  if (!has_folds(law)) return 0;
  double e[5];
  fold_energy(fold_slot(law), s, E, e);
  const double folds = (e[0] - E[0]) + (e[1] - E[1]);
  const Eigen<double> cloth = eigen(Plane<double>{(e[0] + e[1]) / 2, (e[0] - e[1]) / 2, e[4] / 2});
  const double shortened = max(-cloth.first, 0.0) + max(-cloth.second, 0.0);
  return folds > 0 ? folds / (folds + shortened) : 0;
}

Internal internal(const Law& law, const double E[5], const double* s) {
  const WovenData& w = law.woven;
  switch (law.kind) {
    case CompiledKind::potential:
      return potential_internal(w, E, s);
#define FABRICSH_CASE(name) \
  case CompiledKind::name:  \
    return name::internal(w, E, s);
      FABRICSH_WOVEN_LAWS(FABRICSH_CASE)
#undef FABRICSH_CASE
    default:
      return {};
  }
}

}  // namespace fabricsh::law
