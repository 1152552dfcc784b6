// Runs with contact: nothing passes, whatever is thrown at whatever; the same bits for any number of threads
// and after a restart, explicit and implicit; the ledger closed.
#include <omp.h>

#include <random>

#include "catch.hpp"
#include "contact/intersect.hpp"
#include "contact/scene.hpp"
#include "draws.hpp"
#include "mechanics/terms/contact.hpp"
#include "message_of.hpp"
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
  out.model->add(self);
  out.model->add(on_ball);
  out.model->add(model::InitialVelocity{"high.all", Vec3(number(-1, 1), number(-1, 1), -speed),
                                        Vec3(number(-200, 200), 0, 0)});
  out.model->add(model::BodyVelocity{out.ball, Vec3(0, 0, number(0, fastest / 3)), Vec3(0, 300, 0)});
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

TEST_CASE("contact: sheets thrown together do not pass, at any step") {
  for (unsigned seed = 1; seed <= static_cast<unsigned>(test::draws(8)); ++seed) {
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
    REQUIRE(run->contact().readings().touching() > 0);
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
    out.model->add<model::ContactGiven>({{{"", out.ball}, {"all", nullptr}}, 0.3});
    out.model->add(model::BodyVelocity{out.ball, Vec3(0.3, 0, -1), Vec3::Zero()});
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
    CHECK(energy.lost_in("friction") > 0);
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
  m->add<model::ContactGiven>({{{"", punch}, {"all", nullptr}}, 0.2});
  model::Components down;
  down[2] = model::History::ramp(-0.002, 1);
  m->add<model::BodyMotion>({punch, down, std::nullopt});
  run::StaticOptions options;
  options.duration = 1;
  options.step = 0.05;
  const auto run = std::make_shared<run::Static>(m, options, std::make_shared<Notices>());
  run->solve();
  const auto state = run::body_state(*run, *punch);
  CHECK(state.place.z() == Approx(r + 0.55 * t - 0.002).epsilon(1e-12));
  CHECK(state.force.z() < 0);
  // The supports of the sheet take the force that the punch gives it.
  CHECK(run->reaction("boundary").z() == Approx(-state.force.z()).epsilon(1e-6));
  CHECK(run->energy().error < 0.02);
  CHECK(run->energy().external > 0);
  CHECK(run::nearest_pair(*run).gap > 0);
}

namespace {

// A sheet that is held all over, its middle plane at z = 0; what it does is what contact does to bodies
// alone.
std::shared_ptr<model::Model> held_sheet(int n = 4) {
  auto m = std::make_shared<model::Model>(
      std::vector<model::BodyGiven>{sheet("", 0.04, n, Vec3(-0.02, -0.02, 0))});
  m->fix("all", model::parse_freedoms("x y z rotation"));
  return m;
}

std::shared_ptr<run::Dynamic> moving_run(std::shared_ptr<model::Model> m, double duration,
                                         std::optional<double> step, bool implicit) {
  run::DynamicOptions options;
  options.duration = duration;
  options.step = step;
  options.scheme = implicit ? run::Scheme::implicit_steps : run::Scheme::explicit_steps;
  options.ledger_limit = 1;  // tests look at the error themselves; at first it is one of next to nothing
  return run::make_dynamic(std::move(m), options, std::make_shared<Notices>());
}

}  // namespace

TEST_CASE("contact: pairs that begin too near are opened, and the ledger holds the work of it") {
  const double t = test::svk().thickness, side = 0.04;
  for (const int kind : {0, 1, 2}) {
    INFO("kind " << kind);
    const auto m = held_sheet();
    const auto plane = std::make_shared<const model::Rigid>(
        model::Plane{Vec3(0, 0, -0.05 * t), Vec3(0, 0, 1)}, std::nullopt, "", "plane");
    const double gap = t / 2, floor = 0.5 * 590 * t / 1500, kappa = 1e8;
    m->add<model::ContactGiven>(
        {.between = {{"", plane}, {"all", nullptr}}, .stiffness = kappa, .settle = 2e-4});
    // Lengths that the law has when half of the time is over, at a gap of 0.05 t.
    const auto notices = std::make_shared<Notices>();
    std::shared_ptr<run::Run> run;
    if (kind == 0) {
      run::StaticOptions options;
      options.duration = 4e-4;
      options.step = 2.5e-7;
      run = std::make_shared<run::Static>(m, options, notices);
    } else {
      run = moving_run(m, 4e-4, 2.5e-7, kind == 2);
    }
    // Half way the smooth rise stands at one half: lengths are the mean of those at the start and of all.
    const contact::ContactLaw law({gap, floor, kappa, {}});
    const double start = 0.05 * t / gap;
    // As far as the law opens without coming to its floor.
    const auto pressed = [&](double time) {
      const double s = std::min(1.0, time / 2e-4), share = start + (1 - start) * s * s * (3 - 2 * s);
      return side * side * law.scaled(0.05 * t, share).pressure;
    };
    run->advance(1.5e-5);
    CHECK(run::body_state(*run, *plane).force.z() == Approx(pressed(1.5e-5)).epsilon(1e-9));
    CHECK(run->energy().contact > 0);
    CHECK(run->energy().error < 2e-3);  // the trapezoid over sixty steps
    // The floor cannot be there: the sheet is held nearer than that.
    CHECK_THROWS_AS(run->solve(), NumericalFailure);
  }
}

TEST_CASE("contact: a free sheet that begins below its floor is opened to its gap") {
  const double t = test::svk().thickness;
  for (const bool implicit : {false, true}) {
    INFO("implicit " << implicit);
    auto m = std::make_shared<model::Model>(std::vector<model::BodyGiven>{sheet("", 0.04, 4, Vec3::Zero())});
    const auto plane = std::make_shared<const model::Rigid>(model::Plane{Vec3(0, 0, -0.1 * t), Vec3(0, 0, 1)},
                                                            std::nullopt, "", "plane");
    m->add<model::ContactGiven>(
        {.between = {{"", plane}, {"all", nullptr}}, .friction = 0.2, .settle = 2e-3});
    run::DynamicOptions options;
    options.duration = 2.5e-3;
    if (implicit) options.step = 5e-6;
    options.scheme = implicit ? run::Scheme::implicit_steps : run::Scheme::explicit_steps;
    options.ledger_limit = 1;  // of next to nothing, at first
    const auto run = run::make_dynamic(m, options, std::make_shared<Notices>());
    run->solve();
    const auto x = std::as_const(*run).assembly().state().x();
    for (std::size_t i = 0; i < x.size() / 3; ++i) CHECK(x[3 * i + 2] + 0.1 * t > 0.47 * t);
    CHECK(run->energy().external > 0);
    CHECK(run->energy().error < 1e-2);
  }
}

TEST_CASE("contact: an overlap is refused, and what settle opens is told") {
  const double t = test::svk().thickness;
  const auto run_of = [&](std::optional<double> settle, double z, std::string* told) {
    auto m = std::make_shared<model::Model>(std::vector<model::BodyGiven>{sheet("", 0.04, 2, Vec3::Zero())});
    const auto plane = std::make_shared<const model::Rigid>(model::Plane{Vec3(0, 0, -z), Vec3(0, 0, 1)},
                                                            std::nullopt, "", "plane");
    m->add<model::ContactGiven>({.between = {{"", plane}, {"all", nullptr}}, .settle = settle});
    auto notices = std::make_shared<Notices>([told](const std::string& line) {
      if (told != nullptr) *told += line + "\n";
    });
    run::StaticOptions options;
    options.duration = 1;
    run::Static run(m, options, notices);
  };
  says(message_of([&] { run_of({}, 0.1 * t, nullptr); }),
       "contact: 9 pairs overlap at the start: node 1 and the plane");
  says(message_of([&] { run_of({}, 0.1 * t, nullptr); }), "(settle= of m:contact would open");
  says(message_of([&] { run_of(0.5, 1e-5 * t, nullptr); }),
       "contact: field 'settle': plane on the cloth: expected at least");
  says(message_of([&] { run_of(-1.0, 0.1 * t, nullptr); }),
       "contact: field 'settle': expected a positive number in s, got -1");
  std::string told;
  run_of(0.5, 0.1 * t, &told);
  says(told, "; 9 points are nearer than that at the start, the nearest by 0.000152 m: opened over 0.5 s");
}

TEST_CASE("contact: touching pairs are told by the names of the bodies") {
  auto m = std::make_shared<model::Model>(std::vector<model::BodyGiven>{
      sheet("front", 0.04, 2, Vec3::Zero()), sheet("back", 0.04, 2, Vec3(0, 0, 0.01))});
  const auto plane = std::make_shared<const model::Rigid>(model::Plane{Vec3(0, 0, -0.01), Vec3(0, 0, 1)},
                                                          std::nullopt, "", "plane");
  m->add<model::ContactGiven>({{{"front", nullptr}, {"back", nullptr}}, 0});
  m->add<model::ContactGiven>({{{"front", nullptr}}, 0});
  m->add<model::ContactGiven>({{{"", plane}, {"front", nullptr}}, 0});
  std::string told;
  run::StaticOptions options;
  options.duration = 1;
  run::Static run(m, options,
                  std::make_shared<Notices>([&](const std::string& line) { told += line + "\n"; }));
  says(told, "back on front: from a gap of");
  says(told, "front on itself: from a gap of");
  says(told, "plane on front: from a gap of");
}

TEST_CASE("contact: a spinning ball comes to roll as friction asks, explicit and implicit", "[long]") {
  const double t = test::svk().thickness, r = 0.01, spin = 20, mu = 0.3;
  for (const bool implicit : {false, true}) {
    INFO("implicit " << implicit);
    const auto m = held_sheet(4);
    const auto ball =
        std::make_shared<const model::Rigid>(model::Sphere{r, Vec3(0, 0, r + 0.5 * t)}, 0.02, "", "sphere");
    m->add<model::ContactGiven>({{{"", ball}, {"all", nullptr}}, mu, {}, 1e11});  // so that it feels no nodes
    m->gravity({std::nullopt, std::nullopt, model::History::constant(-9.81)});
    m->add(model::BodyVelocity{ball, Vec3::Zero(), Vec3(0, spin, 0)});
    const auto run = moving_run(m, 0.035, implicit ? std::optional(5e-5) : std::nullopt, implicit);
    // Slipping: v = mu times the impulse per mass that presses, g t and what throws the ball up; rolling from
    // 2 spin r / (7 mu g) = 14 ms on with 2/7 of spin r.
    run->advance(0.007);
    const auto early = run::body_state(*run, *ball);
    CHECK(early.velocity.x() == Approx(mu * (9.81 * 0.007 + early.velocity.z())).epsilon(0.02));
    run->solve();
    const auto late = run::body_state(*run, *ball);
    CHECK(late.velocity.x() == Approx(2.0 / 7 * spin * r).epsilon(0.02));
    // In implicit steps it goes from contact point to contact point, which lie as far apart as it presses
    // wide.
    CHECK(late.velocity.x() == Approx(late.spin.y() * r).epsilon(implicit ? 0.02 : 0.001));
    // About the place of contact nothing turns it.
    const double inertia = 0.4 * 0.02 * r * r;
    CHECK(0.02 * late.velocity.x() * r + inertia * late.spin.y() == Approx(inertia * spin).epsilon(5e-3));
    CHECK(run->energy().lost_in("friction") == Approx(inertia * spin * spin / 2 * 5 / 7).epsilon(0.03));
    // Friction of an implicit step is that at its end: first order.
    CHECK(run->energy().error < (implicit ? 5e-3 : 1e-3));
  }
}

TEST_CASE("contact: implicit steps carry a light ball on a contact of any stiffness") {
  // Let go where contact begins, it swings about where its weight is carried, m g = p'; an explicit flight
  // would want steps below 2 sqrt(m / k).
  const double t = test::svk().thickness, r = 0.01, mass = 1e-3, stiffness = 1e11;
  const auto m = held_sheet(8);
  const auto ball = std::make_shared<const model::Rigid>(model::Sphere{r, Vec3(0.001, 0.002, r + 0.5 * t)},
                                                         mass, "", "sphere");
  m->add<model::ContactGiven>({{{"", ball}, {"all", nullptr}}, 0.2, {}, stiffness});
  m->gravity({std::nullopt, std::nullopt, model::History::constant(-9.81)});
  run::DynamicOptions options;
  options.duration = 0.05;
  options.step = 1e-3;
  options.scheme = run::Scheme::implicit_steps;
  options.ledger_limit = 1e9;
  const auto run = run::make_dynamic(m, options, std::make_shared<Notices>());
  double highest = 0, lowest = 1, mean = 0;
  int steps = 0;
  run->every_step([&](run::Run& now) {
    const auto state = run::body_state(now, *ball);
    highest = std::max(highest, state.place.z());
    lowest = std::min(lowest, state.place.z());
    mean += state.force.z();
    ++steps;
  });
  run->solve();
  CHECK(highest < r + 0.5 * t + 1e-5);
  CHECK(lowest > r + 0.5 * t - 3e-5);
  CHECK(mean / steps == Approx(-mass * 9.81).epsilon(0.1));
}

TEST_CASE("contact: implicit steps of a sheet and a free ball keep momentum") {
  auto m = std::make_shared<model::Model>(
      std::vector<model::BodyGiven>{sheet("", 0.04, 6, Vec3(-0.02, -0.02, 0))});
  const double t = test::svk().thickness, r = 0.01, mass = 2e-4;
  const auto ball = std::make_shared<const model::Rigid>(model::Sphere{r, Vec3(0.004, 0.001, r + 0.51 * t)},
                                                         mass, "", "sphere");
  m->add<model::ContactGiven>({{{"", ball}, {"all", nullptr}}, 0.3});
  m->add(model::BodyVelocity{ball, Vec3(0.1, 0, -0.5), Vec3(0, 50, 20)});
  const auto run = moving_run(m, 4e-3, 5e-5, true);
  run->solve();
  REQUIRE(run->energy().lost_in("friction") > 0);
  Vec3 momentum = mass * run::body_state(*run, *ball).velocity;
  const auto& nodes = std::as_const(*run).assembly().cloth().mass();
  for (std::size_t i = 0; i < nodes.size(); ++i)
    momentum += nodes[i] * run->node(static_cast<mesh::Index>(i)).v;
  CHECK((momentum - mass * Vec3(0.1, 0, -0.5)).norm() < 1e-8 * mass);
  CHECK(run->energy().error < 1e-2);
}

TEST_CASE("contact: cloth that slides on itself has the same bits for any threads and after a restart",
          "[many]") {
  const auto make = [](bool implicit) {
    const double t = test::svk().thickness;
    auto m = std::make_shared<model::Model>(std::vector<model::BodyGiven>{
        sheet("low", 0.03, 4, Vec3::Zero()), sheet("high", 0.02, 3, Vec3(0.004, 0.006, 1.02 * t))});
    m->fix("low.boundary", model::parse_freedoms("x y z rotation"));
    m->add<model::ContactGiven>({{{"all", nullptr}}, 0.3});
    m->add(model::InitialVelocity{"high.all", Vec3(0.3, 0.1, -0.5), Vec3::Zero()});
    return moving_run(m, 2.4e-4, implicit ? std::optional(1e-5) : std::nullopt, implicit);
  };
  const int most = omp_get_max_threads();
  for (const bool implicit : {false, true}) {
    std::string first;
    for (const int threads : {1, 2, 4}) {
      INFO("implicit " << implicit << ", threads " << threads);
      omp_set_num_threads(threads);
      const auto run = make(implicit);
      run->advance(1.6e-4);
      CHECK(run->energy().lost_in("friction") > 0);
      const std::string kept = run->kept();
      run->solve();
      if (first.empty()) first = bits(*run);
      CHECK(bits(*run) == first);
      const auto other = make(implicit);
      other->resume(kept);
      other->solve();
      CHECK(bits(*other) == first);
    }
  }
  omp_set_num_threads(most);
}

TEST_CASE(
    "contact: a card's compression presses as it was measured; explicit steps no more than they carry") {
  const double side = 0.04;
  auto card = test::svk();
  card.compression = {{0.3e-3, 5000}, {0.36e-3, 800}, {0.5e-3, 50}};
  card.fibre_density = 1540;
  for (const bool implicit : {true, false}) {
    auto given = sheet("", side, 4, Vec3(-0.02, -0.02, 0));
    given.card = card;
    auto m = std::make_shared<model::Model>(std::vector<model::BodyGiven>{given});
    m->fix("all", model::parse_freedoms("x y z rotation"));
    // A body has half of the sheet against it.
    const auto plane = std::make_shared<const model::Rigid>(model::Plane{Vec3(0, 0, -0.18e-3), Vec3(0, 0, 1)},
                                                            std::nullopt, "", "plane");
    m->add<model::ContactGiven>({{{"", plane}, {"all", nullptr}}, 0});
    std::string told;
    const auto notices = std::make_shared<Notices>([&](const std::string& line) { told += line; });
    run::DynamicOptions options;
    options.duration = 1e-5;
    options.step = 5e-6;
    options.scheme = implicit ? run::Scheme::implicit_steps : run::Scheme::explicit_steps;
    const auto run = run::make_dynamic(m, options, notices);
    run->solve();
    CHECK(run::body_state(*run, *plane).force.z() == Approx(side * side * 800).epsilon(1e-6));
    says(told, "pressed as its card's compression has it");
  }
}

namespace {

// A strip that stands on edge between two planes, which come together and fold it: by symmetry its middle
// stays upright. Bending alone: as long as it is thin, it takes no other strain.
struct Fold {
  static constexpr double half = 14e-3, width = 1e-3, thickness = 0.3e-3, rigidity = 1e-5, end = 10e-3;
  std::shared_ptr<model::Model> model;
  model::RigidPointer upper;
  int cells;
  explicit Fold(int n) : cells(n) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(width, 2 * half, 1, n));
    mesh->map([](const Vec3& X) {  // a little to one side
      const double y = X.y() / half - 1;
      return Vec3(1e-4 * (1 - y * y), X.x(), X.y() - half);
    });
    card::Card card;
    card.name = "strip";
    card.density = 500;
    card.thickness = thickness;
    card.law = card::Svk{50e6, 50e6, 25e6, 0, 0, {}, {}};
    card.bending = card::Bending{rigidity, rigidity, rigidity / 2, {}, {}};
    model::Options options;
    options.warp = [](const Vec3&) { return model::Direction(Vec3::UnitZ()); };
    mesh->sets["middle"] = {static_cast<mesh::Index>(n), static_cast<mesh::Index>(n + 1)};
    model = std::make_shared<model::Model>(std::vector<model::BodyGiven>{{"", mesh, card, options, {}}});
    model->fix("middle", model::parse_freedoms("x y z rotation"));
    const double high = half + thickness / 2 + 1e-5, way = high - end / 2 - thickness / 2;
    upper = plane(high, -1, -way);
    model->add<model::ContactGiven>({{{"", upper}, {"", plane(-high, 1, way)}, {"all", nullptr}}, 0});
    model->add<model::ContactGiven>({{{"all", nullptr}}, 0});
  }
  model::RigidPointer plane(double z, double normal, double way) {
    auto body = std::make_shared<const model::Rigid>(model::Plane{Vec3(0, 0, z), Vec3(0, 0, normal)},
                                                     std::nullopt, normal < 0 ? "upper" : "lower", "plane");
    model::Components moved;
    moved[2] = model::History::ramp(way, 1);
    model->add<model::BodyMotion>({body, moved, std::nullopt});
    return body;
  }
};

}  // namespace

