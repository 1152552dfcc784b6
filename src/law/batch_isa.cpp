// The batch kernels: compiled once per instruction set, picked at run time by batch_function().
#include "law/energy_kernel.hpp"
#include "law/part.hpp"
#include "law/update.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

// most: length of the longest state of this law, so that the copy on the stack is small.
template <int most, class Kernel>
unsigned run_part(int state, const double* E, const double* s0, double* s1, double* S, double* C,
                  Kernel kernel) {
  Pack e[5], old[most] = {}, trial[most];
  for (int i = 0; i < 5; ++i) e[i] = load(E + i * lanes);
  for (int i = 0; i < state; ++i) old[i] = load(s0 + i * lanes);
  const Response<Pack> out = kernel(e, old, trial);
  for (int i = 0; i < state; ++i) store(s1 + i * lanes, trial[i]);
  for (int i = 0; i < 5; ++i) store(S + i * lanes, out.S[i]);
  if (C != nullptr) put_tangent(out, [C](int entry, Pack value) { store(C + entry * lanes, value); });
  return bits(!healthy(e, out));
}

// Numbers that curved loops add to a state at most.
template <Yarns yarns>
inline constexpr int loop_numbers = yarns == Yarns::curved ? 2 * loop_state::count : 0;

template <bool rubs, Yarns yarns>
[[gnu::flatten]] unsigned potential_part(const Law& law, const Step& step, const double* E, const double* s0,
                                         double* s1, double* S, double* C) {
  return run_part<potential_state::count + 2 + loop_numbers<yarns>>(
      law.state_size, E, s0, s1, S, C, [&](const Pack* e, const Pack* old, Pack* trial) {
        return potential_update<rubs, yarns>(law.woven, step.at, e, old, trial);
      });
}

[[gnu::flatten]] unsigned plain_part(const Law& law, const Step& step, const double* E, const double* s0,
                                     double* s1, double* S, double* C) {
  return run_part<potential_state::count>(potential_state::count, E, s0, s1, S, C,
                                          [&](const Pack* e, const Pack* old, Pack* trial) {
                                            return potential_update(law.plain, step.at, e, old, trial);
                                          });
}

template <bool rubs, Yarns yarns>
[[gnu::flatten]] unsigned parallel_part(const Law& law, const Step& step, const double* E, const double* s0,
                                        double* s1, double* S, double* C) {
  constexpr int numbers = yarns == Yarns::factored ? rheology::most_numbers
                                                   : rheology::most_parallel_numbers + loop_numbers<yarns>;
  return run_part<potential_state::count + 2 + numbers>(
      law.state_size, E, s0, s1, S, C, [&](const Pack* e, const Pack* old, Pack* trial) {
        return parallel_update<rubs, yarns>(law.woven, step, e, old, trial);
      });
}

// The laws that take the woven card in the place of the springs.
#define FABRICSH_PART(name)                                                                                  \
  [[gnu::flatten]] unsigned name##_part(const Law& law, const Step& step, const double* E, const double* s0, \
                                        double* s1, double* S, double* C) {                                  \
    return run_part<name::Kind::numbers>(law.state_size, E, s0, s1, S, C,                                    \
                                         [&](const Pack* e, const Pack* old, Pack* trial) {                  \
                                           return name::update(law.woven, step, e, old, trial);              \
                                         });                                                                 \
  }
FABRICSH_WOVEN_LAWS(FABRICSH_PART)
#undef FABRICSH_PART

// Points with folds, of plain cloth and of any other.
[[gnu::flatten]] unsigned folded_plain_part(const Law& law, const Step& step, const double* E,
                                            const double* s0, double* s1, double* S, double* C) {
  return run_part<potential_state::count + fold_state::count>(
      law.state_size, E, s0, s1, S, C, [&](const Pack* e, const Pack* old, Pack* trial) {
        const auto cloth = [&](const Pack* at, const Pack* from, Pack* to) {
          return potential_update(law.plain, step.at, at, from, to);
        };
        return folded_update(cloth, potential_state::count, e, old, trial);
      });
}

unsigned folded_part(const Law& law, const Step& step, const double* E, const double* s0, double* s1,
                     double* S, double* C) {
  return run_part<most_states>(
      law.state_size, E, s0, s1, S, C,
      [&](const Pack* e, const Pack* old, Pack* trial) { return update(law, step, e, old, trial); });
}

unsigned elastic_part(const Law& law, const Step&, const double* E, const double* s0, double* s1, double* S,
                      double* C) {
  return run_part<1>(0, E, s0, s1, S, C,
                     [&](const Pack* e, const Pack*, Pack*) { return elastic_update(law.elastic, e); });
}

// Selects the kernel of law "potential" by the features that the card uses, so that unused ones cost nothing.
template <Yarns yarns>
BatchFunction woven_part_for(const WovenData& w) {
  if (rheology::any(w.elements))
    return w.friction.on ? parallel_part<true, yarns> : parallel_part<false, yarns>;
  return w.friction.on ? potential_part<true, yarns> : potential_part<false, yarns>;
}

BatchFunction potential_part_for(const Law& law) {
  if (law.is_plain) return plain_part;
  if (rheology::any_on_springs(law.woven.elements))
    return law.woven.friction.on ? parallel_part<true, Yarns::factored>
                                 : parallel_part<false, Yarns::factored>;
  return is_curved(law.woven) ? woven_part_for<Yarns::curved>(law.woven)
                              : woven_part_for<Yarns::straight>(law.woven);
}

BatchFunction part_for(const Law& law) {
  if (has_folds(law)) return law.plain_cloth ? folded_plain_part : folded_part;
  switch (law.kind) {
    case CompiledKind::potential:
      return potential_part_for(law);
#define FABRICSH_CASE(name) \
  case CompiledKind::name:  \
    return name##_part;
      FABRICSH_WOVEN_LAWS(FABRICSH_CASE)
#undef FABRICSH_CASE
    default:
      return elastic_part;
  }
}

unsigned batch(const Law& law, const Step& step, const double* E, const double* s0, double* s1, double* S,
               double* C) {
  const auto part = part_for(law);
  return at_parts([=, &law, &step](int i) {
    return part(law, step, E + i, s0 + i, s1 + i, S + i, C == nullptr ? nullptr : C + i);
  });
}

template <int most, class Kernel>
void energies_of_part(int states, const double* E, const double* s, double* out, Kernel kernel) {
  Pack e[5], state[most] = {};
  for (int i = 0; i < 5; ++i) e[i] = load(E + i * lanes);
  for (int i = 0; i < states; ++i) state[i] = load(s + i * lanes);
  const EnergyOf<Pack> energy = kernel(e, state);
  store(out, energy.stored);
  for (int i = 0; i < dissipations; ++i) store(out + (1 + i) * lanes, energy.dissipated[i]);
  store(out + (1 + dissipations) * lanes, energy.created);
}

[[gnu::flatten]] void plain_energies(const Law& law, const double* E, const double* s, double* out) {
  energies_of_part<potential_state::count>(
      potential_state::count, E, s, out,
      [&](const Pack* e, const Pack* state) { return plain_energy(law.plain, e, state); });
}

void any_energies(const Law& law, const double* E, const double* s, double* out) {
  energies_of_part<most_states>(law.state_size, E, s, out,
                                [&](const Pack* e, const Pack* state) { return energy_at(law, e, state); });
}

void energies(const Law& law, const double* E, const double* s, double* out) {
  const auto part = law.is_plain ? plain_energies : any_energies;
  at_parts([=, &law](int first) {
    part(law, E + first, s + first, out + first);
    return 0u;
  });
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
