// The one problem of all runs: its tangent against differences of its residual under every time scheme, and
// the accounts of the terms that hang on the motion.
#include <algorithm>
#include <random>

#include "catch.hpp"
#include "mechanics/springs_of_pairs.hpp"
#include "mechanics/terms/cloth.hpp"
#include "mechanics/terms/damping.hpp"
#include "run/dynamic.hpp"
#include "run/problem.hpp"
#include "run/problems.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

// Flat, so that all unknowns are displacements, whose increments add up.
std::shared_ptr<model::Model> make_sheet() {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.04, 0.03, 4, 3));
  auto m = std::make_shared<model::Model>(mesh, isotropic(1e6, 0.3, 1e-3), model::Options{});
  m->fix("all", model::parse_freedoms("z rotation"));
  m->fix("left", model::parse_freedoms("x y"));
  model::Components along;
  along[0] = history::History::ramp(0.002, 1);
  m->move("right", along);
  return m;
}

std::vector<double> some(std::size_t n, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-size, size);
  std::vector<double> v(n);
  for (double& x : v) x = number(random);
  return v;
}

// The largest difference between K and central differences of the residual about a displaced configuration,
// over the largest entry of their product.
double tangent_error(run::EquilibriumProblem& problem) {
  const auto n = static_cast<std::size_t>(problem.size());
  linear::Matrix K;
  std::vector<double> r(n), product(n, 0);
  REQUIRE(problem.predict(K, r, product) == Answer::ok);
  std::fill(product.begin(), product.end(), 0.0);
  problem.apply_increment(some(n, 1e-4, 1), 1);
  problem.accept();
  REQUIRE(problem.residual(r) == Answer::ok);
  REQUIRE(problem.tangent(K) == Answer::ok);
  const auto direction = some(n, 1e-3, 2);
  for (std::size_t c = 0; c < n; ++c)
    for (auto k = K.pattern->column[c]; k < K.pattern->column[c + 1]; ++k)
      product[K.pattern->row[k]] += K.value[k] * direction[c];
  const double h = 1e-4;
  const auto at = [&](double scale) {
    problem.apply_increment(direction, scale);
    std::vector<double> moved(n);
    REQUIRE(problem.residual(moved) == Answer::ok);
    return moved;
  };
  const auto up = at(h), down = at(-h);
  double worst = 0, scale = 0;
  for (std::size_t i = 0; i < n; ++i) {
    worst = std::max(worst, std::abs(product[i] + (up[i] - down[i]) / (2 * h)));
    scale = std::max(scale, std::abs(product[i]));
  }
  return worst / scale;
}

const run::EquilibriumProblem::Poll no_poll;

}  // namespace

TEST_CASE("the tangent is the derivative of the residual, quasi-static with and without stabilisation") {
  for (const double fraction : {0.0, 0.3}) {
    const auto m = make_sheet();
    m->validate();
    mechanics::Assembly assembly(*m);
    run::EquilibriumProblem problem(assembly, 1e-7, no_poll);
    if (fraction > 0) assembly.terms().add(std::make_unique<mechanics::Stabilisation>(assembly, fraction));
    problem.set_time(0);
    problem.start();
    problem.set_time(0.1);
    CHECK(tangent_error(problem) < 1e-8);
  }
}

TEST_CASE("the tangent is the derivative of the residual, by Newmark with every kind of damping") {
  struct Case {
    double mass, stiffness, hht;
  };
  for (const Case& c : {Case{0, 0, 0}, Case{300, 0, 0}, Case{0, 1e-4, 0}, Case{300, 1e-4, -0.2}}) {
    const auto m = make_sheet();
    m->validate();
    mechanics::Assembly assembly(*m);
    const auto& inertia = assembly.terms().add(std::make_unique<mechanics::Inertia>(
        assembly.cloth().mass(), assembly.cloth().rotary_inertia(false)));
    if (c.mass > 0) assembly.terms().add(std::make_unique<mechanics::MassDamping>(assembly, c.mass));
    if (c.stiffness > 0)
      assembly.terms().add(std::make_unique<mechanics::StiffnessDamping>(assembly, c.stiffness));
    const auto scheme = run::NewmarkScheme::of_hht(c.hht);
    run::Newmark newmark(assembly, inertia, scheme);
    run::EquilibriumProblem problem(assembly, newmark, no_poll);
    problem.set_time(0);
    REQUIRE(assembly.forces({}));
    assembly.commit(0);
    mechanics::NodalRates v{some(3 * assembly.dofs().reference().size(), 0.1, 3),
                            std::vector<double>(3 * assembly.dofs().reference().size(), 0)},
        possible;
    assembly.dofs().spread_rates(assembly.dofs().collect_rates(v),
                                 std::vector<double>(assembly.dofs().targets(0).size(), 0), possible);
    problem.start(possible);
    problem.set_time(1e-3);
    INFO("damping " << c.mass << " and " << c.stiffness << ", hht " << c.hht);
    CHECK(tangent_error(problem) < 1e-8);
  }
}