TEST_CASE("contact: a fold pressed between two planes is the elastica") {
  // F D^2 / B = 2.8711 per width and 2.3963 = the greatest curvature times D, where both legs lie flat.
  const int n = 56;
  const Fold fold(n);
  run::StaticOptions options;
  options.duration = 1;
  options.step = 0.04;
  run::Static run(fold.model, options, std::make_shared<Notices>());
  run.solve();
  const auto at = [&](int row) { return run.node(2 * row).x; };
  double high = 0, low = 0;
  for (int row = 0; row <= n; ++row) {
    high = std::max(high, at(row).z());
    low = std::min(low, at(row).z());
  }
  const double D = high - low, force = -run::body_state(run, *fold.upper).force.z();
  CHECK(D == Approx(fold.end).epsilon(1e-3));
  CHECK(force / fold.width * D * D / fold.rigidity == Approx(2.8711).epsilon(4e-3));
  // The circle through the apex and its neighbours.
  const Vec3 a = at(n / 2 - 1), b = at(n / 2), c = at(n / 2 + 1);
  const double curvature =
      2 * (b - a).cross(c - b).norm() / ((b - a).norm() * (c - b).norm() * (c - a).norm());
  CHECK(curvature * D == Approx(2.3963).epsilon(1e-2));
  CHECK(run.energy().error < 0.02);
}

