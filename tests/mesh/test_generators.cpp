#include <cmath>
#include <numbers>
#include <set>

#include "mesh/generators.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::mesh;
using std::numbers::pi;

namespace {

Vec3 area_vector(const Mesh& m, std::size_t e) {
  const auto& id = m.elements[e];
  const auto x = [&](std::size_t i) { return m.nodes[static_cast<std::size_t>(id[i])]; };
  return 0.5 * (x(2) - x(0)).cross(x(3) - x(1));
}

Vec3 middle(const Mesh& m, std::size_t e) {
  Vec3 sum = Vec3::Zero();
  for (const Index id : m.elements[e]) sum += m.nodes[static_cast<std::size_t>(id)];
  return sum / 4;
}

// Area of all elements; each must turn counter-clockwise about the normal at its middle.
double area(const Mesh& m, const std::function<Vec3(const Vec3&)>& normal) {
  double sum = 0;
  for (std::size_t e = 0; e < m.elements.size(); ++e) {
    const Vec3 a = area_vector(m, e);
    CHECK(a.dot(normal(middle(m, e))) > 0.9 * a.norm());
    sum += a.norm();
  }
  return sum;
}

Vec3 up(const Vec3&) { return {0, 0, 1}; }
Vec3 from_axis(const Vec3& x) { return Vec3(x.x(), x.y(), 0).normalized(); }
Vec3 from_centre(const Vec3& x) { return x.normalized(); }

// Nodes on edges that one element has; an edge walked twice the same way fails the test.
NodeSet free_nodes_of_edges(const Mesh& m) {
  std::set<std::pair<Index, Index>> edges;
  for (const auto& id : m.elements)
    for (std::size_t i = 0; i < 4; ++i) CHECK(edges.insert({id[i], id[(i + 1) % 4]}).second);
  std::set<Index> nodes;
  for (const auto& [a, b] : edges)
    if (!edges.contains({b, a})) nodes.insert({a, b});
  return {nodes.begin(), nodes.end()};
}

// Smallest sine of a corner angle, 1 for rectangles.
double worst_corner(const Mesh& m) {
  double worst = 1;
  for (const auto& id : m.elements)
    for (std::size_t i = 0; i < 4; ++i) {
      const auto x = [&](std::size_t k) { return m.nodes[static_cast<std::size_t>(id[(i + k) % 4])]; };
      const Vec3 a = (x(1) - x(0)).normalized(), b = (x(3) - x(0)).normalized();
      worst = std::min(worst, a.cross(b).z());
    }
  return worst;
}

}  // namespace

TEST_CASE("disk: elements, area of the polygon, rim on the circle", "[mesh]") {
  for (const Index cells : {1, 2, 3, 8}) {
    const Mesh m = disk({.radius = 0.05, .cells = cells});
    const Index rings = (cells + 1) / 2, rim = 4 * cells;
    CHECK(static_cast<Index>(m.elements.size()) == cells * cells + rings * rim);
    CHECK(static_cast<Index>(m.nodes.size()) == (cells + 1) * (cells + 1) + rings * rim);
    const double n = static_cast<double>(rim);
    CHECK(area(m, up) == Approx(n / 2 * std::sin(2 * pi / n) * 0.05 * 0.05).epsilon(1e-13));
    CHECK(static_cast<Index>(m.set("boundary").size()) == rim);
    CHECK(m.set("boundary") == free_nodes_of_edges(m));
    for (const Index id : m.set("boundary"))
      CHECK(m.nodes[static_cast<std::size_t>(id)].norm() == Approx(0.05).epsilon(1e-14));
    CHECK(m.flat);
    CHECK(m.sets.contains("centre") == (cells % 2 == 0));
  }
}

TEST_CASE("disk: well shaped, the centre at the origin", "[mesh]") {
  const Mesh m = disk({.radius = 2, .cells = 16});
  CHECK(worst_corner(m) > 0.85);
  CHECK(m.set("core").size() == 17 * 17);
  REQUIRE(m.set("centre").size() == 1);
  CHECK(m.nodes[static_cast<std::size_t>(m.set("centre")[0])].norm() < 1e-15);
  CHECK(disk({.radius = 2, .cells = 4, .rings = 5}).elements.size() == 16 + 80);
}