TEST_CASE("the terms that hang on the motion give their energies by name, and the ledger is their sum") {
  for (const auto scheme : {run::Scheme::implicit_steps, run::Scheme::explicit_steps}) {
    run::DynamicOptions options;
    options.duration = 2e-3;
    options.scheme = scheme;
    if (scheme == run::Scheme::implicit_steps) {
      options.step = 1e-5;
      options.hht = 0;  // so that no step follows another rule, whose loss would be in the sum
    }
    options.mass_damping = 200;
    options.stiffness_damping = 1e-7;
    const auto a = run::make_dynamic(make_sheet(), options, quiet());
    a->solve();
    const auto energies = a->assembly().energies();
    const auto of = [&](const std::string& name, mechanics::Account account) {
      const auto found = std::find_if(energies.begin(), energies.end(),
                                      [&](const auto& e) { return e.name == name && e.account == account; });
      REQUIRE(found != energies.end());
      return found->value;
    };
    using mechanics::Account;
    const auto ledger = a->energy();
    const double mass = of("mass damping", Account::damping),
                 stiff = of("stiffness damping", Account::damping);
    CHECK(mass > 0);
    CHECK(stiff > 0);
    CHECK(ledger.damping == mass + stiff);
    CHECK(of("kinetic", Account::kinetic) > 0);
    CHECK(of("kinetic", Account::kinetic) < ledger.kinetic);  // without the side that is driven
    CHECK(ledger.error < (scheme == run::Scheme::implicit_steps ? 2e-2 : 2e-3));
  }
}

TEST_CASE("the energy that damping has taken is kept with the terms, and goes on from there") {
  for (const auto scheme : {run::Scheme::implicit_steps, run::Scheme::explicit_steps}) {
    const auto make = [&] {
      run::DynamicOptions options;
      options.duration = 1e-3;
      options.scheme = scheme;
      if (scheme == run::Scheme::implicit_steps) options.step = 1e-5;
      options.mass_damping = 200;
      options.stiffness_damping = 1e-7;
      return run::make_dynamic(make_sheet(), options, quiet());
    };
    const auto first = make(), second = make();
    first->advance(4e-4);
    second->resume(first->kept());
    CHECK(second->energy().damping == first->energy().damping);
    first->solve();
    second->solve();
    CHECK(second->energy().damping == first->energy().damping);
    CHECK(second->energy().kinetic == first->energy().kinetic);
  }
}

TEST_CASE("explicit steps ask no term for couplings: no pattern is made") {
  class Asked final : public mechanics::Term {
   public:
    explicit Asked(int& times) : times_(times) {}
    const char* name() const override { return "asked"; }
    void couple(const mechanics::Trial&, std::vector<mechanics::NodePair>&) override { ++times_; }

   private:
    int& times_;
  };
  run::DynamicOptions options;
  options.duration = 1e-4;
  int times = 0;
  auto a = run::make_dynamic(make_sheet(), options, quiet());
  a->add(std::make_unique<Asked>(times));
  a->solve();
  CHECK(times == 0);
  options.scheme = run::Scheme::implicit_steps;
  a = run::make_dynamic(make_sheet(), options, quiet());
  a->add(std::make_unique<Asked>(times));
  a->step();
  CHECK(times > 0);
}

