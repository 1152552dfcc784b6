// Step sizes, threads, stabilisation, relaxation, and what a failure says.
#include <omp.h>

#include "catch.hpp"
#include "message_of.hpp"
#include "run/problems.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using run::Control;
using run::Static;
using run::StaticOptions;

namespace {

// A square plate held on the left, its right edge lifted by a fifth of its length and pushed in by a tenth.
std::shared_ptr<model::Model> make_plate(const card::Card& card, int n, double push = 0) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, 1, n, n));
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->fix("left", model::parse_freedoms("x y z rotation"));
  model::Components lift;
  lift[2] = history::History::ramp(0.2, 1);
  if (push != 0) lift[0] = history::History::ramp(-push, 1);
  m->move("right", lift);
  return m;
}

}  // namespace

TEST_CASE("steps that converge well keep the size that was asked for") {
  Static a(make_plate(isotropic(1e7, 0.3, 0.05), 4), {.duration = 1, .step = 1.0 / 80}, quiet());
  a.solve();
  CHECK(a.steps().size() == 80);
  for (const auto& s : a.steps()) CHECK(std::abs(80 * s.step - 1) < 1e-9);
}

TEST_CASE("a step that is too large is cut, and the run still lands on its end") {
  Static a(make_plate(isotropic(1e7, 0.3, 0.002), 8), {.duration = 1, .step = 0.5, .max_iterations = 4},
           quiet());
  a.solve();
  int cuts = 0;
  for (const auto& s : a.steps()) {
    cuts += s.cuts;
    CHECK(s.step <= 0.5 + 1e-12);
  }
  CHECK(cuts > 0);
  CHECK(a.time() == 1);
}

TEST_CASE("one thread and two give the same bits, in load and along an arc, symmetric or not") {
  const int before = omp_get_max_threads();
  for (const Control control : {Control::load, Control::arc})
    for (const auto linear : {run::Symmetry::symmetric, run::Symmetry::unsymmetric}) {
      std::vector<double> x[2];
      for (const int threads : {1, 2}) {
        omp_set_num_threads(threads);
        StaticOptions options{.duration = 1, .step = 0.1, .linear = linear, .control = control};
        Static a(make_plate(isotropic(1e7, 0.3, 0.02), 24), options, quiet());  // 576 elements: shared out
        a.advance(0.3);
        x[threads - 1] = positions(a);
      }
      CHECK(x[0] == x[1]);
    }
  omp_set_num_threads(before);
}

TEST_CASE("the symmetric and the unsymmetric solver give the same state of woven cloth") {
  std::vector<double> x[2];
  int i = 0;
  for (const auto linear : {run::Symmetry::symmetric, run::Symmetry::unsymmetric}) {
    Static a(make_plate(blend(), 5), {.duration = 1, .step = 0.1, .linear = linear}, quiet());
    a.advance(0.5);
    x[i++] = positions(a);
  }
  double worst = 0;
  for (std::size_t k = 0; k < x[0].size(); ++k) worst = std::max(worst, std::abs(x[0][k] - x[1][k]));
  CHECK(worst < 1e-7);  // m, of a plate of 1 m: both stop at a residual of 1e-10
}

TEST_CASE("relaxation alone arrives where Newton does") {
  std::vector<double> x[2];
  int i = 0;
  for (const auto method : {run::Method::newton, run::Method::relaxation}) {
    Static a(make_plate(isotropic(1e7, 0.3, 0.05), 4), {.duration = 1, .step = 0.25, .method = method},
             quiet());
    a.solve();
    x[i++] = positions(a);
    if (method == run::Method::relaxation) CHECK(a.steps().front().iterations > 50);
  }
  double worst = 0;
  for (std::size_t k = 0; k < x[0].size(); ++k) worst = std::max(worst, std::abs(x[0][k] - x[1][k]));
  CHECK(worst < 1e-9);
}

