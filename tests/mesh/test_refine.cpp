// Elements cut into quadrilaterals of half their size.
#include "catch.hpp"
#include "mesh/check.hpp"
#include "mesh/generators.hpp"
#include "mesh/panel.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::mesh;

TEST_CASE("a refined rectangle has the nodes and sets of one of half the size") {
  Mesh m = rectangle(0.3, 0.2, 3, 2);
  refine(m);
  Mesh fine = rectangle(0.3, 0.2, 6, 4);
  CHECK(m.elements.size() == fine.elements.size());
  const auto places = [](const Mesh& mesh, const NodeSet& ids) {
    std::vector<std::pair<double, double>> at;
    for (const Index id : ids) {
      const Vec3& x = mesh.nodes[static_cast<std::size_t>(id)];
      at.emplace_back(std::round(x.x() * 1e9), std::round(x.y() * 1e9));
    }
    std::sort(at.begin(), at.end());
    return at;
  };
  for (const auto& [name, ids] : fine.sets) {
    INFO(name);
    CHECK(places(m, m.sets.at(name)) == places(fine, ids));
    CHECK(std::is_sorted(m.sets.at(name).begin(), m.sets.at(name).end()));
  }
  CHECK(check(m).ok());
}

TEST_CASE("a refined panel has quadrilaterals alone, the same area and border, and the warp of its grain") {
  Panel shape;
  shape.outline = {{PlaneCurve::line({0, 0}, {0.2, 0.02}), "a"},
                   {PlaneCurve::line({0.2, 0.02}, {0.17, 0.15}), "b"},
                   {PlaneCurve::line({0.17, 0.15}, {0, 0}), "c"}};
  shape.size = 0.017;
  shape.grain = 37;
  shape.quadrilaterals = false;
  Mesh m = panel(shape);
  const Measures before = check(m).measures;
  REQUIRE(before.triangles > 4);
  const std::size_t rim = m.sets.at("boundary").size(), side = m.sets.at("b").size();
  refine(m);
  const Report after = check(m);
  CHECK(after.ok());
  CHECK(after.measures.triangles == 0);
  CHECK(after.measures.quadrilaterals == 3 * before.triangles + 4 * before.quadrilaterals);
  CHECK_THAT(after.measures.area, Catch::Matchers::WithinRel(before.area, 1e-12));
  CHECK(m.sets.at("boundary").size() == 2 * rim);
  CHECK(m.sets.at("b").size() == 2 * side - 1);
  REQUIRE(m.warp.size() == m.elements.size());
  CHECK(m.warp.front().isApprox(m.warp.back()));
}

TEST_CASE("a set of inner nodes takes the middles of elements; a mesh in use is refused") {
  Mesh m = rectangle(0.2, 0.2, 2, 2);
  m.define("half", [](const Vec3& x) { return x.x() < 0.11; });
  refine(m);
  CHECK(m.sets.at("half").size() == 15);
  m.in_use = true;
  says(message_of([&] { refine(m); }), "refine: a compiled model uses this mesh");
}
