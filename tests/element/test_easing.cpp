// The strain of yarns that cross a quadrilateral obliquely (the top of src/element/shell4.hpp).
#include <numbers>

#include "catch.hpp"
#include "one_batch.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using test::Quadrilateral;

namespace {

constexpr double kHeld = 20;  // yarn over shear up to which nothing is eased

// Eight equal rectangles 10 mm x 6 mm whose warp is at an angle (degrees) to the first side, eased or not.
struct Turned : test::RandomBatch<Quadrilateral> {
  Turned(const card::Card& card, double angle, bool eased, double skew = 0) : RandomBatch(card, 1) {
    if (!eased) section.yarns_over_shear = {0, 0};
    const double a = angle * std::numbers::pi / 180;
    const Vec3 warp(std::cos(a), std::sin(a), 0);
    for (int l = 0; l < lanes; ++l) {
      for (int n = 0; n < 4; ++n) {
        X[l][n] = Vec3(0.01 * square[n].x() + skew * square[n].y(), 0.006 * square[n].y(), 0);
        D[l][n] = Vec3::UnitZ();
      }
      Quadrilateral::geometry(
          section, X[l], D[l], [&](const Vec3&, const Vec3&) { return warp; }, geometry.data(), l, lanes);
    }
    rest();
    sharing = Quadrilateral::sharing(section, geometry.data());
  }
  // Strain i of the four points of the first lane.
  std::array<double, 4> strain(int i) {
    const auto E = strains();
    std::array<double, 4> out{};
    for (std::size_t g = 0; g < 4; ++g) out[g] = E[(5 * g + static_cast<std::size_t>(i)) * lanes];
    return out;
  }
};

double mean(const std::array<double, 4>& v) { return (v[0] + v[1] + v[2] + v[3]) / 4; }

// The same arbitrary deformation of both.
void deform_alike(Turned& one, Turned& other) {
  one.random.seed(7);
  one.deform(0.03);
  other.x = one.x;
  other.d = one.d;
  other.basis();
}

// sin^2 of twice the angle that a yarn at an angle to the first side has in the square to which the rectangle
// is mapped.
double obliqueness(double angle) {
  const double a = angle * std::numbers::pi / 180, on_square = std::atan2(std::sin(a) / 6, std::cos(a) / 10);
  return std::pow(std::sin(2 * on_square), 2);
}

}  // namespace

TEST_CASE("yarns along the sides of a rectangle: strains and forces are those without easing, bit for bit") {
  for (const auto& card : {test::blend(), test::duck(), test::muslin(), test::denim()})
    for (const double angle : {0.0, 90.0}) {
      Turned eased(card, angle, true), full(card, angle, false);
      REQUIRE(eased.section.yarns_over_shear[0] > kHeld);
      deform_alike(eased, full);
      CHECK(eased.strains() == full.strains());
      CHECK(eased.force() == full.force());
      CHECK(eased.tangent(3) == full.tangent(3));
    }
}

TEST_CASE("isotropic sheets are not eased at any angle") {
  card::Card card = test::svk();
  card.law = card::Svk{30e6, 30e6, 30e6 / 2.8, 0.4, 0.4, {}, {}};
  for (const double angle : {17.0, 45.0}) {
    Turned eased(card, angle, true), full(card, angle, false);
    deform_alike(eased, full);
    CHECK(eased.strains() == full.strains());
  }
}

TEST_CASE(
    "oblique yarns keep the mean of their strain and the stated share of its variation; shear keeps all") {
  for (const double angle : {3.0, 20.0, 45.0, 71.0}) {
    Turned eased(test::duck(), angle, true), full(test::duck(), angle, false);
    deform_alike(eased, full);
    for (const int axis : {0, 1}) {
      const double excess =
          std::max(0.0, eased.section.yarns_over_shear[static_cast<std::size_t>(axis)] / kHeld - 1);
      const double share = 1 / std::sqrt(1 + obliqueness(angle + 90 * axis) * excess);
      const auto got = eased.strain(axis), all = full.strain(axis);
      for (std::size_t g = 0; g < 4; ++g)
        CHECK_THAT(got[g], Catch::Matchers::WithinAbs(mean(all) + share * (all[g] - mean(all)), 1e-14));
    }
    const auto got = eased.strain(4), all = full.strain(4);
    for (std::size_t g = 0; g < 4; ++g) CHECK_THAT(got[g], Catch::Matchers::WithinAbs(all[g], 1e-14));
  }
}

TEST_CASE("yarns a million times as stiff as shear leave an element its six rigid modes and no other one") {
  const card::Card card =
      test::make_card({"stiff", {2000}, {3000}, {4e-3}, 2000, 3000, 5e-3, 0, 0, 0.4, 900, 3, 3});
  for (const double angle : {0.0, 1.0, 10.0, 30.0, 45.0, 59.0})
    for (const double skew : {0.0, 0.004}) {
      Turned shell(card, angle, true, skew);
      Eigen::MatrixXd K = shell.tangent(0);
      // In the plane, in units of the stiffness of shear: 2 kPa times the thickness.
      std::vector<int> plane;
      for (int a = 0; a < 4; ++a)
        for (int i = 0; i < 2; ++i) plane.push_back(5 * a + i);
      const Eigen::MatrixXd in_plane = K(plane, plane) / (2e3 * card.thickness);
      const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(in_plane).eigenvalues();
      INFO(angle << " degrees, skew " << skew << ": " << values.transpose());
      CHECK(std::abs(values[2]) < 1e-8);  // of stiffnesses of 1e6
      CHECK(values[3] > 0.05);
    }
}

TEST_CASE("easing goes over smoothly from yarns along the sides to oblique ones") {
  const auto energy_at = [](double angle) {
    Turned shell(test::blend(), angle, true), other(test::blend(), angle, true);
    deform_alike(shell, other);
    shell.force();
    return shell.energy(0);
  };
  // The jump over a small angle falls with the angle: no step at 0 nor anywhere else.
  for (const double angle : {0.0, 0.5, 30.0, 44.9}) {
    const double wide = std::abs(energy_at(angle + 1e-2) - energy_at(angle)),
                 near = std::abs(energy_at(angle + 1e-3) - energy_at(angle));
    CHECK(near < 0.2 * wide);
  }
}
