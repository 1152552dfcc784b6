#include <cmath>

#include "mesh/check.hpp"
#include "mesh/generators.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::mesh;
using Ids = std::vector<Index>;

namespace {

const Finding& found(const Report& report, const std::string& key) {
  const Finding* item = report.find(key);
  INFO(key << " in\n" << report.text());
  REQUIRE(item != nullptr);
  return *item;
}

// A strip of n quadrilaterals whose ends are joined after half a turn.
Mesh moebius(Index n) {
  Mesh m = rectangle(1, 0.1, n, 1);
  const Index width = n + 1;
  m.elements.back() = {n - 1, width, 0, width + n - 1};
  return m;
}

}  // namespace

TEST_CASE("check: generated meshes are clean", "[mesh]") {
  for (const Mesh& m : {rectangle(1, 2, 3, 4), disk({.radius = 1, .cells = 8}),
                        annulus({.inner = 1, .outer = 2, .around = 16, .across = 4}),
                        cylinder({.radius = 1, .length = 2, .around = 16, .along = 8}),
                        hemisphere({.radius = 1, .around = 8, .along = 8})}) {
    const Report report = check(m);
    INFO(report.text());
    CHECK(report.ok());
    CHECK(report.items.size() == 1);
    CHECK(found(report, "free").nodes == m.set("boundary"));
    CHECK(report.measures.parts == 1);
    CHECK(report.measures.borders == (m.sets.contains("seam") ? 2 : 1));
  }
}

TEST_CASE("check: measures against closed forms", "[mesh]") {
  Mesh m = rectangle(3, 1, 1, 1);
  m.nodes[3].z() = 0.5;  // the far corner lifted
  const Measures& lifted = check(m).measures;
  const double deg = 180 / std::acos(-1.0);
  // Halves along the diagonal through the lifted corner: normals (0, 0, 1) against each other's tilt.
  const Vec3 a = Vec3(3, 0, 0).cross(Vec3(3, 1, 0.5)), b = Vec3(3, 1, 0.5).cross(Vec3(0, 1, 0));
  const double along = std::acos(a.dot(b) / a.norm() / b.norm()) * deg;
  const Vec3 c(0, 0, 1), d = Vec3(0, 1, 0.5).cross(Vec3(-3, 0, 0.5));
  const double across = std::acos(std::abs(c.dot(d)) / d.norm()) * deg;
  CHECK(lifted.warping == Approx(std::max(along, across)).epsilon(1e-12));
  CHECK(lifted.shortest == Approx(1));
  CHECK(lifted.longest == Approx(std::sqrt(9.25)));
  CHECK(lifted.aspect == Approx(std::sqrt(9.25)));
  CHECK(check(rectangle(3, 1, 5, 5)).measures.area == Approx(3).epsilon(1e-14));
}

TEST_CASE("check: elements that cannot be are named from 1", "[mesh]") {
  Mesh m = rectangle(3, 1, 3, 1);
  std::swap(m.elements[1][2], m.elements[1][3]);  // a bow tie
  Report report = check(m);
  CHECK_FALSE(report.ok());
  CHECK(found(report, "degenerate").elements == Ids{1});  // its halves cancel
  says(report.text(), "error: element 2: no area");
  m = rectangle(3, 1, 3, 1);
  m.nodes[5] = Vec3(1.6, 0.1, 0);  // a re-entrant corner of the second element
  report = check(m);
  CHECK(found(report, "inverted").elements == Ids{1});
  m = rectangle(3, 1, 3, 1);
  m.elements[2][2] = m.elements[2][1];
  CHECK(found(check(m), "degenerate").elements == Ids{2});
  m = rectangle(3, 1, 3, 1);
  m.elements.push_back({1, 2, 6, 5});
  report = check(m);
  CHECK(found(report, "repeated").elements == Ids{3});
  CHECK(found(report, "nonmanifold").elements == Ids{0, 1, 2, 3});
}

