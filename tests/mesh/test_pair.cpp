// Triangles joined in pairs to quadrilaterals.
#include "catch.hpp"
#include "mesh/check.hpp"
#include "mesh/generators.hpp"
#include "mesh/panel.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::mesh;

TEST_CASE("the triangles of a lattice become its cells again, and sets stay") {
  Mesh m = rectangle(0.3, 0.2, 5, 4);
  const Report before = check(m);
  const auto sets = m.sets;
  split(m, 5);
  CHECK(pair_triangles(m) == 0);
  const Report after = check(m);
  CHECK(after.ok());
  CHECK(after.measures.quadrilaterals == 20);
  CHECK(after.measures.least_angle == before.measures.least_angle);
  CHECK(m.sets == sets);
}

TEST_CASE("a panel of triangles: nearly all are joined, no element has a defect, and the area stays") {
  Panel shape;
  shape.outline = {{PlaneCurve::line({0, 0}, {0.2, 0.02}), "a"},
                   {PlaneCurve::line({0.2, 0.02}, {0.17, 0.15}), "b"},
                   {PlaneCurve::line({0.17, 0.15}, {0, 0}), "c"}};
  shape.size = 0.012;
  shape.triangles = true;
  Mesh m = panel(shape);
  const Measures before = check(m).measures;
  const Index left = pair_triangles(m);
  const Report after = check(m);
  CHECK(after.ok());
  CHECK(after.measures.triangles == left);
  CHECK(static_cast<double>(left) < 0.08 * static_cast<double>(before.triangles));
  CHECK_THAT(after.measures.area, Catch::Matchers::WithinRel(before.area, 1e-12));
  CHECK(m.warp.size() == m.elements.size());
}

TEST_CASE("a row of triangles is joined whole, though its best pair would leave one at either end") {
  // Seven nodes and six triangles along a strip; those in the middle form the best quadrilateral.
  Mesh row;
  row.nodes = {{0, 0, 0},   {1, 0, 0},   {2, 0, 0},   {3.6, 0, 0},
               {0.4, 1, 0}, {1, 1.1, 0}, {2, 1.1, 0}, {3, 1, 0}};
  row.elements = {{0, 1, 4, -1}, {1, 5, 4, -1}, {1, 2, 5, -1}, {2, 6, 5, -1}, {2, 3, 6, -1}, {3, 7, 6, -1}};
  CHECK(pair_triangles(row) == 0);
  CHECK(row.elements.size() == 3);
  CHECK(check(row).ok());
}

TEST_CASE("triangles at a crease and needles are not joined; a mesh in use is refused") {
  Mesh crease;
  crease.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}};
  crease.elements = {{0, 1, 2, -1}, {0, 2, 3, -1}};
  CHECK(pair_triangles(crease) == 2);
  Mesh needles;
  needles.nodes = {{0, 0, 0}, {1, 0, 0}, {1.4, 0.2, 0}, {0.4, 0.2, 0}};
  needles.elements = {{0, 1, 2, -1}, {0, 2, 3, -1}};
  CHECK(pair_triangles(needles) == 2);
  needles.in_use = true;
  says(message_of([&] { pair_triangles(needles); }), "pair: a compiled model uses this mesh");
}
