// A strut beyond Euler's load against the elastica.
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "run/problems.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using run::Static;

namespace {

// A strip of length 1 along x, one end held and turning about y, the other pushed: Euler's case with pinned
// ends. nu = 0, thickness 0.01, so that it shortens by 8e-5 before it buckles.
constexpr double thickness = 0.01, modulus = 1e7;
constexpr double euler =
    std::numbers::pi * std::numbers::pi * modulus * thickness * thickness * thickness / 12;

std::shared_ptr<model::Model> make_strut(double load) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, 0.1, 32, 1));
  auto m = std::make_shared<model::Model>(mesh, isotropic(modulus, 0, thickness), model::Options{});
  m->fix("all", model::parse_freedoms("y"));
  m->fix("left", model::parse_freedoms("x z"));
  m->fix("right", model::parse_freedoms("z"));
  model::Components push;
  push[0] = history::History::ramp(-load, 1);
  m->force("right", push);
  return m;
}

// Modulus k of the elliptic integrals at a load over Euler's: load = (2 K(k) / pi)^2; the sag of the middle
// over the length is k / K(k), the end comes nearer by 2 - 2 E(k) / K(k).
double modulus_at(double load) {
  double low = 0, high = 1 - 1e-12;
  for (int i = 0; i < 100; ++i) {
    const double k = (low + high) / 2, K = std::comp_ellint_1(k);
    (std::pow(2 * K / std::numbers::pi, 2) < load ? low : high) = k;
  }
  return low;
}

}  // namespace

TEST_CASE("a strut stays straight below Euler's load and bows as the elastica above it, at any step") {
  for (const auto linear : {run::Symmetry::symmetric, run::Symmetry::unsymmetric})
    for (const double step : {0.5, 0.11, 0.02}) {
      Static a(make_strut(0.1 * 1.8 * euler), {.duration = 1, .step = step, .linear = linear}, quiet());
      a.every_step([&](run::Run& run) {
        const double load = 1.8 * run.time(), sag = std::abs(run.node(16).u.z());
        INFO("step " << step << ", load " << load << " of Euler's");
        if (load < 0.99) CHECK(sag < 1e-9);
        if (load < 1.05) return;
        const double k = modulus_at(load), K = std::comp_ellint_1(k);
        CHECK(sag == Approx(k / K).epsilon(0.02));
        CHECK(-run.node(32).u.x() == Approx(2 - 2 * std::comp_ellint_2(k) / K).epsilon(0.02));
      });
      a.solve();
      for (const auto& s : a.steps()) CHECK(s.negative_pivots == 0);
    }
}

TEST_CASE("a path along an arc goes on over Euler's load unstable, and a notice says so") {
  int notices = 0;
  auto sink = std::make_shared<Notices>([&](const std::string& text) {
    if (text.find("1 negative pivot") != std::string::npos) ++notices;
  });
  Static a(make_strut(0.1 * 3 * euler), {.duration = 1, .step = 0.02, .control = run::Control::arc}, sink);
  a.solve();
  for (const auto& s : a.steps()) {
    const double before = 3 * (s.time - s.step), after = 3 * s.time;
    if (after < 0.99) CHECK(s.negative_pivots == 0);
    if (before > 1.01) CHECK(s.negative_pivots == 1);
  }
  CHECK(notices == 1);
}
