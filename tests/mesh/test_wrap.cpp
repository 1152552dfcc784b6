// Panels laid around cylinders and cones: lengths, areas and directions in closed form.
#include <cmath>
#include <numbers>

#include "mesh/area.hpp"
#include "mesh/check.hpp"
#include "mesh/generators.hpp"
#include "mesh/normals.hpp"
#include "mesh/panel.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::mesh;
using Catch::Detail::Approx;
using std::numbers::pi;

namespace {

// The area of the surface from those of chords at two sizes of element: their error is of second order.
double extrapolated(const std::function<Mesh(Index cells)>& make, Index cells) {
  const double coarse = area(make(cells)), fine = area(make(2 * cells));
  CHECK(fine > coarse);
  return fine + (fine - coarse) / 3;
}

// A wedge of a ring in the plane, whose centre is at the origin: 0.2 to 0.5 m, 20 to 130 degrees.
Mesh wedge(Index cells) {
  Mesh mesh = annulus({0.2, 0.5, cells, 4, 110});
  mesh.map([](const Vec3& x) -> Vec3 {
    const double turn = 20 * pi / 180;
    return {std::cos(turn) * x.x() - std::sin(turn) * x.y(), std::sin(turn) * x.x() + std::cos(turn) * x.y(),
            0};
  });
  return mesh;
}

// Half angle of the cone: its sine is 0.6. The apex of the plane's cone is the origin.
const double half = std::asin(0.6) * 180 / pi;
const Wrap upwards{.radius = 0.3 * 0.6,
                   .angle = half,
                   .from = {1, 2, 3},
                   .axis = {0, 0.5, 0},
                   .towards = {0, 0, 1},
                   .at = {0, 0.3}};

}  // namespace

TEST_CASE("around a cylinder: places, lengths along and around, area, normals, warp", "[mesh][wrap]") {
  const double r = 0.07;
  const auto make = [&](Index cells) {
    Mesh mesh = rectangle(0.2, 0.35, cells, 5, {0.03, -0.1, 0});
    mesh.warp.assign(mesh.elements.size(), Vec3(0, 1, 0));
    wrap(mesh, {.radius = r, .from = {0.5, 0, 0}, .at = {0.13, 0}});
    return mesh;
  };
  const Mesh mesh = make(16);
  const Mesh flat = rectangle(0.2, 0.35, 16, 5, {0.03, -0.1, 0});
  const auto normals = node_normals(mesh);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const double angle = (flat.nodes[i].x() - 0.13) / r;
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    CHECK((mesh.nodes[i] - (Vec3(0.5, 0, flat.nodes[i].y()) + r * out)).norm() < 1e-15);
    CHECK(normals[i].dot(out) > std::cos(0.2 / 16 / r));  // within an element's angle, at the edges
  }
  for (std::size_t i = 0; i + 1 < 17; ++i)  // the length of the arc over a chord
    CHECK(2 * r * std::asin((mesh.nodes[i + 1] - mesh.nodes[i]).norm() / 2 / r) ==
          Approx(0.2 / 16).epsilon(1e-12));
  for (const Vec3& warp : mesh.warp) CHECK((warp - Vec3(0, 0, 1)).norm() < 1e-14);
  CHECK(extrapolated(make, 40) == Approx(0.2 * 0.35).epsilon(1e-7));
  CHECK_FALSE(mesh.flat);
  CHECK(check(mesh).ok());
}

TEST_CASE("around a cone: distances from the apex, angles about the axis, area, the opening either way",
          "[mesh][wrap]") {
  const auto make = [](const Wrap& shape) {
    return [shape](Index cells) {
      Mesh mesh = wedge(cells);
      wrap(mesh, shape);
      return mesh;
    };
  };
  const Mesh flat = wedge(22), mesh = make(upwards)(22);
  // The point at 0.3 m from the apex lies at `from`; the apex is 0.3 cos(half) below along the axis (y).
  const Vec3 apex = Vec3(1, 2, 3) - 0.3 * 0.8 * Vec3::UnitY();
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Vec3 x = mesh.nodes[i] - apex;
    const double s = flat.nodes[i].norm();
    CHECK(x.norm() == Approx(s).epsilon(1e-13));
    CHECK(x.y() == Approx(0.8 * s).epsilon(1e-13));
    // From the direction `towards` (z) to y x z = x.
    const double angle = (pi / 2 - std::atan2(flat.nodes[i].y(), flat.nodes[i].x())) / 0.6;
    CHECK(std::cos(std::atan2(x.x(), x.z()) - angle) == Approx(1).epsilon(1e-13));
  }
  const auto normals = node_normals(mesh);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Vec3 x = mesh.nodes[i] - apex;
    const Vec3 radial = Vec3(x.x(), 0, x.z()).normalized();
    CHECK(normals[i].dot(0.8 * radial - 0.6 * Vec3::UnitY()) > 0.99);
  }
  const double wanted = 110 * pi / 360 * (0.5 * 0.5 - 0.2 * 0.2);
  CHECK(extrapolated([](Index cells) { return wedge(cells); }, 80) == Approx(wanted).epsilon(1e-7));
  CHECK(extrapolated(make(upwards), 80) == Approx(wanted).epsilon(1e-6));
  // Narrower along the axis: the panel stands on its head.
  Mesh down = wedge(22);
  for (Vec3& x : down.nodes) x = Vec3(-x.x(), -x.y(), 0);
  wrap(down, {.radius = 0.18, .angle = -half, .at = {0, -0.3}});
  for (std::size_t i = 0; i < down.nodes.size(); ++i) {
    const Vec3 x = down.nodes[i] - Vec3(0, 0, 0.3 * 0.8);
    CHECK(x.norm() == Approx(flat.nodes[i].norm()).epsilon(1e-13));
    CHECK(x.z() == Approx(-0.8 * flat.nodes[i].norm()).epsilon(1e-13));
  }
  CHECK(check(down).measures.area == Approx(check(mesh).measures.area).epsilon(1e-12));
  const auto below = node_normals(down);
  for (std::size_t i = 0; i < down.nodes.size(); ++i)
    CHECK(below[i].dot(Vec3(down.nodes[i].x(), down.nodes[i].y(), 0).normalized()) > 0.7);
  // A small angle is nearly a cylinder.
  Mesh nearly = rectangle(0.2, 0.1, 8, 2), cylinder = nearly;
  wrap(nearly, {.radius = 0.05, .angle = 1e-4});
  wrap(cylinder, {.radius = 0.05});
  for (std::size_t i = 0; i < nearly.nodes.size(); ++i)
    CHECK((nearly.nodes[i] - cylinder.nodes[i]).norm() < 2e-6);
}

