// Stored and dissipated energy, and what the outputs show of a point, from strain and state alone.
#include "fabric/data.hpp"
#include "fabric/potential.hpp"
#include "fabric/rate_laws.hpp"

namespace fabricsh::fabric {

namespace {

// Stored energy of one yarn with its share c nu E^2 / 2 of the coupling; m is the largest strain so far.
double yarn_stored(const AxisData& axis, double coupling, double E, double residual) {
  const double cross = coupling * axis.poisson;
  const double x = E - residual;
  if (x >= 0) return 0.5 * axis.unloading * x * x + 0.5 * cross * E * E;
  return cross * residual * (0.5 * residual + x) + 0.5 * axis.slack * x * x;
}

struct YarnPoint {
  double stored, dissipated, residual;
};

YarnPoint yarn_point(const AxisData& axis, double coupling, double E, double m) {
  const auto curve = backbone_at(axis.curve, max(E, m));
  const double residual = max(E, m) - curve.P * axis.softness;
  return {yarn_stored(axis, coupling, E, residual), branch_loss(curve, axis.unloading), residual};
}

void add_biaxial_energy(const WovenData& w, const double E[5], const double* s, Energy& out) {
  double m = s[biaxial_slot(w)];
  const double y = E[0] + w.biaxial.alpha * E[1] - w.biaxial.offset;
  const auto t = biaxial_spring(w.biaxial, AtSwitch::loading, y, m);
  const double lost = branch_loss(backbone_at(w.biaxial.curve, m), w.biaxial.unloading);
  out.stored += t.S * t.S / (2 * w.biaxial.unloading);
  out.dissipated_warp += lost / (1 + w.biaxial.alpha);
  out.dissipated_weft += lost * w.biaxial.alpha / (1 + w.biaxial.alpha);
}

Energy potential_energy(const WovenData& w, const double E[5], const double* s) {
  using namespace potential_state;
  const auto warp = yarn_point(w.axis[0], w.coupling, E[0], s[m1]);
  const auto weft = yarn_point(w.axis[1], w.coupling, E[1], s[m2]);
  auto branch = load_shear(w.shear, s);
  const auto shear = shear_spring(w.shear, AtSwitch::loading, E[4], branch);
  Energy out;
  out.stored = warp.stored + weft.stored + w.coupling * E[0] * E[1];
  out.stored += shear.S * shear.S / (2 * w.shear.unloading);
  out.stored += 0.5 * w.transverse * (E[2] * E[2] + E[3] * E[3]);
  out.dissipated_warp = warp.dissipated;
  out.dissipated_weft = weft.dissipated;
  out.dissipated_shear =
      branch.lost + branch_loss(backbone_at(w.shear.curve, branch.peak), w.shear.unloading);
  if (w.biaxial.on) add_biaxial_energy(w, E, s, out);
  return out;
}

Energy elastic_energy(const ElasticData& e, const double E[5]) {
  Energy out;
  out.stored = 0.5 * (e.C11 * E[0] * E[0] + e.C22 * E[1] * E[1]) + e.C12 * E[0] * E[1] +
               0.5 * (e.G23 * E[2] * E[2] + e.G13 * E[3] * E[3] + e.G12 * E[4] * E[4]);
  return out;
}

// The comparison laws keep the work; what is not stored counts as dissipated.
Energy rate_energy(const WovenData& w, const double* s) {
  using namespace rate_state;
  const auto stored = rate_stored(w, s + S);
  Energy out;
  out.stored = stored.warp + stored.weft + stored.shear;
  out.dissipated_warp = s[W1] - stored.warp;
  out.dissipated_weft = s[W2] - stored.weft;
  out.dissipated_shear = s[W3] - stored.shear;
  out.created = s[created];
  return out;
}

Internal rate_internal(const WovenData& w, const double E[5], const double* s) {
  using namespace rate_state;
  const auto yarn = [](double x, double m) {
    return x >= m - switch_width ? Branch::virgin : x < 0 ? Branch::slack : Branch::unloading;
  };
  Internal out;
  out.residual1 = s[m1] - backbone_at(w.axis[0].curve, s[m1]).P * w.axis[0].softness;
  out.residual2 = s[m2] - backbone_at(w.axis[1].curve, s[m2]).P * w.axis[1].softness;
  out.slack1 = max(-E[0], 0.0);
  out.slack2 = max(-E[1], 0.0);
  out.warp = yarn(E[0], s[m1]);
  out.weft = yarn(E[1], s[m2]);
  const bool virgin = !w.shear.hysteresis || abs(E[4] - s[g0]) >= s[gp] - switch_width;
  out.shear = virgin ? Branch::virgin : Branch::unloading;
  return out;
}

Branch yarn_branch(double E, double m, double zero) {
  if (E >= m - switch_width) return Branch::virgin;
  return E < zero ? Branch::slack : Branch::unloading;
}

}  // namespace

Energy energy(const Law& law, const double E[5], const double* s) {
  if (law.kind == Kind::elastic) return elastic_energy(law.elastic, E);
  if (law.kind != Kind::potential) return rate_energy(law.woven, s);
  return potential_energy(law.woven, E, s);
}

Internal internal(const Law& law, const double E[5], const double* s) {
  Internal out;
  if (law.kind == Kind::elastic) return out;
  const WovenData& w = law.woven;
  if (law.kind != Kind::potential) return rate_internal(w, E, s);
  const auto warp = yarn_point(w.axis[0], w.coupling, E[0], s[0]);
  const auto weft = yarn_point(w.axis[1], w.coupling, E[1], s[1]);
  out.residual1 = warp.residual;
  out.residual2 = weft.residual;
  out.slack1 = max(warp.residual - E[0], 0.0);
  out.slack2 = max(weft.residual - E[1], 0.0);
  out.warp = yarn_branch(E[0], s[0], warp.residual);
  out.weft = yarn_branch(E[1], s[1], weft.residual);
  auto branch = load_shear(w.shear, s);
  const double before = branch.peak;
  shear_spring(w.shear, AtSwitch::loading, E[4], branch);
  const double r = branch.sign * (E[4] - branch.origin);
  out.shear = r >= before - switch_width || branch.peak <= switch_width ? Branch::virgin : Branch::unloading;
  return out;
}

}  // namespace fabricsh::fabric
