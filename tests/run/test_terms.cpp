// What a run makes of its terms: of couplings that come on the way, of the step that a term is told, and of
// its answers.
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/springs_of_pairs.hpp"
#include "message_of.hpp"
#include "run/dynamic.hpp"
#include "run/job.hpp"
#include "run/problems.hpp"
#include "run/result_fields.hpp"
#include "scratch.hpp"

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

namespace {

// Springs from some nodes to the ground along x that slip at a largest force: a term with a state, two
// energies, a section of a checkpoint and a field.
class Brake final : public mechanics::Term {
 public:
  Brake(std::size_t all, std::vector<mechanics::Index> nodes, double k, double largest)
      : nodes_(std::move(nodes)),
        k_(k),
        largest_(largest),
        slip_(all),
        trial_(all),
        lost_(all),
        spent_(all) {}
  const char* name() const override { return "brake"; }
  mechanics::Outcome add_forces(const law::Step&, const mechanics::Trial& trial,
                                mechanics::Forces& forces) override {
    for (const auto n : nodes_) {
      const double u = moved(trial, n), over = std::abs(k_ * (u - slip_[n])) - largest_;
      trial_[n] = over > 0 ? slip_[n] + std::copysign(over / k_, u - slip_[n]) : slip_[n];
      spent_[n] = lost_[n] + largest_ * std::abs(trial_[n] - slip_[n]);
      forces.on_x[3 * n] += k_ * (u - trial_[n]);
    }
    return {};
  }
  void add_tangent(const mechanics::Trial&, mechanics::TangentSink& sink) const override {
    for (const auto n : nodes_)
      if (trial_[n] == slip_[n]) sink.on_positions(n, n, Vec3(k_, 0, 0).asDiagonal());
  }
  void add_energies(const mechanics::Trial& trial, std::vector<mechanics::Energy>& out) const override {
    double stored = 0, spent = 0;
    for (const auto n : nodes_) {
      stored += k_ / 2 * std::pow(moved(trial, n) - trial_[n], 2);
      spent += spent_[n];
    }
    out.push_back({"brake", mechanics::Account::stored, stored});
    out.push_back({"brake", mechanics::Account::dissipated, spent});
  }
  std::vector<mechanics::TermField> shows() const override {
    return {{"slip", "m", "how far the brake has slipped at a node", false,
             [this](mechanics::Index n) { return slip_[n]; }}};
  }
  void commit() override { slip_ = trial_, lost_ = spent_; }
  void rollback() override { trial_ = slip_, spent_ = lost_; }
  void keep(Archive& archive) override {
    archive(slip_, lost_);
    if (archive.reading()) rollback();
  }

 private:
  static double moved(const mechanics::Trial& trial, mechanics::Index n) {
    return at(trial.configuration.x(), n).x() - trial.X[n].x();
  }
  std::vector<mechanics::Index> nodes_;
  double k_, largest_;  // N/m, N
  std::vector<double> slip_, trial_, lost_, spent_;
};

constexpr double brake_force = 0.05;  // N

std::shared_ptr<run::Static> braked() {
  run::StaticOptions options;
  options.duration = 1;
  options.step = 0.02;
  auto a = std::make_shared<run::Static>(make_sheet({{0, 0}, {0.5, 0.004}, {1, 0.0005}}), options, quiet());
  a->add(std::make_unique<Brake>(25, std::vector<mechanics::Index>{7, 12, 17}, 1e3, brake_force));
  return a;
}

}  // namespace

TEST_CASE("a term of one's own is in the ledger, with what it stores and what it loses") {
  const auto a = braked();
  a->solve();
  const auto slip = a->field("slip");
  REQUIRE(slip.size() == 25);
  CHECK(slip[0] == 0);
  CHECK(std::abs(slip[12]) > 1e-4);
  // Isotropic cloth loses nothing. There and back: the way of the slip is longer than what is left of it.
  const auto energy = a->energy();
  CHECK(energy.dissipated > brake_force * (std::abs(slip[7]) + std::abs(slip[12]) + std::abs(slip[17])));
  CHECK(energy.error < 2e-3);  // the trapezoidal rule, over steps in which a brake starts to slip
}

TEST_CASE("a field that a term shows is read like every other one, and goes to files") {
  const ScratchFolder scratch;
  const auto a = braked();
  run::Job job(a);
  const std::string stem = scratch / "pull";
  job.vtk(stem, 0.5, std::vector<std::string>{"slip", "S11"});
  CHECK(message_of([&] {
          job.vtk(stem + "2", 0.5, std::vector<std::string>{"slide"});
        }).starts_with("vtk: field 'fields': unknown field 'slide'"));
  job.solve();
  const run::VtkFrame frame(*a, {{"slip", "S11"}});
  const auto found = std::find_if(frame.grid().point_data.begin(), frame.grid().point_data.end(),
                                  [](const auto& array) { return array.name == "slip"; });
  REQUIRE(found != frame.grid().point_data.end());
  CHECK(found->unit == "m");
  CHECK(found->values == a->field("slip"));
  CHECK(content_of(stem + "_00002.vtu").find("Name=\"slip\"") != std::string::npos);
  const auto usual = run::VtkFrame(*a, {}).grid().point_data;
  CHECK(std::any_of(usual.begin(), usual.end(), [](const auto& array) { return array.name == "slip"; }));
  const auto slip = a->field("slip");
  double sum = 0;
  for (const double x : slip) sum += x;
  CHECK(a->mean("slip") == sum / 25);
  CHECK(message_of([&] { (void)a->mean("displacement"); }) ==
        "mean: expected a field of one number, got 'displacement'");
  CHECK(message_of([] {
          const auto b = braked();
          b->add(std::make_unique<Brake>(25, std::vector<mechanics::Index>{1}, 1.0, 1.0));
        }) == "a term 'brake': its field 'slip' has the name of another field");
}

TEST_CASE(
    "a term's state is kept: a run goes on from half way with the same bits, slip and losses included") {
  const auto whole = braked(), first = braked(), second = braked();
  whole->solve();
  first->advance(0.5);
  second->resume(first->kept());
  CHECK(second->field("slip") == first->field("slip"));
  second->solve();
  CHECK(positions(*second) == positions(*whole));
  CHECK(second->field("slip") == whole->field("slip"));
  CHECK(second->energy().dissipated == whole->energy().dissipated);
}
