// Warnings of a run: by code, as part of its state, as an error where that is asked for.
#include "catch.hpp"
#include "run/dynamic.hpp"
#include "run/problems.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using run::Run;

namespace {

// A strip of three elements, 0.09 m long, that cannot narrow: pulled by `end` (m) over 1 s it is strained
// alike everywhere, E = u/L + (u/L)^2/2. Its card was tested to the strain at 3 mm.
constexpr double length = 0.09;
double strain(double u) { return u / length + u * u / (2 * length * length); }

std::shared_ptr<model::Model> make_strip(double end) {
  card::Card card = blend();
  std::get<card::Woven>(card.law).tested.weft = strain(0.003);
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.02, length, 1, 3));
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->fix("all", model::parse_freedoms("x z rotation"));
  m->fix("bottom", model::parse_freedoms("y"));
  model::Components pull;
  pull[1] = history::History::ramp(end, 1);
  m->move("top", pull);
  return m;
}

std::shared_ptr<Run> make_pulled(double end, std::shared_ptr<Notices> notices = quiet()) {
  return std::make_shared<run::Static>(make_strip(end), run::StaticOptions{.duration = 1, .step = 0.1},
                                       std::move(notices));
}

// One element whose every node is driven, through its own length and 2 mm beyond it.
std::shared_ptr<Run> make_turned() {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.02, 0.01, 1, 1));
  auto m = std::make_shared<model::Model>(mesh, isotropic(1e6, 0.3, 1e-3), model::Options{});
  m->fix("all", model::parse_freedoms("x z rotation"));
  m->fix("bottom", model::parse_freedoms("y"));
  model::Components push;
  push[1] = history::History::ramp(-0.012, 1e-3);
  m->move("top", push);
  return run::make_dynamic(m, {.duration = 1e-3, .ledger_limit = 1e9}, quiet());
}

std::vector<std::string> codes(const Run& run) {
  std::vector<std::string> all;
  for (const auto& w : run.warnings()) all.push_back(w.code);
  return all;
}

bool has(const Run& run, const std::string& code) {
  const auto all = codes(run);
  return std::find(all.begin(), all.end(), code) != all.end();
}

}  // namespace

TEST_CASE("a warning has a code, the time, the element and the words that were said") {
  std::vector<std::string> said;
  const auto a =
      make_pulled(0.01, std::make_shared<Notices>([&](const std::string& text) { said.push_back(text); }));
  a->advance(0.3);  // 3 mm: up to what was tested
  CHECK(a->warnings().empty());
  a->solve();
  REQUIRE(codes(*a) == std::vector<std::string>{"beyond"});
  const run::Warning& w = a->warnings()[0];
  CHECK(std::abs(w.time - 0.4) < 1e-12);
  CHECK(w.element >= 0);
  CHECK(w.element < 3);
  CHECK_FALSE(w.serious);
  REQUIRE(said.size() == 1);
  CHECK(said[0] == "warning: " + w.text);
  CHECK(w.text.starts_with("static: at time 0.4 s the weft of element "));
}

TEST_CASE(
    "warnings are state of the run: a snapshot returns to those of its time, another process goes on with "
    "them") {
  const auto whole = make_pulled(0.01);
  for (const double time : {0.2, 0.6, 1.0}) whole->advance(time);
  const auto a = make_pulled(0.01);
  a->advance(0.2);
  const auto early = a->snapshot();
  a->advance(0.6);
  CHECK(codes(*a) == std::vector<std::string>{"beyond"});
  const std::string kept = a->kept();
  a->restore(*early);
  CHECK(a->warnings().empty());
  a->advance(0.7);  // said once, kept each time that it comes true
  CHECK(codes(*a) == std::vector<std::string>{"beyond"});

  const auto b = make_pulled(0.01);
  b->note("lost", "restart: an output is gone");
  b->resume(kept);
  CHECK(codes(*b) == std::vector<std::string>{"beyond", "lost"});
  b->solve();
  CHECK(codes(*b) == std::vector<std::string>{"beyond", "lost"});
  const auto &first = whole->warnings()[0], &again = b->warnings()[0];
  CHECK(again.text == first.text);
  CHECK(again.time == first.time);
  CHECK(again.element == first.element);
}

TEST_CASE("a strict run ends at each serious warning, once, with a report; one that is not strict goes on") {
  const auto barrier_free_blocks = make_turned();
  barrier_free_blocks->solve();
  CHECK(has(*barrier_free_blocks, "inverted"));

  const auto a = make_turned();
  a->be_strict();
  std::string message, why;
  double time = 0;
  const auto caught = [&] {
    try {
      a->solve();
    } catch (const NumericalFailure& failure) {
      message = failure.what(), why = failure.why, time = failure.time;
      CHECK(failure.element == (message.find("inside out") != std::string::npos ? 0 : failure.element));
      return true;
    }
    return false;
  };
  int failures = 0;
  bool inverted = false;
  while (caught()) {
    ++failures;
    CHECK(message.find("(an error under --strict)") != std::string::npos);
    if (message.find("is turned inside out") == std::string::npos) continue;
    inverted = true;
    CHECK(time > 10e-3 / 12e-3 * 1e-3);  // where it has no length
    CHECK(time == a->time());
    CHECK(why.starts_with("dynamic: element 1 is turned inside out"));
    CHECK(a->why() == why);
  }
  CHECK(inverted);
  CHECK(a->time() == barrier_free_blocks->time());
  const auto& all = a->warnings();
  CHECK(failures == std::count_if(all.begin(), all.end(), [](const auto& w) { return w.serious; }));
  CHECK(codes(*a) == codes(*barrier_free_blocks));
}

TEST_CASE(
    "a strict run that is taken up elsewhere does not raise again what it has raised, but what it has not") {
  const auto a = make_turned(), b = make_turned(), c = make_turned();
  a->solve();
  const auto serious =
      std::count_if(a->warnings().begin(), a->warnings().end(), [](const auto& w) { return w.serious; });
  const auto raised = [](Run& run) {
    int n = 0;
    for (;; ++n) try {
        run.solve();
        return n;
      } catch (const NumericalFailure&) {
      }
  };
  b->be_strict();
  b->resume(a->kept());
  CHECK(raised(*b) == serious);
  c->be_strict();
  c->resume(b->kept());
  CHECK(raised(*c) == 0);
}

TEST_CASE("beyond what was tested is serious where the run was told to stop there") {
  const auto a = make_pulled(0.01);
  a->stop_beyond();
  a->be_strict();
  std::string message;
  std::int64_t element = -1;
  try {
    a->solve();
  } catch (const NumericalFailure& failure) {
    message = failure.what();
    element = failure.element;
  }
  CHECK(message.find("is strained to E22 = ") != std::string::npos);
  CHECK(element >= 0);
  const auto b = make_pulled(0.01);
  b->be_strict();
  b->solve();
  CHECK(b->time() == 1);
}

TEST_CASE("each kind of warning is explained") {
  for (const run::WarningKind& kind : run::warning_kinds()) {
    INFO(kind.code);
    CHECK(std::string(kind.sentence).size() > 10);
    CHECK(std::string(run::warning_kind(kind.code).code) == kind.code);
  }
}
