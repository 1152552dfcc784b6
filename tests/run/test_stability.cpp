// Negative pivots against Euler's load.
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

}  // namespace

TEST_CASE("a strut's tangent has no negative pivot below Euler's load, one above it, and a notice says so") {
  for (const auto linear : {run::Linear::symmetric, run::Linear::unsymmetric}) {
    int notices = 0;
    std::string said;
    auto sink = std::make_shared<Notices>([&](const std::string& text) {
      if (text.find("pivot") == std::string::npos) return;
      ++notices;
      said = text;
    });
    Static a(make_strut(0.1 * 3 * euler), {.duration = 1, .step = 0.02, .linear = linear}, sink);
    a.solve();
    for (const auto& s : a.steps()) {
      // The last tangent is that of the step's end or, where one iteration was enough, of its beginning. Mesh
      // and shear: the strip buckles within 1 % of Euler's load.
      const double before = 3 * (s.time - s.step), after = 3 * s.time;
      INFO("load " << before << " to " << after << " of Euler's");
      if (after < 0.99) CHECK(s.negative_pivots == 0);
      if (before > 1.01) CHECK(s.negative_pivots == 1);
    }
    CHECK(notices == 1);
    CHECK(said.find("1 negative pivot") != std::string::npos);
  }
}
