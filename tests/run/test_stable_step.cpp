// The automatic step of explicit runs: 2000 steps from small random velocities of all nodes, which excite
// every frequency, on meshes and cards that a step from the smallest height and the membrane's waves does not
// carry.
#include <omp.h>

#include <random>

#include "catch.hpp"
#include "message_of.hpp"
#include "run/dynamic.hpp"
#include "run/problems.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using run::DynamicOptions;
using run::make_dynamic;
using run::Run;

namespace {

card::Card rubber(double poisson = 0.3) {
  auto card = isotropic(6e6, poisson, 0.4e-3);
  card.density = 520;
  return card;
}

std::shared_ptr<mesh::Mesh> triangles(double width, double height, double noise) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(width, height, 4, 3));
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  mesh->map([&](const Vec3& X) {
    return Vec3(X.x() + noise * width / 4 * number(random), X.y() + noise * height / 3 * number(random), 0);
  });
  const auto whole = mesh->elements;
  mesh->elements.clear();
  for (const auto& [a, b, c, d] : whole) {
    mesh->elements.push_back({a, b, c, -1});
    mesh->elements.push_back({a, c, d, -1});
  }
  return mesh;
}

std::shared_ptr<model::Model> shaken(std::shared_ptr<mesh::Mesh> mesh, const card::Card& card,
                                     int points = 3) {
  model::Options options;
  options.points = points;
  options.warp = [](const Vec3&) { return model::Direction(Vec3(1, 0.2, 0)); };
  auto m = std::make_shared<model::Model>(std::move(mesh), card, options);
  model::InitialVelocity any{"all"};
  any.place = [](const Vec3& X) {
    Vec3 v;
    for (int i = 0; i < 3; ++i) v[i] = 1e-4 * std::sin(54321 * X.x() + 98765 * X.y() + 2.3 * i);
    return model::RigidVelocity{v, Vec3::Zero(), Vec3::Zero()};
  };
  m->add(any);
  return m;
}

double usual(const std::shared_ptr<model::Model>& m) {
  return make_dynamic(m, {.duration = 1}, quiet())->step_size();
}

// The energies swing between the ends of the steps by no more than 1 / (1 - 0.9^2); nothing is made.
// A woven law, whose stiffness changes where yarns go slack, bends the swings: `share` of the energy.
void runs_calmly(const std::shared_ptr<model::Model>& m, double share = 1e-4) {
  constexpr int steps = 2000;
  const auto a = make_dynamic(m, {.duration = steps * usual(m)}, quiet());
  double most = 0;
  a->every_step([&](Run& r) { most = std::max(most, r.energy().kinetic); });
  a->solve();
  CHECK(a->steps().size() >= static_cast<std::size_t>(steps));
  CHECK(most < 5.3 * a->energy().initial);
  CHECK(a->energy().error < share);
}

}  // namespace

TEST_CASE("the usual step carries triangles of any ratio, of rubber and of cloth", "[many]") {
  for (const auto& card : {rubber(), rubber(0), blend(), muslin()})
    for (const double ratio : {1.0, 2.5, 7.0, 30.0}) {
      CAPTURE(card.name, ratio);
      const auto m = shaken(triangles(0.09, 0.09 / ratio, ratio == 1 ? 0.25 : 0.08), card);
      runs_calmly(m, std::holds_alternative<card::Woven>(card.law) ? 1e-2 : 1e-4);
      // Their inertia is scaled, not their step.
      const auto a = make_dynamic(m, {.duration = 1}, quiet());
      CHECK(std::abs(a->step_size() / (0.7 * a->assembly().terms().stable_step(true)) - 1) < 1e-12);
      CHECK(a->step_size() <= 0.9000001 * a->stable_step());
    }
}

TEST_CASE("the usual step carries springs, pressure that stiffens and stiff transverse shear", "[many]") {
  const auto sheet = [](const card::Card& card, int points = 3) {
    return shaken(std::make_shared<mesh::Mesh>(mesh::rectangle(0.08, 0.06, 4, 4)), card, points);
  };
  auto m = sheet(rubber());
  m->add<model::GroundSpring>({"left", {0, 2e6, 7e5}});
  CHECK(usual(m) < 0.4 * usual(sheet(rubber())));
  runs_calmly(m);
  for (const bool both : {true, false}) {
    auto card = rubber(0);
    auto law = std::get<card::Svk>(card.law);
    law.g13 = 2e8;
    law.g23 = both ? 2e8 : 3e6;
    card.law = law;
    // With one point through the thickness the shear is the section's alone; else bending is in series with
    // it.
    CHECK(usual(sheet(card, 1)) < 0.3 * usual(sheet(rubber(0), 1)));
    runs_calmly(sheet(card, 1));
    CHECK(usual(sheet(card)) > 0.9 * usual(sheet(rubber(0))));
    runs_calmly(sheet(card));
  }
}

