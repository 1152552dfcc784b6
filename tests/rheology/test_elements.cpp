// Rules that every rheological element keeps, whichever folders there are: tangent, energies, steps, and the
// description of which cards are made.
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "rheology/elements.hpp"

using namespace fabricsh;

namespace {

using Strain = std::array<double, 5>;

struct Sum {  // what add_stress() and add_energy() add to
  double S[5] = {}, C11 = 0, C12 = 0, C21 = 0, C22 = 0, C55 = 0;
  double stored = 0, lost = 0;
};

constexpr int strains[3] = {0, 1, 4};  // E11, E22, 2 E12, which an element may resist

struct Random {
  std::mt19937 engine{3};
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  Strain strain() { return {(*this)(-0.1, 0.1), (*this)(-0.1, 0.1), 0, 0, (*this)(-0.3, 0.3)}; }
};

// An element alone, with its committed state.
template <class Element, class Data>
struct Alone {
  Data data;
  std::vector<double> s = std::vector<double>(Element::numbers, 0.0), trial = s;
  Strain E{};

  Sum look(const Strain& to, double dt) {
    Sum out;
    add_stress(data, dt, to.data(), s.data(), trial.data(), out);
    return out;
  }
  Sum go(const Strain& to, double dt) {
    const Sum out = look(to, dt);
    s = trial;
    E = to;
    return out;
  }
  Sum energy() const {
    Sum out;
    add_energy(data, s.data(), out.stored, out.lost);
    return out;
  }
};

// Two springs that follow these curves, for elements that act on springs.
constexpr double kModulus = 50e6, kUnloading = 200e6;  // Pa
double virgin(double E) { return kModulus * E * (1 + 4 * E); }
const rheology::YarnSpring kSpring{virgin, kUnloading};
const rheology::PointSite kSite{{1e-3, 2e-3}, 4e-4, {1, 0.9}};

// Calls test(element with random parameters) a few times for each element that acts so: every parameter is
// within the usual range for cloth if it has one, else about 1.
template <rheology::Acts acts, class Test>
void for_all_elements(const Test& test) {
  rheology::for_each([&](auto element, auto given, auto compiled) {
    using Element = decltype(element);
    if constexpr (Element::acts == acts) {
      INFO("element " << Element::name);
      Random random;
      for (int k = 0; k < 6; ++k) {
        rheology::Given card;
        auto& parameters = (card.*given).emplace();
        for (const auto& row : Element::rows())
          if (row.place != nullptr) {
            const bool bounded = std::isfinite(row.usual.low) && std::isfinite(row.usual.high);
            parameters.*row.place =
                bounded ? std::sqrt(row.usual.low * row.usual.high) * random(0.5, 2) : random(0.5, 2);
            REQUIRE(row.range.holds(parameters.*row.place));
          }
        rheology::Compiled all;
        all.*compiled = Element::compile(parameters, 0.5);
        CHECK((all.*compiled).on);
        CHECK(rheology::any(all));
        CHECK(rheology::numbers(all) == Element::numbers);
        CHECK(rheology::is_rate_dependent(all) == Element::is_rate_dependent);
        CHECK(rheology::softens(all) == Element::softens);
        CHECK(rheology::any_on_springs(all) == (acts == rheology::Acts::on_springs));
        Alone<Element, std::remove_cvref_t<decltype(all.*compiled)>> alone{all.*compiled};
        if constexpr (Element::depends_on_site)
          Element::set_initial({kSpring, kSpring}, kSite, all.*compiled, alone.s.data());
        test(alone, Element::stiffest(all.*compiled), random);
      }
    }
  });
}

}  // namespace

