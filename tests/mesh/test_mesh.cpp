#include <cmath>

#include "mesh/mesh.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using mesh::Index;
using mesh::Mesh;
using mesh::NodeSet;
using mesh::rectangle;

namespace {

double area(const Mesh& m, std::size_t e) {
  const auto& id = m.elements[e];
  const auto x = [&](std::size_t i) { return m.nodes[static_cast<std::size_t>(id[i])]; };
  return 0.5 * (x(2) - x(0)).cross(x(3) - x(1)).z();
}

}  // namespace

TEST_CASE("rectangle: nodes row-major from the origin corner, ends exact", "[mesh]") {
  const Mesh m = rectangle(0.3, 0.7, 3, 2, Vec3(1, 2, 3));
  REQUIRE(m.nodes.size() == 12);
  REQUIRE(m.elements.size() == 6);
  CHECK(m.nodes.front() == Vec3(1, 2, 3));
  CHECK(m.nodes[3] == Vec3(1 + 0.3, 2, 3));
  CHECK(m.nodes[4].x() == 1);
  CHECK(m.nodes.back() == Vec3(1 + 0.3, 2 + 0.7, 3));
  CHECK(m.flat);
  CHECK(m.origin == "rectangle 3x2");
}

TEST_CASE("rectangle: elements turn counter-clockwise about +z and fill the area", "[mesh]") {
  const Mesh m = rectangle(0.3, 0.7, 3, 2);
  double sum = 0;
  for (std::size_t e = 0; e < m.elements.size(); ++e) {
    CHECK(area(m, e) > 0);
    sum += area(m, e);
  }
  CHECK(sum == Approx(0.21).epsilon(1e-14));
  CHECK(m.elements[4] == std::array<Index, 4>{5, 6, 10, 9});
}

TEST_CASE("rectangle: named sets", "[mesh]") {
  const Mesh m = rectangle(1, 1, 3, 2);
  CHECK(m.set("left") == NodeSet{0, 4, 8});
  CHECK(m.set("right") == NodeSet{3, 7, 11});
  CHECK(m.set("bottom") == NodeSet{0, 1, 2, 3});
  CHECK(m.set("top") == NodeSet{8, 9, 10, 11});
  CHECK(m.set("boundary") == NodeSet{0, 1, 2, 3, 4, 7, 8, 9, 10, 11});
  CHECK(m.set("corners") == NodeSet{0, 3, 8, 11});
  CHECK(m.set("all").size() == 12);
  CHECK(m.sets.size() == 7);
}

TEST_CASE("rectangle: a single cell has all four corners in every border set", "[mesh]") {
  const Mesh m = rectangle(1, 1, 1, 1);
  CHECK(m.set("corners") == NodeSet{0, 1, 2, 3});
  CHECK(m.set("boundary") == m.set("all"));
  CHECK(m.elements_in(m.set("all")) == std::vector<Index>{0});
}

TEST_CASE("rectangle: refused sizes and counts name the field and the value", "[mesh]") {
  says(message_of([] { rectangle(-1, 1, 1, 1); }),
       "rectangle: field 'width': expected a positive length, m, got -1");
  says(message_of([] { rectangle(1, 0, 1, 1); }), "'height'");
  says(message_of([] { rectangle(std::nan(""), 1, 1, 1); }), "got nan");
  says(message_of([] { rectangle(1, 1, 0, 1); }), "'nx': expected a count from 1");
  says(message_of([] { rectangle(1, 1, 1, -3); }), "'ny'");
  says(message_of([] { rectangle(1, 1, 1'000'000, 1'000'000); }), "cells");
  says(message_of([] { rectangle(1, 1, 1, 1, Vec3(std::nan(""), 0, 0)); }), "'origin'");
}

TEST_CASE("an unknown set is answered with the nearest and the list", "[mesh]") {
  const Mesh m = rectangle(1, 1, 1, 1);
  CHECK(
      message_of([&] { m.set("lft"); }) ==
      "unknown set 'lft', did you mean 'left'? known sets: all, bottom, boundary, corners, left, right, top");
  says(message_of([&] { m.set("seam"); }), "unknown set 'seam'; known sets: all,");
  says(message_of([] { Mesh().set("all"); }), "known sets: none");
}