TEST_CASE("relaxation of stiffening cloth converges to a balance or fails; never to what is not a number") {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.0254, 0.0762, 2, 6));
  auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
  m->fix("all", model::parse_freedoms("z rotation"));
  m->fix("bottom", model::parse_freedoms("x y"));
  m->fix("top", model::parse_freedoms("x"));
  model::Components up;
  up[1] = history::History::table({{0, 0}, {1, 0.01}, {2, 0.0095}});
  m->move("top", up);
  // one step of a tenth of the pull stiffens the row at the grip tenfold before the others know of it
  Static a(m, {.duration = 2, .step = 0.1, .method = run::Method::relaxation}, quiet());
  try {
    a.solve();
  } catch (const NumericalFailure&) {
  }
  REQUIRE_FALSE(a.steps().empty());
  for (const auto& step : a.steps()) {
    CHECK(step.iterations > 0);
    CHECK(step.residuals.back() <= 1e-10);
  }
  CHECK(std::isfinite(a.reaction("top")[1]));
  CHECK(std::isfinite(a.energy().stored));
}

TEST_CASE("a residual that is not a number is the largest of all") {
  const auto m = make_plate(isotropic(1e7, 0.3, 0.05), 2);
  mechanics::Assembly assembly(*m);
  std::vector<double> r(static_cast<std::size_t>(assembly.dofs().unknowns()), 1.0);
  r[3] = std::nan("");
  CHECK(std::isinf(assembly.largest_residual(r).first));
  CHECK(assembly.largest_residual(r).second == 3);
}

TEST_CASE("stabilisation takes the fraction of the work that it is told, and reports it") {
  for (const double fraction : {2e-4, 2e-3}) {
    Static a(make_plate(isotropic(1e7, 0.3, 0.05), 4), {.duration = 1, .step = 0.05, .stabilise = fraction},
             quiet());
    a.solve();
    const auto e = a.energy();
    INFO("damping " << e.damping << " of " << e.external);
    CHECK(e.damping > 0.1 * fraction * e.external);
    CHECK(e.damping < 2 * fraction * e.external);
    CHECK(e.error < 5e-3);  // the trapezoid over 20 steps
  }
}

TEST_CASE("bad options say what they are and what they may be") {
  const auto message = [](const StaticOptions& options) {
    return message_of([&] { Static(make_plate(isotropic(1e7, 0.3, 0.05), 2), options, quiet()); });
  };
  says(message({.duration = 1, .control = Control::arc, .stabilise = 1e-3}), "field 'control'");
  says(message({.duration = 1, .stabilise = -1}), "field 'stabilise'");
  says(message({.duration = 1, .step = 0.1, .min_step = 0.2}), "field 'min_step'");
}

TEST_CASE("a part that can move freely: the failure names the cause in two lines") {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, 1, 2, 2));
  auto m = std::make_shared<model::Model>(mesh, isotropic(1e7, 0.3, 0.01), model::Options{});
  model::Components pull;
  pull[0] = history::History::ramp(1, 1);
  m->force("right", pull);
  Static a(m, {.duration = 1}, quiet());
  try {
    a.solve();
    FAIL("no failure");
  } catch (const NumericalFailure& failure) {
    const std::string message = failure.what();
    INFO(message);
    CHECK(std::count(message.begin(), message.end(), '\n') == 1);
    says(message, "the tangent is singular");
    says(message, "\nTry: supports that leave no part free");
  }
}

TEST_CASE("a static run speaks of relaxation only where the cloth may have fallen") {
  const auto said_of = [](double step, bool pulled) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.0254, 0.0762, 1, 3));
    auto m = std::make_shared<model::Model>(mesh, test::blend(), model::Options{});
    m->fix("all", model::parse_freedoms("z rotation"));
    m->fix("bottom", model::parse_freedoms("x y"));
    model::Components pull;
    pull[1] = history::History::ramp(100, 1);
    if (pulled)
      m->force("top", pull);
    else
      m->gravity(model::steady({0, 1e5, 0}));
    std::string said;
    auto notices = std::make_shared<Notices>([&](const std::string& text) { said += text + "\n"; });
    run::StaticOptions options;
    options.duration = 1;
    options.step = step;
    run::Static a(m, options, notices);
    a.solve();
    const auto e = a.energy();
    INFO(said << e.error);
    CHECK(e.error < 1e-12);
    CHECK((e.relaxed > 0.05 * e.external) == !pulled);
    return said;
  };
  // A load that stiffens would do more work by the trapezium than the cloth takes up: that is its work.
  CHECK(said_of(0.5, true).find("relaxation") == std::string::npos);
  CHECK(said_of(0.02, true).find("relaxation") == std::string::npos);
  // A weight that is there from the first gives more than the cloth takes up: that is not the steps' fault.
  CHECK(said_of(0.02, false).find("relaxation") == std::string::npos);
}