TEST_CASE("contact: statics lay a strip over a rod, with friction, and relaxation comes to the same") {
  const double t = test::svk().thickness, r = 0.01, side = 0.04;
  const auto sheet_over_rod = [&](run::Method method, double friction) {
    auto given = sheet("", side, 8, Vec3(-side / 2, 0, 0));
    given.card.bending = card::Bending{1e-5, 1e-5, 5e-6, {}, {}};
    auto& mesh = *given.mesh;
    std::vector<mesh::Index> middle;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      if (std::abs(mesh.nodes[i].x()) < 1e-9) middle.push_back(static_cast<mesh::Index>(i));
    mesh.sets["middle"] = middle;
    mesh.sets["one"] = {middle.front()};
    auto m = std::make_shared<model::Model>(std::vector<model::BodyGiven>{given});
    m->fix("middle", model::parse_freedoms("x rotation"));
    m->fix("one", model::parse_freedoms("y"));
    const auto rod = std::make_shared<const model::Rigid>(
        model::Cylinder{r, Vec3(0, -0.02, -r - 0.46 * t), Vec3(0, 0.06, -r - 0.46 * t)}, std::nullopt, "",
        "cylinder");
    m->add<model::ContactGiven>({{{"", rod}, {"all", nullptr}}, friction});
    m->add<model::ContactGiven>({{{"all", nullptr}}, friction});
    m->gravity({std::nullopt, std::nullopt, model::History::ramp(-9.81, 1)});
    run::StaticOptions options;
    options.duration = 1;
    options.step = method == run::Method::relaxation ? 0.5 : 0.1;
    options.method = method;
    options.tolerance = method == run::Method::relaxation ? 1e-5 : 1e-9;
    const auto run = std::make_shared<run::Static>(m, options, std::make_shared<Notices>());
    run->solve();
    CHECK(run::body_state(*run, *rod).force.z() == Approx(590 * t * side * side * 9.81).epsilon(1e-5));
    // It begins pressed in and not in balance: statics let that energy go in the first step.
    const auto energy = run->energy();
    CHECK(energy.initial > 0);
    CHECK(energy.relaxed > 0.9 * energy.initial);
    CHECK(std::abs(energy.surplus()) < 0.02 * std::abs(energy.external));
    CHECK((run->energy().lost_in("friction") > 0) == (friction > 0));
    return run->node(0).x;
  };
  const Vec3 newton = sheet_over_rod(run::Method::newton, 0),
             relaxed = sheet_over_rod(run::Method::relaxation, 0);
  CHECK(newton.z() < -0.2 * side / 2);
  CHECK((newton - relaxed).norm() < 1e-4 * side);
  CHECK(sheet_over_rod(run::Method::newton, 0.3).z() > newton.z());
}
