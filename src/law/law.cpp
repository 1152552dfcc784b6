#include "law/law.hpp"

#include <algorithm>
#include <cmath>

#include "law/bound.hpp"
#include "law/data.hpp"
#include "law/update.hpp"
#include "simd/copies.hpp"

namespace fabricsh::law {

// The copies compiled by batch_isa.cpp.
FABRICSH_DECLARE_COPIES(unsigned batch(const Law&, const Step&, const double*, const double*, double*,
                                       double*, double*);
                        void energies(const Law&, const double*, const double*, double*);)

int state_size(const Law& law) { return law.state_size; }
bool symmetric(const Law& law) { return law.symmetric; }
bool linear(const Law& law) { return law.kind == CompiledKind::elastic; }
bool is_rate_dependent(const Law& law) { return rheology::is_rate_dependent(law.woven.parallel); }

BatchEnergy batch_energy(Isa isa) { return FABRICSH_COPY_FOR(isa, energies); }
BatchFunction batch_function(Isa isa) { return FABRICSH_COPY_FOR(isa, batch); }

Evaluation evaluate(const Law& law, const Step& step, const double E[5], const double* s0, double* s1,
                    double S[5], double* C) {
  const auto out = update(law, step, E, s0, s1);
  for (int i = 0; i < 5; ++i) S[i] = out.S[i];
  if (C != nullptr) put_tangent(out, [C](int entry, double value) { C[entry] = value; });
  if (healthy(E, out)) return Evaluation::ok;
  const bool is_finite = std::all_of(s0, s0 + law.state_size, [](double s) { return std::isfinite(s); });
  return is_finite ? Evaluation::cut : Evaluation::broken;
}

static_assert(most_states >= rate_state::count);

void stress(const Law& law, const double E[5], const double* s, double S[5]) {
  if (law.kind == CompiledKind::incremental || law.kind == CompiledKind::thesis) {
    std::copy_n(s + rate_state::S, 5, S);
    return;
  }
  double scratch[most_states];
  const auto out = update(law, Step{}, E, s, scratch);
  for (int i = 0; i < 5; ++i) S[i] = out.S[i];
}

namespace {

// Larger eigenvalue of a 2x2 matrix with real eigenvalues.
double larger_eigenvalue(double a, double b, double c, double d) {
  const double half = 0.5 * (a - d);
  return 0.5 * (a + d) + std::sqrt(std::max(half * half + b * c, 0.0));
}

double stiffest_potential(const WovenData& w) {
  const double c = w.coupling;
  double T = w.biaxial.on ? w.biaxial.unloading : 0.0;
  const double alpha = w.biaxial.alpha;
  const auto axial = [&](int i) {
    return std::max(w.axis[i].unloading * w.loop[i].steepest + c * w.axis[i].poisson, w.axis[i].slack);
  };
  return larger_eigenvalue(axial(0) + T, c + alpha * T, c + alpha * T, axial(1) + alpha * alpha * T);
}

// The coupling of [williams2010, eq. 6.24] adds to Du_max / (1 - nn); the eigenvalue includes it.
double stiffest_rate(const WovenData& w) {
  const double D1 = w.axis[0].unloading, D2 = w.axis[1].unloading;
  const double nu12 = w.axis[0].poisson, nu21 = w.axis[1].poisson;
  return larger_eigenvalue(D1, nu21 * D1, nu12 * D2, D2) / (1.0 - nu12 * nu21);
}

}  // namespace

double transverse_modulus(const Law& law) {
  if (law.kind == CompiledKind::elastic) return std::max(law.elastic.G13, law.elastic.G23);
  return law.woven.follow ? 5.0 / 6.0 * law.woven.shear.unloading : law.woven.transverse;
}

Bound bound(const Law& law) {
  const double transverse = transverse_modulus(law);
  if (law.kind == CompiledKind::elastic) {
    const auto& e = law.elastic;
    return {larger_eigenvalue(e.C11, e.C12, e.C12, e.C22), e.G12, transverse};
  }
  const double axial =
      law.kind == CompiledKind::potential ? stiffest_potential(law.woven) : stiffest_rate(law.woven);
  const rheology::Stiffest parallel = rheology::stiffest(law.woven.parallel);
  return {axial + parallel.axial, law.woven.shear.unloading + law.woven.friction.stiffness + parallel.shear,
          transverse};
}

double stiffest(const Law& law) {
  const Bound most = bound(law);
  return std::max(most.axial, most.shear);
}

namespace {

double elastic_modulus(const ElasticData& e, int axis) {
  return axis == 1 ? e.young1 : axis == 2 ? e.young2 : e.G12;
}

const Backbone& curve_of(const Law& law, int axis) {
  return axis == 3 ? law.woven.shear.curve : law.woven.axis[axis - 1].curve;
}

}  // namespace

double backbone(const Law& law, int axis, double x) {
  if (law.kind == CompiledKind::elastic) return elastic_modulus(law.elastic, axis) * x;
  const double P = backbone_at(curve_of(law, axis), std::fabs(x)).P;
  return x < 0 ? (axis == 3 ? -P : curve_of(law, axis).initial * x) : P;
}

double backbone_modulus(const Law& law, int axis, double x) {
  if (law.kind == CompiledKind::elastic) return elastic_modulus(law.elastic, axis);
  return x < 0 && axis != 3 ? curve_of(law, axis).initial : backbone_at(curve_of(law, axis), std::fabs(x)).D;
}

}  // namespace fabricsh::law
