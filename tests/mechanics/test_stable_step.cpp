// The bound of the frequencies of a mesh against all of its frequencies, from a dense matrix.
#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <random>

#include "catch.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/rate_bound.hpp"
#include "mechanics/terms/cloth.hpp"
#include "mesh/panel.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

card::Card isotropic(double young, double poisson, double thickness) {
  card::Card c = test::svk();
  c.law = card::Svk{young, young, young / 2 / (1 + poisson), poisson, poisson, {}, {}};
  c.thickness = thickness;
  c.density = 430;
  return c;
}

// A sheet of skewed cells of this ratio, whose nodes are moved by a share of the cells.
std::shared_ptr<mesh::Mesh> crooked(bool triangles, double ratio, double noise, double skew) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.06, 0.06 / ratio, 3, 4));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  mesh->map([&](const Vec3& X) {
    return Vec3(X.x() + noise * 0.02 * number(random) + skew * X.y(),
                X.y() + noise * 0.015 / ratio * number(random), 0);
  });
  if (!triangles) return mesh;
  const auto whole = mesh->elements;
  mesh->elements.clear();
  for (const auto& [a, b, c, d] : whole) {
    mesh->elements.push_back({a, b, d, -1});
    mesh->elements.push_back({b, c, d, -1});
  }
  return mesh;
}

std::shared_ptr<model::Model> sheet(std::shared_ptr<mesh::Mesh> mesh, const card::Card& card) {
  model::Options options;
  options.warp = [](const Vec3&) { return model::Direction(Vec3(1, 0.3, 0)); };
  return std::make_shared<model::Model>(std::move(mesh), card, options);
}

// 1/s^2: the square of the highest frequency at the trial configuration.
double highest(mechanics::Assembly& a, bool scaled) {
  linear::Matrix K;
  REQUIRE(a.tangent({}, K, {}, {}));
  const auto mass = a.lumped_mass(scaled);
  const auto n = static_cast<Eigen::Index>(mass.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index c = 0; c < n; ++c)
    for (auto e = K.pattern->column[c]; e < K.pattern->column[c + 1]; ++e)
      A(K.pattern->row[e], c) = K.value[e] / std::sqrt(mass[c] * mass[K.pattern->row[e]]);
  return A.eigenvalues().cwiseAbs().maxCoeff();
}

// The bound over the highest frequency; at least one.
double excess(mechanics::Assembly& a, bool scaled) {
  const auto added = mechanics::added_rates(a, scaled);
  return std::sqrt(mechanics::rate_bound(a, scaled, added) / highest(a, scaled));
}

double excess(const model::Model& m, bool scaled) {
  m.validate();
  mechanics::Assembly a(m);
  if (scaled) a.terms().elements().scale_mass(false);
  return excess(a, scaled);
}

}  // namespace

TEST_CASE("no frequency of a mesh is above the bound, and the bound is not far above the highest") {
  for (const double poisson : {0.0, 0.35})
    for (const bool triangles : {false, true})
      for (const double ratio : {1.0, 3.0, 11.0, 30.0})
        for (const double noise : {0.0, 0.12})
          for (const double skew : {0.0, -0.7})
            for (const bool scaled : {true, false}) {
              CAPTURE(poisson, triangles, ratio, noise, skew, scaled);
              const auto m = sheet(crooked(triangles, ratio, noise, skew), isotropic(7e6, poisson, 0.6e-3));
              const double over = excess(*m, scaled);
              CHECK(over > 1 - 1e-6);                 // B is a difference of strains
              CHECK(over < (triangles ? 1.8 : 1.7));  // thin triangles have next to no shear in their edges
            }
}

TEST_CASE("the usual step is below the bound on triangles of any ratio, whose inertia sees to it") {
  for (const double ratio : {1.0, 2.0, 5.0, 13.0, 30.0}) {
    CAPTURE(ratio);
    const auto m = sheet(crooked(true, ratio, 0.1, 0.2), isotropic(9e6, 0.25, 0.4e-3));
    m->validate();
    mechanics::Assembly a(*m);
    a.terms().elements().scale_mass(false);
    const double usual = 0.7 * a.terms().stable_step(true);
    CHECK(usual * usual * highest(a, true) < 4);
    CHECK(usual * usual * mechanics::rate_bound(a, true, {}) < 4 * 0.9 * 0.9);
    // Only as much inertia as that takes, and not where it is not needed.
    const auto &more = a.cloth().rotary_inertia(true), &mass = a.cloth().mass();
    const double longest = 0.02 * 0.02 * 1.5;
    for (std::size_t n = 0; n < mass.size(); ++n) CHECK(more[n] < mass[n] * longest / 12);
  }
}

TEST_CASE("short elements of a rim share the masses beside them, and the step is still a stable one") {
  const auto line = [](double x, double y, double u, double v) {
    return mesh::OutlinePiece{mesh::PlaneCurve::line({x, y}, {u, v})};
  };
  for (const bool triangles : {false, true})
    for (const double grain : {0.0, 25.0})
      for (const double poisson : {0.0, 0.4}) {
        CAPTURE(triangles, grain, poisson);
        mesh::Panel shape;
        shape.outline = {line(0, 0, 0.21, 0.02), line(0.21, 0.02, 0.16, 0.19), line(0.16, 0.19, 0.03, 0.17),
                         line(0.03, 0.17, 0, 0)};
        shape.size = 0.03;
        shape.grain = grain;
        shape.triangles = triangles;
        auto mesh = std::make_shared<mesh::Mesh>(mesh::panel(shape));
        const auto card = isotropic(8e6, poisson, 0.5e-3);
        const auto m = std::make_shared<model::Model>(std::move(mesh), card, model::Options{});
        m->validate();
        mechanics::Assembly a(*m);
        a.terms().elements().scale_mass(false);
        const double speed = std::sqrt(8e6 / (1 - poisson) / 430), step = a.terms().stable_step(true);
        CHECK(step > 1.08 * a.cloth().rates().smallest_size() / speed);
        CHECK(0.7 * 0.7 * step * step * highest(a, true) < 4 * 0.9 * 0.9);
        CHECK(excess(a, true) > 1 - 1e-6);
        CHECK(excess(a, true) < 1.6);
      }
}

