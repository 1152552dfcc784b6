// Hooks, events and snapshots: what fires when, what an error leaves, what a restored run does.
#include "catch.hpp"
#include "message_of.hpp"
#include "run/problems.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using run::Run;
using run::Static;

namespace {

// A strip of one element pulled along y by a history.
std::shared_ptr<model::Model> make_pull(const history::History& h, const card::Card& card = blend()) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.1, 1, 1));
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->fix("all", model::parse_freedoms("z rotation"));
  m->fix("bottom", model::parse_freedoms("x y"));
  model::Components up;
  up[1] = h;
  m->move("top", up);
  return m;
}

std::unique_ptr<Static> make_run(double step = 0.25) {
  return std::make_unique<Static>(make_pull(history::History::ramp(0.008, 1)),
                                  run::StaticOptions{.duration = 1, .step = step}, quiet());
}

double pull(const Run& a) { return a.node(2).u.y(); }

struct Fired {
  std::vector<double> times;
  Run::Hook hook() {
    return [this](Run& a) { times.push_back(a.time()); };
  }
};

}  // namespace

TEST_CASE("an event whose value comes to exactly zero at the end of a step fires there, once") {
  const auto a = make_run();
  Fired fired;
  // 0.5 of 0.008 is exact in binary: the value rises to zero without passing it.
  a->event([](Run& run) { return pull(run) - 0.5 * 0.008; }, 1e-12, fired.hook());
  a->solve();
  CHECK(fired.times == std::vector<double>{0.5});
}

TEST_CASE("an event inside a step is landed on, in order, whatever order they were declared in") {
  for (const bool swapped : {false, true}) {
    const auto a = make_run(1);
    Fired early, late;
    const auto add_early = [&] { a->event([](Run& r) { return pull(r) - 0.002; }, 1e-9, early.hook()); };
    const auto add_late = [&] { a->event([](Run& r) { return 0.006 - pull(r); }, 1e-9, late.hook()); };
    swapped ? add_late() : add_early();
    swapped ? add_early() : add_late();
    a->solve();
    REQUIRE(early.times.size() == 1);
    REQUIRE(late.times.size() == 1);
    CHECK(std::abs(early.times[0] - 0.25) < 1e-8);  // of the event's own tolerance
    CHECK(std::abs(late.times[0] - 0.75) < 1e-8);
    CHECK(a->time() == 1);
  }
}

TEST_CASE("a step that ends within the tolerance on the near side fires, and not again on the way out") {
  const auto a = make_run(0.1);
  Fired fired;
  a->event([](Run& r) { return pull(r) - 0.004002; }, 1e-3, fired.hook());  // 2e-6 short of it at t = 0.5
  a->solve();
  REQUIRE(fired.times.size() == 1);
  CHECK(std::abs(fired.times[0] - 0.5) < 1e-12);
}

TEST_CASE("an event fires again when its value comes back, and one added under way sees the next step") {
  Static a(make_pull(history::History::table({{0, 0}, {1, 0.008}, {2, 0}})), {.duration = 2, .step = 0.3},
           quiet());
  Fired both, second;
  a.event([](Run& r) { return pull(r) - 0.004; }, 1e-9, both.hook());
  a.advance(0.9);
  a.event([](Run& r) { return pull(r) - 0.0075; }, 1e-9, second.hook());
  a.solve();
  REQUIRE(both.times.size() == 2);
  CHECK(std::abs(both.times[1] - 1.5) < 1e-8);
  REQUIRE(second.times.size() == 2);
  CHECK(std::abs(second.times[0] - 0.9375) < 1e-8);
}

TEST_CASE("a value that jumps over zero fires at the far side of the jump") {
  const auto a = make_run(1);
  Fired fired;
  a->event([](Run& r) { return pull(r) < 0.003 ? -1.0 : 1.0; }, 1e-6, fired.hook());
  a->solve();
  REQUIRE(fired.times.size() == 1);
  CHECK(fired.times[0] >= 0.375);
  CHECK(fired.times[0] < 0.375 + 1e-9);
}

TEST_CASE("an error in a hook loses none of the later ones; an output is called again, a hook is not") {
  const auto a = make_run(0.5);
  std::vector<std::string> log;
  bool broken = true;
  const auto say = [&log](const std::string& who) {
    return [&log, who](Run& r) { log.push_back(who + std::to_string(static_cast<int>(10 * r.time()))); };
  };
  a->every_step([&](Run& r) {
    if (broken && r.time() > 0) throw Error("typo");
    say("hook")(r);
  });
  a->every_step(
      [&](Run& r) {
        if (broken && r.time() == 0) throw Error("disk full");
        say("row")(r);
      },
      Run::AfterError::repeat);
  a->every_step(say("last"));
  CHECK_THROWS_AS(a->solve(), Error);  // the row of time 0
  CHECK(log == std::vector<std::string>{"hook0"});
  broken = false;
  a->step();
  CHECK(log == std::vector<std::string>{"hook0", "row0", "last0", "hook5", "row5", "last5"});
  broken = true;
  CHECK_THROWS_AS(a->solve(), Error);  // the hook of time 1
  broken = false;
  a->solve();
  CHECK(log.size() == 8);
  CHECK(log[6] == "row10");
  CHECK(log[7] == "last10");
}

