// Several bodies in one model, and regions with a card of their own.
#include <numeric>

#include "base/error.hpp"
#include "catch.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/cloth.hpp"
#include "message_of.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

std::shared_ptr<mesh::Mesh> sheet(double width, double height, int nx, int ny, double z = 0) {
  return std::make_shared<mesh::Mesh>(mesh::rectangle(width, height, nx, ny, Vec3(0, 0, z)));
}

// Internal forces on the nodes after every node went by a field of its own.
std::vector<double> forces_of(const model::Model& m) {
  mechanics::Assembly a(m);
  std::vector<double> step(a.dofs().unknowns());
  for (std::size_t n = 0; n < a.dofs().reference().size(); ++n) {
    const Vec3& X = a.dofs().reference()[n];
    const double move[5] = {0.05 * X.x() * X.x(), 0.02 * X.y(), 0.01 * std::sin(20 * X.x()), 0.02 * X.y(),
                            0.01};
    for (int i = 0; i < 5; ++i)
      if (const auto eq = a.dofs().freedoms().nodes[n].equation[i]; eq >= 0) step[eq] = move[i];
  }
  a.begin_iterate();
  a.apply_increment(step, 1, {});
  REQUIRE(a.forces({}));
  std::vector<double> all(a.internal().on_x.begin(), a.internal().on_x.end());
  all.insert(all.end(), a.internal().on_d.begin(), a.internal().on_d.end());
  return all;
}

}  // namespace

TEST_CASE("bodies side by side have the forces that each has alone") {
  auto front = sheet(0.3, 0.1, 7, 3), back = sheet(0.2, 0.2, 4, 5, 0.01);
  const auto one = forces_of(model::Model(front, test::blend(), {}));
  const auto two = forces_of(model::Model(back, test::svk(), {}));
  const auto both =
      forces_of(model::Model({{"front", front, test::blend(), {}, {}}, {"back", back, test::svk(), {}, {}}}));
  const std::size_t n = one.size() / 2, k = two.size() / 2;
  REQUIRE(both.size() == one.size() + two.size());
  const auto part = [&](std::size_t from, std::size_t count) {
    return std::vector<double>(both.begin() + static_cast<long>(from),
                               both.begin() + static_cast<long>(from + count));
  };
  CHECK(part(0, n) == std::vector<double>(one.begin(), one.begin() + static_cast<long>(n)));
  CHECK(part(n, k) == std::vector<double>(two.begin(), two.begin() + static_cast<long>(k)));
  CHECK(part(n + k, n) == std::vector<double>(one.begin() + static_cast<long>(n), one.end()));
}

TEST_CASE("a region of the same card changes nothing, one of another card its own elements") {
  auto mesh = sheet(0.3, 0.1, 6, 4);
  mesh->define("pocket", [](const Vec3& X) { return X.x() > 0.149; });
  const auto plain = forces_of(model::Model(mesh, test::blend(), {}));
  const auto same = forces_of(model::Model({{"", mesh, test::blend(), {}, {{"pocket", test::blend(), {}}}}}));
  CHECK(same == plain);

  model::Options thick;
  thick.thickness = 3 * test::blend().thickness;
  const model::Model m({{"", mesh, test::blend(), {}, {{"pocket", test::blend(), thick}}}});
  mechanics::Assembly a(m);
  const double areal = test::blend().density * test::blend().thickness;
  const double mass = std::accumulate(a.cloth().mass().begin(), a.cloth().mass().end(), 0.0);
  CHECK(mass == Approx(areal * (0.015 + 3 * 0.015)).epsilon(1e-13));
  const auto other = forces_of(m);
  for (std::size_t i = 0; i < mesh->nodes.size(); ++i) {
    INFO("node " << i + 1);
    if (mesh->nodes[i].x() < 0.12) CHECK(other[3 * i] == plain[3 * i]);
    // The thickness stays out of the membrane strains: three times the force.
    if (mesh->nodes[i].x() > 0.18) CHECK(other[3 * i] == Approx(3 * plain[3 * i]).epsilon(1e-2).margin(1e-9));
  }
}

TEST_CASE("sets of bodies go by the body's name, those made later too") {
  auto front = sheet(0.3, 0.1, 3, 2), back = sheet(0.2, 0.2, 2, 2);
  model::Model m({{"front", front, test::blend(), {}, {}}, {"back", back, test::svk(), {}, {}}});
  const auto first = static_cast<mesh::Index>(front->nodes.size());
  CHECK(m.mesh().set("front.left") == front->set("left"));
  CHECK(m.mesh().set("back.left").front() == first + back->set("left").front());
  CHECK(m.mesh().set("all").size() == front->nodes.size() + back->nodes.size());
  back->define("corner", mesh::NodeSet{0});
  CHECK(m.mesh().set("back.corner") == mesh::NodeSet{first});
  back->define("corner", mesh::NodeSet{1, 2});
  CHECK(m.mesh().set("back.corner") == mesh::NodeSet{first + 1, first + 2});
  CHECK(
      message_of([&] { m.fix("back.lef", model::parse_freedoms("x")); }) ==
      "unknown set 'back.lef', did you mean 'back.left'? known sets: all, back.all, back.bottom, "
      "back.boundary, "
      "back.corner, back.corners, back.left, back.right, back.top, front.all, front.bottom, front.boundary, "
      "front.corners, front.left, front.right, front.top");
  CHECK(m.element_name(0) == "1 of body front");
  CHECK(m.element_name(7) == "2 of body back");
  m.seal();
  CHECK_THROWS_AS(back->define("corner", mesh::NodeSet{3}), Error);
}

TEST_CASE("bodies and regions that cannot be are refused") {
  auto mesh = sheet(0.3, 0.1, 3, 2);
  const auto card = test::blend();
  const auto refusal = [&](std::vector<model::BodyGiven> bodies) {
    return message_of([&] { model::Model m(std::move(bodies)); });
  };
  CHECK(refusal({}) == "model: field 'bodies': expected at least one body, got none");
  CHECK(refusal({{"a", mesh, card, {}, {}}, {"a", mesh, card, {}, {}}}) ==
        "bodies: expected different names, got 'a' twice");
  CHECK(refusal({{"a", mesh, card, {}, {}}, {"", mesh, card, {}, {}}}) ==
        "bodies: expected a name without a full stop for every body, got ''");
  CHECK(refusal({{"", mesh, card, {}, {{"left", card, {}}}}}) ==
        "model: region 'left' holds no whole element");
  mesh->define("one", [](const Vec3& X) { return X.x() < 0.21; });
  mesh->define("two", [](const Vec3& X) { return X.x() > 0.09; });
  CHECK(refusal({{"", mesh, card, {}, {{"one", card, {}}, {"two", card, {}}}}}) ==
        "model: element 2 is in two regions, 'one' and 'two'");
}
