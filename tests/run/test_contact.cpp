// Runs with contact: nothing passes, whatever is thrown at whatever; the same bits for any number of threads
// and after a restart, explicit and implicit; the ledger closed.
#include <omp.h>

#include <random>

#include "catch.hpp"
#include "contact/intersect.hpp"
#include "contact/scene.hpp"
#include "mechanics/terms/contact.hpp"
#include "run/bodies.hpp"
#include "run/dynamic.hpp"
#include "run/static.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

model::BodyGiven sheet(const std::string& name, double side, int n, const Vec3& origin) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(side, side, n, n));
  mesh->map([&](const Vec3& X) { return Vec3(X + origin); });
  model::Options options;
  options.warp = [](const Vec3&) { return model::Direction(0.0); };
  options.points = 3;
  return {name, mesh, test::svk(), options, {}};
}

// Brute force over all edges and triangles of the cloth.
std::size_t intersections(const run::Run& run) {
  const auto& mesh = run.model().mesh();
  const auto x = std::as_const(run).assembly().state().x();
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    points.push_back(Eigen::Map<const Vec3>(x.data() + 3 * i));
  const auto triangles = contact::split(mesh.nodes, mesh.elements).triangles;
  std::vector<contact::Edge> edges;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3]});
  return contact::intersections(points, edges, triangles).size();
}

struct Thrown {
  std::shared_ptr<model::Model> model;
  model::RigidPointer ball;
};

// Two sheets and a ball that fly at each other.
Thrown thrown(unsigned seed, double fastest = 30) {
  std::mt19937 random(seed);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double t = test::svk().thickness, thickness = t * number(0.5, seed % 4 == 0 ? 12 : 1.5),
               friction = seed % 3 == 0 ? 0 : number(0, 1), speed = number(1, fastest);
  std::vector<model::BodyGiven> bodies;
  bodies.push_back(sheet("low", 0.03, 3 + static_cast<int>(seed % 4), Vec3::Zero()));
  bodies.push_back(sheet("high", 0.02, 2 + static_cast<int>(seed % 3),
                         Vec3(number(-0.01, 0.02), number(-0.01, 0.02), 1.5 * thickness)));
  Thrown out{std::make_shared<model::Model>(std::move(bodies)), nullptr};
  out.ball = std::make_shared<const model::Rigid>(
      model::Sphere{0.008, Vec3(number(0, 0.03), number(0, 0.03), -0.008 - thickness)}, 0.001, "", "sphere");
  model::ContactGiven self{{{"all", nullptr}}, friction, thickness},
      on_ball{{{"", out.ball}, {"all", nullptr}}, friction, thickness};
  out.model->contact(self);
  out.model->contact(on_ball);
  out.model->velocity(model::InitialVelocity{"high.all", Vec3(number(-1, 1), number(-1, 1), -speed),
                                             Vec3(number(-200, 200), 0, 0)});
  out.model->velocity(model::BodyVelocity{out.ball, Vec3(0, 0, number(0, fastest / 3)), Vec3(0, 300, 0)});
  return out;
}

std::shared_ptr<run::Dynamic> explicit_run(const Thrown& what, double duration) {
  run::DynamicOptions options;
  options.duration = duration;
  return run::make_dynamic(what.model, options, std::make_shared<Notices>());
}

// All that a state is made of, as bytes.
std::string bits(run::Run& run) { return run.kept(); }

}  // namespace

TEST_CASE("contact: what is thrown together does not pass, at any step") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    INFO("seed " << seed);
    const Thrown what = thrown(seed);
    const auto run = explicit_run(what, 1e-3);
    std::size_t steps = 0, cut = 0;
    run->every(2e-5, [&](run::Run& r) {
      ++steps;
      cut += intersections(r);
    });
    std::string stopped;
    try {
      run->solve();
    } catch (const NumericalFailure& failure) {
      stopped = failure.what();
    }
    CHECK(cut == 0);
    CHECK(steps > 0);
    INFO(stopped);
    CHECK((!stopped.empty() || run->energy().error < 0.05));
  }
}

