// What every rheological element keeps to, whichever folders there are: tangent, energies, steps, and the
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
  double stored = 0, warp = 0, weft = 0, shear = 0;
  double dissipated() const { return warp + weft + shear; }
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
    add_energy(data, s.data(), out);
    return out;
  }
};

// Calls test(element with random parameters) a few times for each element: every parameter is within the
// usual range for cloth if it has one, else about 1.
template <class Test>
void for_all_elements(const Test& test) {
  rheology::for_each([&](auto element, auto given, auto compiled) {
    using Element = decltype(element);
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
      Alone<Element, std::remove_cvref_t<decltype(all.*compiled)>> alone{all.*compiled};
      test(alone, Element::stiffest(all.*compiled), random);
    }
  });
}

}  // namespace

TEST_CASE("each element's tangent is the slope of its stress, and never stiffer than it says", "[rheology]") {
  for_all_elements([](auto& alone, const rheology::Stiffest& stiffest, Random& random) {
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
      CHECK(alone.energy().dissipated() >= dissipated - 1e-12 * effort);
      dissipated = alone.energy().dissipated();
    }
  }
  CHECK(work > 0);  // back at no strain, something was lost
  return std::abs(work - alone.energy().stored - dissipated) / effort;
}

}  // namespace

TEST_CASE("what is done on an element is stored or dissipated, and its dissipation never falls",
          "[rheology]") {
  for_all_elements([](auto& alone, const rheology::Stiffest&, Random& random) {
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
  rheology::add_energies(none, before, out);
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
}
