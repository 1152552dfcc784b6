// Random closed strain loops: their work by quadrature from outside, and what the laws' own accounts say of
// it.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.hpp"
#include "law/law_point.hpp"
#include "law/thesis_cards.hpp"

namespace fabricsh::test {

inline Strain random_strain(Random& random, const card::Woven& w) {
  return {random(-0.3, 1.2) * w.tested.warp, random(-0.3, 1.2) * w.tested.weft, random(-0.1, 0.1),
          random(-0.1, 0.1), random(-0.7, 0.7)};
}

inline Strain between(const Strain& a, const Strain& b, double s) {
  Strain e;
  for (int i = 0; i < 5; ++i) e[i] = a[i] + s * (b[i] - a[i]);
  return e;
}

// Power S . (b - a) at the fraction s of a leg, from the state at its start.
inline double power(LawPoint& point, const Strain& a, const Strain& b, double s) {
  point.evaluate(between(a, b, s), {0, s * point.over});
  double sum = 0;
  for (int i = 0; i < 5; ++i) sum += point.S[i] * (b[i] - a[i]);
  return sum;
}

// Four-point Gauss-Lobatto: exact for degree 5, above any branch of the law; the ends are among its points,
// so that no switch near one of them goes unseen.
inline double lobatto(LawPoint& point, const Strain& a, const Strain& b, double s, double t) {
  const double half = 0.5 * (t - s), mid = 0.5 * (s + t), x = std::sqrt(0.2) * half;
  return half / 6 *
         (power(point, a, b, s) + 5 * power(point, a, b, mid - x) + 5 * power(point, a, b, mid + x) +
          power(point, a, b, t));
}

// Work of a leg to rounding: bisected wherever a switch lies.
inline double work(LawPoint& point, const Strain& a, const Strain& b, double s, double t, double whole,
                   double size, int depth = 0) {
  const double mid = 0.5 * (s + t);
  const double left = lobatto(point, a, b, s, mid), right = lobatto(point, a, b, mid, t);
  if (depth > 45 || std::fabs(left + right - whole) <= 1e-15 * size) return left + right;
  return work(point, a, b, s, mid, left, size, depth + 1) + work(point, a, b, mid, t, right, size, depth + 1);
}

inline double leg_work(LawPoint& point, const Strain& b, double size) {
  const Strain a = point.E;
  const double W = work(point, a, b, 0, 1, lobatto(point, a, b, 0, 1), size);
  point.go(b, {0, point.over});
  return W;
}

struct LoopSum {
  double worst = 0;   // lowest work of a loop, of the loop's energy
  double ledger = 0;  // largest |W - stored - dissipated|, of the loop's energy
  double fall = 0;    // largest fall of dissipation, of the loop's energy
};

inline void one_loop(const card::Card& card, Random& random, LoopSum& sum) {
  LawPoint point(card);
  const auto& w = std::get<card::Woven>(card.law);
  double W = 0, energy = 0, dissipated = 0, fall = 0;
  const int corners = 2 + random.below(5);
  for (int k = 0; k <= corners; ++k) {
    const Strain next = k == corners ? Strain{} : random_strain(random, w);
    if (w.parallel.viscous) point.over = random(0, 3) * w.parallel.viscous->time;
    const double step = leg_work(point, next, 1e5);
    W += step;
    energy += std::fabs(step);
    const auto now = point.energy();
    fall = std::max(fall, dissipated - now.dissipated());
    dissipated = now.dissipated();
    sum.ledger = std::max(sum.ledger, std::fabs(W - now.stored - dissipated) / energy);
  }
  sum.worst = std::min(sum.worst, W / energy);
  sum.fall = std::max(sum.fall, fall / energy);
}

inline void no_energy_from_nothing(const card::Card& card, unsigned seed, int loops) {
  Random random(seed);
  LoopSum sum;
  for (int k = 0; k < loops; ++k) one_loop(card, random, sum);
  const auto& w = std::get<card::Woven>(card.law);
  const char* option = w.warp.loop                                   ? "curved"
                       : w.shear.friction                            ? "friction"
                       : w.parallel.damage                           ? "damage"
                       : w.parallel.viscous                          ? "viscous"
                       : w.biaxial                                   ? "biaxial"
                       : w.shear.memory == card::ShearMemory::fading ? "fading"
                                                                     : "";
  std::printf("potential %-7s %-8s %d loops, least work %.1e, ledger %.1e, fall %.1e\n", option,
              card.name.c_str(), loops, sum.worst, sum.ledger, sum.fall);
  std::fflush(stdout);
  CHECK(sum.worst >= -1e-12);
  CHECK(sum.ledger <= 1e-10);  // the quadrature of this test stops at 1e-10 J/m^3 a piece, not the law
  CHECK(sum.fall <= 1e-14);
}

// The comparison laws keep their own account; legs of 20 steps.
struct Made {
  double created = 0, dissipated = 0, energy = 0;
  double worst = 0;  // lowest work of a loop, of its energy
  int negative = 0;
};

inline void one_rate_loop(const card::Card& card, Random& random, Made& made) {
  LawPoint point(card);
  const auto& w = std::get<card::Woven>(card.law);
  double energy = 0, W = 0;
  const int corners = 2 + random.below(5);
  for (int k = 0; k <= corners; ++k) {
    const Strain a = point.E, b = k == corners ? Strain{} : random_strain(random, w);
    for (int step = 1; step <= 20; ++step) {
      point.go(step == 20 ? b : between(a, b, step / 20.0));
      const auto now = point.energy();
      energy += std::fabs(now.stored + now.dissipated() - W);
      W = now.stored + now.dissipated();
    }
  }
  made.created += point.energy().created;
  made.energy += energy;
  made.worst = std::min(made.worst, W / energy);
  made.negative += W < 0 ? 1 : 0;
}

// The table's line of one comparison law.
inline Made loops_of(const card::Card& card, unsigned seed, int loops) {
  Random random(seed);
  Made made;
  for (int k = 0; k < loops; ++k) one_rate_loop(card, random, made);
  const auto& w = std::get<card::Woven>(card.law);
  std::printf("%-12s %-10s %-8s %16.3f %% %18.2f %% %19.1f %%\n",
              w.law == card::LawKind::thesis ? "thesis" : "incremental",
              w.transverse == card::Transverse::follow ? "follow" : "elastic", card.name.c_str(),
              100 * made.created / made.energy, 100.0 * made.negative / loops, 100 * made.worst);
  return made;
}

// Both comparison laws with either transverse rule on all four cards.
inline void comparison_loops(int loops) {
  std::printf(
      "law          transverse card     created/work done  loops with work < 0  lowest work of a loop\n");
  for (const auto law : {card::LawKind::incremental, card::LawKind::thesis})
    for (const auto transverse : {card::Transverse::elastic, card::Transverse::follow})
      for (int f = 0; f < 4; ++f)
        CHECK(loops_of(thesis_card(f, law, transverse), 400 + f, loops).created >
              0);  // why they are no default
}

// The potential law on one card: as it is, and with its options.
inline void potential_loops(int f, int loops) {
  no_energy_from_nothing(thesis_card(f), 100 + f, loops);
  no_energy_from_nothing(with_biaxial(thesis_card(f)), 200 + f, loops);
  auto fading = thesis_card(f);
  woven(fading).shear.memory = card::ShearMemory::fading;
  no_energy_from_nothing(fading, 300 + f, loops);
  no_energy_from_nothing(with_viscous(thesis_card(f)), 500 + f, loops);
  no_energy_from_nothing(with_friction(thesis_card(f)), 600 + f, loops);
  no_energy_from_nothing(with_viscous(with_friction(thesis_card(f), -0.2)), 700 + f, loops);
  no_energy_from_nothing(with_loops(thesis_card(f)), 800 + f, loops);
  no_energy_from_nothing(with_damage(thesis_card(f)), 1000 + f, loops);
  no_energy_from_nothing(with_damage(with_viscous(with_friction(thesis_card(f)))), 1100 + f, loops);
  no_energy_from_nothing(with_loops(with_biaxial(with_viscous(with_friction(thesis_card(f))))), 900 + f,
                         loops);
}

}  // namespace fabricsh::test