TEST_CASE("each element's tangent is the slope of its stress, and never stiffer than it says", "[rheology]") {
  for_all_elements<rheology::Acts::in_parallel>(
      [](auto& alone, const rheology::Stiffest& stiffest, Random& random) {
        const double scale = stiffest.axial + stiffest.shear;
        REQUIRE(scale > 0);
        for (int k = 0; k < 50; ++k) {
          const Strain to = random.strain();
          const double dt = k % 5 == 0 ? 0 : random(0, 3);
          const Sum here = alone.look(to, dt);
          const double C[3][3] = {{here.C11, here.C12, 0}, {here.C21, here.C22, 0}, {0, 0, here.C55}};
          for (int j = 0; j < 3; ++j) {
            constexpr double h = 1e-6;
            Strain up = to, down = to;
            up[strains[j]] += h;
            down[strains[j]] -= h;
            const Sum high = alone.look(up, dt), low = alone.look(down, dt);
            for (int i = 0; i < 3; ++i)  // rounding of the differences, and their curvature
              CHECK(std::abs((high.S[strains[i]] - low.S[strains[i]]) / (2 * h) - C[i][j]) < 1e-7 * scale);
          }
          CHECK(std::abs(here.C12 - here.C21) <= 1e-12 * scale);  // the solver of symmetric matrices takes it
          CHECK(here.S[2] == 0);
          CHECK(here.S[3] == 0);
          CHECK(here.C55 <= stiffest.shear * (1 + 1e-12));
          CHECK(std::max(here.C11 + std::abs(here.C12), here.C22 + std::abs(here.C21)) <=
                stiffest.axial * (1 + 1e-12));
          alone.go(to, dt);
        }
      });
}

namespace {

// The work done on an element along straight legs of strain, less what it has stored and dissipated, over the
// sum of all work counted positive; each leg in so many steps. The work is summed by the trapezoidal rule.
template <class OneElement>
double imbalance(OneElement alone, const std::vector<std::pair<Strain, double>>& legs, int steps) {
  double work = 0, effort = 0, dissipated = 0;
  for (const auto& [to, over] : legs) {
    const Strain from = alone.E;
    Sum before = alone.look(from, 0);
    for (int k = 1; k <= steps; ++k) {
      Strain next;
      for (int i = 0; i < 5; ++i) next[i] = from[i] + (to[i] - from[i]) * k / steps;
      const Strain last = alone.E;
      const Sum now = alone.go(next, over / steps);
      for (int i = 0; i < 5; ++i) {
        const double part = (before.S[i] + now.S[i]) / 2 * (next[i] - last[i]);
        work += part;
        effort += std::abs(part);
      }
      before = now;
      CHECK(alone.energy().lost >= dissipated - 1e-12 * effort);
      dissipated = alone.energy().lost;
    }
  }
  CHECK(work > 0);  // back at no strain, something was lost
  return std::abs(work - alone.energy().stored - dissipated) / effort;
}

}  // namespace

TEST_CASE("work on an element is stored or dissipated, and its dissipation never falls", "[rheology]") {
  for_all_elements<rheology::Acts::in_parallel>([](auto& alone, const rheology::Stiffest&, Random& random) {
    std::vector<std::pair<Strain, double>> legs;
    for (int leg = 0; leg < 6; ++leg)
      legs.emplace_back(leg == 5 ? Strain{} : random.strain(), random(0.01, 3));
    const double coarse = imbalance(alone, legs, 1000), fine = imbalance(alone, legs, 2000);
    INFO(coarse << " " << fine);
    // The rule errs by the square of a step, or by the step where a stress jumps with the rate.
    CHECK(fine < 1e-3);
    CHECK(fine < 0.6 * coarse);
  });
}

namespace {

// The spring of a yarn with the factor of an element: the strain and the largest strain of the spring so far.
template <class OneElement>
struct Factored {
  OneElement alone;
  int yarn;
  double E = 0, m = 0;

  struct Value {
    double S, C, m;
  };
  Value look(double to) {
    const auto f = yarn_factor(alone.data, yarn, true, to, alone.s.data(), alone.trial.data());
    CHECK((f.value >= 0 && f.value <= 1));
    const double peak = std::max(std::min(to, f.limit), m), residual = peak - virgin(peak) / kUnloading;
    const bool grows = to >= m && to < f.limit;
    const double S = grows ? virgin(to) : kUnloading * (to - residual);
    const double D = grows ? kModulus * (1 + 8 * to) : kUnloading;
    if (to < residual) return {0, 0, peak};
    return {f.value * S, f.value * D + f.rate * S, peak};
  }
  double go(double to) {
    const Value now = look(to);
    alone.s = alone.trial;
    E = to;
    m = now.m;
    CHECK(yarn_factor_at(alone.data, yarn, alone.s.data()) ==
          yarn_factor(alone.data, yarn, true, E, alone.s.data(), alone.trial.data()).value);
    return now.S;
  }
  // Stored; dissipated by the spring and by the element.
  std::array<double, 2> energy() const {
    const double residual = m - virgin(m) / kUnloading, x = std::max(E - residual, 0.0);
    const double spring = kModulus * m * m * (0.5 + 4 * m / 3) - virgin(m) * virgin(m) / (2 * kUnloading);
    const Sum own = alone.energy();
    return {yarn_factor_at(alone.data, yarn, alone.s.data()) * kUnloading * x * x / 2 + own.stored,
            spring + own.lost};
  }
};

}  // namespace

