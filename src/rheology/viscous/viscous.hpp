// Shear that relaxes: a spring and a dashpot in series (Maxwell), parallel to the shear spring of the
// woven law; together a standard linear solid. q is the stress of the spring and dashpot, gamma = 2 E12:
//   dq/dt = G dgamma/dt - q / tau
// Within a step gamma is linear in time, and for that the solution is exact: a ramp gives the same
// result in one step or in a thousand.
#pragma once
#include "rheology/element.hpp"
#include "simd/isa.hpp"

namespace fabricsh::rheology::viscous {

struct Parameters {
  double modulus = 0, time = 0;  // Pa, in the measure of the card's shear; s
  bool operator==(const Parameters&) const = default;
};

struct Data {
  bool on = false;
  double modulus = 0, time = 0;  // Pa, of S12 against gamma; s
};

struct Element {
  static constexpr const char* name = "viscous";
  static constexpr const char* sentence = "stress that relaxes with time, law potential only";
  static constexpr Acts acts = Acts::in_parallel;
  static constexpr const char* dissipation = "shear";  // the name of the energy that it dissipates
  static constexpr int numbers = 3;                    // of the state
  static constexpr bool is_rate_dependent = true;      // the stress changes at constant strain
  static constexpr bool softens = false;               // the stress never falls while the strain grows
  static constexpr bool depends_on_site = false;       // the state of virgin cloth is zero
  static std::vector<ParameterRow<Parameters>> rows();
  // measure: d(strain of the card's shear)/d(gamma), 1/2 for the tensor E12.
  static Data compile(const Parameters& given, double measure) {
    return {true, given.modulus * measure, given.time};
  }
  static Stiffest stiffest(const Data& data) { return {0, data.modulus}; }
  static void set_initial(const std::array<YarnSpring, 2>&, const PointSite&, const Data&, double*) {}
};

// The state: gamma and its stress q at the last step, and the energy lost so far.
namespace state {
inline constexpr int gamma = 0, q = 1, lost = 2;
}

// The effect of a step of x = dt / tau, the same for all points:
//   q1 = decay q0 + factor G dgamma,   lost = (q0^2 own + 2 q0 (G dgamma) mixed + (G dgamma)^2 pulled) / G
// An instantaneous step (x = 0): decay = factor = 1 and nothing is lost.
struct StepEffect {
  double decay = 1, factor = 1;
  double own = 0, mixed = 0, pulled = 0;
};
StepEffect effect_of_step(double x);

inline namespace FABRICSH_ISA {

template <class T, class Out>
void add_stress(const Data& data, double dt, const T E[5], const T* s0, T* s1, Out& out) {
  const StepEffect w = effect_of_step(dt / data.time);
  const T G(data.modulus), q0 = s0[state::q];
  const T pulled = G * (E[4] - s0[state::gamma]);
  const T q = T(w.decay) * q0 + T(w.factor) * pulled;
  s1[state::gamma] = E[4];
  s1[state::q] = q;
  s1[state::lost] = s0[state::lost] +
                    (T(w.own) * q0 * q0 + T(2 * w.mixed) * q0 * pulled + T(w.pulled) * pulled * pulled) / G;
  out.S[4] += q;
  out.C55 += T(w.factor) * G;
}

template <class T>
void add_energy(const Data& data, const T* s, T& stored, T& lost) {
  stored += s[state::q] * s[state::q] / T(2 * data.modulus);
  lost += s[state::lost];
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::rheology::viscous
