// Panels from outlines against closed forms of areas and lengths, and outlines that are wrong.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "mesh/area.hpp"
#include "mesh/check.hpp"
#include "mesh/edges.hpp"
#include "mesh/panel.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::mesh;
using Catch::Detail::Approx;
using std::numbers::pi;

namespace {

Loop polygon(const std::vector<Vec2>& points, const std::vector<std::string>& names = {}) {
  Loop loop;
  for (std::size_t i = 0; i < points.size(); ++i)
    loop.push_back(
        {PlaneCurve::line(points[i], points[(i + 1) % points.size()]), i < names.size() ? names[i] : ""});
  return loop;
}

// Elements of which every corner is on no border and two sides are along the angle, to 1e-9.
std::size_t along(const Mesh& mesh, double degrees) {
  const Vec3 warp(std::cos(degrees * pi / 180), std::sin(degrees * pi / 180), 0);
  std::size_t count = 0;
  for (const auto& e : mesh.elements) {
    if (e[3] < 0) continue;
    const Vec3 side = (mesh.nodes[e[1]] - mesh.nodes[e[0]]).normalized();
    const Vec3 next = (mesh.nodes[e[2]] - mesh.nodes[e[1]]).normalized();
    const double a = std::abs(side.dot(warp)), b = std::abs(next.dot(warp));
    if (std::min(a, b) < 1e-9 && std::max(a, b) > 1 - 1e-12) ++count;
  }
  return count;
}

void sound(const Mesh& mesh, double least_angle = 24) {
  const Report report = check(mesh);
  INFO(report.text());
  CHECK(report.ok());
  CHECK(report.measures.parts == 1);
  CHECK(report.measures.least_angle > least_angle);
  CHECK(report.find("hanging") == nullptr);
  CHECK(report.find("duplicate") == nullptr);
  for (const auto& e : mesh.elements) {
    const Vec3 normal = (mesh.nodes[e[1]] - mesh.nodes[e[0]]).cross(mesh.nodes[e[2]] - mesh.nodes[e[0]]);
    CHECK(normal.z() > 0);
  }
}

}  // namespace

TEST_CASE("a rectangle along the grain becomes the mesh of a rectangle", "[mesh][panel]") {
  const Mesh mesh = panel(
      {.outline = polygon({{0.1, 0.2}, {0.4, 0.2}, {0.4, 0.4}, {0.1, 0.4}}, {"hem", "right", "top", "left"}),
       .size = 0.05});
  sound(mesh, 89.9);
  CHECK(mesh.elements.size() == 24);
  CHECK(mesh.nodes.size() == 35);
  CHECK(along(mesh, 0) == 24);
  CHECK(area(mesh) == Approx(0.06).epsilon(1e-14));
  CHECK(mesh.set("hem").size() == 7);
  CHECK(mesh.set("right").size() == 5);
  CHECK(mesh.set("boundary").size() == 20);
  for (std::size_t i = 0; i < 7; ++i)  // in order along the edge
    CHECK((mesh.nodes[mesh.set("hem")[i]] - Vec3(0.1 + 0.05 * static_cast<double>(i), 0.2, 0)).norm() <
          1e-15);
  for (const Vec3& warp : mesh.warp) CHECK(warp == Vec3(1, 0, 0));
}

