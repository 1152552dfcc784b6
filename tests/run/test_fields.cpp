// Fields of a run against closed forms on elements that are no parallelograms, and by ply; and what an
// interrupted step leaves behind.
#include <numbers>

#include "catch.hpp"
#include "message_of.hpp"
#include "run/result_fields.hpp"
#include "run/static.hpp"
#include "run/vtk_frame.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

// Quadrilaterals none of which is a parallelogram, all nodes moved to F X.
std::unique_ptr<run::Static> deformed(const Mat3& F, model::Options options) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.04, 0.03, 3, 2));
  mesh->map([](const Vec3& X) {
    return Vec3(X.x() * (0.6 + 11 * X.y()), X.y() * (1.2 - 7 * X.x()) + 2 * X.x() * X.x(), 0);
  });
  for (std::size_t n = 0; n < mesh->nodes.size(); ++n)
    mesh->define("n" + std::to_string(n), mesh::NodeSet{static_cast<mesh::Index>(n)});
  auto m = std::make_shared<model::Model>(mesh, test::svk(), std::move(options));
  m->fix("all", model::parse_freedoms("rotation"));
  for (std::size_t n = 0; n < mesh->nodes.size(); ++n) {
    const Vec3 u = F * mesh->nodes[n] - mesh->nodes[n];
    model::Components c;
    for (int i = 0; i < 3; ++i) c[static_cast<std::size_t>(i)] = model::History::table({{0, 0}, {1, u[i]}});
    m->move("n" + std::to_string(n), c);
  }
  run::StaticOptions how;
  how.duration = how.step.emplace(1);
  auto run = std::make_unique<run::Static>(m, how, std::make_shared<Notices>());
  run->solve();
  return run;
}

model::Options warp(double angle) {
  model::Options options;
  options.warp = [angle](const Vec3&) { return model::Direction(angle); };
  return options;
}

}  // namespace

TEST_CASE("the shear angle is that of the strains, on quadrilaterals of any shape") {
  Mat3 F = Mat3::Identity();
  for (const double angle : {0.0, 37.0}) {
    for (const double g : deformed(F, warp(angle))->field("shear_angle")) CHECK(std::abs(g) < 1e-9);
    Mat3 G;
    G << 1.1, 0.45, 0, -0.1, 0.9, 0, 0, 0, 1;
    const auto run = deformed(G, warp(angle));
    const double a = angle * std::numbers::pi / 180;
    const Vec3 w = G * Vec3(std::cos(a), std::sin(a), 0), f = G * Vec3(-std::sin(a), std::cos(a), 0);
    const double want = std::asin(w.dot(f) / w.norm() / f.norm()) * 180 / std::numbers::pi;
    const auto angles = run->field("shear_angle"), warps = run->field("warp"), wefts = run->field("weft"),
               E12 = run->field("E12"), E11 = run->field("E11"), E22 = run->field("E22");
    for (std::size_t e = 0; e < angles.size(); ++e) {
      CHECK(angles[e] == Approx(want).epsilon(1e-10));
      CHECK(std::sin(angles[e] * std::numbers::pi / 180) ==
            Approx(2 * E12[e] / std::sqrt((1 + 2 * E11[e]) * (1 + 2 * E22[e]))).epsilon(1e-12));
      CHECK((Vec3(&warps[3 * e]) - w.normalized()).norm() < 1e-12);
      CHECK((Vec3(&wefts[3 * e]) - f.normalized()).norm() < 1e-12);
    }
  }
}

TEST_CASE("fields of single plies, of all plies in common axes, and their names") {
  Mat3 F = Mat3::Identity();
  F(0, 0) = 1.03;
  F(0, 1) = 0.05;
  model::Options options = warp(0);
  options.points = 2;
  options.plies = {{test::svk(), 2e-4, 0}, {test::svk(), 3e-4, 60, "face"}, {test::svk(), 1e-4, 90}};
  const auto run = deformed(F, options);
  const Mat3 E = (F.transpose() * F - Mat3::Identity()) / 2;
  const double a = std::numbers::pi / 3;
  const Vec3 w(std::cos(a), std::sin(a), 0), f(-std::sin(a), std::cos(a), 0);
  const auto is = [&](const char* name, double want) {
    INFO(name);
    for (const double got : run->field(name)) CHECK(got == Approx(want).epsilon(1e-9).margin(1e-13));
  };
  is("E11", E(0, 0));
  is("E12", E(0, 1));
  is("E22", E(1, 1));
  is("ply2.E11", w.dot(E * w));
  is("face.E22", f.dot(E * f));
  is("face.E12", w.dot(E * f));
  is("ply3.E11", E(1, 1));
  is("ply3.E12", -E(0, 1));
  // S of all plies in common axes is what their forces add up to.
  const auto of = [&](const std::string& name) { return run->mean(name); };
  const double s = std::sin(a), c = std::cos(a);
  const double face11 = c * c * of("face.S11") + s * s * of("face.S22") - 2 * c * s * of("face.S12");
  const double face12 = c * s * (of("face.S11") - of("face.S22")) + (c * c - s * s) * of("face.S12");
  CHECK(of("S11") == Approx((2 * of("ply1.S11") + 3 * face11 + of("ply3.S22")) / 6).epsilon(1e-12));
  CHECK(of("S12") == Approx((2 * of("ply1.S12") + 3 * face12 - of("ply3.S12")) / 6).epsilon(1e-12));
  CHECK(of("ply1.tension_warp") == Approx(2e-4 * of("ply1.S11") * std::sqrt(1 + 2 * E(0, 0))).epsilon(1e-12));
  CHECK(of("tension_warp") == Approx(6e-4 * of("S11") * std::sqrt(1 + 2 * E(0, 0))).epsilon(1e-12));

  says(message_of([&] { run->field("residual"); }), "as in 'ply1.residual'");
  says(message_of([&] { run->field("ply4.E"); }), "unknown ply 'ply4'");
  says(message_of([&] { run->field("face.region"); }), "'region' is not of single plies");
  says(message_of([&] { run::find_field("face.E13x"); }), "unknown field 'E13x', did you mean 'E13'?");
  CHECK(run::find_field("anything.E13").ply == "anything");

  const run::VtkFrame usual(*run, {}), some(*run, {{"face.E", "S12", "ply1.slack2"}});
  const auto names = [](const run::VtkFrame& frame) {
    std::vector<std::string> all;
    for (const auto& array : frame.grid().cell_data) all.push_back(array.name);
    return all;
  };
  CHECK(names(usual) == std::vector<std::string>{"E", "S", "energy", "warp", "weft"});
  CHECK(names(some) == std::vector<std::string>{"S", "face.E", "ply1.slack"});
}