TEST_CASE("sets of one's own: by ids, sorted and each once; by place", "[mesh]") {
  Mesh m = rectangle(1, 1, 2, 2);
  m.define("mine", NodeSet{5, 1, 5, 0});
  CHECK(m.set("mine") == NodeSet{0, 1, 5});
  m.define("mine", [](const Vec3& x) { return x.y() > 0.75; });
  CHECK(m.set("mine") == m.set("top"));
}

TEST_CASE("a set that cannot be is refused and changes nothing", "[mesh]") {
  Mesh m = rectangle(1, 1, 2, 2);
  m.define("mine", NodeSet{4});
  says(message_of([&] {
         m.define("mine", NodeSet{0, 9});
       }),
       "set 'mine': expected node ids from 1 to 9, got 10");
  says(message_of([&] { m.define("mine", NodeSet{-1}); }), "got 0");
  says(message_of([&] { m.define("mine", NodeSet{}); }), "no node");
  says(message_of([&] { m.define("mine", [](const Vec3&) { return false; }); }), "no node");
  says(message_of([&] { m.define("", NodeSet{1}); }), "name");
  CHECK(m.set("mine") == NodeSet{4});
}

TEST_CASE("elements of a set have all their nodes in it", "[mesh]") {
  Mesh m = rectangle(1, 1, 2, 2);
  m.define("lower", [](const Vec3& x) { return x.y() < 0.75; });
  CHECK(m.elements_in(m.set("lower")) == std::vector<Index>{0, 1});
  CHECK(m.elements_in(m.set("bottom")).empty());
  m.elements[0][3] = -1;  // a triangle of its first three nodes 0, 1, 4
  CHECK(m.elements_in(NodeSet{0, 1, 4}) == std::vector<Index>{0});
}

TEST_CASE("map moves every node, or none", "[mesh]") {
  Mesh m = rectangle(1, 1, 1, 1);
  m.map([](const Vec3& x) { return Vec3(2 * x.x(), x.y(), 1); });
  CHECK(m.nodes.back() == Vec3(2, 1, 1));
  CHECK_FALSE(m.flat);
  const auto before = m.nodes;
  says(message_of(
           [&] { m.map([](const Vec3& x) { return Vec3(x.x(), x.y() > 0.5 ? std::nan("") : 0.0, 0); }); }),
       "map: node 3 at (0, 1, 1)");
  CHECK(m.nodes == before);
}

TEST_CASE("a rectangle in triangles: two a cell, all counter-clockwise, cuts turning from cell to cell",
          "[mesh]") {
  Mesh m = rectangle(0.3, 0.7, 3, 2);
  mesh::split(m, 3);
  REQUIRE(m.elements.size() == 12);
  double sum = 0;
  for (const auto& e : m.elements) {
    REQUIRE(e[3] == -1);
    const double twice = (m.nodes[e[1]] - m.nodes[e[0]]).cross(m.nodes[e[2]] - m.nodes[e[0]]).z();
    CHECK(twice > 0);
    sum += twice / 2;
  }
  CHECK(sum == Approx(0.21).epsilon(1e-14));
  // Node 5 (second column, second row) is where four cuts meet; its neighbour on the right has none but
  // edges.
  const auto meeting = [&](Index n) {
    return std::count_if(m.elements.begin(), m.elements.end(),
                         [&](const auto& e) { return e[0] == n || e[1] == n || e[2] == n; });
  };
  CHECK(meeting(5) == 8);
  CHECK(meeting(6) == 4);
}

TEST_CASE("a mesh in use keeps its nodes and its sets; new sets may come", "[mesh]") {
  Mesh m = rectangle(1, 1, 2, 2);
  m.in_use = true;
  m.define("middle", NodeSet{4});
  m.define("middle", NodeSet{4});
  CHECK(message_of([&] { m.define("middle", NodeSet{5}); }) ==
        "set 'middle': a compiled model uses this mesh, whose sets stay as they were: take another name");
  CHECK(message_of([&] { m.map([](const Vec3& X) { return X; }); }) ==
        "map: a compiled model uses this mesh: make a new one");
  CHECK(m.set("middle") == NodeSet{4});
}
