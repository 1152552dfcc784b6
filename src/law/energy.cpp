// Stored and dissipated energy, and the outputs of a point, as functions of strain and state only.
#include "law/data.hpp"
#include "law/energy_kernel.hpp"

namespace fabricsh::law {

namespace {

Internal rate_internal(const WovenData& w, const double E[5], const double* s) {
  using namespace rate_state;
  const auto yarn = [](double x, double m) {
    return x >= m - switch_width ? LoadBranch::virgin : x < 0 ? LoadBranch::slack : LoadBranch::unloading;
  };
  Internal out;
  out.residual1 = s[m1] - backbone_at(w.axis[0].curve, s[m1]).P * w.axis[0].softness;
  out.residual2 = s[m2] - backbone_at(w.axis[1].curve, s[m2]).P * w.axis[1].softness;
  out.slack1 = max(-E[0], 0.0);
  out.slack2 = max(-E[1], 0.0);
  out.warp = yarn(E[0], s[m1]);
  out.weft = yarn(E[1], s[m2]);
  const bool virgin = !w.shear.hysteresis || abs(E[4] - s[g0]) >= s[gp] - switch_width;
  out.shear = virgin ? LoadBranch::virgin : LoadBranch::unloading;
  return out;
}

LoadBranch yarn_branch(double E, double m, double zero) {
  if (E >= m - switch_width) return LoadBranch::virgin;
  return E < zero ? LoadBranch::slack : LoadBranch::unloading;
}

}  // namespace

EnergyDensity energy(const Law& law, const double E[5], const double* s) {
  const auto e = energy_at(law, E, s);
  return {e.stored, e.warp, e.weft, e.shear, e.created};
}

Internal internal(const Law& law, const double E[5], const double* s) {
  Internal out;
  if (law.kind == CompiledKind::elastic) return out;
  const WovenData& w = law.woven;
  if (law.kind != CompiledKind::potential) return rate_internal(w, E, s);
  const auto warp = yarn_point(w.axis[0], w.coupling, E[0], s[0]);
  const auto weft = yarn_point(w.axis[1], w.coupling, E[1], s[1]);
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

}  // namespace fabricsh::law
