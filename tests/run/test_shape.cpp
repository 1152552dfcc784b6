// Messages of a run on shapes that no cloth has: a director turned over, an element inside out.
#include "catch.hpp"
#include "message_of.hpp"
#include "run/dynamic.hpp"
#include "run/explicit.hpp"
#include "run/problems.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

// A flat sheet that is held at its nodes, but for the middle one, which is driven.
std::shared_ptr<model::Model> make_sheet(const std::function<void(model::Model&)>& drive) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.05, 0.04, 4, 4));
  auto m = std::make_shared<model::Model>(mesh, isotropic(2e5, 0.2, 1e-3), model::Options{});
  mesh->define("middle", mesh::NodeSet{12});
  mesh->define("others", nodes_where(*mesh, [](const Vec3& X) {
                 return std::abs(X.x() - 0.025) + std::abs(X.y() - 0.02) > 1e-6;
               }));
  m->fix("others", model::parse_freedoms("x y z rotation"));
  drive(*m);
  return m;
}

// The message of a run that refuses to go on.
std::string refused(const std::shared_ptr<model::Model>& m) {
  run::Static a(m, {.duration = 1, .step = 0.1, .method = run::Method::newton}, std::make_shared<Notices>());
  try {
    a.solve();
  } catch (const NumericalFailure& failure) {
    return failure.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a director that is turned over is told by its node, an element turned inside out by its number") {
  const auto turned = refused(make_sheet([](model::Model& m) {
    m.fix("middle", model::parse_freedoms("x y z"));
    m.add<model::PrescribedTurn>(
        {"middle", Vec3(1, 0.4, 0).normalized(), history::History::table({{0, 0}, {1, 130}}), std::nullopt});
  }));
  says(turned, "the director at node 13 is turned over");
  CHECK(turned.find("is turned inside out)") == std::string::npos);
  const auto inverted = refused(make_sheet([](model::Model& m) {
    model::Components along;
    along[0] = history::History::table({{0, 0}, {1, 0.03}});
    m.move("middle", along);
    m.fix("middle", model::parse_freedoms("y z rotation"));
  }));
  says(inverted, "is turned inside out");
  CHECK(inverted.find("the director at") == std::string::npos);
}