TEST_CASE("annulus: closed, sector and slit", "[mesh]") {
  const double n = 12, ring = n / 2 * std::sin(2 * pi / n) * (0.1 * 0.1 - 0.06 * 0.06);
  const Mesh closed = annulus({.inner = 0.06, .outer = 0.1, .around = 12, .across = 3});
  CHECK(closed.nodes.size() == 48);
  CHECK(area(closed, up) == Approx(ring).epsilon(1e-13));
  CHECK(free_nodes_of_edges(closed) == closed.set("boundary"));
  CHECK(closed.set("boundary").size() == 24);
  CHECK(closed.set("seam").size() == 4);
  CHECK_FALSE(closed.sets.contains("start"));
  const Mesh slit = annulus({.inner = 0.06, .outer = 0.1, .around = 12, .across = 3, .slit = true});
  CHECK(slit.nodes.size() == 52);
  CHECK(area(slit, up) == Approx(ring).epsilon(1e-13));
  CHECK(free_nodes_of_edges(slit) == slit.set("boundary"));
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(slit.nodes[static_cast<std::size_t>(slit.set("start")[i])] ==
          slit.nodes[static_cast<std::size_t>(slit.set("end")[i])]);
  const Mesh sector = annulus({.inner = 0.06, .outer = 0.1, .around = 3, .across = 3, .angle = 90});
  CHECK(area(sector, up) == Approx(ring / 4).epsilon(1e-13));
  for (const Index id : sector.set("end")) CHECK(sector.nodes[static_cast<std::size_t>(id)].x() == 0);
  CHECK(sector.flat);
  CHECK(sector.origin == "annulus 3x3, 90 degrees");
}

TEST_CASE("cylinder: sleeve and open shell, normal outward", "[mesh]") {
  const Mesh sleeve = cylinder({.radius = 0.04, .length = 0.2, .around = 16, .along = 5});
  CHECK(sleeve.nodes.size() == 16 * 6);
  CHECK(area(sleeve, from_axis) == Approx(16 * 2 * 0.04 * std::sin(pi / 16) * 0.2).epsilon(1e-13));
  CHECK(free_nodes_of_edges(sleeve) == sleeve.set("boundary"));
  CHECK(sleeve.set("bottom").size() == 16);
  CHECK(sleeve.set("top").size() == 16);
  CHECK(sleeve.set("seam").size() == 6);
  CHECK_FALSE(sleeve.flat);
  const Mesh open = cylinder({.radius = 0.04, .length = 0.2, .around = 4, .along = 5, .angle = 90});
  CHECK(open.nodes.size() == 30);
  CHECK(area(open, from_axis) == Approx(4 * 2 * 0.04 * std::sin(pi / 16) * 0.2).epsilon(1e-13));
  CHECK(free_nodes_of_edges(open) == open.set("boundary"));
  for (const Index id : open.set("start")) CHECK(open.nodes[static_cast<std::size_t>(id)].y() == 0);
  for (const Index id : open.set("end")) CHECK(open.nodes[static_cast<std::size_t>(id)].x() == 0);
  for (const Index id : open.set("top")) CHECK(open.nodes[static_cast<std::size_t>(id)].z() == 0.2);
}

TEST_CASE("hemisphere: nodes on the sphere, normal outward, area of second order", "[mesh]") {
  const auto error = [](Index n) {
    const Mesh m = hemisphere({.radius = 10, .hole = 18, .around = n, .along = n});
    for (const Vec3& x : m.nodes) CHECK(x.norm() == Approx(10).epsilon(1e-14));
    return 1 - area(m, from_centre) / (pi / 2 * 100 * std::cos(18 * pi / 180));
  };
  CHECK(error(8) > 0);
  CHECK(error(8) / error(16) == Approx(4).epsilon(0.02));  // the mesh's own error, second order
  const Mesh quarter = hemisphere({.radius = 10, .around = 4, .along = 3});
  CHECK(free_nodes_of_edges(quarter) == quarter.set("boundary"));
  CHECK(quarter.nodes[static_cast<std::size_t>(quarter.set("top")[0])].z() ==
        Approx(10 * std::cos(18 * pi / 180)).epsilon(1e-14));
  for (const Index id : quarter.set("bottom")) CHECK(quarter.nodes[static_cast<std::size_t>(id)].z() == 0);
  const Mesh whole = hemisphere({.radius = 10, .hole = 5, .around = 12, .along = 3, .angle = 360});
  CHECK(whole.nodes.size() == 48);
  CHECK(free_nodes_of_edges(whole) == whole.set("boundary"));
}