TEST_CASE("straight outlines keep their area, holes and darts theirs", "[mesh][panel]") {
  const Loop trapezoid = polygon({{0, 0}, {0.31, 0}, {0.24, 0.22}, {0.05, 0.22}});
  const double whole = 0.5 * (0.31 + 0.19) * 0.22;
  for (const double grain : {0.0, 17.0, 45.0, 90.0}) {
    const Mesh mesh = panel({.outline = trapezoid, .size = 0.013, .grain = grain, .rows = grain});
    sound(mesh);
    CHECK(area(mesh) == Approx(whole).epsilon(1e-13));
    CHECK(along(mesh, grain) > 0.6 * static_cast<double>(mesh.elements.size()));
  }
  const Loop ell = polygon({{0, 0}, {0.3, 0}, {0.3, 0.11}, {0.13, 0.11}, {0.13, 0.25}, {0, 0.25}});
  const Mesh bent = panel({.outline = ell, .size = 0.02});
  sound(bent, 25);
  CHECK(area(bent) == Approx(0.3 * 0.11 + 0.13 * 0.14).epsilon(1e-13));

  const Loop window = polygon({{0.12, 0.08}, {0.18, 0.08}, {0.18, 0.14}, {0.12, 0.14}}, {"w1", "w2"});
  const Dart dart{"waist", {0.09, 0}, {0.1, 0.12}, {0.115, 0.00005}};  // which is moved onto the outline
  const Mesh cut =
      panel({.outline = polygon({{0, 0}, {0.31, 0}, {0.24, 0.22}, {0.05, 0.22}}, {"hem", "r", "t", "l"}),
             .holes = {window},
             .darts = {dart},
             .size = 0.01});
  sound(cut, 10);
  CHECK(area(cut) == Approx(whole - 0.06 * 0.06 - 0.5 * 0.025 * 0.12).epsilon(1e-13));
  CHECK(check(cut).measures.borders == 2);
  const auto tip = [](const Mesh& mesh, const std::string& name) {
    const NodeSet& ids = mesh.set(name);
    return std::count_if(ids.begin(), ids.end(),
                         [&](Index n) { return (mesh.nodes[n] - Vec3(0.1, 0.12, 0)).norm() < 1e-15; });
  };
  CHECK(tip(cut, "waist_in") == 1);
  CHECK(tip(cut, "waist_out") == 1);
  CHECK(cut.set("hem").size() == cut.set("hem_1").size() + cut.set("hem_2").size());
  double right = 0;
  for (const Index n : cut.set("hem_1")) right = std::max(right, cut.nodes[n].x());
  CHECK(right == Approx(0.09).epsilon(1e-15));
}

TEST_CASE("rows follow straight sides oblique to the grain where few triangles are left", "[mesh][panel]") {
  const auto triangles = [](const Mesh& mesh) { return check(mesh).measures.triangles; };
  const auto turned = [](std::vector<Vec2> points, double degrees) {
    const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
    for (Vec2& x : points) x = Vec2(c * x.x() - s * x.y(), s * x.x() + c * x.y());
    return polygon(points);
  };
  // A strip and an angle piece, each turned by 20 degrees: rows along their sides leave no triangle.
  const Loop strip = turned({{0, 0}, {0.05, 0}, {0.05, 0.2}, {0, 0.2}}, 20);
  const Loop ell = turned({{0, 0}, {0.3, 0}, {0.3, 0.12}, {0.12, 0.12}, {0.12, 0.24}, {0, 0.24}}, 20);
  for (const Loop& outline : {strip, ell})
    for (const double grain : {-25.0, 65.0, 50.0}) {
      const Mesh mesh = panel({.outline = outline, .size = 0.01, .grain = grain});
      sound(mesh, 80);
      CHECK(triangles(mesh) == 0);
      CHECK(along(mesh, 20) == mesh.elements.size());
      for (const Vec3& warp : mesh.warp)
        CHECK((warp - Vec3(std::cos(grain * pi / 180), std::sin(grain * pi / 180), 0)).norm() < 1e-12);
      const Mesh asked = panel({.outline = outline, .size = 0.01, .grain = grain, .rows = grain});
      CHECK(triangles(asked) > 20);
      CHECK(asked.warp.front() == mesh.warp.front());
    }
  // A trapezoid with its grain at 45 degrees has fewer than half the triangles of rows along the grain.
  const Loop trapezoid = polygon({{0, 0}, {0.31, 0}, {0.24, 0.22}, {0.05, 0.22}});
  const Mesh mesh = panel({.outline = trapezoid, .size = 0.013, .grain = 45});
  sound(mesh);
  CHECK(2 * triangles(mesh) <
        triangles(panel({.outline = trapezoid, .size = 0.013, .grain = 45, .rows = 45})));
  // A circle has no straight side; sides within five degrees of the grain do not count.
  const Loop circle{{PlaneCurve::circle({0, 0}, 0.1), "rim"}};
  CHECK(panel({.outline = circle, .size = 0.01, .grain = 30, .quadrilaterals = false}).elements ==
        panel({.outline = circle, .size = 0.01, .grain = 30, .rows = 30}).elements);
  CHECK(panel({.outline = strip, .size = 0.01, .grain = 24}).elements ==
        panel({.outline = strip, .size = 0.01, .grain = 24, .rows = 24}).elements);
}

