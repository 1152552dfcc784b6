// The thesis' strip on a mesh of triangles: uniaxial stress is exact on any mesh.
#include "catch.hpp"
#include "strip.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

TEST_CASE("a strip of triangles with free ends: S = P(E)") {
  Strip s;
  s.card = blend();
  s.stroke = 18e-3;
  s.triangles = true;
  run::Static a(make_strip(s), {.duration = 1, .step = 0.1}, std::make_shared<Notices>());
  a.solve();
  const double E = green(s.stroke);
  // Loading polynomial of the blend's warp, Pa: 8e6 + 826e6 E.
  const double want = 8e6 * E + 826e6 * E * E / 2;
  CHECK(std::abs(stress(a, s, s.stroke) / want - 1) < 1e-8);
  CHECK(std::abs(-a.mean("E22") / a.mean("E11") / 0.25 - 1) < 1e-8);
  std::printf("  strip of triangles: stress over P(E) less one %.1e\n", stress(a, s, s.stroke) / want - 1);
}
