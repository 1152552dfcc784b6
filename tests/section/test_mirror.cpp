// Which sections are symmetric about a plane across the surface.
#include <numbers>

#include "catch.hpp"
#include "section/section.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

constexpr double degree = std::numbers::pi / 180;

card::Card elastic(double warp, double weft, double shear, double nu12, double nu21) {
  card::Card c = test::svk();
  c.law = card::Svk{warp, weft, shear, nu12, nu21, {}, {}};
  return c;
}

section::Section single(const card::Card& card) { return section::integrated(card, card.thickness, 3, 0); }

}  // namespace

TEST_CASE("woven cloth is symmetric about planes along and across its yarns alone") {
  for (const card::Card& card : {test::blend(), test::duck(), test::svk()}) {
    const auto s = single(card);
    for (const double along : {0.0, 90.0, -90.0, 180.0, 270.0}) CHECK(section::mirrored(s, along * degree));
    for (const double between : {0.1, 17.0, 30.0, 45.0, 89.0, 135.0})
      CHECK_FALSE(section::mirrored(s, between * degree));
  }
}

TEST_CASE("cloth with like yarns is symmetric between them, an isotropic sheet about any plane") {
  const auto like = single(elastic(5e6, 5e6, 3e5, 0.2, 0.2));
  CHECK(section::mirrored(like, 45 * degree));
  CHECK(section::mirrored(like, -135 * degree));
  CHECK_FALSE(section::mirrored(like, 44 * degree));
  const auto isotropic = single(elastic(5e6, 5e6, 5e6 / 2.6, 0.3, 0.3));
  for (const double any : {0.0, 11.0, 45.0, 77.7}) CHECK(section::mirrored(isotropic, any * degree));
}

TEST_CASE("each ply must be symmetric") {
  const auto card = elastic(8e6, 3e6, 4e5, 0.1, 0.1);
  const auto stack = [&](std::vector<double> angles) {
    std::vector<section::Ply> plies;
    for (const double a : angles) plies.push_back({card, 0.2e-3, a});
    return section::stacked(plies, 2, 0);
  };
  CHECK(section::mirrored(stack({0, 90, 0}), 90 * degree));
  CHECK(section::mirrored(stack({25, 115}), 25 * degree));
  CHECK_FALSE(section::mirrored(stack({25, 115}), 0));
  CHECK_FALSE(section::mirrored(stack({0, 30}), 0));
  CHECK_FALSE(section::mirrored(stack({20, -20}), 0));  // the image has its plies in the other order
}

TEST_CASE("separate bending counts, too") {
  card::Card card = elastic(5e6, 5e6, 3e5, 0.2, 0.2);
  card.bending.emplace();
  card.bending->warp = card.bending->weft = 12e-6;
  card.bending->twist = 4e-6;
  CHECK(section::mirrored(single(card), 45 * degree));
  card.bending->weft = 9e-6;
  CHECK_FALSE(section::mirrored(single(card), 45 * degree));
  CHECK(section::mirrored(single(card), 90 * degree));
}

TEST_CASE("plies are numbered, and their common axes are those they have, or those of the section") {
  const auto card = elastic(8e6, 3e6, 4e5, 0.1, 0.1);
  const auto both = section::stacked({{card, 1e-4, 30}, {card, 2e-4, 30, "face"}}, 2, 0);
  CHECK_FALSE(both.turned_plies());
  CHECK(both.common_angle() == both.points[3].angle);
  CHECK(both.points[1].ply == 0);
  CHECK(both.points[2].ply == 1);
  const auto turned = section::stacked({{card, 1e-4, 30}, {card, 2e-4, 31}}, 1, 0);
  CHECK(turned.turned_plies());
  CHECK(turned.common_angle() == 0);
}