namespace {

// A barrel, 70 to 90 mm wide, a moon, a collar and a cap of a sleeve.
Loop barrel() {
  return {{PlaneCurve::line({0, 0}, {0.07, 0}), "low"},
          {PlaneCurve::arc_through({0.07, 0}, {0.08, 0.1}, {0.07, 0.2}), "right"},
          {PlaneCurve::line({0.07, 0.2}, {0, 0.2}), "high"},
          {PlaneCurve::arc_through({0, 0.2}, {-0.01, 0.1}, {0, 0}), "left"}};
}
Loop collar() {
  return {{PlaneCurve::arc_about({0, 0}, {0.2, 0}, {0, 0.2}, false), "outer"},
          {PlaneCurve::line({0, 0.2}, {0, 0.13}), "end"},
          {PlaneCurve::arc_about({0, 0}, {0, 0.13}, {0.13, 0}, true), "inner"},
          {PlaneCurve::line({0.13, 0}, {0.2, 0}), "start"}};
}
Loop cap() {
  return {{PlaneCurve::line({-0.15, 0}, {0.15, 0}), "bicep"},
          {PlaneCurve::bezier({{0.15, 0}, {0.1, 0.02}, {0.08, 0.13}, {0, 0.13}}), "front"},
          {PlaneCurve::bezier({{0, 0.13}, {-0.08, 0.13}, {-0.1, 0.02}, {-0.15, 0}}), "back"}};
}

double polygon_area(const Mesh& mesh, Index rim) {
  double twice = 0;
  for (Index i = 0; i < rim; ++i) {
    const Vec3 &p = mesh.nodes[i], &q = mesh.nodes[(i + 1) % rim];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return twice / 2;
}

}  // namespace

TEST_CASE("panels of quadrilaterals alone: nodes on the curves, the area, the angles", "[mesh][panel]") {
  for (const Loop& outline : {barrel(), collar(), cap()})
    for (const double size : {0.03, 0.017, 0.008})
      for (const double grain : {0.0, 25.0, 45.0, 62.0}) {
        const Mesh mesh = panel({.outline = outline, .size = size, .grain = grain, .quadrilaterals = true});
        CAPTURE(size, grain, outline.front().edge);
        sound(mesh, outline.front().edge == "bicep" ? 8 : 30);
        CHECK(check(mesh).measures.triangles == 0);
        Index rim = 0;
        for (const OutlinePiece& piece : outline) {
          const NodeSet& ids = mesh.set(piece.edge);
          CHECK(ids.size() % 2 == 1);  // an even number of elements
          CHECK(static_cast<double>(ids.size() - 1) ==
                Approx(piece.curve.length() / size).margin(piece.curve.straight() ? 2 : 1.001));
          rim += static_cast<Index>(ids.size()) - 1;
          for (const Index n : ids) {
            const Vec2 x(mesh.nodes[n].x(), mesh.nodes[n].y());
            CHECK((piece.curve.at(piece.curve.nearest(x)) - x).norm() < 1e-9);
          }
          // In their order, at even distances along the edge.
          const double step = piece.curve.length() / static_cast<double>(ids.size() - 1);
          if (ids.back() == ids.front() + static_cast<Index>(ids.size()) - 1)
            for (std::size_t i = 0; i + 1 < ids.size() && !piece.curve.straight(); ++i)
              CHECK((piece.curve.at(step * static_cast<double>(i)) -
                     Vec2(mesh.nodes[ids[i]].x(), mesh.nodes[ids[i]].y()))
                        .norm() < 1e-9);
        }
        CHECK(static_cast<Index>(mesh.set("boundary").size()) == rim);
        CHECK(area(mesh) == Approx(polygon_area(mesh, rim)).epsilon(1e-12));
        const Mesh again = panel({.outline = outline, .size = size, .grain = grain, .quadrilaterals = true});
        CHECK(again.nodes == mesh.nodes);
        CHECK(again.elements == mesh.elements);
      }
}

TEST_CASE("quadrilaterals alone with a hole, a dart, notches and numbers of elements", "[mesh][panel]") {
  Panel shape{.outline = barrel(),
              .holes = {{{PlaneCurve::circle({0.03, 0.14}, 0.018), "vent", 12}}},
              .darts = {{"dart", {0.03, 0}, {0.035, 0.05}, {0.04, 0}}},
              .notches = {{"mark", "right", {}, 0.35}},
              .size = 0.009,
              .grain = 33,
              .quadrilaterals = true};
  shape.outline[2].elements = 10;
  const Mesh mesh = panel(shape);
  sound(mesh, 15);
  CHECK(check(mesh).measures.triangles == 0);
  CHECK(mesh.set("vent").size() == 12);
  CHECK(mesh.set("high").size() == 11);
  CHECK(mesh.set("dart_in").size() == mesh.set("dart_out").size());
  const Vec2 mark = shape.outline[1].curve.at(0.35 * shape.outline[1].curve.length());
  REQUIRE(mesh.set("mark").size() == 1);
  CHECK((mesh.nodes[mesh.set("mark")[0]] - Vec3(mark.x(), mark.y(), 0)).norm() < 1e-12);
  shape.outline[2].elements = 9;
  says(message_of([&] { panel(shape); }),
       "panel: field 'quadrilaterals': expected an even number of elements along each piece, got 9 along "
       "'high'");
  // Without the wish it is a mesh with triangles.
  shape.quadrilaterals = {};
  CHECK(panel(shape).set("high").size() == 10);
}

TEST_CASE("panels are of quadrilaterals alone where triangles would matter", "[mesh][panel]") {
  const auto triangles = [](Panel shape, std::optional<bool> wish) {
    shape.quadrilaterals = wish;
    return check(panel(shape)).measures.triangles;
  };
  // Rows along the sides of the strip are oblique to its grain.
  const Panel oblique{.outline = barrel(), .size = 0.0075, .grain = 40};
  CHECK(triangles(oblique, false) > 0);
  CHECK(triangles(oblique, {}) == 0);
  // A disc along the grain: its triangles are much of it on a coarse mesh alone.
  const auto disc = [](double size) {
    return Panel{.outline = {{PlaneCurve::circle({0, 0}, 0.1), "rim"}}, .size = size};
  };
  CHECK(triangles(disc(0.02), false) > 0);
  CHECK(triangles(disc(0.02), {}) == 0);
  CHECK(triangles(disc(0.004), {}) > 0);
  CHECK(triangles(disc(0.004), true) == 0);
  // Rows that are asked for stay, and so do triangles.
  Panel rows = oblique;
  rows.rows = 40;
  CHECK(triangles(rows, {}) > 0);
  CHECK(triangles(rows, true) == 0);
}

TEST_CASE("arcs: area of the polygon on the circle, which converges to that of the circle", "[mesh][panel]") {
  double before = 0;
  for (const double size : {0.02, 0.01, 0.005}) {
    const Mesh mesh = panel({.outline = {{PlaneCurve::circle({0.03, -0.01}, 0.1), "rim"}},
                             .size = size,
                             .quadrilaterals = false});
    sound(mesh);
    const auto n = static_cast<double>(mesh.set("rim").size());
    CHECK(n == std::round(0.2 * pi / size));
    CHECK(area(mesh) == Approx(n / 2 * 0.01 * std::sin(2 * pi / n)).epsilon(1e-12));
    const double error = pi * 0.01 - area(mesh);
    if (before > 0) CHECK(error * n * n == Approx(before).epsilon(0.01));
    before = error * n * n;
    for (const Index id : mesh.set("rim"))
      CHECK((mesh.nodes[id] - Vec3(0.03, -0.01, 0)).norm() == Approx(0.1));
  }
  const Mesh ring = panel({.outline = {{PlaneCurve::circle({0, 0}, 0.1), "outer"}},
                           .holes = {{{PlaneCurve::circle({0, 0}, 0.04), "inner", 24}}},
                           .size = 0.008,
                           .grain = 30,
                           .quadrilaterals = false});
  sound(ring);
  CHECK(ring.set("inner").size() == 24);
  CHECK(area(ring) == Approx(79 / 2.0 * 0.01 * std::sin(2 * pi / 79) - 12 * 0.0016 * std::sin(2 * pi / 24)));
}

TEST_CASE("curves: length, ends, the nearest place; splines pass through their points", "[mesh][panel]") {
  const PlaneCurve arc = PlaneCurve::arc_through({0, 0}, {1, 1}, {2, 0});
  CHECK(arc.length() == Approx(pi));
  CHECK((arc.at(pi / 2) - Vec2(1, 1)).norm() < 1e-14);
  const PlaneCurve about = PlaneCurve::arc_about({1, 0}, {0, 0}, {2, 0}, true);
  CHECK((about.at(pi / 2) - Vec2(1, 1)).norm() < 1e-14);
  CHECK((PlaneCurve::arc_about({1, 0}, {0, 0}, {2, 0}, false).at(pi / 2) - Vec2(1, -1)).norm() < 1e-14);
  CHECK(arc.nearest({1 - 3 * std::cos(1), 3 * std::sin(1)}) == Approx(1).epsilon(1e-12));
  // The parabola y = x^2 from 0 to 1 as a Bezier curve; its length in closed form.
  const PlaneCurve parabola = PlaneCurve::bezier({{0, 0}, {1.0 / 3, 0}, {2.0 / 3, 1.0 / 3}, {1, 1}});
  CHECK(parabola.length() == Approx(std::sqrt(5) / 2 + std::asinh(2) / 4).epsilon(1e-12));
  const auto until = [](double x) { return x * std::sqrt(1 + 4 * x * x) / 2 + std::asinh(2 * x) / 4; };
  CHECK((parabola.at(until(0.3)) - Vec2(0.3, 0.09)).norm() < 1e-12);
  CHECK((parabola.reversed().at(parabola.length() - until(0.3)) - Vec2(0.3, 0.09)).norm() < 1e-12);
  CHECK(parabola.nearest({0.3 - 0.6 * 0.1, 0.09 + 0.1}) == Approx(until(0.3)).epsilon(1e-11));
  const std::vector<Vec2> points{{0, 0}, {1, 0.4}, {1.5, 1.7}, {3, 2}};
  const PlaneCurve spline = PlaneCurve::spline(points);
  for (const Vec2& x : points) CHECK((spline.at(spline.nearest(x)) - x).norm() < 1e-11);
  CHECK(PlaneCurve::spline({{0, 0}, {2, 1}}).length() == Approx(std::sqrt(5)).epsilon(1e-13));
  CHECK(PlaneCurve::spline({{0, 0}, {1, 2}, {2, 4}, {5, 10}}).length() ==
        Approx(5 * std::sqrt(5)).epsilon(1e-13));
  // Smooth: the tangents on both sides of a point agree.
  const double s = spline.nearest(points[1]);
  CHECK((spline.tangent(s - 1e-9) - spline.tangent(s + 1e-9)).norm() < 1e-7);
}

TEST_CASE("notches are nodes, however the outline was drawn", "[mesh][panel]") {
  const std::vector<Vec2> points{{0, 0}, {0.4, 0}, {0.4, 0.3}, {0, 0.3}};
  for (const bool turned : {false, true}) {
    Loop loop = polygon(points, {"hem", "right", "top", "left"});
    if (turned) {
      std::reverse(loop.begin(), loop.end());
      for (OutlinePiece& piece : loop) piece.curve = piece.curve.reversed();
    }
    const double at = turned ? 0.3 - 0.0777 : 0.0777;
    const Mesh mesh = panel({.outline = loop,
                             .notches = {{"a", "right", at},
                                         {"b", "top", {}, 0.25},
                                         {"c", "", {}, {}, Vec2(0.1234, 0)},
                                         {"corner", "left", {}, {}, Vec2(0, 0)}},
                             .size = 0.02});
    sound(mesh, 10);
    const auto x = [&](const char* name) {
      REQUIRE(mesh.set(name).size() == 1);
      return mesh.nodes[mesh.set(name)[0]];
    };
    CHECK((x("a") - Vec3(0.4, 0.0777, 0)).norm() < 1e-15);
    CHECK((x("b") - Vec3(turned ? 0.1 : 0.3, 0.3, 0)).norm() < 1e-15);
    CHECK((x("c") - Vec3(0.1234, 0, 0)).norm() < 1e-12);
    CHECK((x("corner") - Vec3(0, 0, 0)).norm() < 1e-15);
    CHECK(area(mesh) == Approx(0.12).epsilon(1e-13));
  }
}

TEST_CASE("a bodice with armhole and neck, narrow places and sharp corners", "[mesh][panel]") {
  const Vec2 a{0, 0}, b{0.24, 0}, c{0.25, 0.2}, d{0.2, 0.4}, e{0.09, 0.43}, f{0, 0.36};
  const Loop bodice{{PlaneCurve::line(a, b), "waist"},
                    {PlaneCurve::line(b, c), "side"},
                    {PlaneCurve::spline({c, {0.205, 0.25}, {0.195, 0.33}, d}), "armhole"},
                    {PlaneCurve::line(d, e), "shoulder"},
                    {PlaneCurve::arc_about({0, 0.45}, e, {0, 0.45 - std::hypot(0.09, 0.02)}, true), "neck"},
                    {PlaneCurve::line({0, 0.45 - std::hypot(0.09, 0.02)}, a), "front"}};
  for (const double size : {0.03, 0.015, 0.006})
    sound(panel({.outline = bodice, .size = size, .grain = 90}), 12);
  const Mesh again = panel({.outline = bodice, .size = 0.015, .grain = 90});
  const Mesh same = panel({.outline = bodice, .size = 0.015, .grain = 90});
  CHECK(again.elements == same.elements);
  CHECK(again.nodes == same.nodes);
  // An hourglass with a waist narrower than an element, a needle, and a comb.
  const Loop glass = polygon({{0, 0}, {0.2, 0}, {0.102, 0.1}, {0.2, 0.2}, {0, 0.2}, {0.098, 0.1}});
  CHECK(area(panel({.outline = glass, .size = 0.03})) == Approx(0.5 * (0.2 + 0.004) * 0.2).epsilon(1e-12));
  const Loop needle = polygon({{0, 0}, {0.3, 0.011}, {0.3, 0.02}});
  CHECK(area(panel({.outline = needle, .size = 0.009})) == Approx(0.5 * 0.3 * 0.009).epsilon(1e-12));
  std::vector<Vec2> comb{{0, 0}, {0.32, 0}};
  for (int i = 7; i >= 0; --i) {
    const double x = 0.04 * i;
    comb.insert(comb.end(), {{x + 0.04, 0.1}, {x + 0.021, 0.1}, {x + 0.02, 0.013}, {x + 0.01, 0.012}});
  }
  double twice = 0;
  for (std::size_t i = 0; i < comb.size(); ++i) {
    const Vec2 &p = comb[i], &q = comb[(i + 1) % comb.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  for (const double size : {0.02, 0.007})
    CHECK(area(panel({.outline = polygon(comb), .size = size, .grain = 33})) ==
          Approx(twice / 2).epsilon(1e-12));
}

TEST_CASE("any star of straight lines is covered", "[mesh][panel]") {
  std::mt19937_64 random(5);
  const auto draw = [&random](double low, double high) {
    return low + (high - low) * 0x1p-64 * static_cast<double>(random());
  };
  for (int i = 0; i < 150; ++i) {
    const int corners = 5 + i % 9;
    std::vector<Vec2> points;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * pi * (k + draw(0, 0.7)) / corners, r = draw(0.15, 1);
      points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    double twice = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Vec2 &p = points[k], &q = points[(k + 1) % points.size()];
      twice += p.x() * q.y() - p.y() * q.x();
    }
    const Mesh mesh = panel({.outline = polygon(points),
                             .size = std::pow(10, draw(-1.6, -0.7)),
                             .grain = draw(-180, 180),
                             .triangles = i % 5 == 0});
    const Report report = check(mesh);
    INFO(report.text());
    CHECK(report.ok());
    CHECK(report.measures.area == Approx(twice / 2).epsilon(1e-11));
    CHECK(report.find("hanging") == nullptr);
  }
}

TEST_CASE("equilateral triangles", "[mesh][panel]") {
  const Mesh mesh = panel({.outline = {{PlaneCurve::circle({0, 0}, 0.1)}}, .size = 0.01, .triangles = true});
  sound(mesh, 23);
  CHECK(check(mesh).measures.quadrilaterals == 0);
  CHECK(mesh.elements.size() == 2 * mesh.nodes.size() - 2 - mesh.set("boundary").size());  // Euler
}

TEST_CASE("wrong panels are refused with their place", "[mesh][panel]") {
  const Loop square = polygon({{0, 0}, {0.2, 0}, {0.2, 0.2}, {0, 0.2}}, {"a", "b", "c", "d"});
  const auto refused = [](const Panel& shape) { return message_of([&] { panel(shape); }); };
  says(
      refused({.outline = polygon({{0, 0}, {0.2, 0.2}, {0.2, 0}, {0, 0.25}}, {"a", "b", "c"}), .size = 0.05}),
      "panel: field 'outline': edge 'a' crosses or touches edge 'c' near (");
  says(refused({.outline = {{PlaneCurve::line({0, 0}, {1, 0})}, {PlaneCurve::line({1, 0}, {1, 1}), "b"}},
                .size = 0.1}),
       "panel: field 'outline': open: it ends at (1, 1), 1.41421 m from where it goes on, (0, 0)");
  says(refused({.outline = {}, .size = 0.1}),
       "panel: field 'outline': expected at least one piece, got none");
  says(refused({.outline = polygon({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), .size = 0.1}),
       "panel: field 'outline': piece 2 has no length, at (1, 0)");
  says(refused({.outline = polygon({{0, 0}, {1, 0}, {0.5, 0}, {0.5, 1}}), .size = 0.1}),
       "crosses or touches");
  says(refused({.outline = square, .size = 0.21}),
       "panel: field 'size': expected at most the smaller extent of the panel, 0.2 m, got 0.21");
  says(refused({.outline = square, .size = 1e-6}), "panel: field 'size': expected a size that gives at most");
  says(refused({.outline = square, .size = 0}), "panel: field 'size': expected a positive length, m, got 0");
  const auto hole = [&](const Loop& line) {
    return refused({.outline = square, .holes = {line}, .size = 0.05});
  };
  says(hole(polygon({{0.3, 0}, {0.4, 0}, {0.4, 0.1}})),
       "panel: field 'holes': hole 1 lies outside of the outline, at (0.3, 0)");
  says(hole({{PlaneCurve::circle({0.1, 0.15}, 0.08)}}),
       "panel: field 'holes': hole 1, piece 1 crosses or touches edge 'c'");
  says(refused({.outline = square,
                .holes = {{{PlaneCurve::circle({0.1, 0.1}, 0.08)}}, {{PlaneCurve::circle({0.1, 0.1}, 0.03)}}},
                .size = 0.05}),
       "panel: field 'holes': hole 2 lies in hole 1, at (");
  says(refused({.outline = square, .size = 0.05, .triangles = true, .quadrilaterals = true}),
       "panel: field 'quadrilaterals': expected false with triangles=true");
  const auto dart = [&](std::vector<Dart> darts) {
    return refused({.outline = square, .darts = darts, .size = 0.05});
  };
  says(dart({{"w", {0.05, 0}, {0.1, 0.3}, {0.1, 0}}}),
       "panel: field 'darts': dart 'w': its tip (0.1, 0.3) is not inside the outline");
  says(dart({{"w", {0.05, 0.01}, {0.1, 0.1}, {0.1, 0}}}),
       "panel: field 'darts': dart 'w': expected 'from' and 'to' on the outline, got (0.05, 0.01), 0.01 m "
       "off it");
  says(dart({{"w", {0.05, 0}, {0.1, 0.1}, {0.05, 0}}}),
       "dart 'w': expected 'from' and 'to' at different places");
  says(dart({{"v", {0.05, 0}, {0.15, 0.1}, {0.08, 0}}, {"w", {0.1, 0}, {0.05, 0.1}, {0.13, 0}}}),
       "panel: field 'darts': dart 'v' crosses or touches dart 'w' near (0.0916667, 0.0166667)");
  says(dart({{"a", {0.05, 0}, {0.1, 0.1}, {0.1, 0}}, {"a", {0.12, 0}, {0.14, 0.1}, {0.15, 0}}}),
       "'a_in' twice");
  const auto notch = [&](const Notch& given) {
    return refused({.outline = square, .notches = {given}, .size = 0.05});
  };
  says(notch({"n", "sleeve", 0.1}), "panel: field 'notches': notch 'n': no edge has the name 'sleeve'");
  says(notch({"n", "a", 0.3}), "notch 'n': expected a place from 0 to 0.2 m along edge 'a', got 0.3");
  says(notch({"n", "a", {}, {}, Vec2(0.1, 0.004)}), "notch 'n': (0.1, 0.004) lies 0.004 m off edge 'a'");
  says(notch({"n", "", {}, {}, Vec2(0.1, 0.1)}), "notch 'n': (0.1, 0.1) lies 0.1 m off the outline");
  says(notch({"n", "a"}), "notch 'n': expected a point, or an edge and one of at= (m) and share=");
  says(notch({"b", "a", 0.1}), "expected a name of its own, got 'b' twice");
  says(notch({"all", "a", 0.1}), "'all' is a set of every mesh");
  says(refused({.outline = square,
                .darts = {{"w", {0.05, 0}, {0.1, 0.1}, {0.1, 0}}},
                .notches = {{"n", "a", 0.07}},
                .size = 0.02}),
       "notch 'n': (0.07, 0) lies in the mouth of a dart");
  says(message_of([] {
         PlaneCurve::arc_through({0, 0}, {1, 1}, {2, 2});
       }),
       "arc: expected three points that do not lie on a line");
  says(message_of([] {
         PlaneCurve::arc_about({0, 0}, {1, 0}, {0, 1.1}, false);
       }),
       "arc: expected both ends at one distance from 'centre', got 1 and 1.1 m");
}
