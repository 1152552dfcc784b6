// The batch kernels: compiled once per instruction set, picked at run time by batch_function().
#include "fabric/update.hpp"

namespace fabricsh::fabric {
inline namespace FABRICSH_ISA {

// most: the longest state of this law, so that the copy on the stack stays small.
template <int most, class Kernel>
unsigned run_batch(int state, const double* E, const double* s0, double* s1, double* S, double* C,
                   Kernel kernel) {
  Pack e[5], old[most] = {}, trial[most];
  for (int i = 0; i < 5; ++i) e[i] = load(E + i * lanes);
  for (int i = 0; i < state; ++i) old[i] = load(s0 + i * lanes);
  const Response<Pack> out = kernel(e, old, trial);
  for (int i = 0; i < state; ++i) store(s1 + i * lanes, trial[i]);
  for (int i = 0; i < 5; ++i) store(S + i * lanes, out.S[i]);
  if (C != nullptr) put_tangent(out, [C](int entry, Pack value) { store(C + entry * lanes, value); });
  return bits(!healthy(e, out)) & ((1u << lanes) - 1u);
}

[[gnu::flatten]] unsigned potential_batch(const Law& law, AtSwitch at, const double* E, const double* s0,
                                          double* s1, double* S, double* C) {
  return run_batch<potential_state::count + 2>(law.state_size, E, s0, s1, S, C,
                                               [&](const Pack* e, const Pack* old, Pack* trial) {
                                                 return potential_update(law.woven, at, e, old, trial);
                                               });
}

template <bool exact>
[[gnu::flatten]] unsigned rate_batch(const Law& law, AtSwitch at, const double* E, const double* s0,
                                     double* s1, double* S, double* C) {
  return run_batch<rate_state::count>(law.state_size, E, s0, s1, S, C,
                                      [&](const Pack* e, const Pack* old, Pack* trial) {
                                        return rate_update<exact>(law.woven, at, e, old, trial);
                                      });
}

unsigned elastic_batch(const Law& law, AtSwitch, const double* E, const double* s0, double* s1, double* S,
                       double* C) {
  return run_batch<1>(0, E, s0, s1, S, C,
                      [&](const Pack* e, const Pack*, Pack*) { return elastic_update(law.elastic, e); });
}

BatchFunction batch_for(const Law& law) {
  switch (law.kind) {
    case Kind::potential:
      return potential_batch;
    case Kind::incremental:
      return rate_batch<true>;
    case Kind::thesis:
      return rate_batch<false>;
    default:
      return elastic_batch;
  }
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::fabric
