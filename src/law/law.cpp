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
bool linear(const Law& law) { return law.kind == CompiledKind::elastic && !has_folds(law); }
bool is_rate_dependent(const Law& law) { return rheology::is_rate_dependent(law.woven.elements); }
bool has_initial(const Law& law) { return has_folds(law) || rheology::depends_on_site(law.woven.elements); }
bool softens(const Law& law) { return rheology::softens(law.woven.elements); }

namespace {

// The stiffness of folds [elastica: a strut that is shortened by the share f carries 1 + f / 2 times what it
// buckles at], and a trace of that of the cloth, so that what is slack has a place where it rests.
void set_folds(const Law& law, const Site& site, double* s) {
  constexpr double trace = 1e-5;
  const bool elastic = law.kind == CompiledKind::elastic;
  const bool is_free = law.folds == card::Folds::free;
  if (!is_free && !(site.folding[0] >= 0 && site.folding[1] >= 0)) return;
  const double modulus[2] = {elastic ? law.elastic.C11 : law.woven.axis[0].slack,
                             elastic ? law.elastic.C22 : law.woven.axis[1].slack};
  double limit[2], scale[2];
  for (int i = 0; i < 2; ++i) {
    limit[i] = is_free ? 0 : site.folding[static_cast<std::size_t>(i)];
    scale[i] = std::sqrt(0.5 * limit[i] + trace * modulus[i]);
  }
  s[fold_state::a] = scale[0];
  s[fold_state::b] = scale[1];
  s[fold_state::c] = std::sqrt(scale[0] * scale[1]);
  s[fold_state::s1] = limit[0];
  s[fold_state::s2] = limit[1];
}

}  // namespace

void set_initial(const Law& law, const Site& site, double* s) {
  std::fill_n(s, law.state_size, 0.0);
  if (!has_initial(law)) return;
  if (has_folds(law)) set_folds(law, site, s + fold_slot(law));
  if (!rheology::depends_on_site(law.woven.elements)) return;
  Site own = site;
  if (own.thickness <= 0) own.thickness = law.thickness;
  std::array<rheology::YarnSpring, 2> yarns;
  for (int i = 0; i < 2; ++i) {
    const AxisData& axis = law.woven.axis[i];
    yarns[static_cast<std::size_t>(i)] = {[&axis](double E) { return backbone_at(axis.curve, E).P; },
                                          axis.unloading};
  }
  rheology::set_initial(law.woven.elements, yarns, own, s + elements_slot(law.woven));
}

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

namespace {

// Where a law keeps the stress in its state; -1: it is a function of strain and state.
int stored_stress(CompiledKind kind) {
  switch (kind) {
#define FABRICSH_CASE(name)                            \
  case CompiledKind::name:                             \
    static_assert(most_states >= name::Kind::numbers); \
    return name::Kind::stored_stress;
    FABRICSH_WOVEN_LAWS(FABRICSH_CASE)
#undef FABRICSH_CASE
    default:
      return -1;
  }
}

}  // namespace

void stress(const Law& law, const double E[5], const double* s, double S[5]) {
  if (const int at = stored_stress(law.kind); at >= 0) {
    std::copy_n(s + at, 5, S);
    return;
  }
  double scratch[most_states];
  const auto out = update(law, Step{}, E, s, scratch);
  for (int i = 0; i < 5; ++i) S[i] = out.S[i];
}

namespace {

double stiffest_potential(const WovenData& w) {
  const double c = w.coupling;
  double T = w.biaxial.on ? w.biaxial.unloading : 0.0;
  const double alpha = w.biaxial.alpha;
  const auto axial = [&](int i) {
    return std::max(w.axis[i].unloading * w.loop[i].steepest + c * w.axis[i].poisson, w.axis[i].slack);
  };
  return larger_eigenvalue(axial(0) + T, c + alpha * T, c + alpha * T, axial(1) + alpha * alpha * T);
}

Bound bound_of_springs(const Law& law) {
  switch (law.kind) {
#define FABRICSH_CASE(name) \
  case CompiledKind::name:  \
    return name::Kind::bound(law.woven);
    FABRICSH_WOVEN_LAWS(FABRICSH_CASE)
#undef FABRICSH_CASE
    default:
      return {stiffest_potential(law.woven), law.woven.shear.unloading, 0};
  }
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
  const Bound springs = bound_of_springs(law);
  const rheology::Stiffest elements = rheology::stiffest(law.woven.elements);
  return {springs.axial + elements.axial, springs.shear + law.woven.friction.stiffness + elements.shear,
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

ByDirection by_direction(const Law& law) {
  if (law.kind == CompiledKind::elastic) return {{law.elastic.C11, law.elastic.C22}, law.elastic.G12};
  const WovenData& w = law.woven;
  ByDirection out;
  out.shear = backbone_modulus(law, 3, 0);
  for (int i = 0; i < 2; ++i)
    out.axis[i] =
        std::max(w.axis[i].unloading * w.loop[i].steepest + w.coupling * w.axis[i].poisson, w.axis[i].slack);
  return out;
}

}  // namespace fabricsh::law