TEST_CASE("the step follows a sheet that is stretched far, and its velocities stay those of its edges",
          "[many]") {
  for (const bool cut : {false, true}) {
    CAPTURE(cut);
    const double width = 0.09, time = 0.03, stretch = 2.7;
    auto mesh = cut ? triangles(width, width / 2, 0)
                    : std::make_shared<mesh::Mesh>(mesh::rectangle(width, width / 2, 4, 4));
    std::vector<std::pair<std::string, Vec3>> rim;
    for (std::size_t n = 0; n < mesh->nodes.size(); ++n) {
      const Vec3& X = mesh->nodes[n];
      const bool inside = X.x() > 1e-6 && X.x() < width - 1e-6 && X.y() > 1e-6 && X.y() < width / 2 - 1e-6;
      if (inside) continue;
      rim.emplace_back("rim " + std::to_string(n), X);
      mesh->define(rim.back().first, mesh::NodeSet{static_cast<mesh::Index>(n)});
    }
    auto m = shaken(mesh, rubber());
    for (const auto& [name, X] : rim) {
      model::Components to;
      for (std::size_t i = 0; i < 2; ++i)
        to[i] = history::History::callback([=, X = X[static_cast<int>(i)]](double t) {
          const double s = std::min(1.0, t / time);
          return (stretch - 1) * X * s * s * (3 - 2 * s);
        });
      to[2] = history::History::constant(0);
      m->move(name, to);
    }
    const auto a = make_dynamic(m, {.duration = 2 * time}, quiet());
    double fastest = 0, across = 0;
    a->every(time / 20, [&](Run& r) {
      for (std::size_t n = 0; n < mesh->nodes.size(); ++n) {
        const Vec3 v = r.node(static_cast<mesh::Index>(n)).v;
        fastest = std::max(fastest, v.norm());
        across = std::max(across, std::abs(v.z()));
      }
    });
    a->solve();
    CHECK(fastest < 2 * 1.5 * 1.7 * width / time);
    CHECK(across < 1e-2);
    CHECK(a->energy().error < 1e-3);
    CHECK(a->steps().back().step < 0.6 * usual(m));
  }
}

TEST_CASE("a bound is the same for any number of threads, and a run goes on with the same bits") {
  const int before = omp_get_max_threads();
  const auto make = [] {
    auto m = shaken(triangles(0.09, 0.02, 0.1), rubber());
    m->add<model::GroundSpring>({"left", {1e5, 0, 3e5}});
    m->pressure("all", history::History::ramp(300, 0.002));
    return m;
  };
  const double step = usual(make()), duration = 700 * step;
  std::string kept;
  std::vector<double> ends;
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    const auto a = make_dynamic(make(), {.duration = duration}, quiet());
    CHECK(a->step_size() == step);
    a->advance(300 * step);
    if (threads == 1) kept = a->kept();
    a->solve();
    ends.push_back(a->node(7).u.z());
  }
  omp_set_num_threads(before);
  const auto later = make_dynamic(make(), {.duration = duration}, quiet());
  later->resume(kept);
  later->solve();
  CHECK(ends[0] == ends[1]);
  CHECK(ends[0] == ends[2]);
  CHECK(ends[0] == later->node(7).u.z());
}

TEST_CASE("a step that a few elements forbid says which, and a run that breaks by it names them") {
  // One thin triangle in a mesh of plain ones, without scaled inertia.
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.08, 0.08, 4, 4));
  const auto whole = mesh->elements;
  mesh->elements.clear();
  for (const auto& [a, b, c, d] : whole) {
    mesh->elements.push_back({a, b, c, -1});
    mesh->elements.push_back({a, c, d, -1});
  }
  mesh->nodes[12] += Vec3(0.017, -0.0002, 0);
  auto card = rubber();
  std::vector<std::string> said;
  const auto notices = std::make_shared<Notices>([&](const std::string& text) { said.push_back(text); });
  const auto m = shaken(mesh, card);
  m->add<model::GroundSpring>({"right", {0, 0, 4e7}});
  const auto a = make_dynamic(m, {.duration = 1e-3}, notices);
  REQUIRE(!said.empty());
  CHECK(said[0].find("of what waves in the cloth allow, because of the springs or loads at element ") !=
        std::string::npos);
  // At three times the bound, below what waves in the cloth allow.
  const auto broken = make_dynamic(m, {.duration = 1, .step = 3 * a->stable_step(), .force = true}, quiet());
  std::string message, why;
  try {
    broken->solve();
  } catch (const NumericalFailure& failure) {
    message = failure.what();
    why = broken->why();
  }
  INFO(message << "\n" << why);
  CHECK(message.find("Try: a step below ") != std::string::npos);
  CHECK(message.find("softer springs or loads there") != std::string::npos);
  const auto at = message.find("which element ");
  REQUIRE(at != std::string::npos);
  const int element = std::stoi(message.substr(at + 14));
  const auto& right = mesh->set("right");
  const auto& nodes = mesh->elements[static_cast<std::size_t>(element) - 1];
  CHECK(std::any_of(nodes.begin(), nodes.end(),
                    [&](mesh::Index n) { return std::find(right.begin(), right.end(), n) != right.end(); }));
}