TEST_CASE("check: folds at which a shell has no normal", "[mesh]") {
  // a strip of two wide elements and one narrow one, folded by an angle before the last
  const auto folded = [](double degrees, bool split) {
    Mesh m = rectangle(3, 1, 3, 1);
    const double angle = degrees * 3.14159265358979 / 180;
    for (const Index n : {3, 7})
      m.nodes[n] = {2 + 0.3 * std::cos(angle), m.nodes[n].y(), 0.3 * std::sin(angle)};
    if (split) {
      m.elements.pop_back();
      m.elements.push_back({2, 3, 6, -1});
      m.elements.push_back({3, 7, 6, -1});
    }
    return m;
  };
  // At the fold the mean normal of areas 1 and 0.3 leans towards the large element: against the small one
  // beyond 90 degrees and a bit, since at its far end the director is its own.
  for (const bool split : {false, true}) {
    CHECK(check(folded(60, split)).ok());
    CHECK(check(folded(100, split)).find("fold") == nullptr);
    const Report sharp = check(folded(170, split));
    CHECK_FALSE(sharp.ok());
    CHECK(found(sharp, "fold").elements.front() == 2);
  }
  Mesh flat = rectangle(2, 1, 2, 1);  // one element lies upon the other
  for (const Index n : {2, 5}) flat.nodes[n].x() = 0;
  const Finding fold = found(check(flat), "fold");
  CHECK(fold.nodes == Ids{1, 4});
  says(fold.text, "nodes 2, 5: no normal, its elements cancel");
}

TEST_CASE("check: nodes at one place, and nodes in no element", "[mesh]") {
  Mesh m = annulus({.inner = 1, .outer = 2, .around = 12, .across = 2, .slit = true});
  CHECK(found(check(m), "duplicate").nodes == m.set("end"));
  m.nodes.push_back(Vec3(0, 0, 5));
  const Report report = check(m);
  CHECK(found(report, "unused").nodes == Ids{39});
  says(report.text(), "error: node 40: in no element");
  CHECK_FALSE(report.ok());  // a model refuses it too
  m = rectangle(1, 1, 20, 20);
  for (int k = 0; k < 3; ++k) {  // as near as rounding, in every direction
    m.nodes.push_back(m.nodes[static_cast<std::size_t>(100 + k)] + Vec3(1e-13, -1e-13, k == 1 ? 1e-13 : 0));
    m.elements.push_back({441 + k, 0, 21, -1});
  }
  CHECK(found(check(m), "duplicate").nodes == Ids{441, 442, 443});
  m.nodes.back() += Vec3(1e-6, 0, 0);  // as a file in single precision leaves it; the mesh spans 1.4
  CHECK(found(check(m), "duplicate").nodes == Ids{441, 442, 443});
  m.nodes.back() += Vec3(1e-5, 0, 0);
  CHECK(found(check(m), "duplicate").nodes == Ids{441, 442});
}

TEST_CASE("check: parts at one place are told wherever the mesh is from, but for those of a slit", "[mesh]") {
  // Two squares of four elements side by side, with nodes of their own along the edge between them.
  const auto halves = [](double gap) {
    Mesh left = rectangle(2, 2, 2, 2), right = rectangle(2, 2, 2, 2);
    std::vector<Vec3> nodes = left.nodes;
    auto elements = left.elements;
    for (const Vec3& x : right.nodes) nodes.push_back(x + Vec3(2 + gap, 0, 0));
    for (auto ids : right.elements) {
      for (Index& id : ids) id += id < 0 ? 0 : 9;
      elements.push_back(ids);
    }
    return from_lists(nodes, elements);
  };
  Mesh m = halves(0);
  const Report report = check(m);
  CHECK_FALSE(report.ok());
  CHECK(found(report, "apart").nodes == Ids{9, 12, 15});
  CHECK(found(report, "apart").text ==
        "the sheet is in 2 parts that are not connected, though they share places (nodes 10, 13, 16, the "
        "first at {2, 0, 0} m): fabric.mesh{ nodes=..., elements=..., join=true } makes one node of those at "
        "one place");
  CHECK(join_nodes(m) == 3);
  CHECK(check(m).ok());
  CHECK(check(m).measures.parts == 1);
  CHECK(check(halves(1e-4)).ok());  // side by side
  // what merge() just missed, and what lies at some distance, as layers do
  const auto merged = [](const Vec3& by, double distance) {
    Mesh other = rectangle(2, 2, 2, 2);
    for (Vec3& x : other.nodes) x += by;
    return merge({std::make_shared<Mesh>(rectangle(2, 2, 2, 2)), std::make_shared<Mesh>(other)}, distance);
  };
  const Mesh missed = merged(Vec3(2.0002, 0, 0), 1e-6);
  CHECK(found(check(missed), "apart").nodes == Ids{9, 12, 15});
  says(check(missed).text(), "fabric.mesh.merge{ meshes=..., distance= }");
  CHECK(check(merged(Vec3(2.0002, 0, 0), 1e-3)).ok());
  CHECK(check(merged(Vec3(0, 0, 0.004), 1e-6)).ok());
  // a slit made two parts of one, as it was to do; it does not hide that there were two before
  m = rectangle(4, 2, 4, 2);
  slit(m, Vec3(2, 0, 0), Vec3(2, 2, 0));
  CHECK(check(m).ok());
  CHECK(check(m).measures.parts == 2);
  m = halves(0);
  slit(m, Vec3(1, 0, 0), Vec3(1, 2, 0));
  CHECK_FALSE(check(m).ok());
}

