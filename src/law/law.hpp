// Fabric laws: strain and committed state in; stress, consistent tangent and trial state out.
//
// E   5-vector (E11 E22 2E23 2E13 2E12), Green-Lagrange, material axes (1 = warp, 2 = weft, 3 = normal)
// S   5-vector (S11 S22 S23 S13 S12), second Piola-Kirchhoff, Pa, material axes
// C   5x5 dS/dE, row-major
// s0  committed state, s1 trial state: state_size(law) numbers each, all zero for virgin cloth
//
// A law never commits, never allocates, never throws; it can say that a step must be cut, or that it is
// broken.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "card/card.hpp"
#include "simd/isa.hpp"

namespace fabricsh::law {

class Law;  // compiled parameters of one card; immutable, shared, thread-safe

// Compiles a card. Errors: a refused card (share/doc/theory.md, 4), with the reason, the strain and the
// numbers.
std::shared_ptr<const Law> compile(const card::Card& card);

int state_size(const Law& law);
bool symmetric(const Law& law);      // is the consistent tangent symmetric in every state
bool linear(const Law& law);         // is it one constant tangent
bool hangs_on_time(const Law& law);  // does a stress change while the strain rests

// Which tangent holds where loading and unloading meet (E = m exactly): the virgin one, or the unloading one
// for the first iteration after a reversal.
enum class AtSwitch { loading, unloading };

// The step that an evaluation belongs to: from t0 over dt, s, and which tangent holds at a switch. dt = 0: at
// once.
struct Step {
  double t0 = 0, dt = 0;
  AtSwitch at = AtSwitch::loading;
};

// What came of an evaluation. cut: not this step, a shorter one may do. broken: no step leads on from the
// committed state, which is not finite.
enum class Outcome { ok, cut, broken };

// A batch of `lanes` points in structure-of-arrays order: entry i of lane l at [i * lanes + l].
// C may be null (stress only). s1 may not alias s0. Returns bit l set where the outcome of lane l is not ok.
// Row-major C: entry (i, j) of lane l at [(5 * i + j) * lanes + l].
using BatchFunction = unsigned (*)(const Law& law, const Step& step, const double* E, const double* s0,
                                   double* s1, double* S, double* C);
BatchFunction batch_function(Isa isa);

// One point, plain arrays.
Outcome evaluate(const Law& law, const Step& step, const double E[5], const double* s0, double* s1,
                 double S[5], double* C);

// The stress that an evaluation left with the strain and the trial state that it ended with, Pa: whatever
// reads a stress reads this one. A state keeps all of the stress that hangs on more than strain and state
// (laws in rates the whole of it, viscous shear its part), so that no step is needed.
void stress(const Law& law, const double E[5], const double* s, double S[5]);

// Energies per reference volume, J/m^3, from strain and committed state alone (share/doc/theory.md, 4).
struct Energy {
  double stored = 0;
  double dissipated_warp = 0, dissipated_weft = 0,
         dissipated_shear = 0;  // biaxial spring: shared by its weights
  double created = 0;           // comparison laws: the sum of every fall of dissipation
  double dissipated() const { return dissipated_warp + dissipated_weft + dissipated_shear; }
};
Energy energy(const Law& law, const double E[5], const double* s);
// The same for a batch of `lanes` points: stored, dissipated in warp, weft and shear, created; entry i of
// lane l at [i * lanes + l].
inline constexpr int energy_values = 5;
using BatchEnergy = void (*)(const Law& law, const double* E, const double* s, double* energies);
BatchEnergy batch_energy(Isa isa);

// What the outputs show of a point: residual strain E_r per axis, how far below it the yarn is slack, the
// branch.
enum class Branch { virgin, unloading, slack };
struct Internal {
  double residual1 = 0, residual2 = 0;  // E_r
  double slack1 = 0, slack2 = 0;        // max(E_r - E, 0)
  Branch warp = Branch::virgin, weft = Branch::virgin, shear = Branch::virgin;
};
Internal internal(const Law& law, const double E[5], const double* s);

// Largest eigenvalue of the stiffest tangent the law can take, Pa (share/doc/theory.md, 7): for the explicit
// step.
double stiffest(const Law& law);
// Transverse shear modulus G_t, Pa (the larger of the two).
double transverse_modulus(const Law& law);
// Virgin uniaxial backbone P(E) of an axis, Pa: axis 1 or 2; 3: shear S12 against 2 E12. Below zero strain:
// odd in shear, D(0) x on an axis.
double backbone(const Law& law, int axis, double x);
double backbone_modulus(const Law& law, int axis, double x);

}  // namespace fabricsh::law
