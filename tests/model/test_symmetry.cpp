// Planes of symmetry as declared: where they lie, and what cloth they suit.
#include "catch.hpp"
#include "message_of.hpp"
#include "model/model.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

std::shared_ptr<mesh::Mesh> quarter() {
  return std::make_shared<mesh::Mesh>(mesh::rectangle(0.04, 0.03, 4, 3));
}

model::Options warp(const model::Direction& direction) {
  model::Options options;
  options.warp = [direction](const Vec3&) { return direction; };
  return options;
}

std::string refused(model::Model& m, const char* set, int axis) {
  m.add(model::symmetry(set, axis));
  return message_of([&] { m.validate(); });
}

std::string refused(const model::Options& options, const char* set = "left", int axis = 0) {
  model::Model m(quarter(), test::blend(), options);
  return refused(m, set, axis);
}

}  // namespace

TEST_CASE("a plane of symmetry takes cloth whose yarns run along and across it") {
  for (const double along : {0.0, 90.0, 180.0, -90.0}) {
    CHECK(refused(warp(along)) == "no error");
    CHECK(refused(warp(along), "bottom", 1) == "no error");
  }
  CHECK(refused(warp(25.0)) ==
        "symmetry: set 'left': the cloth of element 1 is not symmetric about the plane, whose normal lies at "
        "25 degrees to "
        "the warp: expected warp and weft along and across the plane; or the whole model");
  says(refused(warp(Vec3(1, 2, 0)), "bottom", 1), "whose normal lies at 26.57 degrees to the warp");
}

TEST_CASE("directions are looked at where the cloth meets the plane, and there alone") {
  // Towards the corner, where it has no direction; and round about it.
  model::Options radial, fan;
  radial.warp = [](const Vec3& X) { return model::Direction(Vec3(X.x(), X.y(), 0)); };
  fan.warp = [](const Vec3& X) { return model::Direction(X.x() < 0.011 ? 90.0 : 30.0); };
  model::Model m(quarter(), test::blend(), radial);
  m.add(model::symmetry("left", 0));
  CHECK(refused(m, "bottom", 1) == "no error");
  CHECK(refused(fan) == "no error");
  says(refused(fan, "bottom", 1), "the cloth of element 2 is not symmetric");
}

TEST_CASE("regions and plies count each for itself") {
  auto mesh = quarter();
  mesh->define("patch", [](const Vec3& X) { return X.x() < 0.011 && X.y() < 0.011; });
  mesh->define("far", [](const Vec3& X) { return X.x() > 0.019; });
  const auto body = [&](const char* set) {
    return model::BodyGiven{"", mesh, test::blend(), warp(0.0), {{set, test::blend(), warp(40.0)}}};
  };
  model::Model patched({body("patch")}), beside({body("far")});
  says(refused(patched, "left", 0), "the cloth of element 1 is not symmetric");
  CHECK(refused(beside, "left", 0) == "no error");
  model::Options plies = warp(0.0);
  plies.plies = {{test::blend(), 2e-4, 0}, {test::blend(), 2e-4, 90}};
  CHECK(refused(plies) == "no error");
  plies.plies[1].angle = 50;
  says(refused(plies), "along and across the plane, in each layer; or the whole model");
}

TEST_CASE("the set of a plane of symmetry lies in a plane") {
  CHECK(refused(warp(0.0), "bottom", 0) ==
        "symmetry: set 'bottom': expected nodes in a plane normal to x, got x from 0 to 0.04 m");
  CHECK(refused(warp(30.0), "all", 2) == "no error");  // a sheet that lies in the plane itself
  model::Model m(quarter(), test::blend(), warp(0.0));
  m.add(model::symmetry("left", 0));
  m.add(model::symmetry("right", 0));
  m.fix("bottom", model::parse_freedoms("y rx rz"));
  const auto planes = model::symmetry_planes(m);
  REQUIRE(planes.size() == 2);
  CHECK(planes[1].words() == "the plane of symmetry x = 0.04 m of set 'right'");
}

TEST_CASE("plies go by number and by name") {
  model::Options plies = warp(0.0);
  plies.plies = {{test::blend(), 2e-4, 0}, {test::blend(), 3e-4, 90, "face"}};
  model::Model m(
      {{"a", quarter(), test::blend(), plies, {}}, {"b", quarter(), test::blend(), warp(0.0), {}}});
  CHECK(m.plies() == std::vector<std::string>{"ply1", "ply2", "face"});
  CHECK(m.ply_of(0, "face") == 1);
  CHECK(m.ply_of(0, "ply2") == 1);
  CHECK(m.ply_of(12, "ply1") == 0);
  CHECK(m.ply_of(12, "face") == -1);
  CHECK(m.ply_of(0, "") == -1);
}