TEST_CASE("contact: an explicit run has the same bits for one, two and four threads and after a restart") {
  std::string first;
  const int most = omp_get_max_threads();
  for (const int threads : {1, 2, 4}) {
    omp_set_num_threads(threads);
    const Thrown what = thrown(5, 1);
    const auto run = explicit_run(what, 6e-4);
    run->advance(3e-4);
    const std::string kept = run->kept();
    run->solve();
    REQUIRE(std::as_const(*run).assembly().contact()->touching() > 0);
    if (first.empty()) first = bits(*run);
    CHECK(bits(*run) == first);
    const Thrown again = thrown(5, 1);
    const auto other = explicit_run(again, 6e-4);
    other->resume(kept);
    other->solve();
    CHECK(bits(*other) == first);
  }
  omp_set_num_threads(most);
}

TEST_CASE("contact: an implicit run with friction has the same bits for two threads and after a restart") {
  const auto make = [](const Thrown& what) {
    run::DynamicOptions options;
    options.duration = 1e-3;
    options.step = 5e-5;
    options.scheme = run::Scheme::implicit_steps;
    return run::make_dynamic(what.model, options, std::make_shared<Notices>());
  };
  const auto sheet_on_ball = [] {
    Thrown out;
    out.model =
        std::make_shared<model::Model>(std::vector<model::BodyGiven>{sheet("low", 0.03, 4, Vec3::Zero())});
    const double t = test::svk().thickness;
    out.ball = std::make_shared<const model::Rigid>(model::Sphere{0.01, Vec3(0.016, 0.014, 0.01 + 0.51 * t)},
                                                    0.002, "", "sphere");
    out.model->fix("low.boundary", model::parse_freedoms("x y z rotation"));
    out.model->contact({{{"", out.ball}, {"all", nullptr}}, 0.3});
    out.model->velocity(model::BodyVelocity{out.ball, Vec3(0.3, 0, -1), Vec3::Zero()});
    return out;
  };
  std::string first;
  const int most = omp_get_max_threads();
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    const Thrown what = sheet_on_ball();
    const auto run = make(what);
    run->advance(5e-4);
    const std::string kept = run->kept();
    run->solve();
    const auto energy = run->energy();
    CHECK(energy.friction > 0);
    CHECK(energy.error < 1e-2);
    if (first.empty()) first = bits(*run);
    CHECK(bits(*run) == first);
    const Thrown again = sheet_on_ball();
    const auto other = make(again);
    other->resume(kept);
    other->solve();
    CHECK(bits(*other) == first);
  }
  omp_set_num_threads(most);
}

TEST_CASE("contact: a punch that is moved presses a held sheet in statics; work, reaction and reach agree") {
  std::vector<model::BodyGiven> bodies{sheet("", 0.03, 6, Vec3::Zero())};
  const auto m = std::make_shared<model::Model>(std::move(bodies));
  const double t = test::svk().thickness, r = 0.01;
  const auto punch = std::make_shared<const model::Rigid>(model::Sphere{r, Vec3(0.015, 0.015, r + 0.55 * t)},
                                                          std::nullopt, "punch", "sphere");
  m->fix("boundary", model::parse_freedoms("x y z rotation"));
  m->contact({{{"", punch}, {"all", nullptr}}, 0.2});
  model::Displacement down;
  down[2] = model::History::ramp(-0.002, 1);
  m->move({punch, down, std::nullopt});
  run::StaticOptions options;
  options.duration = 1;
  options.step = 0.05;
  const auto run = std::make_shared<run::Static>(m, options, std::make_shared<Notices>());
  run->solve();
  const auto state = run::body_state(*run, *punch);
  CHECK(state.place.z() == Approx(r + 0.55 * t - 0.002).epsilon(1e-12));
  CHECK(state.force.z() < 0);
  // What the punch gives the sheet, its supports take.
  CHECK(run->reaction("boundary").z() == Approx(-state.force.z()).epsilon(1e-6));
  CHECK(run->energy().error < 0.02);
  CHECK(run->energy().external > 0);
  CHECK(run::nearest_pair(*run).gap > 0);
}
