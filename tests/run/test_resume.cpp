// A run taken up by another object, as another process would: the same bits as if it had never ended.
#include <omp.h>

#include "catch.hpp"
#include "message_of.hpp"
#include "run/dynamic.hpp"
#include "run/problems.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using run::Run;

namespace {

using Maker = std::function<std::shared_ptr<Run>()>;

// Into slack cloth and out of it again; a sheet that may leave its plane stays taut, since where it buckles
// there are many answers, and rounding chooses among them.
const auto slackened = history::History::table({{0, 0}, {0.4, 0.008}, {0.6, 0.002}, {1, 0.009}});
const auto eased = history::History::table({{0, 0}, {0.4, 0.008}, {0.6, 0.0078}, {1, 0.009}});

std::shared_ptr<model::Model> make_strip(const card::Card& card, bool flat) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.1, 3, 3));
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  if (flat) m->fix("all", model::parse_freedoms("z rotation"));
  m->fix("bottom", model::parse_freedoms("x y z rotation"));
  model::Components up;
  up[1] = flat ? slackened : eased;
  m->move("top", up);
  if (!flat) m->pressure("all", history::History::ramp(20, 1));
  return m;
}

std::shared_ptr<Run> make_static(run::StaticOptions options, bool flat = true) {
  options.duration = 1;
  options.step = 0.07;
  return std::make_shared<run::Static>(make_strip(blend(), flat), options, quiet());
}

std::shared_ptr<Run> make_moving(run::DynamicOptions options) {
  options.duration = 1;
  auto m = make_strip(blend(), false);
  model::InitialVelocity v{"right", Vec3(0, 0, 0.5)};
  m->add(v);
  return run::make_dynamic(m, options, quiet());
}

struct Trace {
  std::vector<double> times, values;
  bool operator==(const Trace&) const = default;
};

void watch(Run& run, Trace& trace) {
  run.every_step([&trace](Run& a) { trace.values.push_back(a.energy().external); });
  run.every(0.13, [&trace](Run& a) { trace.times.push_back(a.time()); });
  run.event([](Run& a) { return a.node(14).u.y() - 0.004; }, 1e-9,
            [&trace](Run& a) { trace.times.push_back(-a.time()); });
}

std::vector<double> result(const Run& run) {
  const auto x = run.assembly().state().x(), d = run.assembly().state().d();
  std::vector<double> all(x.begin(), x.end());
  all.insert(all.end(), d.begin(), d.end());
  for (const auto& s : run.steps()) {
    all.insert(all.end(), {s.time, s.step, double(s.iterations), double(s.cuts), double(s.negative_pivots)});
    all.insert(all.end(), s.residuals.begin(), s.residuals.end());
  }
  const auto e = run.energy();
  const auto f = run.reaction("top");
  all.insert(all.end(), {e.kinetic, e.stored, e.dissipated, e.external, e.damping, e.initial, e.error, f.x(),
                         f.y(), f.z()});
  return all;
}

// Ends at `until`; kept and taken up by a new run at each of `breaks`.
void check_same(const Maker& make, std::vector<double> breaks, double until) {
  Trace whole, parts;
  const auto a = make();
  watch(*a, whole);
  for (const double b : breaks) a->advance(b);
  a->advance(until);
  std::string bytes;
  std::shared_ptr<Run> b;
  for (std::size_t i = 0; i <= breaks.size(); ++i) {
    omp_set_num_threads(1 + static_cast<int>(i) % 2);
    b = make();
    watch(*b, parts);
    if (i > 0) b->resume(bytes);
    b->advance(i < breaks.size() ? breaks[i] : until);
    bytes = b->kept();
  }
  omp_set_num_threads(2);
  CHECK(result(*a) == result(*b));
  CHECK(whole == parts);
  CHECK(a->kept() == b->kept());
}

}  // namespace

TEST_CASE("a static run that is taken up gives the same bits") {
  using namespace run;
  const bool flat = GENERATE(true, false);
  INFO((flat ? "flat" : "free"));
  StaticOptions o;
  SECTION("Newton") {}
  SECTION("stabilised") { o.stabilise = 2e-4; }
  SECTION("either") { o.method = Method::either; }
  SECTION("unsymmetric") { o.linear = Symmetry::unsymmetric; }
  check_same([&] { return make_static(o, flat); }, {0.21, 0.4, 0.55}, 0.8);
}

TEST_CASE("a run along an arc past its limit point that is taken up gives the same bits") {
  const auto make = [] {
    Roof roof;
    roof.cells = 4;
    auto a = std::make_shared<run::Static>(
        make_roof(roof), run::StaticOptions{.duration = 1, .step = 0.1, .control = run::Control::arc},
        quiet());
    return a;
  };
  // By steps: time goes down behind the limit point.
  const auto whole = make();
  for (int i = 0; i < 45; ++i) whole->step();
  CHECK(std::any_of(whole->steps().begin(), whole->steps().end(),
                    [](const auto& s) { return s.negative_pivots > 0; }));
  std::string bytes;
  std::shared_ptr<Run> part;
  for (int i = 0; i < 45; ++i) {
    part = make();
    if (i > 0) part->resume(bytes);
    part->step();
    bytes = part->kept();
  }
  CHECK(whole->kept() == part->kept());
}