TEST_CASE(
    "a factored spring's tangent is the slope of its stress, and its work is stored or lost, never regained",
    "[rheology]") {
  for_all_elements<rheology::Acts::on_springs>(
      [](auto& alone, const rheology::Stiffest& stiffest, Random& random) {
        CHECK(stiffest.axial + stiffest.shear == 0);  // a factor of at most one adds no stiffness
        for (const int yarn : {0, 1}) {
          Factored<std::remove_cvref_t<decltype(alone)>> spring{alone, yarn};
          double errors[2] = {}, lost = 0;
          for (int halved = 0; halved < 2; ++halved) {
            Random path = random;
            spring = {alone, yarn};
            double work = 0, effort = 0;
            for (int leg = 0; leg < 9; ++leg) {
              const double from = spring.E, to = leg == 8 ? 0 : path(-0.01, 0.06 * (leg + 1));
              const int steps = 2000 << halved;
              for (int k = 1; k <= steps; ++k) {
                const double E = from + (to - from) * k / steps, h = 1e-7;
                if (k % 97 == 0) {
                  const double C = spring.look(E).C,
                               slope = (spring.look(E + h).S - spring.look(E - h).S) / (2 * h);
                  const double next = (spring.look(E + 2 * h).S - spring.look(E).S) / (2 * h);
                  // Where a branch begins within the difference there is no slope.
                  if (std::abs(next - slope) < 1e-3 * kModulus)
                    CHECK(std::abs(C - slope) < 1e-4 * kUnloading);
                }
                const double before = spring.look(spring.E).S, last = spring.E, now = spring.go(E);
                work += (before + now) / 2 * (E - last);
                effort += std::abs(now * (E - last));
                CHECK(spring.energy()[1] >= lost * (1 - 1e-12));
                lost = spring.energy()[1];
              }
            }
            REQUIRE(effort > 0);
            errors[halved] = std::abs(work - spring.energy()[0] - spring.energy()[1]) / effort;
            lost = 0;
          }
          INFO("yarn " << yarn << ": " << errors[0] << " " << errors[1]);
          CHECK(errors[1] < 1e-6);  // of the rule, mostly where a branch begins within a step
        }
      });
}

TEST_CASE("without elements a card's law has no numbers, no stress and no stiffness of theirs",
          "[rheology]") {
  const rheology::Compiled none;
  CHECK_FALSE(rheology::any(none));
  CHECK_FALSE(rheology::is_rate_dependent(none));
  CHECK(rheology::numbers(none) == 0);
  CHECK(rheology::stiffest(none).axial == 0);
  CHECK(rheology::stiffest(none).shear == 0);
  Sum out;
  const Strain E{0.1, 0.2, 0, 0, 0.3};
  const double* before = nullptr;
  double* after = nullptr;
  rheology::add_stresses(none, 1.0, E.data(), before, after, out);
  double lost[rheology::dissipations] = {};
  rheology::add_energies(none, before, out.stored, lost);
  for (const double one : lost) CHECK(one == 0);
  CHECK(rheology::yarn_factors(none, 0, true, 0.1, before, after).value == 1);
  CHECK((out.S[0] == 0 && out.S[1] == 0 && out.S[4] == 0 && out.C55 == 0 && out.stored == 0));
}

TEST_CASE("every parameter of an element has a name of its own, a sentence and, in a group, that group") {
  std::set<std::string> elements;
  rheology::for_each([&](auto element, auto, auto) {
    INFO("element " << element.name);
    CHECK(elements.insert(element.name).second);
    CHECK(std::string(element.sentence) != "");
    std::set<std::string> names;
    for (const auto& row : element.rows()) {
      CHECK(names.insert(row.name).second);
      CHECK(row.sentence != "");
      const auto dot = row.name.rfind('.');
      if (dot != std::string::npos) CHECK(names.contains(row.name.substr(0, dot)));
    }
  });
  CHECK(elements.contains("viscous"));
  CHECK(rheology::dissipation_names.index("shear") == 2);
  CHECK(rheology::dissipation_names.index("damage") == 3);
  CHECK(rheology::dissipation_names.index("viscous") < 0);  // it is dissipated in shear
}
