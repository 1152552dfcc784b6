// Ties: what follows what, what is refused, and what a deck would see.
#include <numbers>

#include "base/error.hpp"
#include "catch.hpp"
#include "mechanics/assembly.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using model::TieKind;

namespace {

std::shared_ptr<mesh::Mesh> tied_square(int n = 2) {
  return std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.1, n, n));
}

model::FixedFreedoms words(const char* text) { return model::parse_freedoms(text, "tie"); }

model::Components constant(int axis, double value) {
  model::Components c;
  c[axis] = history::History::constant(value);
  return c;
}

}  // namespace

TEST_CASE("ties that cannot be are refused with node, freedom and both sets") {
  const auto refusal = [](const std::function<void(mesh::Mesh&, model::Model&)>& tie) -> std::string {
    auto mesh = tied_square();
    model::Model m(mesh, test::blend(), {});
    try {
      tie(*mesh, m);
      m.validate();
    } catch (const Error& e) {
      return e.what();
    }
    return "none";
  };
  CHECK(refusal([](mesh::Mesh&, model::Model& m) {
          m.add<model::Tie>({TieKind::equal, "top", {}, words("x")});
          m.fix("all", model::parse_freedoms("x"));
        }) == "model: node 8: x is tied (set 'top') and fixed (set 'all')");
  CHECK(refusal([](mesh::Mesh&, model::Model& m) {
          m.add<model::Tie>({TieKind::rigid, "top", {}, {}});
          m.move("top", constant(1, 1e-3));
        }) == "model: node 7: y is tied (set 'top') and moved (set 'top')");
  CHECK(refusal([](mesh::Mesh&, model::Model& m) {
          m.add<model::Tie>({TieKind::rigid, "top", {}, {}});
          m.add<model::PrescribedTurn>({"right", Vec3::UnitX(), history::History::constant(1), std::nullopt});
        }) == "model: node 9: rotation is tied (set 'top') and turned (set 'right')");
  CHECK(refusal([](mesh::Mesh&, model::Model& m) {
          m.add<model::Tie>({TieKind::equal, "top", {}, words("x")});
          m.add<model::Tie>({TieKind::straight, "right", {}, words("x")});
          m.add<model::Tie>({TieKind::equal, "right", {}, words("x")});
        }) == "model: node 6: x is tied twice, in two ways");
  CHECK(refusal([](mesh::Mesh&, model::Model& m) {
          m.add<model::Tie>({TieKind::rigid, "top", {}, {}});
          m.add<model::Tie>({TieKind::rigid, "right", {}, {}});
        }) == "model: node 9: is in two rigid sets");
  CHECK(refusal([](mesh::Mesh&, model::Model& m) {
          m.add<model::Tie>({TieKind::periodic, "left", "corners", words("x")});
        }) == "tie: sets 'left' and 'corners' have 3 and 4 nodes: they do not pair");
  CHECK(refusal([](mesh::Mesh& mesh, model::Model& m) {
          mesh.nodes[5].y() += 0.003;
          m.add<model::Tie>({TieKind::periodic, "left", "right", words("x")});
        })
            .find("tie: node 1 of set 'left' has no partner in set 'right': the nearest, node 3, is 0.001 m "
                  "off") == 0);
  CHECK(refusal([](mesh::Mesh& mesh, model::Model& m) {
          mesh.nodes[5].x() += 0.003;
          m.add<model::Tie>({TieKind::straight, "right", {}, words("x")});
        }) ==
        "model: node 6: set 'right' is not straight: the node is 0.003 m off the line between its ends");
  CHECK(refusal([](mesh::Mesh&, model::Model& m) {
          m.add<model::Tie>({TieKind::equal, "top", {}, words("x rx")});
        }) == "tie: expected some of x y z");
}

TEST_CASE("followers are where their leads put them; a rigid edge keeps its shape through a large turn") {
  auto mesh = tied_square(4);
  model::Model m(mesh, test::blend(), {});
  m.add<model::Tie>({TieKind::straight, "bottom", {}, words("x y z")});
  m.add<model::Tie>({TieKind::rigid, "top", {}, {}});
  m.validate();
  mechanics::Assembly a(m);
  std::vector<double> step(a.dofs().unknowns());
  for (std::size_t i = 0; i < step.size(); ++i) step[i] = 1e-3 * std::sin(7.0 * static_cast<double>(i));
  const auto& body = a.dofs().freedoms().bodies.at(0);
  const Vec3 spin(0.4, -1.1, 0.7);
  for (int i = 0; i < 3; ++i) step[body.equation + 3 + i] = spin[i];
  a.begin_iterate();
  a.apply_increment(step, 1, {});
  const auto x = [&](int n) { return Vec3(Eigen::Map<const Vec3>(a.state().x().data() + 3 * n)); };
  CHECK((x(2) - (x(0) + x(4)) / 2).norm() < 1e-16);
  CHECK((x(1) - (3 * x(0) + x(4)) / 4).norm() < 1e-16);
  const Mat3 R = Eigen::AngleAxisd(spin.norm(), spin.normalized()).toRotationMatrix();
  CHECK((x(24) - x(20) - R * Vec3(0.1, 0, 0)).norm() < 1e-16);
  for (int n = 20; n < 25; ++n)
    CHECK((Eigen::Map<const Vec3>(std::as_const(a).state().d().data() + 3 * n) - R * Vec3::UnitZ()).norm() <
          1e-15);
}

TEST_CASE("the directors of a periodic seam are the mean of its two sides'") {
  // One wave of corrugated cloth, its seam on a crest, where two waves have the same director inside; and off
  // the crest, where the two sides lean by different angles.
  for (const double shift : {0.0, 0.3}) {
    const double wave = 0.1;
    const auto corrugated = [&](int waves) {
      auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(waves * wave, 0.02, 6 * waves, 2));
      mesh->map([&](const Vec3& X) {
        return Vec3(X.x(), X.y(), 0.02 * std::cos(2 * std::numbers::pi * (X.x() / wave + shift)));
      });
      return mesh;
    };
    model::Options options;
    options.warp = [](const Vec3&) { return model::Direction(Vec3(0, 1, 0)); };
    model::Model tied(corrugated(1), test::blend(), options), apart(corrugated(1), test::blend(), options),
        two(corrugated(2), test::blend(), options);
    tied.add<model::Tie>({TieKind::periodic, "left", "right", words("x y z rotation")});
    for (const auto* m : {&tied, &apart, &two}) m->validate();
    const mechanics::Assembly seam(tied), open(apart), whole(two);
    const auto director = [](const mechanics::Assembly& a, int n) {
      return Vec3(Eigen::Map<const Vec3>(a.state().d().data() + 3 * n));
    };
    for (int row = 0; row < 3; ++row) {
      const int left = 7 * row, right = left + 6;
      const Vec3 mean = (director(open, left) + director(open, right)).normalized();
      CHECK((director(open, left) - mean).norm() > 0.05);
      CHECK((director(seam, left) - mean).norm() < 1e-15);
      CHECK((director(seam, right) - mean).norm() < 1e-15);
      if (shift == 0) CHECK((director(whole, 13 * row + 6) - mean).norm() < 1e-14);
    }
  }
}
