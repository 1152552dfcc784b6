// Random steps of single points beside the same steps of a batch, for every instruction set that the machine
// has.
#pragma once
#include <vector>

#include "catch.hpp"
#include "law/law_point.hpp"

namespace fabricsh::test {

// The values of a batch at one of its points: stress, tangent, state and energies by number.
struct Lane {
  const std::vector<double>&stress, &tangent, &state, &energies;
  int lane;
  double S(int i) const { return stress[i * lanes + lane]; }
  double C(int i) const { return tangent[i * lanes + lane]; }
  double s(int i) const { return state[i * lanes + lane]; }
  double energy(int i) const { return energies[i * lanes + lane]; }
};

// check(point, lane) after every step.
template <class Check>
void beside_batches(const card::Card& card, int steps, Random& random, const Check& check) {
  for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512}) {
    if (isa > best_isa()) continue;
    std::vector<LawPoint> points(lanes, LawPoint(card));
    const auto& law = *points[0].law;
    const int n = law::state_size(law);
    std::vector<double> E(5 * lanes), s0(n * lanes), s1(n * lanes), S(5 * lanes), C(25 * lanes),
        out(law::energy_values * lanes);
    for (int step = 0; step < steps; ++step) {
      const law::Step over{0, random(0, 1)};
      for (int l = 0; l < lanes; ++l) {
        const Strain e{random(-0.02, 0.1), random(-0.02, 0.1), 0, 0, random(-0.5, 0.5)};
        for (int i = 0; i < 5; ++i) E[i * lanes + l] = e[i];
        for (int i = 0; i < n; ++i) s0[i * lanes + l] = points[l].s[i];
        points[l].go(e, over);
      }
      REQUIRE(law::batch_function(isa)(law, over, E.data(), s0.data(), s1.data(), S.data(), C.data()) == 0);
      law::batch_energy(isa)(law, E.data(), s1.data(), out.data());
      for (int l = 0; l < lanes; ++l) check(points[l], Lane{S, C, s1, out, l});
    }
  }
}

}  // namespace fabricsh::test