TEST_CASE("generators: refused fields are named", "[mesh]") {
  says(message_of([] { disk({.radius = -1, .cells = 2}); }),
       "disk: field 'radius': expected a positive length, m, got -1");
  says(message_of([] { disk({.radius = 1, .cells = 0}); }), "disk: field 'cells'");
  says(message_of([] { disk({.radius = 1, .cells = 900'000'000}); }), "disk: cells * (cells + 4 * rings)");
  says(message_of([] { annulus({.inner = 2, .outer = 1, .around = 4, .across = 1}); }), "'outer'");
  says(message_of([] { annulus({.inner = std::nan(""), .outer = 1, .around = 4, .across = 1}); }), "'inner'");
  says(message_of([] { cylinder({.radius = 1, .length = 1, .around = 2, .along = 1}); }),
       "cylinder: field 'around': expected a count from 3 to 1000000000, got 2");
  says(message_of([] { cylinder({.radius = 1, .length = 1, .around = 4, .along = 1, .angle = 361}); }),
       "expected an angle above 0 and up to 360 degrees, got 361");
  says(message_of(
           [] { cylinder({.radius = 1, .length = 1, .around = 4, .along = 1, .angle = std::nan("")}); }),
       "'angle'");
  says(message_of([] { hemisphere({.radius = 1, .hole = 0, .around = 4, .along = 1}); }), "'hole'");
  says(message_of([] { hemisphere({.radius = 1, .around = 1'000'000, .along = 1'000'000}); }), "cells");
}

TEST_CASE("meshes as one: coinciding nodes of different meshes are joined, a slit stays open", "[mesh]") {
  const auto part = [](double x, double y) {
    return std::make_shared<const Mesh>(rectangle(1, 1, 2, 2, Vec3(x, y, 0)));
  };
  const Mesh four = merge({part(0, 0), part(1, 0), part(0, 1), part(1, 1)}, 1e-9);
  CHECK(four.nodes.size() == 25);
  CHECK(four.elements.size() == 16);
  CHECK(four.set("boundary").size() == 16);
  CHECK(four.set("all").size() == 25);
  CHECK(four.set("left").size() == 10);  // of the two columns of meshes, at x = 0 and at x = 1
  for (const auto& element : four.elements) {
    const Vec3 a = four.nodes[element[2]] - four.nodes[element[0]];
    const Vec3 b = four.nodes[element[3]] - four.nodes[element[1]];
    CHECK(0.5 * a.cross(b).z() == Catch::Detail::Approx(0.25));
  }
  const auto ring = std::make_shared<const Mesh>(annulus({1, 2, 12, 2, 360, true}));
  const auto far = std::make_shared<const Mesh>(rectangle(1, 1, 1, 1, Vec3(9, 9, 9)));
  CHECK(merge({ring, far}, 1e-6).nodes.size() == ring->nodes.size() + 4);
  CHECK(message_of([&] { merge({part(0, 0), part(0.1, 0)}, 0.6); }).find("twice") != std::string::npos);
}

TEST_CASE("a mesh from lists: an element that no sheet can have is refused by its place", "[mesh]") {
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Mesh mesh = from_lists(square, {{0, 1, 2, -1}, {0, 2, 3, -1}});
  CHECK(mesh.set("boundary").size() == 4);
  CHECK(message_of([&] {
          from_lists(square, {{0, 1, 2, 4}});
        }) == "element 1: expected node numbers from 1 to 4, got 5");
  CHECK(message_of([&] {
          from_lists(square, {{0, 1, 2, 3}, {0, 1, 1, -1}});
        }) == "element 2: expected different nodes, got node 2 twice");
  CHECK(message_of([&] { from_lists(square, {{0, 1, 2, -1}}); }) == "node 4 is in no element");
  CHECK(message_of([&] { from_lists(square, {}); }) == "expected at least one element, got none");
}
