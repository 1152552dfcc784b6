// Fabric laws: strain and committed state in; stress, consistent tangent and trial state out.
//
// E   5-vector (E11 E22 2E23 2E13 2E12), Green-Lagrange, material axes (1 = warp, 2 = weft, 3 = normal)
// S   5-vector (S11 S22 S23 S13 S12), second Piola-Kirchhoff, Pa, material axes
// C   5x5 dS/dE, row-major
// s0  committed state, s1 trial state: state_size(law) numbers each; virgin cloth: set_initial()
//
// A law does not commit, allocate or throw. Its outcome can
// say that the step must be cut, or that no step is possible.
#pragma once
#include <array>
#include <memory>

#include "card/card.hpp"
#include "simd/isa.hpp"

namespace fabricsh::law {

class Law;  // compiled parameters of one card; immutable, shared, thread-safe

// Compiles a card. Errors: a card that is refused (share/doc/theory.md,
// 4), with the reason, the strain and the numbers. Without transverse shear S13 and S23 are zero, as in a
// membrane.
std::shared_ptr<const Law> compile(const card::Card& card, bool transverse_shear = true);

int state_size(const Law& law);
bool symmetric(const Law& law);          // whether the consistent tangent is symmetric in every state
bool linear(const Law& law);             // whether the tangent is constant
bool is_rate_dependent(const Law& law);  // whether the stress changes at constant strain
bool softens(const Law& law);            // whether the stress can fall while the strain grows

// The state of virgin cloth at a point, state_size(law) numbers: all zero, but for elements that keep there
// what they need of the site. Error: a site that an element cannot bear.
using Site = rheology::PointSite;
bool has_initial(const Law& law);  // false: zeros, whatever the site
void set_initial(const Law& law, const Site& site, double* s);

// The tangent to use where loading and unloading meet (E = m exactly): the
// virgin one, or the unloading one for the first iteration after a reversal.
enum class AtSwitch { loading, unloading };

// The step of an evaluation: from t0 over dt (s), and the
// tangent to use at a switch. dt = 0: an instantaneous change.
struct Step {
  double t0 = 0, dt = 0;
  AtSwitch at = AtSwitch::loading;
};

// The outcome of an evaluation. cut: impossible with this step, a shorter one may
// succeed. broken: impossible with any step, because the committed state is not finite.
enum class Evaluation { ok, cut, broken };

// Evaluates a batch of `lanes` points in structure-of-arrays order: entry i of lane l at [i * lanes
// + l]. C may be null (stress only) and is row-major: entry (i, j) of lane l at [(5 * i + j) * lanes
// + l]. s1 must not alias s0. Returns a mask with bit l set if the outcome of lane l is not ok.
using BatchFunction = unsigned (*)(const Law& law, const Step& step, const double* E, const double* s0,
                                   double* s1, double* S, double* C);
BatchFunction batch_function(Isa isa);

// Evaluates one point; plain arrays.
Evaluation evaluate(const Law& law, const Step& step, const double E[5], const double* s0, double* s1,
                    double S[5], double* C);

// The stress at the end of an evaluation, from its strain and trial state, Pa. Whatever reads a
// stress must use this function. A state stores every part of the stress that is not a function of
// strain and state (all of it for rate laws, the viscous part of shear), so that no step is needed.
void stress(const Law& law, const double E[5], const double* s, double S[5]);

// Energies per reference volume, J/m^3, from strain and committed state alone (share/doc/theory.md, 4).
// Those dissipated have names, rheology::dissipation_names: those of the springs, and those of elements.
using rheology::dissipation_names, rheology::dissipations;
struct EnergyDensity {
  double stored = 0;
  std::array<double, dissipations>
      lost{};          // by dissipation_names; the biaxial spring is divided by its weights
  double created = 0;  // comparison laws: sum of all decreases of the dissipation
  double dissipated() const {
    double sum = 0;
    for (const double one : lost) sum += one;
    return sum;
  }
};
EnergyDensity energy(const Law& law, const double E[5], const double* s);
// The same for a batch of `lanes` points: stored, dissipated by dissipation_names, created; entry i of lane l
// at [i * lanes + l].
inline constexpr int energy_values = dissipations + 2;
using BatchEnergy = void (*)(const Law& law, const double* E, const double* s, double* energies);
BatchEnergy batch_energy(Isa isa);

// Outputs of a point: for each axis the residual strain E_r, the
// amount by which the strain is below E_r (slack), and the branch.
enum class LoadBranch { virgin, unloading, slack };
struct Internal {
  double residual1 = 0, residual2 = 0;  // E_r
  double slack1 = 0, slack2 = 0;        // max(E_r - E, 0)
  LoadBranch warp = LoadBranch::virgin, weft = LoadBranch::virgin, shear = LoadBranch::virgin;
};
Internal internal(const Law& law, const double E[5], const double* s);

// The part of the compression of a point, 0 to 1, that folds within it have taken: the sum of the principal
// strains of the folds, over that and those by which its cloth is shortened. 0 without folds.
double folded(const Law& law, const double E[5], const double* s);

// Largest eigenvalue of the stiffest tangent that the law can have,
// Pa (share/doc/theory.md, 7); it determines the explicit step.
double stiffest(const Law& law);
// Transverse shear modulus G_t, Pa (the larger of the two).
double transverse_modulus(const Law& law);
// Virgin uniaxial backbone P(E), Pa, of axis 1 or 2; axis 3: shear stress
// S12 against 2 E12. For negative strain: odd in shear, D(0) x on an axis.
double backbone(const Law& law, int axis, double x);
double backbone_modulus(const Law& law, int axis, double x);

// --- How stiff a law is along its axes and in shear, for the choice of the strains of elements and for
// advice.

// Pa. axis: the stiffest tangent along warp and weft; shear: the first of S12 on 2 E12 of virgin cloth,
// without friction and viscosity, which do not hold it for good.
struct ByDirection {
  double axis[2] = {0, 0}, shear = 0;
};
ByDirection by_direction(const Law& law);

}  // namespace fabricsh::law
