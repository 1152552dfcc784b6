// What a run makes of its terms: of couplings that come on the way, of the step that a term is told, and of
// its answers.
#include "catch.hpp"
#include "mechanics/springs_of_pairs.hpp"
#include "message_of.hpp"
#include "run/dynamic.hpp"
#include "run/problems.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

// A square sheet whose right side is drawn away from the left one, along a table of displacements.
std::shared_ptr<model::Model> make_sheet(const std::vector<std::pair<double, double>>& way) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.04, 0.04, 4, 4));
  auto m = std::make_shared<model::Model>(mesh, isotropic(1e6, 0.3, 1e-3), model::Options{});
  m->fix("left", model::parse_freedoms("x y z rotation"));
  model::Components along;
  along[0] = history::History::table(way);
  m->move("right", along);
  m->fix("right", model::parse_freedoms("y z rotation"));
  return m;
}

// Of nodes within the sheet, 0.02 m apart.
const std::vector<mechanics::NodePair> inner = {{6, 8}, {11, 13}, {18, 16}};

std::unique_ptr<SpringsOfPairs> springs(bool all) {
  auto made = std::make_unique<SpringsOfPairs>(inner, std::vector{0.0203, 0.0207, 0.0212}, 3e6);
  made->names_all = all;
  return made;
}

const std::vector<std::pair<double, double>> there_and_back = {{0, 0}, {0.5, 0.004}, {1, 0.0005}};

std::shared_ptr<run::Static> stretched(bool all) {
  run::StaticOptions options;
  options.duration = 1;
  options.step = 0.1;
  auto a = std::make_shared<run::Static>(make_sheet(there_and_back), options, quiet());
  a->add(springs(all));
  return a;
}

std::vector<double> positions(const run::Run& a) {
  const auto x = a.assembly().state().x();
  return {x.begin(), x.end()};
}

// Answers as it is told by what step it is in; forces none.
class Adviser final : public mechanics::Term {
 public:
  using Says = std::function<mechanics::Outcome(const law::Step&)>;
  explicit Adviser(Says says) : says_(std::move(says)) {}
  const char* name() const override { return "adviser"; }
  mechanics::Outcome add_forces(const law::Step& step, const mechanics::Trial&, mechanics::Forces&) override {
    return says_(step);
  }

 private:
  Says says_;
};

enum class Way { statics, implicit_steps, explicit_steps };

std::shared_ptr<run::Run> make_run(Way way, Adviser::Says says) {
  auto model = make_sheet({{0, 0}, {1, 1e-6}});
  std::shared_ptr<run::Run> a;
  if (way == Way::statics) {
    run::StaticOptions options;
    options.duration = 1e-4;
    options.step = 1e-5;
    a = std::make_shared<run::Static>(model, options, quiet());
  } else {
    run::DynamicOptions options;
    options.duration = 1e-4;
    options.step = way == Way::implicit_steps ? 1e-5 : 1e-6;
    options.scheme = way == Way::implicit_steps ? run::Scheme::implicit_steps : run::Scheme::explicit_steps;
    a = run::make_dynamic(model, options, quiet());
  }
  a->add(std::make_unique<Adviser>(std::move(says)));
  return a;
}

// The text of the NumericalFailure that ends a run.
std::string failure_of(run::Run& a) {
  try {
    a.solve();
  } catch (const NumericalFailure& failure) {
    return failure.what();
  }
  return "no failure";
}

constexpr Way all_ways[] = {Way::statics, Way::implicit_steps, Way::explicit_steps};

}  // namespace

TEST_CASE("a run whose pattern grows on the way ends where one does that had all couplings from the start") {
  const auto grows = stretched(false), has_all = stretched(true);
  grows->solve();
  has_all->solve();
  const auto x = positions(*grows), y = positions(*has_all);
  double apart = 0;
  for (std::size_t i = 0; i < x.size(); ++i) apart = std::max(apart, std::abs(x[i] - y[i]));
  CHECK(apart < 1e-13);  // m; the orders of elimination differ
  CHECK((grows->reaction("right") - has_all->reaction("right")).norm() < 1e-8);  // of 10 N
  // Few iterations: the tangent has the springs in it.
  for (const auto& step : grows->steps()) CHECK(step.iterations <= 6);
}

TEST_CASE("a run whose pattern has grown goes on from a kept state with the same bits") {
  const auto whole = stretched(false);
  whole->solve();
  for (const double stop : {0.25, 0.5, 0.8}) {
    const auto first = stretched(false);
    first->advance(stop);
    const std::string kept = first->kept();
    // Neither what was tried before the state is taken up, nor that nothing was, makes a difference.
    first->solve();
    first->resume(kept);
    first->solve();
    const auto second = stretched(false);
    second->resume(kept);
    second->solve();
    INFO("stopped at " << stop);
    CHECK(positions(*second) == positions(*first));
    // The whole run lands on 0.5 too, a kink of the motion.
    if (stop == 0.5) CHECK(positions(*second) == positions(*whole));
  }
}

TEST_CASE("a term is told the step under way: from the committed time, as long as it is") {
  for (const Way way : all_ways) {
    std::vector<law::Step> told;
    const auto a = make_run(way, [&](const law::Step& step) {
      told.push_back(step);
      return mechanics::Outcome{};
    });
    a->step();
    told.clear();
    const double from = a->time();
    a->step();
    REQUIRE(!told.empty());
    for (const auto& step : told) {
      CHECK(step.t0 == from);
      CHECK(step.dt == a->time() - from);
    }
  }
}

TEST_CASE("a term that asks for a shorter step gets one, without a word, and the run goes on") {
  for (const Way way : all_ways) {
    const double longest = way == Way::explicit_steps ? 4e-7 : 4e-6;  // s
    const auto a = make_run(way, [&](const law::Step& step) {
      if (step.t0 < 3e-5 || step.dt <= longest) return mechanics::Outcome{};
      return mechanics::Outcome{Answer::cut, -1, "in a hurry"};
    });
    a->solve();
    CHECK(std::abs(a->time() - 1e-4) < 1e-16);
    double most = 0;
    int cuts = 0;
    for (const auto& step : a->steps()) {
      if (step.time > 3.0001e-5 + longest) most = std::max(most, step.step);
      cuts += step.cuts;
    }
    CHECK(most <= longest);
    CHECK(cuts > 0);
    CHECK(a->why().empty());
  }
}

TEST_CASE("a term that is cut for ever, or broken, ends the run with its words, in its report as well") {
  for (const Way way : all_ways)
    for (const Answer answer : {Answer::cut, Answer::broken}) {
      int tries = 0;
      const auto a = make_run(way, [&](const law::Step& step) {
        if (step.t0 < 3e-5) return mechanics::Outcome{};
        ++tries;
        return mechanics::Outcome{answer, 4, "the seam is torn"};
      });
      const std::string message = failure_of(*a);
      INFO(message);
      CHECK(message.find("the seam is torn") != std::string::npos);
      CHECK(a->why().find("the seam is torn") != std::string::npos);
      CHECK(message.find("element 5") != std::string::npos);
      CHECK((message.find("stopped at time") != std::string::npos) ==
            (answer == Answer::broken || way == Way::explicit_steps));
      CHECK((answer == Answer::broken ? tries == 1 : tries > 12));
      CHECK(a->time() < 4.2e-5);
    }
}

TEST_CASE("a term is added before the run begins, and with a symmetric tangent") {
  const auto a = stretched(false);
  a->step();
  CHECK(message_of([&] { a->add(springs(false)); }) ==
        "a term 'springs of pairs': expected before the run begins");
}