TEST_CASE("once around: the edges of the seam meet", "[mesh][wrap]") {
  const double r = 0.05;
  Mesh tube = rectangle(2 * pi * r, 0.1, 24, 4);
  wrap(tube, {.radius = r});
  for (std::size_t i = 0; i < 5; ++i)
    CHECK((tube.nodes[tube.set("left")[i]] - tube.nodes[tube.set("right")[i]]).norm() < 1e-15);
  // The wedge that becomes a whole cone: 360 sin(half) = 216 degrees.
  Mesh cone = annulus({0.2, 0.5, 36, 3, 216});
  cone.map([](const Vec3& x) -> Vec3 {
    const double turn = (90 - 108) * pi / 180;
    return {std::cos(turn) * x.x() - std::sin(turn) * x.y(), std::sin(turn) * x.x() + std::cos(turn) * x.y(),
            0};
  });
  wrap(cone, upwards);
  for (std::size_t i = 0; i < 4; ++i)
    CHECK((cone.nodes[cone.set("start")[i]] - cone.nodes[cone.set("end")[i]]).norm() < 1e-14);
}

TEST_CASE("the warp of a panel goes with a map and with joined meshes", "[mesh][wrap]") {
  const auto slanted = [] {
    Mesh mesh = rectangle(0.2, 0.1, 4, 3);
    mesh.warp.assign(mesh.elements.size(), Vec3(0.6, 0.8, 0));
    return mesh;
  };
  Mesh mesh = slanted();
  mesh.map([](const Vec3& x) -> Vec3 { return {2 * x.x(), x.y(), 0.5 * x.x()}; });
  for (const Vec3& warp : mesh.warp) CHECK((warp - Vec3(1.2, 0.8, 0.3).normalized()).norm() < 1e-14);
  const auto a = std::make_shared<Mesh>(slanted()), b = std::make_shared<Mesh>(rectangle(1, 1, 1, 1)),
             c = std::make_shared<Mesh>(cylinder({1, 1, 4, 1}));
  const Mesh both = join({{"a", a}, {"b", b}, {"c", c}});
  REQUIRE(both.warp.size() == 17);
  CHECK(both.warp[11] == Vec3(0.6, 0.8, 0));
  CHECK(both.warp[12] == Vec3(1, 0, 0));
  CHECK(both.warp[13] == Vec3(0, 0, 0));
  CHECK_FALSE(both.has_warp());
  CHECK(a->has_warp());
  CHECK(join({{"b", b}, {"c", c}}).warp.empty());
}

TEST_CASE("a mesh that cannot be wrapped is refused, and no node moves", "[mesh][wrap]") {
  const auto refused = [](const Wrap& shape, Index cells = 20) {
    Mesh mesh = rectangle(0.4, 0.2, cells, 4);
    const auto before = mesh.nodes;
    const std::string message = message_of([&] { wrap(mesh, shape); });
    CHECK(mesh.nodes == before);
    return message;
  };
  says(refused({.radius = 0.06}), "wrap: the panel goes around by 381.972 degrees: expected at most 360");
  CHECK(message_of([] {
          Mesh mesh = rectangle(0.4, 0.2, 20, 4);
          wrap(mesh, {.radius = 0.06, .overlap = true});
        }) == "no error");
  says(refused({.radius = 0.07}, 5), "wrap: element 1 spans 65.5 degrees: expected at most 60");
  says(refused({.radius = 0.05, .angle = 30, .at = {0.21, 0.17}}),
       "wrap: field 'cone': its apex lies in the panel, at (0.21, 0.07) in element ");
  says(refused({.radius = 0.05, .angle = -30, .at = {0.2, 0.05}}),
       "its apex lies in the panel, at (0.2, 0.15)");
  says(refused({.radius = 0}), "wrap: field 'radius': expected a positive length, m, got 0");
  says(refused({.radius = 1, .angle = 90}),
       "wrap: field 'angle': expected an angle between -90 and 90 degrees, got 90");
  says(refused({.radius = 1, .axis = {0, 0, 0}}), "wrap: field 'axis': expected a direction");
  says(refused({.radius = 1, .towards = {0, 0, 2}}),
       "wrap: field 'towards': expected a direction across the axis");
  says(message_of([&] {
         Mesh ring = annulus({0.2, 0.5, 36, 3, 300});
         wrap(ring, upwards);
       }),
       "wrap: field 'cone': the panel runs around its apex, at element ");
  Mesh mesh = rectangle(0.4, 0.2, 20, 4);
  wrap(mesh, {.radius = 0.1});
  says(message_of([&] { wrap(mesh, {.radius = 0.1}); }),
       "wrap: expected a mesh in the x-y plane, got node 22 at z = 0.05");
}
