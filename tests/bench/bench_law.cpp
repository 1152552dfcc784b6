// Nanoseconds per update of one material point, scalar and batch, for each law: bench_law [repeats]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "law/law.hpp"
#include "law/thesis_cards.hpp"

using namespace fabricsh;
using Clock = std::chrono::steady_clock;

namespace {

constexpr int points = 1024;  // 128 batches: strains and states stay in the first caches
constexpr int steps = 16;

// Strain of point p after step k: two axes and shear out and back, every point a little different.
double strain(int component, int p, int k) {
  const double there = k < 8 ? k / 8.0 : (16 - k) / 8.0;
  const double own = 0.5 + p / (2.0 * points);
  const double reach[5] = {0.04, 0.03, 0.01, 0.01, 0.3};
  return reach[component] * own * there * (component == 1 && p % 3 == 0 ? -0.5 : 1.0);
}

struct Data {
  std::vector<double> E, s0, s1, S, C;
  int state;
  explicit Data(int n)
      : E(steps * points * 5), s0(points * n), s1(points * n), S(points * 5), C(points * 25), state(n) {}
};

// Structure of arrays inside each batch of `lanes` points.
void fill_batches(Data& d) {
  for (int k = 0; k < steps; ++k)
    for (int p = 0; p < points; ++p)
      for (int i = 0; i < 5; ++i)
        d.E[(k * points + p / lanes * lanes) * 5 + i * lanes + p % lanes] = strain(i, p, k);
}

void fill_points(Data& d) {
  for (int k = 0; k < steps; ++k)
    for (int p = 0; p < points; ++p)
      for (int i = 0; i < 5; ++i) d.E[(k * points + p) * 5 + i] = strain(i, p, k);
}

template <class Step>
double best_time(int repeats, Data& d, Step step) {
  double best = 1e9;
  for (int r = 0; r < repeats; ++r) {
    std::fill(d.s0.begin(), d.s0.end(), 0.0);
    const auto start = Clock::now();
    for (int k = 0; k < steps; ++k) {
      step(k);
      d.s0.swap(d.s1);
    }
    best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return best / (steps * points) * 1e9;
}

double batch_time(const law::Law& law, Isa isa, bool tangent, int repeats) {
  Data d(law::state_size(law));
  fill_batches(d);
  const auto run = law::batch_function(isa);
  return best_time(repeats, d, [&](int k) {
    for (int b = 0; b < points; b += lanes)
      run(law, law::Step{}, &d.E[(k * points + b) * 5], d.s0.data() + b * d.state, d.s1.data() + b * d.state,
          &d.S[b * 5], tangent ? &d.C[b * 25] : nullptr);
  });
}

double scalar_time(const law::Law& law, int repeats) {
  Data d(law::state_size(law));
  fill_points(d);
  return best_time(repeats, d, [&](int k) {
    for (int p = 0; p < points; ++p)
      law::evaluate(law, law::Step{}, &d.E[(k * points + p) * 5], d.s0.data() + p * d.state,
                    d.s1.data() + p * d.state, &d.S[p * 5], &d.C[p * 25]);
  });
}

void report(const std::string& name, const card::Card& card, int repeats) {
  const auto law = law::compile(card);
  std::printf("%-22s %8.1f", name.c_str(), scalar_time(*law, repeats));
  for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512})
    if (isa <= best_isa())
      std::printf("  %8s %6.1f %6.1f", fabricsh::name(isa), batch_time(*law, isa, true, repeats),
                  batch_time(*law, isa, false, repeats));
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 200;
  std::printf("ns per update of one point   scalar | batch: with tangent, stress only\n");
  auto card = test::thesis_card(0);
  report("potential", card, repeats);
  report("potential, biaxial", test::with_biaxial(card), repeats);
  report("potential, curved", test::with_loops(card), repeats);
  auto relaxing = card;
  test::woven(relaxing).parallel.viscous = rheology::viscous::Parameters{1e6, 1e-3};
  report("potential, viscous", relaxing, repeats);
  test::woven(card).shear.memory = card::ShearMemory::fading;
  report("potential, fading", card, repeats);
  report("incremental", test::thesis_card(0, card::LawKind::incremental), repeats);
  report("thesis", test::thesis_card(0, card::LawKind::thesis), repeats);
  card.law = card::Svk{8e6, 37e6, 1e6, 0.25, 0.42, {}, {}};
  report("svk", card, repeats);
}
