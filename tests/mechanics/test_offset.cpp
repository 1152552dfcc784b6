// Gravity on a sheet whose reference surface is not its middle: the weight's line of action is the middle's.
#include <cmath>
#include <numbers>
#include <numeric>

#include "catch.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/cloth.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

struct Sheet {
  double width = 0.3, height = 0.2, thickness = 2e-3, offset = 0;
  int points = 3;
  Mat3 turn = Mat3::Identity();
  std::shared_ptr<model::Model> hung(const Vec3& gravity) const {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(width, height, 3, 2));
    mesh->map([&](const Vec3& X) { return Vec3(turn * X); });
    model::Options options;
    options.offset = offset;
    options.points = points;
    options.thickness = thickness;
    const Vec3 along = turn.col(0);
    options.warp = [along](const Vec3&) { return model::Direction(along); };
    auto m = std::make_shared<model::Model>(mesh, test::svk(), options);
    m->gravity(model::steady({gravity.x(), gravity.y(), gravity.z()}));
    return m;
  }
};

}  // namespace

TEST_CASE("gravity's moment is the weight's about the reference surface, for an offset to either side") {
  const Vec3 g(3, -7, 5);  // m/s2
  for (const double offset : {-1.0, -0.4, 0.7}) {
    Sheet sheet;
    sheet.offset = offset;
    sheet.turn =
        Eigen::AngleAxisd(143 * std::numbers::pi / 180, Vec3(1, 2, -2).normalized()).toRotationMatrix();
    const auto m = sheet.hung(g);
    mechanics::Assembly a(*m);
    const double mass = 590 * sheet.thickness * sheet.width * sheet.height;
    // Of all loads on directors and nodes at the reference: force, and moment about the reference surface's
    // middle.
    std::vector<double> external;
    a.terms().external(0, external);
    a.begin_iterate();
    REQUIRE(a.forces({}));
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    const Vec3 middle = sheet.turn * Vec3(sheet.width / 2, sheet.height / 2, 0);
    const auto on_d = a.internal().on_d;
    const Vec3 n = sheet.turn.col(2);
    for (std::size_t i = 0; i < a.dofs().reference().size(); ++i) {
      // The undeformed cloth has no forces of its own: what is on the directors is the load's, with the sign
      // of a residual.
      moment -= n.cross(Vec3(on_d[3 * i], on_d[3 * i + 1], on_d[3 * i + 2]));
      force += a.cloth().mass()[i] * g;
      moment += (a.dofs().reference()[i] - middle).cross(a.cloth().mass()[i] * g);
    }
    CHECK((force - mass * g).norm() < 1e-13 * mass * g.norm());
    // The middle surface lies at -offset t / 2 along the normal: its weight has that lever.
    const Vec3 wanted = mass * (-offset * sheet.thickness / 2 * n).cross(g);
    CHECK((moment - wanted).norm() < 1e-12 * wanted.norm());
    // The ledger takes the same moments, with the sign of a load.
    std::vector<double> on_x(3 * a.dofs().reference().size()), load(on_x);
    for (const auto* follower : a.terms().all<mechanics::FollowerLoad>())
      follower->add_follower(0, a.trial(), on_x, load);
    double largest = 0, differs = 0;
    for (std::size_t i = 0; i < load.size(); ++i) {
      largest = std::max(largest, std::abs(load[i]));
      differs = std::max(differs, std::abs(load[i] + on_d[i]));
    }
    CHECK(differs < 1e-12 * largest);
    CHECK(largest > 0);
  }
}

TEST_CASE("rotary inertia is that of the thickness about the reference surface, for any points and offset") {
  for (const int points : {1, 2, 5})
    for (const double offset : {-1.0, 0.0, 0.7}) {
      Sheet sheet;
      sheet.points = points;
      sheet.offset = offset;
      const auto m = sheet.hung(Vec3::Zero());
      const mechanics::Assembly a(*m);
      const auto& rotary = a.cloth().rotary_inertia(false);
      const double t = sheet.thickness, mass = 590 * t * sheet.width * sheet.height;
      const double wanted = mass * (t * t / 12 + std::pow(offset * t / 2, 2));
      CHECK(std::accumulate(rotary.begin(), rotary.end(), 0.0) == Approx(wanted).epsilon(1e-12));
    }
}