TEST_CASE("a run that was stopped goes on when it is told to") {
  const auto a = make_run(0.25);
  a->every_step([](Run& r) {
    if (std::abs(r.time() - 0.5) < 1e-9) r.stop("half way");
  });
  a->solve();
  CHECK(a->time() == 0.5);
  CHECK(a->stop_reason() == "half way");
  a->solve();
  CHECK(a->time() == 1);
  CHECK(!a->stopped());
}

TEST_CASE("a run does not go back by being told to advance") {
  const auto a = make_run(0.25);
  a->advance(0.5);
  a->advance(0.5);
  says(message_of([&] { a->advance(0.25); }), "advance: expected a time from 0.5 s");
}

TEST_CASE("a hook can't drive its own run") {
  const auto a = make_run(0.5);
  a->every_step([](Run& r) { r.step(); });
  says(message_of([&] { a->solve(); }), "step: not from a hook of the same run");
}

TEST_CASE("restored, a run gives the same bits as if it had never gone on") {
  const auto history = history::History::table({{0, 0}, {1, 0.008}, {1.5, 0.003}, {2, 0.006}});
  for (const auto control : {run::Control::load, run::Control::arc}) {
    std::vector<std::vector<double>> ends;
    std::vector<double> reactions, energies;
    std::vector<std::size_t> steps;
    for (const bool detour : {false, true}) {
      const bool arc = control == run::Control::arc;
      Static a(make_pull(history, arc ? isotropic(1e7, 0.3, 0.02) : blend()),
               {.duration = 2, .step = 0.07, .control = control}, quiet());
      Fired fired;
      a.event([](Run& r) { return pull(r) - 0.005; }, 1e-9, fired.hook());
      std::shared_ptr<const Run::Snapshot> s;
      for (const double first : {0.0, 1.2}) {
        if (first > 0) a.advance(first);
        s = a.snapshot();
        if (!detour) continue;
        a.advance(first + 0.5);
        a.restore(*s);
        CHECK(a.time() == first);
      }
      reactions.push_back(a.reaction("top").y());
      energies.push_back(a.energy().external);
      a.solve();
      const auto x = a.assembly().state().x();
      ends.emplace_back(x.begin(), x.end());
      reactions.push_back(a.reaction("top").y());
      energies.push_back(a.energy().external);
      steps.push_back(a.steps().size());
    }
    CHECK(ends[0] == ends[1]);
    CHECK(steps[0] == steps[1]);
    for (int i = 0; i < 2; ++i) {
      CHECK(reactions[i] == reactions[2 + i]);
      CHECK(energies[i] == energies[2 + i]);
    }
  }
}

TEST_CASE("the external work counts moments, turned grips and pressure") {
  // Work that is not counted would be missing: it is taken from the cloth's only within what the forces at
  // both ends of a step allow.
  const auto error_of = [](const std::function<void(model::Model&)>& load, double step) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, 0.2, 8, 2));
    auto m = std::make_shared<model::Model>(mesh, isotropic(1e7, 0.3, 0.02), model::Options{});
    m->fix("left", model::parse_freedoms("x y z rotation"));
    load(*m);
    Static a(m, {.duration = 1, .step = step, .tolerance = 1e-12}, quiet());
    a.solve();
    const auto e = a.energy();
    CHECK(e.external > 1e-6);
    CHECK(e.stored > 1e-6);
    CHECK(e.error < 1e-12);
    return std::abs(e.external - e.internal()) / e.external;
  };
  const std::function<void(model::Model&)> loads[] = {
      [](model::Model& m) {
        model::Components about_y;
        about_y[1] = history::History::ramp(0.3, 1);
        m.add<model::MomentLoad>({"right", about_y});
      },
      [](model::Model& m) {
        m.add<model::PrescribedTurn>({"right", Vec3::UnitY(), history::History::ramp(20, 1), std::nullopt});
      },
      [](model::Model& m) { m.pressure("all", history::History::ramp(5, 1)); }};
  for (const auto& load : loads) {
    for (const double step : {0.1, 0.05}) CHECK(error_of(load, step) < 1e-12);
  }
}

TEST_CASE("a strip pushed past zero length is not turned inside out but fails, whatever solves it") {
  const auto pushed = [&](double end, run::Method method, double step) {
    Static a(make_pull(history::History::ramp(end, 1), isotropic(1e7, 0, 0.02)),
             {.duration = 1, .step = step, .method = method}, quiet());
    a.solve();
  };
  CHECK_NOTHROW(pushed(-0.03, run::Method::newton, 0.01));
  // 0.15 is more than the strip is long.
  for (const auto method : {run::Method::newton, run::Method::relaxation, run::Method::either})
    CHECK_THROWS_AS(pushed(-0.15, method, 1), NumericalFailure);
  CHECK_THROWS_AS(pushed(-0.15, run::Method::newton, 0.01), NumericalFailure);
}