TEST_CASE("a run in motion that is taken up gives the same bits") {
  using namespace run;
  DynamicOptions o;
  double until = 0.03;
  std::vector<double> breaks{0.0101, 0.02};
  SECTION("explicit") {}
  SECTION("explicit, damped") {
    o.mass_damping = 20;
    o.stiffness_damping = 1e-5;
    o.gamma = 0.6;
  }
  const auto implicit = [&] {
    o.scheme = Scheme::implicit_steps;
    o.step = 0.01;
    until = 0.6;
    o.ledger_limit = 10;  // of a sheet pushed together at ten times the step that it needs
    breaks = {0.13, 0.4, 0.41};
  };
  SECTION("implicit") { implicit(); }
  SECTION("implicit, alpha method, damped") {
    implicit();
    o.hht = -0.1;
    o.mass_damping = 5;
    o.stiffness_damping = 1e-4;
  }
  check_same([&] { return make_moving(o); }, breaks, until);
}

namespace {

// Cloth hung by an edge beside a ball on which it comes to lie, in steps that are cut, shortened and landed.
std::shared_ptr<Run> make_falling(run::DynamicOptions options) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.1, 3, 3));
  auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
  m->fix("top", model::parse_freedoms("x y z"));
  model::Components down;
  down[2] = history::History::constant(-9.81);
  m->gravity(down);
  const auto ball = std::make_shared<const model::Rigid>(model::Sphere{0.02, Vec3(0.05, 0.03, -0.025)},
                                                         std::nullopt, "", "sphere");
  m->add(model::ContactGiven{{{"", ball}, {"all", nullptr}}, 0.3});
  options.duration = 0.07;
  options.scheme = run::Scheme::implicit_steps;
  options.step = 5e-3;
  return run::make_dynamic(m, options, quiet());
}

struct Interrupted {};

// The run with one call interrupted at its `at`-th evaluation of forces, kept, and taken up by another
// object; without a number the run as it is. Returns whether the run came to that evaluation.
bool interrupt(const std::function<std::shared_ptr<Run>()>& make, int at, std::string& kept, Trace& trace) {
  const auto look = [](Run& run, Trace& seen) {
    run.every_step([&seen](Run& a) { seen.values.push_back(a.energy().external); });
    run.event([](Run& a) { return a.node(14).u.y() - 0.004; }, 1e-9,
              [&seen](Run& a) { seen.times.push_back(a.time()); });
  };
  auto a = make();
  Trace seen;
  look(*a, seen);
  int evaluations = 0;
  a->poll([&] {
    if (++evaluations == at) throw Interrupted();
  });
  bool interrupted = false;
  try {
    a->solve();
  } catch (const Interrupted&) {
    interrupted = true;
    const std::string bytes = a->kept();
    a = make();
    look(*a, seen);
    a->resume(bytes);
    a->solve();
  }
  kept = a->kept();
  trace = seen;
  return interrupted;
}

}  // namespace

TEST_CASE("an implicit step that is interrupted leaves no trace") {
  run::DynamicOptions o;
  SECTION("average acceleration") {}
  SECTION("alpha method, damped") {
    o.hht = -0.1;
    o.mass_damping = 2;
  }
  const auto make = [&] { return make_falling(o); };
  std::string whole, parts;
  Trace seen, seen_in_parts;
  REQUIRE(!interrupt(make, 0, whole, seen));
  for (int at = 18; interrupt(make, at, parts, seen_in_parts); at += 73) {
    INFO("interrupted at evaluation " << at);
    CHECK((seen == seen_in_parts));
    CHECK((parts == whole));
  }
}

TEST_CASE("bytes of another run, or cut short, are refused and leave the run as it was") {
  const auto a = make_static({}), b = make_static({});
  a->advance(0.3);
  const std::string bytes = a->kept();
  const auto moving = make_moving({});
  CHECK_THROWS_AS(moving->resume(bytes), Error);
  CHECK(moving->time() == 0);
  const std::string before = b->kept();
  for (std::size_t n = 0; n < bytes.size(); n += 1 + n / 50) {
    CHECK_THROWS_AS(b->resume(bytes.substr(0, n)), Error);
    REQUIRE(b->kept() == before);
  }
  CHECK_THROWS_AS(b->resume(bytes + "x"), Error);
  b->resume(bytes);
  CHECK(b->time() == 0.3);
}

TEST_CASE("a hook or event added after a run was taken up has its state of then") {
  const auto make = [] { return make_static({}); };
  Trace whole, late;
  const auto a = make();
  watch(*a, whole);
  a->advance(0.5);
  const std::string bytes = a->kept();
  const auto seen = whole;
  a->solve();
  const auto b = make();
  b->resume(bytes);
  late = seen;
  watch(*b, late);
  b->solve();
  CHECK(whole == late);
}
