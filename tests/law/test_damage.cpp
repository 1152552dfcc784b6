// Yarns that soften and break: closed forms, energy, batches, what is refused.
#include <cmath>

#include "catch.hpp"
#include "law/beside_batches.hpp"
#include "law/data.hpp"
#include "law/thesis_cards.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

// A sheet of two equal, linear families without coupling: f = D E_f.
constexpr double D = 50 * MPa, Du = 80 * MPa, thickness = 4e-4, energy = 6;
constexpr double begin = 0.06, stress = D * begin, residual = begin - stress / Du;
constexpr double size = 1e-3;
const double stretch = std::sqrt(1 + 2 * begin);  // where it breaks, and where it carries nothing more
const double end =
    stretch + 2 * (energy / (thickness * size) - stress * stress / (2 * Du)) / (stress * stretch);
double strain(double l) { return (l * l - 1) / 2; }

card::Card linear_card() {
  card::Woven w;
  w.warp = {{{D}, {}}, Du, 0};
  w.weft = w.warp;
  w.shear.loading.coefficients = {2 * MPa};
  w.shear.unloading = 4 * MPa;
  w.tested = {0.1, 0.1, 0.3};
  const double strength = thickness * stress * stretch;
  w.parallel.damage = rheology::damage::Parameters{strength, energy, strength, energy};
  card::Card c;
  c.name = "linear";
  c.density = 500;
  c.thickness = thickness;
  c.law = w;
  return c;
}

constexpr std::size_t damage = 3;  // in dissipation_names

}  // namespace

TEST_CASE("a yarn softens linearly from its strength to nothing, and unloads to its residual strain",
          "[law][damage]") {
  CHECK(law::dissipation_names.name[damage] == "damage");
  for (const int axis : {0, 1}) {
    LawPoint point(linear_card());
    CHECK(law::softens(*point.law));
    const auto go = [&](double E) {
      Strain e{};
      e[axis] = E;
      REQUIRE(point.go(e));
      return point.S[axis];
    };
    CHECK(go(0.5 * begin) == Approx(0.5 * stress).epsilon(1e-12));
    CHECK(point.energy().lost[damage] == 0);
    CHECK(go(begin) == Approx(stress).epsilon(1e-12));
    double lost = 0;
    for (const double share : {0.1, 0.4, 0.8}) {
      const double l = stretch + share * (end - stretch), k = strain(l),
                   S = (1 - share) * stress * stretch / l;
      CHECK(go(k) == Approx(S).epsilon(1e-12));
      CHECK(go(residual + (k - residual) / 4) == Approx(S / 4).epsilon(1e-12));
      CHECK(go(residual) == Approx(0).margin(1e-9 * stress));
      CHECK(point.energy().stored == Approx(0).margin(1e-9 * stress));
      CHECK(go(k) == Approx(S).epsilon(1e-12));
      // The energy of the spring less what the factor takes of it loses digits.
      CHECK(point.energy().stored == Approx(S * (k - residual) / 2).epsilon(1e-10));
      CHECK(point.energy().stored + point.energy().dissipated() ==
            Approx(stress * begin / 2 + stress * stretch * (l - stretch) * (1 - share / 2)).epsilon(1e-10));
      CHECK(point.energy().lost[damage] > lost);
      lost = point.energy().lost[damage];
    }
    CHECK(go(strain(1.01 * end)) == 0);
    CHECK(point.energy().stored == 0);
    CHECK(point.energy().lost[damage] == Approx(energy / (thickness * size)).epsilon(1e-12));
    const double before =
        stress * begin / 2 - stress * stress / (2 * Du);  // of the spring, up to its strength
    CHECK(point.energy().lost[static_cast<std::size_t>(axis)] == Approx(before).epsilon(1e-12));
    CHECK(go(begin) == 0);
    CHECK(go(strain(2 * end)) == 0);
  }
}

TEST_CASE("size and strength of the site set how far a yarn softens, not what it takes", "[law][damage]") {
  const auto law = law::compile(linear_card());
  for (const double longer : {0.5, 1.0, 3.0})
    for (const double strength : {0.8, 1.0}) {
      std::vector<double> s(law::state_size(*law)), next(s);
      law::set_initial(*law, {{longer * size, size}, 0, {strength, 1}}, s.data());
      double S[5], most = 0;
      for (double l = 1; l < 25; l += 5e-4) {
        const double E = strain(l), e[5] = {E};
        REQUIRE(law::evaluate(*law, law::Step{}, e, s.data(), next.data(), S, nullptr) ==
                law::Evaluation::ok);
        s = next;
        most = std::max(most, thickness * S[0] * l);
      }
      const double e[5] = {strain(25)};
      CHECK(law::energy(*law, e, s.data()).lost[damage] ==
            Approx(energy / (thickness * longer * size)).epsilon(1e-9));
      CHECK(most == Approx(strength * thickness * stress * stretch).epsilon(3e-3));
    }
}

TEST_CASE("without a site, or without a strength, yarns hold", "[law][damage]") {
  auto half = linear_card();
  woven(half).parallel.damage->weft_strength = woven(half).parallel.damage->weft_energy = 0;
  LawPoint point(half);
  const double far = strain(2 * end);
  point.go({far, far, 0, 0, 0});
  CHECK(point.S[0] == 0);
  CHECK(point.S[1] > stress);
  std::vector<double> s(law::state_size(*point.law)), next(s);
  const double e[5] = {far};
  double S[5];
  law::evaluate(*point.law, law::Step{}, e, s.data(), next.data(), S, nullptr);
  CHECK(S[0] > stress);
}

TEST_CASE("batches of breaking yarns agree with single points", "[law][damage]") {
  Random random(5);
  int broken = 0;
  for (int i = 0; i < 4; ++i)
    beside_batches(
        with_damage(with_viscous(thesis_card(i))), 40, random, [&](const LawPoint& point, const Lane& lane) {
          for (int k = 0; k < 5; ++k) CHECK(lane.S(k) == Approx(point.S[k]).epsilon(1e-9).margin(1));
          const auto energy = point.energy();
          CHECK(lane.energy(0) == Approx(energy.stored).epsilon(1e-8).margin(1e-3));
          for (std::size_t k = 0; k < energy.lost.size(); ++k)
            CHECK(lane.energy(1 + static_cast<int>(k)) == Approx(energy.lost[k]).epsilon(1e-8).margin(1e-3));
          if (energy.lost[damage] > 0) ++broken;
        });
  CHECK(broken > 100);
}

TEST_CASE("parts of a card that a breaking yarn refuses", "[law][damage]") {
  const auto refused = [](const auto& change, const std::string& words) {
    auto c = linear_card();
    change(woven(c));
    says(message_of([&] {
           const auto law = law::compile(c);
           std::vector<double> s(law::state_size(*law));
           law::set_initial(*law, {{1, 1}}, s.data());
         }),
         words);
  };
  refused([](auto&) {}, "field 'damage.warp': expected at most 0.");
  refused(
      [](auto& w) {
        w.warp.loop = card::YarnLoop{0.3, 0.5, 0};
      },
      "field 'damage': expected a card without warp.loop, whose stress it does not change");
  refused([](auto& w) { w.biaxial = card::Biaxial{1, 0, 1e7, 1e8}; }, "expected a card without biaxial");
  refused([](auto& w) { w.law = card::LawKind::thesis; },
          "field 'damage': expected law = \"potential\", the only one that takes it");
  refused([](auto& w) { w.parallel.damage->warp_strength = -1; }, "field 'damage.warp.strength'");
}
