// Shares of the tested strains: of a batch with every instruction set as of one point, for every law and any
// history of strain.
#include <algorithm>
#include <random>

#include "catch.hpp"
#include "law/peaks.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

card::Card with_law(card::LawKind kind) {
  card::Card c = test::blend();
  std::get<card::Woven>(c.law).law = kind;
  return c;
}

std::vector<Isa> usable() {
  std::vector<Isa> all;
  for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512})
    if (isa <= best_isa()) all.push_back(isa);
  return all;
}

constexpr int points = 3;

// States of points that were strained at random, in the order of a batch.
std::vector<double> strained(const law::Law& law, std::mt19937& random) {
  const int size = law::state_size(law);
  std::vector<double> states(static_cast<std::size_t>(points * size * lanes)), s0(size), s1(size);
  std::uniform_real_distribution<double> strain(-0.4, 0.4);
  for (int i = 0; i < points; ++i)
    for (int lane = 0; lane < lanes; ++lane) {
      std::fill(s0.begin(), s0.end(), 0);
      for (int step = 0; step < 5; ++step) {
        const double E[5] = {strain(random), strain(random), 0, 0, strain(random)};
        double S[5];
        REQUIRE(law::evaluate(law, law::Step{}, E, s0.data(), s1.data(), S, nullptr) == law::Evaluation::ok);
        s0 = s1;
      }
      for (int k = 0; k < size; ++k) states[static_cast<std::size_t>((i * size + k) * lanes + lane)] = s0[k];
    }
  return states;
}

}  // namespace

TEST_CASE("the largest share of the tested strains is the same for a batch as for its points") {
  std::mt19937 random(7);
  for (const auto kind : {card::LawKind::potential, card::LawKind::incremental, card::LawKind::thesis}) {
    const card::Card card = with_law(kind);
    const auto law = law::compile(card);
    const auto tested = law::tested_strains(card);
    const double inverse[3] = {1 / tested[0], 1 / tested[1], 1 / tested[2]};
    const int size = law::state_size(*law);
    for (int round = 0; round < 50; ++round) {
      const auto states = strained(*law, random);
      for (const Isa isa : usable()) {
        const double share = law::strain_ratio_function(isa)(*law, inverse, states.data(),
                                                             static_cast<long>(size) * lanes, points);
        double most = 0;
        for (int lane = 0; lane < lanes; ++lane)
          for (int i = 0; i < points; ++i) {
            const auto peak = law::peak_strains(*law, states.data() + i * size * lanes + lane, lanes);
            for (std::size_t k = 0; k < 3; ++k) most = std::max(most, peak[k] * inverse[k]);
          }
        CHECK(share == Approx(most).epsilon(1e-14));
      }
    }
  }
}

TEST_CASE("peaks are the largest strains of a history, of shear on either side") {
  const auto law = law::compile(test::blend());
  std::vector<double> s0(law::state_size(*law)), s1(s0);
  const auto go = [&](double E11, double E22, double E12) {
    const double E[5] = {E11, E22, 0, 0, 2 * E12};
    double S[5];
    REQUIRE(law::evaluate(*law, law::Step{}, E, s0.data(), s1.data(), S, nullptr) == law::Evaluation::ok);
    s0 = s1;
    return law::peak_strains(*law, s0.data(), 1);
  };
  CHECK(go(0.1, -0.05, 0.02) == std::array{0.1, 0.0, 0.02});
  CHECK(go(0.05, 0.03, 0.019)[2] == Approx(0.02));  // let go a little: the same branch
  CHECK(go(0.0, 0.01, -0.2)[0] == 0.1);
  CHECK(go(0.0, 0.01, -0.2)[1] == 0.03);
  CHECK(go(0.0, 0.01, -0.2)[2] == Approx(0.2));
}

TEST_CASE("a card is tested to what it states, else to the last points of its curves") {
  card::Card c = test::blend();
  auto& woven = std::get<card::Woven>(c.law);
  CHECK(law::tested_strains(c) == std::array{woven.tested.warp, woven.tested.weft, woven.tested.shear});
  woven.tested = {};
  CHECK(law::tested_strains(c) == std::array{0.0, 0.0, 0.0});
  woven.warp.loading = {{}, {{0, 0}, {0.1, 1e6}, {0.3, 4e6}}};
  woven.shear.loading = {{}, {{0, 0}, {0.4, 1e5}}};
  CHECK(law::tested_strains(c) == std::array{0.3, 0.0, 0.4});
  woven.shear.measure = card::StrainMeasure::engineering;  // its points are of 2 E12
  CHECK(law::tested_strains(c) == std::array{0.3, 0.0, 0.2});
  CHECK(law::tested_strains(test::svk()) == std::array{0.0, 0.0, 0.0});
}
