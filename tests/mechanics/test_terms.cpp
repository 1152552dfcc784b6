// Requests of a term to the assembly: couplings that come and go, limits, outcomes.
#include <random>

#include "catch.hpp"
#include "mechanics/assembly.hpp"
#include "springs_of_pairs.hpp"
#include "tangent_error.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using mechanics::Assembly;
using test::SpringsOfPairs;

namespace {

std::shared_ptr<model::Model> make_sheet() {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.04, 0.04, 4, 4));
  auto m = std::make_shared<model::Model>(mesh, test::svk(), model::Options{});
  m->fix("left", model::parse_freedoms("x y z rotation"));
  return m;
}

// The sheet stretched along x from its committed state.
void stretch(Assembly& a, double strain) {
  a.rollback();
  a.begin_iterate();
  std::vector<double> delta(static_cast<std::size_t>(a.dofs().unknowns()), 0);
  for (std::size_t n = 0; n < a.dofs().reference().size(); ++n)
    if (const auto eq = a.dofs().freedoms().nodes[n].equation[0]; eq >= 0)
      delta[eq] = strain * a.dofs().reference()[n].x();
  a.apply_increment(delta, 1, a.dofs().targets(0));
}

linear::Matrix tangent(Assembly& a) {
  linear::Matrix K;
  REQUIRE(a.tangent({}, K, {}, {}));
  return K;
}

// Nodes that are free, 0.03 m apart along x.
const std::vector<mechanics::NodePair> across = {{1, 4}, {6, 9}, {24, 21}};

// The largest difference between K and central differences of the residual, over the largest entry.
double tangent_error(Assembly& a, double strain) {
  stretch(a, strain);
  const auto K = tangent(a);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<double> direction(static_cast<std::size_t>(a.dofs().unknowns()));
  for (double& d : direction) d = 1e-3 * number(random);
  return test::tangent_error(a, K, direction, 1e-5);
}

}  // namespace

TEST_CASE(
    "stiffness damping takes the law's part of the tangent, which a turn of a stretched sheet leaves alone") {
  const auto m = std::make_shared<model::Model>(
      std::make_shared<mesh::Mesh>(mesh::rectangle(0.04, 0.04, 4, 4)), test::svk(), model::Options{});
  Assembly a(*m);
  stretch(a, 0.05);
  const auto n = static_cast<std::size_t>(a.dofs().unknowns());
  // Rates of a rigid turn about z, which turns no director, and of a shear.
  std::vector<double> turn(n, 0), shear(n, 0);
  for (std::size_t i = 0; i < a.dofs().reference().size(); ++i) {
    const auto& equation = a.dofs().freedoms().nodes[i].equation;
    turn[equation[0]] = -a.dofs().reference()[i].y();
    turn[equation[1]] = 1.05 * a.dofs().reference()[i].x();
    shear[equation[0]] = a.dofs().reference()[i].y();
  }
  const auto most = [n](const linear::Matrix& K, const std::vector<double>& v) {
    std::vector<double> product(n, 0);
    for (std::size_t c = 0; c < n; ++c)
      for (auto k = K.pattern->column[c]; k < K.pattern->column[c + 1]; ++k)
        product[K.pattern->row[k]] += K.value[k] * v[c];
    double largest = 0;
    for (const double p : product) largest = std::max(largest, std::abs(p));
    return largest;
  };
  const auto whole = tangent(a);
  linear::Matrix law;
  std::vector<double> driven(n);
  REQUIRE(a.material_tangent(law, {}, driven));
  CHECK(most(law, turn) < 1e-12 * most(law, shear));
  CHECK(most(whole, turn) > 1e-3 * most(whole, shear));  // the stress turns with the sheet
}

TEST_CASE("the pattern grows when a term couples nodes that it did not hold, and only then") {
  const auto m = make_sheet();
  Assembly a(*m);
  // Springs that pull once a pair is longer than so much: the first from 2 % on, the others from 6 and 10 %.
  a.terms().add(std::make_unique<SpringsOfPairs>(across, std::vector{0.0306, 0.0318, 0.033}, 2e5));
  stretch(a, 0.01);
  const auto none = tangent(a).pattern;
  stretch(a, 0.04);
  const auto one = tangent(a).pattern;
  CHECK(one->version != none->version);
  CHECK(one->entries() > none->entries());
  a.commit(1);  // what a rollback goes back to from here on
  stretch(a, 0.01);
  CHECK(tangent(a).pattern == one);
  stretch(a, 0.08);
  const auto K = tangent(a);
  CHECK(K.pattern->entries() > one->entries());
  // A pair that has gone leaves its place: the solver has nothing to analyse anew.
  a.begin_iterate();
  std::vector<double> back(static_cast<std::size_t>(a.dofs().unknowns()), 0);
  for (std::size_t n = 0; n < a.dofs().reference().size(); ++n)
    if (const auto eq = a.dofs().freedoms().nodes[n].equation[0]; eq >= 0)
      back[eq] = -0.1 * a.dofs().reference()[n].x();
  a.apply_increment(back, 1, a.dofs().targets(0));
  CHECK(tangent(a).pattern == K.pattern);
  // Before the first pair came the pattern was the sheet's own.
  Assembly plain(*m);
  CHECK(plain.pattern()->row == none->row);
}

