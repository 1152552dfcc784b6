// Directions of warp and weft on elements of any shape: what the deformation makes of the material's
// directions.
#include <numbers>

#include "catch.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/cloth.hpp"
#include "message_of.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

constexpr double degree = std::numbers::pi / 180;

// Quadrilaterals none of which is a parallelogram.
Vec3 askew(const Vec3& X) {
  return {X.x() * (0.5 + 9 * X.y()) + 0.1 * X.y(), X.y() * (1.3 - 8 * X.x()) + 3 * X.x() * X.x(), 0};
}

std::shared_ptr<mesh::Mesh> skewed(bool triangles) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.04, 0.05, 3, 4));
  mesh->map(askew);
  if (!triangles) return mesh;
  const auto whole = mesh->elements;
  mesh->elements.clear();
  for (const auto& e : whole) {
    mesh->elements.push_back({e[0], e[1], e[2], -1});
    mesh->elements.push_back({e[0], e[2], e[3], -1});
  }
  return mesh;
}

void deform(mechanics::Assembly& a, const Mat3& F) {
  auto x = a.state().x();
  for (std::size_t n = 0; n < a.dofs().reference().size(); ++n)
    at(x, static_cast<mechanics::Index>(n)) = F * a.dofs().reference()[n];
  a.state().touch();
}

Vec3 at_angle(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

}  // namespace

TEST_CASE("warp and weft are carried by a homogeneous deformation, whatever the shape of the elements") {
  Mat3 F;
  F << 1.3, 0.4, 0, -0.2, 0.8, 0, 0.5, 0.1, 1;
  for (const bool triangles : {false, true})
    for (const int points : {1, 2, 5}) {
      model::Options options;
      options.points = points;
      options.warp = [](const Vec3&) { return model::Direction(23.0); };
      const model::Model m(skewed(triangles), test::svk(), options);
      mechanics::Assembly a(m);
      const Vec3 warp = at_angle(23 * degree), weft = at_angle(113 * degree);
      for (mechanics::Index e = 0; e < a.cloth().elements(); ++e) {
        const auto rest = a.cloth().readings().yarns(e);
        CHECK((rest.first - warp).norm() < 1e-13);
        CHECK((rest.second - weft).norm() < 1e-13);
      }
      deform(a, F);
      for (mechanics::Index e = 0; points == 1 && e < a.cloth().elements(); ++e) {
        const auto now = a.cloth().readings().yarns(e);
        CHECK((now.first - (F * warp).normalized()).norm() < 1e-13);
        CHECK((now.second - (F * weft).normalized()).norm() < 1e-13);
      }
    }
}

TEST_CASE("plies have yarns of their own, and all together the axes of the model if theirs differ") {
  Mat3 F = Mat3::Identity();
  F(0, 1) = 0.35;
  F(1, 1) = 1.1;
  model::Options options;
  options.points = 2;
  options.warp = [](const Vec3&) { return model::Direction(-15.0); };
  options.plies = {{test::svk(), 2e-4, 0}, {test::svk(), 1e-4, 65}, {test::svk(), 3e-4, 90}};
  const model::Model m(skewed(false), test::svk(), options);
  mechanics::Assembly a(m);
  deform(a, F);
  const auto is = [&](std::pair<Vec3, Vec3> got, double angle) {
    CHECK((got.first - (F * at_angle(angle * degree)).normalized()).norm() < 1e-13);
    CHECK((got.second - (F * at_angle((angle + 90) * degree)).normalized()).norm() < 1e-13);
  };
  for (mechanics::Index e = 0; e < a.cloth().elements(); ++e) {
    is(a.cloth().readings().yarns(e, 0), -15);
    is(a.cloth().readings().yarns(e, 1), 50);
    is(a.cloth().readings().yarns(e, 2), 75);
    is(a.cloth().readings().yarns(e), -15);
  }
}

TEST_CASE("on a curved sheet the yarns follow the layer at which they are read") {
  // A cylinder of radius 6 mm about y, thick as cloth, warp at 30 degrees to its axis.
  const double R = 0.006;
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.01, 0.01, 8, 5));
  mesh->map([&](const Vec3& X) { return Vec3(R * std::sin(X.x() / R), X.y(), R * std::cos(X.x() / R)); });
  model::Options options;
  options.points = 2;
  const double angle = 30 * degree;
  options.warp = [&](const Vec3& X) {
    const Vec3 round = Vec3(X.z(), 0, -X.x()).normalized();
    return model::Direction(Vec3(std::cos(angle) * Vec3::UnitY() + std::sin(angle) * round));
  };
  const model::Model m(mesh, test::svk(), options);
  const mechanics::Assembly a(m);
  for (mechanics::Index e = 0; e < a.cloth().elements(); ++e)
    CHECK(std::abs(std::acos(a.cloth().readings().yarns(e).first.y()) - angle) < 0.1 * degree);
}

TEST_CASE("a fault of an element is told apart from an error of a warp function") {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.02, 0.01, 2, 1));
  const auto fails = [&](const model::Options& options) {
    return message_of([&] {
      const model::Model m(mesh, test::svk(), options);
      const mechanics::Assembly a(m);
    });
  };
  model::Options options;
  options.warp = [](const Vec3&) -> model::Direction { throw Error("is not known here"); };
  CHECK(fails(options) == "is not known here");
  options.warp = [](const Vec3&) { return model::Direction(0.0); };
  mesh->nodes[5] = Vec3(0.008, -0.004, 0);  // beyond the diagonal of the second element
  says(fails(options), "mesh: element 2 is degenerate or inverted: its Jacobian is ");
}