TEST_CASE("check: shape warnings", "[mesh]") {
  CHECK(found(check(rectangle(20, 1, 1, 1)), "aspect").elements == Ids{0});
  Mesh m = rectangle(1, 1, 1, 1);
  m.map([](const Vec3& x) { return Vec3(x.x() + 5 * x.y(), x.y(), 0); });
  CHECK(found(check(m), "angle").elements == Ids{0});
  m = rectangle(1, 1, 1, 1);
  m.nodes[0].z() = 0.3;
  CHECK(found(check(m), "warping").elements == Ids{0});
}

TEST_CASE("orient: turns those that disagree, as few as can be", "[mesh]") {
  Mesh m = cylinder({.radius = 1, .length = 2, .around = 8, .along = 4});
  const auto good = m.elements;
  for (const std::size_t e : {3u, 17u}) std::swap(m.elements[e][1], m.elements[e][3]);
  CHECK(found(check(m), "orientation").elements == Ids{3, 17});
  CHECK(orient(m) == 2);
  CHECK(m.elements == good);
  CHECK(orient(m) == 0);
  Mesh flat = rectangle(1, 1, 3, 3);
  CHECK(orient(flat, Vec3(0, 0.1, -1)) == 9);
  CHECK(orient(flat, Vec3(0, 0, 1)) == 9);
  says(message_of([&] { orient(flat, Vec3(1, 0, 0)); }),
       "orient: the mean normal of part 1 of the mesh is square");
}

TEST_CASE("orient: two parts, triangles, and a strip with one side", "[mesh]") {
  Mesh m = rectangle(2, 1, 2, 1);
  m.elements = {{0, 1, 4, -1}, {0, 3, 4, -1}, {1, 5, 4, -1}, {1, 2, 5, -1}};
  CHECK(orient(m) == 1);
  CHECK(check(m).find("orientation") == nullptr);
  Mesh strip = moebius(6);
  CHECK(found(check(strip), "one_sided").elements.size() == 6);
  says(message_of([&] { orient(strip); }), "Moebius");
  Mesh two = rectangle(3, 1, 3, 1);
  two.elements.erase(two.elements.begin() + 1);
  CHECK(check(two).measures.parts == 2);
  CHECK(check(two).measures.borders == 2);
}

TEST_CASE("check: nodes that lie so that strains suffer", "[mesh]") {
  // One quadrilateral with a corner of almost 180 degrees, and the same with it moved out.
  Mesh m = rectangle(0.02, 0.02, 1, 1);
  m.nodes[3] = Vec3(0.011, 0.0105, 0);
  says(found(check(m), "wide").text,
       "element 1: corners of quadrilaterals up to 171.4 degrees, almost a straight line");
  m.nodes[3] = Vec3(0.02, 0.014, 0);
  CHECK(check(m).find("wide") == nullptr);
  // A trapezoid: its corners span areas as its parallel sides are long, here 1 to 5 and 1 to 3.
  for (const double top : {0.2, 1.0 / 3}) {
    Mesh t = rectangle(0.03, 0.02, 1, 1);
    t.nodes[3].x() = top * 0.03;
    const Report report = check(t);
    const Finding* taper = report.find("taper");
    CHECK((taper != nullptr) == (top < 0.25));
    if (taper != nullptr)
      says(taper->text, "element 1: the narrowest corner spans down to 0.2 of the area of");
  }
}

TEST_CASE("check: nodes on the side of an element that has none there", "[mesh]") {
  // Two strips side by side, of four and of six elements: three of the inner nodes of either side hang.
  Mesh m = rectangle(0.4, 0.1, 4, 1);
  const Mesh other = rectangle(0.4, 0.1, 6, 1, Vec3(0, 0.1, 0));
  const auto first = static_cast<Index>(m.nodes.size());
  m.nodes.insert(m.nodes.end(), other.nodes.begin(), other.nodes.end());
  for (auto e : other.elements) {
    for (Index& n : e) n += first;
    m.elements.push_back(e);
  }
  const Report report = check(m);
  CHECK(found(report, "hanging").nodes == Ids{6, 8, 11, 12, 14, 15});
  CHECK(found(report, "hanging").elements == Ids{0, 1, 2, 3, 5, 8});
  CHECK(found(report, "duplicate").nodes == Ids{10, 13, 16});
  m = rectangle(0.4, 0.1, 4, 1);
  CHECK(check(m).find("hanging") == nullptr);
}
