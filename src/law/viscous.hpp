// Shear that relaxes: a spring and a dashpot in series (Maxwell), parallel to the shear spring of the
// woven law; together a standard linear solid. q is the stress of the spring and dashpot, gamma = 2 E12:
//   dq/dt = G dgamma/dt - q / tau
// Within a step gamma is linear in time, and for that the solution is exact: a ramp gives the same
// result in one step or in a thousand.
#pragma once
#include "law/potential.hpp"

namespace fabricsh::law {

// The effect of a step of x = dt / tau, the same for all points:
//   q1 = decay q0 + share G dgamma,   lost = (q0^2 own + 2 q0 (G dgamma) mixed + (G dgamma)^2 pulled) / G
// An instantaneous step (x = 0): decay = share = 1 and nothing is lost.
struct ViscousStep {
  double decay = 1, share = 1;
  double own = 0, mixed = 0, pulled = 0;
};
ViscousStep viscous_step(double x);

inline namespace FABRICSH_ISA {

template <bool rubs = false, bool curved = false, class T>
Response<T> viscous_update(const WovenData& law, const Step& step, const T E[5], const T* s0, T* s1) {
  Response<T> out = potential_update<rubs, curved>(law, step.at, E, s0, s1);
  const ViscousStep w = viscous_step(step.dt / law.viscous.time);
  const int at = viscous_slot(law);
  const T G(law.viscous.modulus), q0 = s0[at + viscous_state::q];
  const T pulled = G * (E[4] - s0[at + viscous_state::gamma]);
  const T q = T(w.decay) * q0 + T(w.share) * pulled;
  s1[at + viscous_state::gamma] = E[4];
  s1[at + viscous_state::q] = q;
  s1[at + viscous_state::lost] =
      s0[at + viscous_state::lost] +
      (T(w.own) * q0 * q0 + T(2 * w.mixed) * q0 * pulled + T(w.pulled) * pulled * pulled) / G;
  out.S[4] += q;
  out.C55 += T(w.share) * G;
  return out;
}

// Energies of the spring and dashpot, J/m^3.
template <class T>
void add_viscous_energy(const WovenData& law, const T* s, T& stored, T& lost) {
  const int at = viscous_slot(law);
  stored += s[at + viscous_state::q] * s[at + viscous_state::q] / T(2 * law.viscous.modulus);
  lost += s[at + viscous_state::lost];
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