TEST_CASE("a tangent with couplings that came on the way is the derivative of the forces") {
  const auto m = make_sheet();
  Assembly a(*m);
  a.terms().add(std::make_unique<SpringsOfPairs>(across, std::vector{0.0306, 0.0318, 0.033}, 2e5));
  for (const double strain : {0.01, 0.04, 0.08, 0.15}) {
    INFO("strain " << strain);
    CHECK(tangent_error(a, strain) < 1e-8);  // h^2 times the third derivative
  }
  // Mutant: without the spring's part it is not.
  Assembly bare(*m);
  bare.terms().add(std::make_unique<SpringsOfPairs>(across, std::vector{0.0306, 0.0318, 0.033}, 2e5, false));
  CHECK(tangent_error(bare, 0.15) > 1e-4);
}

TEST_CASE("a rollback and a kept state bring the pattern's couplings back") {
  const auto m = make_sheet();
  const auto add_springs = [](Assembly& a) {
    a.terms().add(std::make_unique<SpringsOfPairs>(across, std::vector{0.0306, 0.0318, 0.033}, 2e5));
  };
  Assembly a(*m);
  add_springs(a);
  stretch(a, 0.04);
  const auto one = tangent(a);
  a.commit(1);
  Archive kept;
  a.keep(kept);
  a.begin_iterate();
  std::vector<double> on(static_cast<std::size_t>(a.dofs().unknowns()), 0);
  for (std::size_t n = 0; n < a.dofs().reference().size(); ++n)
    if (const auto eq = a.dofs().freedoms().nodes[n].equation[0]; eq >= 0)
      on[eq] = 0.1 * a.dofs().reference()[n].x();
  a.apply_increment(on, 1, a.dofs().targets(0));
  const auto more = tangent(a);
  CHECK(more.pattern->entries() > one.pattern->entries());
  a.rollback();
  CHECK(a.pattern()->row == one.pattern->row);
  // Another assembly that takes the state up has the same pattern, though its pairs are further apart then.
  Assembly b(*m);
  add_springs(b);
  Archive back(kept.bytes());
  b.keep(back);
  CHECK(back.at_end());
  CHECK(b.pattern()->row == one.pattern->row);
  const auto again = tangent(b);
  CHECK(again.pattern->row == one.pattern->row);
  a.begin_iterate();
  CHECK(tangent(a).value == again.value);
}

#ifdef NDEBUG
TEST_CASE("stiffness between nodes that no pair has named is refused, not added to a neighbour's") {
  const auto m = make_sheet();
  Assembly a(*m);
  auto& springs =
      a.terms().add(std::make_unique<SpringsOfPairs>(across, std::vector{0.0306, 0.0318, 0.033}, 2e5));
  springs.names_pairs = false;
  stretch(a, 0.04);
  linear::Matrix K;
  CHECK_THROWS_AS(a.tangent({}, K, {}, {}), std::logic_error);
}
#endif

TEST_CASE("the assembly's limit is the smallest of its terms', along the way of the nodes") {
  const auto m = make_sheet();
  Assembly a(*m);
  std::vector<double> delta(static_cast<std::size_t>(a.dofs().unknowns()), 0);
  const auto eq = a.dofs().freedoms().nodes[24].equation[0];
  delta[eq] = 0.02;
  a.begin_iterate();
  CHECK(a.limit(delta, a.dofs().targets(0)) == 1);
  auto& springs = a.terms().add(std::make_unique<SpringsOfPairs>(across, std::vector{1.0, 1.0, 1.0}, 2e5));
  springs.farthest = 0.04;  // no pair may get longer
  CHECK(std::abs(a.limit(delta, a.dofs().targets(0)) - 0.5) < 1e-12);
  // From the iterate, not from the committed state.
  a.apply_increment(delta, 0.25, a.dofs().targets(0));
  a.begin_iterate();
  CHECK(std::abs(a.limit(delta, a.dofs().targets(0)) - 0.25) < 1e-12);
}

TEST_CASE("the worst of the terms' outcomes is the assembly's, with its words") {
  const auto m = make_sheet();
  Assembly a(*m);
  auto& first = a.terms().add(std::make_unique<SpringsOfPairs>(across, std::vector{1.0, 1.0, 1.0}, 2e5));
  auto& second = a.terms().add(std::make_unique<SpringsOfPairs>(across, std::vector{1.0, 1.0, 1.0}, 2e5));
  a.begin_iterate();
  CHECK(a.forces({}));
  first.answer = {Answer::cut, 3, "too far for one step"};
  CHECK_FALSE(a.forces({}));
  CHECK(a.outcome().answer == Answer::cut);
  CHECK(a.outcome().element == 3);
  second.answer = {Answer::broken, -1, "torn"};
  linear::Matrix K;
  CHECK_FALSE(a.tangent({}, K, {}, {}));
  CHECK(a.outcome().answer == Answer::broken);
  CHECK(a.outcome().why == "torn");
}