TEST_CASE("the bound holds for woven cloth, layers, separate bending and stiff transverse shear") {
  auto bending = isotropic(5e6, 0.2, 0.5e-3);
  bending.bending = card::Bending{};
  bending.bending->warp = 3e-3;
  bending.bending->weft = 1e-3;
  bending.bending->twist = 2e-3;
  auto stiff = isotropic(2e6, 0.1, 0.5e-3);
  auto law = std::get<card::Svk>(stiff.law);
  law.g13 = 9e7;
  law.g23 = 6e7;
  stiff.law = law;
  auto sheared = isotropic(1e6, 0.1, 0.5e-3);
  auto hard = std::get<card::Svk>(sheared.law);
  hard.shear = 4e7;
  hard.g13 = hard.g23 = 1e5;
  sheared.law = hard;
  for (const bool triangles : {false, true})
    for (const bool scaled : {true, false})
      for (const auto& card : {test::blend(), test::muslin(), bending, stiff, sheared}) {
        CAPTURE(card.name, triangles, scaled);
        const double over = excess(*sheet(crooked(triangles, 2.5, 0.1, 0.3), card), scaled);
        CHECK(over > 1 - 1e-6);
        CHECK(over <
              (triangles ? 9.5 : 8));  // the stiffest tangent of a woven law is not that of the virgin cloth
      }
}

TEST_CASE("springs, pressure and moments are in the bound, and springs on held nodes are not") {
  for (const bool triangles : {false, true})
    for (const int load : {0, 1, 2}) {
      CAPTURE(triangles, load);
      const auto m = sheet(crooked(triangles, 1.5, 0.1, 0.2), isotropic(4e6, 0.3, 0.5e-3));
      if (load == 0) m->add<model::GroundSpring>({"all", {1e5, 0, 3e5}});
      if (load == 1) m->pressure("all", history::History::constant(2e5));
      if (load == 2) m->add<model::MomentLoad>({"right", model::steady({0, 0.4, 0.15})});
      m->validate();
      mechanics::Assembly a(*m);
      a.set_time(0);
      const double over = excess(a, true);
      CHECK(over > 1 - 1e-6);
      CHECK(over < 1.8);
      CHECK(mechanics::rate_bound(a, true, mechanics::added_rates(a, true)) >
            1.2 * mechanics::rate_bound(a, true, {}));
    }
  const auto held = sheet(crooked(false, 1, 0, 0), isotropic(4e6, 0.3, 0.5e-3));
  held->add<model::GroundSpring>({"all", {3e8, 0, 1e9}});
  held->fix("all", model::parse_freedoms("x y z"));
  held->validate();
  const mechanics::Assembly a(*held);
  CHECK(mechanics::added_rates(a, true).empty());
}

TEST_CASE("the bound follows a sheet that is stretched, sheared and turned") {
  for (const bool triangles : {false, true})
    for (const double stretch : {1.3, 2.0, 3.5}) {
      CAPTURE(triangles, stretch);
      const auto m = sheet(crooked(triangles, 2, 0.08, 0.3), isotropic(4e6, 0.3, 0.5e-3));
      m->validate();
      mechanics::Assembly a(*m);
      Mat3 F = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
      F = F * (Mat3() << stretch, 0.2, 0, 0, 0.8 + stretch / 4, 0, 0, 0, 1).finished();
      const Vec3 normal = F.col(0).cross(F.col(1)).normalized();
      for (std::size_t n = 0; n < a.dofs().reference().size(); ++n) {
        Eigen::Map<Vec3>(a.state().x().data() + 3 * n) = F * a.dofs().reference()[n];
        Eigen::Map<Vec3>(a.state().d().data() + 3 * n) = normal;
        Eigen::Map<Vec3>(a.state().b1().data() + 3 * n) = F.col(0).normalized();
      }
      a.state().touch();
      const double over = excess(a, true);
      CHECK(over > 1 - 1e-6);
      CHECK(over < 2.1);
    }
}

TEST_CASE("the bound holds for cloth tied to a lead whose frame is oblique") {
  for (const double angle : {0.0, 45.0, 100.0}) {
    CAPTURE(angle);
    auto mesh = crooked(false, 1, 0.1, 0);
    mesh->define("pair", mesh::NodeSet{5, 6});
    mesh->define("lead", mesh::NodeSet{5});
    const auto m = sheet(mesh, isotropic(4e6, 0.3, 0.5e-3));
    model::FixedFreedoms z = model::parse_freedoms("z");
    m->fix("lead", z, Mat3(Eigen::AngleAxisd(angle / 57.3, Vec3(0.2, 0.3, 1).normalized())));
    m->add<model::Tie>({model::TieKind::equal, "pair", "", model::parse_freedoms("x y z")});
    m->validate();
    mechanics::Assembly a(*m);
    CHECK(excess(a, true) > 1 - 1e-6);
  }
}