TEST_CASE("energies that the forces sum on their way are those of a look of its own, bit for bit") {
  for (const auto& card : {blend(), isotropic(1e6, 0.3, 1e-3)})
    for (const bool bends : {false, true}) {
      auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.07, 7, 5));
      mesh->map([](const Vec3& X) { return Vec3(X.x(), X.y(), 0.003 * std::sin(60 * X.x())); });
      card::Card with = card;
      if (bends) with.bending = card::Bending{15e-6, 12e-6, 5e-6, {}, {}};
      model::Options warp;
      warp.warp = [](const Vec3&) { return model::Direction(10.0); };
      model::Model m(mesh, with, warp);
      m.validate();
      mechanics::Assembly a(m);
      const auto step = some(static_cast<std::size_t>(a.dofs().unknowns()), 2e-4, 5);
      for (int i = 1; i < 4; ++i) {
        a.begin_iterate();
        a.apply_increment(step, i % 2 == 0 ? -1 : 1.5, {});
        a.terms().expect_energies(true);
        REQUIRE(a.forces({}));
        const auto trial = a.energies();
        a.commit(i);
        const auto summed = a.energies();
        a.terms().expect_energies(false);
        REQUIRE(a.forces({}));
        a.rollback();
        const auto looked = a.energies();
        REQUIRE(summed.size() == looked.size());
        for (std::size_t k = 0; k < looked.size(); ++k) {
          CHECK(trial[k].value == looked[k].value);
          CHECK(summed[k].value == looked[k].value);
        }
        CHECK(looked[0].value > 0);
      }
    }
}

TEST_CASE("a term's limit shortens explicit steps, and no step passes it") {
  auto model = make_sheet();
  run::DynamicOptions options;
  options.duration = 2e-3;
  options.scheme = run::Scheme::explicit_steps;
  auto a = run::make_dynamic(model, options, quiet());
  const std::vector<mechanics::NodePair> pairs = {{6, 8}};
  // It pulls from 0.0200 m on and may not be longer than 0.0203 m, which the driven side would make it.
  auto springs = std::make_unique<SpringsOfPairs>(pairs, std::vector{0.02}, 1e7);
  springs->farthest = 0.02 + 2e-6;
  a->add(std::move(springs));
  int cuts = 0;
  const auto longest = [&] {
    const auto x = a->assembly().state().x();
    return (Vec3(x[24], x[25], x[26]) - Vec3(x[18], x[19], x[20])).norm();
  };
  try {
    while (a->time() < 2e-3) {
      a->step();
      cuts += a->steps().back().cuts;
      REQUIRE(longest() <= 0.02 + 2e-6 + 1e-15);
    }
  } catch (const NumericalFailure& failure) {
    INFO(failure.what());
    CHECK(std::string(failure.what()).find("farther than is safe") != std::string::npos);
    cuts += 13;
  }
  CHECK(cuts > 0);
}

TEST_CASE(
    "an explicit run looks at the ledger all the way, sixteen steps apart at least, and stops where it is "
    "off") {
  // Makes energy from a time on, and counts who asks.
  class Maker final : public mechanics::Term {
   public:
    Maker(double from, int& asked) : from_(from), asked_(asked) {}
    const char* name() const override { return "maker"; }
    void add_energies(const mechanics::Trial& trial, std::vector<mechanics::Energy>& out) const override {
      ++asked_;
      out.push_back({"maker", mechanics::Account::created, trial.time > from_ ? 1.0 : 0.0});
    }

   private:
    double from_;
    int& asked_;
  };
  for (const double steps : {400.0, 4000.0}) {
    run::DynamicOptions options;
    options.duration = 2e-3;
    options.step = options.duration / steps;
    options.force = true;
    int asked = 0;
    auto a = run::make_dynamic(make_sheet(), options, quiet());
    a->add(std::make_unique<Maker>(1, asked));
    a->solve();
    INFO(steps << " steps, " << asked << " looks");
    CHECK(asked > (steps < 2000 ? 23 : 195));
    CHECK(asked < (steps < 2000 ? 28 : 210));
    int late = 0;
    auto b = run::make_dynamic(make_sheet(), options, quiet());
    b->add(std::make_unique<Maker>(1e-3, late));
    std::string message = "no failure";
    try {
      b->solve();
    } catch (const NumericalFailure& failure) {
      message = failure.what();
    }
    CHECK(message.find("the ledger's error") != std::string::npos);
    CHECK(b->time() > 1e-3);
    CHECK(b->time() < 1.2e-3);
  }
}
