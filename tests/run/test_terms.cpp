// A run and its terms: couplings that come on the way, the step that a term is given, and a term's
// answers.
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/facets.hpp"
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

// The right edge moves by 1e-6 m in `time`, s; the run takes 1e-4 s.
std::shared_ptr<run::Run> make_run(Way way, Adviser::Says says, double time = 1) {
  auto model = make_sheet({{0, 0}, {time, 1e-6}});
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

namespace {

// Lets some nodes move by no more than so much before forces are computed again: a term that limits steps.
class Leash final : public mechanics::Term, public mechanics::StepLimiter {
 public:
  Leash(std::vector<mechanics::Index> nodes, double reach) : nodes_(std::move(nodes)), reach_(reach) {}
  const char* name() const override { return "leash"; }
  void mark(const mechanics::Trial& trial) override {
    const auto x = trial.configuration.x();
    marked_.assign(x.begin(), x.end());
  }
  double safe_fraction(const mechanics::Trial& trial) override {
    double most = 0;
    for (const auto n : nodes_)
      most = std::max(most, (at(trial.configuration.x(), n) - at(marked_, n)).norm());
    if (most <= reach_ * (1 + 1e-9)) return 1;
    ++shortened;
    return reach_ / most;
  }
  int shortened = 0;

 private:
  std::vector<mechanics::Index> nodes_;
  double reach_;  // m
  std::vector<double> marked_;
};

// Springs along x from some nodes to a carriage without mass, which a further spring holds: a term with an
// unknown of its own, the place c of the carriage, k sum(u - c) = k_0 c.
class Carriage final : public mechanics::Term, public mechanics::OwnUnknowns {
 public:
  Carriage(std::vector<mechanics::Index> nodes, double k, double k0)
      : nodes_(std::move(nodes)), k_(k), all_(k0 + k * static_cast<double>(nodes_.size())) {}
  double place() const { return c_; }
  double balanced_place() const { return k_ * sum_ / all_; }  // m, where the nodes' springs want it

  const char* name() const override { return "carriage"; }
  mechanics::Outcome add_forces(const law::Step&, const mechanics::Trial& trial,
                                mechanics::Forces& forces) override {
    sum_ = 0;
    for (const auto n : nodes_) {
      const double u = at(trial.configuration.x(), n).x() - trial.X[n].x();
      forces.on_x[3 * n] += k_ * (u - c_);
      sum_ += u;
    }
    return {};
  }
  void add_tangent(const mechanics::Trial&, mechanics::TangentSink& sink) const override {
    for (const auto n : nodes_) sink.on_positions(n, n, Vec3(k_, 0, 0).asDiagonal());
  }
  void begin_iterate() override { from_ = c_; }
  void move(double scale) override { c_ = from_ + scale * way_; }
  std::size_t own_unknowns() const override { return 1; }
  bool own_push(std::size_t, std::span<double> on_x) const override {
    std::fill(on_x.begin(), on_x.end(), 0.0);
    for (const auto n : nodes_) on_x[3 * n] = -k_;
    return true;
  }
  Eigen::VectorXd own_residual() const override { return Eigen::VectorXd::Constant(1, missing() / all_); }
  Eigen::VectorXd own_answer(std::span<const double> move) const override {
    double sum = 0;
    for (const auto n : nodes_) sum += move[3 * n];
    return Eigen::VectorXd::Constant(1, k_ * sum / all_);
  }
  Eigen::MatrixXd own_response() const override { return Eigen::MatrixXd::Zero(1, 1); }
  void direct(std::span<const double> way) override { way_ = way[0]; }
  double largest_own_residual() const override { return std::abs(missing()); }
  void commit() override { committed_ = c_, way_ = 0; }
  void rollback() override { c_ = from_ = committed_, way_ = 0; }
  void keep(Archive& archive) override {
    archive(committed_);
    if (archive.reading()) rollback();
  }

 private:
  double missing() const { return k_ * sum_ - all_ * c_; }  // N, on the carriage
  std::vector<mechanics::Index> nodes_;
  double k_, all_;  // N/m: of a spring; of all that hold the carriage
  double c_ = 0, from_ = 0, committed_ = 0, way_ = 0, sum_ = 0;
};

// The same springs where the carriage has been eliminated by hand.
class Eliminated final : public mechanics::Term {
 public:
  Eliminated(std::vector<mechanics::Index> nodes, double k, double k0)
      : nodes_(std::move(nodes)), k_(k), part_(k / (k0 + k * static_cast<double>(nodes_.size()))) {}
  const char* name() const override { return "eliminated"; }
  mechanics::Outcome add_forces(const law::Step&, const mechanics::Trial& trial,
                                mechanics::Forces& forces) override {
    const auto u = [&](mechanics::Index n) { return at(trial.configuration.x(), n).x() - trial.X[n].x(); };
    double c = 0;
    for (const auto n : nodes_) c += part_ * u(n);
    for (const auto n : nodes_) forces.on_x[3 * n] += k_ * (u(n) - c);
    return {};
  }
  void couple(const mechanics::Trial&, std::vector<mechanics::NodePair>& pairs) override {
    for (const auto a : nodes_)
      for (const auto b : nodes_)
        if (a < b) pairs.emplace_back(a, b);
  }
  void add_tangent(const mechanics::Trial&, mechanics::TangentSink& sink) const override {
    for (const auto a : nodes_)
      for (const auto b : nodes_)
        sink.on_positions(a, b, Vec3(k_ * ((a == b ? 1 : 0) - part_), 0, 0).asDiagonal());
  }

 private:
  std::vector<mechanics::Index> nodes_;
  double k_, part_;
};

mechanics::Outcome consent(const law::Step&) { return {}; }

double farthest_apart(const run::Run& a, const run::Run& b) {
  const auto x = positions(a), y = positions(b);
  double apart = 0;
  for (std::size_t i = 0; i < x.size(); ++i) apart = std::max(apart, std::abs(x[i] - y[i]));
  return apart;
}

}  // namespace

TEST_CASE("a term that limits steps is asked in every scheme, and the run ends where it does without it") {
  for (const Way way : all_ways) {
    const auto plain = make_run(way, consent, 1e-4), held = make_run(way, consent, 1e-4);
    auto leash = std::make_unique<Leash>(std::vector<mechanics::Index>{12, 13},
                                         way == Way::explicit_steps ? 5e-9 : 2e-8);
    const Leash& told = *leash;
    held->add(std::move(leash));
    plain->solve();
    held->solve();
    CHECK(told.shortened > 0);
    int cuts = 0, iterations = 0, iterations_before = 0;
    for (const auto& step : held->steps()) cuts += step.cuts, iterations += step.iterations;
    for (const auto& step : plain->steps()) iterations_before += step.iterations;
    // Steps that iterate take shorter ways; explicit ones are cut.
    CHECK((way == Way::explicit_steps ? cuts > 0 : iterations > iterations_before));
    // Of 1e-6 m. Explicit steps of another size have another error, of second order.
    CHECK(farthest_apart(*plain, *held) < (way == Way::explicit_steps ? 5e-10 : 1e-13));
  }
}

TEST_CASE("a term with an unknown of its own is solved with the sheet: as if it had been eliminated") {
  const std::vector<mechanics::Index> nodes = {8, 13, 18};
  for (const Way way : {Way::statics, Way::implicit_steps}) {
    const auto own = make_run(way, consent, 1e-4), eliminated = make_run(way, consent, 1e-4);
    auto carriage = std::make_unique<Carriage>(nodes, 3e3, 2e3);
    const Carriage& there = *carriage;
    own->add(std::move(carriage));
    eliminated->add(std::make_unique<Eliminated>(nodes, 3e3, 2e3));
    own->solve();
    eliminated->solve();
    CHECK(there.place() > 1e-8);
    CHECK(std::abs(there.place() - there.balanced_place()) < 1e-7 * there.place());
    CHECK(farthest_apart(*own, *eliminated) < 1e-12);  // of 1e-6 m, to the tolerance of the steps
    REQUIRE(own->steps().size() == eliminated->steps().size());
    for (std::size_t i = 0; i < own->steps().size(); ++i)
      CHECK(own->steps()[i].iterations <= eliminated->steps()[i].iterations + 1);
    // The steps of a run that is taken up half way have the same bits.
    const auto first = make_run(way, consent, 1e-4), second = make_run(way, consent, 1e-4);
    for (const auto& run : {first, second}) run->add(std::make_unique<Carriage>(nodes, 3e3, 2e3));
    first->advance(5e-5);
    second->resume(first->kept());
    first->solve();
    second->solve();
    CHECK(positions(*first) == positions(*second));
  }
}
