#include <omp.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "catch.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/configuration.hpp"
#include "mechanics/law_states.hpp"
#include "mechanics/terms/cloth.hpp"
#include "mesh/generators.hpp"
#include "test_cards.hpp"

using fabricsh::Archive;
using fabricsh::Error;
using fabricsh::mechanics::Configuration;
using fabricsh::mechanics::LawStates;

namespace {

// Stands for forces(): every trial number is its committed one plus `grown`.
void evaluate(LawStates& s, double grown) {
  const auto from = s.committed();
  const auto to = s.evaluate();
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i] + grown;
}

double law_value(const LawStates& s) { return s.current()[1]; }

}  // namespace

TEST_CASE("the law's state is the last evaluated one, and the committed one after a commit or rollback") {
  LawStates s(3);
  CHECK(law_value(s) == 0);
  evaluate(s, 1);
  CHECK(law_value(s) == 1);
  evaluate(s, 2);  // a second iterate starts from the committed state again
  CHECK(law_value(s) == 2);
  s.rollback();
  CHECK(law_value(s) == 0);
  evaluate(s, 3);
  s.commit();
  CHECK(law_value(s) == 3);
  s.commit();  // nothing evaluated in between: the state stays
  CHECK(law_value(s) == 3);
  evaluate(s, 4);
  CHECK(law_value(s) == 7);
  CHECK(s.committed()[1] == 3);
  s.commit();
  s.rollback();
  CHECK(law_value(s) == 7);
}

TEST_CASE("a kept state brings back configuration and law, whatever was tried since") {
  Configuration c(2);
  LawStates s(3);
  c.x()[4] = 5;
  evaluate(s, 1);
  c.commit(1);
  s.commit();
  Archive kept;
  c.keep(kept);
  s.keep(kept);
  CHECK(kept.bytes().size() == 8 * (1 + 1 + 2 * 9 + 1 + 3));
  c.x()[4] = 6;
  evaluate(s, 1);
  c.commit(2);
  s.commit();
  c.x()[4] = 7;
  evaluate(s, 1);
  const auto version = c.version();
  Archive back(kept.bytes());
  c.keep(back);
  s.keep(back);
  CHECK(c.version() > version);
  CHECK(std::as_const(c).x()[4] == 5);
  CHECK(c.committed_kinematics()[4] == 5);
  CHECK(c.time() == 1);
  CHECK(law_value(s) == 1);
  Configuration other(3);
  Archive again(kept.bytes());
  CHECK_THROWS_AS(other.keep(again), Error);
  LawStates fewer(2);
  Archive third(kept.bytes());
  CHECK_THROWS_AS(fewer.keep(third), Error);
}

TEST_CASE("an element whose strain is not finite asks for a cut, one whose state is not finite is broken") {
  auto mesh = std::make_shared<fabricsh::mesh::Mesh>(fabricsh::mesh::rectangle(0.1, 0.1, 2, 1));
  auto card = fabricsh::test::blend();  // with a part that remembers every strain
  std::get<fabricsh::card::Woven>(card.law).parallel.viscous =
      fabricsh::rheology::viscous::Parameters{1e6, 1};
  const auto model = std::make_shared<fabricsh::model::Model>(mesh, card, fabricsh::model::Options{});
  fabricsh::mechanics::Assembly a(*model);
  CHECK(a.forces({0, 1}));
  const double x = a.state().x()[0];
  a.state().x()[0] = std::nan("");
  a.state().touch();
  CHECK_FALSE(a.forces({0, 1}));
  CHECK(a.outcome().element == 0);
  CHECK(a.outcome().answer == fabricsh::Answer::cut);
  a.commit(1);  // which no run would do
  a.state().x()[0] = x;
  a.state().touch();
  CHECK_FALSE(a.forces({1, 1}));
  CHECK(a.outcome().element == 0);
  CHECK(a.outcome().answer == fabricsh::Answer::broken);
}

namespace {

using fabricsh::lanes;

// The same as evaluate() of one line of states in place, in parts of four lanes: the lanes of `which` grow.
void evaluate_in_place(LawStates& s, unsigned which, double grown) {
  s.evaluate();
  s.changed()[0] = static_cast<unsigned char>(which);
  double* log = s.begin_group(0);
  for (int first = 0; first < lanes; first += 4) {
    if ((which >> first & 15u) == 0) continue;
    log = std::copy_n(s.now() + first, 4, log);
    for (int l = first; l < first + 4; ++l)
      if ((which >> l & 1u) != 0) s.now()[l] += grown;
  }
  s.end_group(log);
}

// States of an element's points, one after the other.
std::vector<double> states_of(const fabricsh::mechanics::Assembly& a) {
  std::vector<double> all;
  for (fabricsh::mechanics::Index e = 0; e < a.cloth().elements(); ++e)
    a.cloth().readings().visit(
        e, [&](double, const fabricsh::law::Law& law, const double*, const double* state) {
          all.insert(all.end(), state, state + fabricsh::law::state_size(law));
        });
  return all;
}

// A corner moved in its plane and out of it, there and back, every third step tried a second time from
// farther away.
std::vector<double> after_steps(fabricsh::mechanics::Assembly& a) {
  const double x = a.dofs().reference()[0].x(), z = a.dofs().reference()[0].z();
  for (int i = 1; i <= 12; ++i) {
    const double way = 1e-3 * (i < 8 ? i : 16 - i);
    for (const double more : {3e-3, 0.0}) {
      if (more > 0 && i % 3 != 0) continue;
      a.state().x()[0] = x + way + more;
      a.state().x()[2] = z + way / 2 - more;
      a.state().touch();
      REQUIRE(a.forces({i - 1.0, 1}));
      if (more > 0 && i % 2 != 0) a.rollback();
    }
    a.commit(i);
  }
  return states_of(a);
}

}  // namespace

TEST_CASE("states in place: a rollback puts back what changed, what is kept is the committed state") {
  LawStates s(lanes);
  s.update_in_place({0, lanes}, 4);
  evaluate_in_place(s, 0b10000010, 1);
  CHECK(s.current()[1] == 1);
  CHECK(s.current()[2] == 0);
  evaluate_in_place(s, 0b00000010, 2);  // from the committed state again
  CHECK(s.current()[1] == 2);
  CHECK(s.current()[7] == 0);
  s.commit();
  evaluate_in_place(s, 0b11111111, 5);
  Archive kept;
  s.keep(kept);
  CHECK(s.current()[1] == 7);  // keeping changes nothing
  s.rollback();
  CHECK(s.current()[1] == 2);
  CHECK(s.current()[7] == 0);
  evaluate_in_place(s, 0b11111111, 6);
  s.commit();
  evaluate_in_place(s, 0b11111111, 7);
  Archive back(kept.bytes());
  s.keep(back);
  CHECK(s.current()[1] == 2);
  CHECK(s.current()[0] == 0);
  s.rollback();
  CHECK(s.current()[1] == 2);
}

TEST_CASE("states in place are those of two copies, bit for bit, for every kind of law") {
  using namespace fabricsh;
  for (const char* kind : {"plain", "fading", "viscous", "thesis", "bending"}) {
    CAPTURE(kind);
    const std::string name = kind;
    auto card = test::blend();
    auto& woven = std::get<card::Woven>(card.law);
    if (name == "fading") woven.shear.memory = card::ShearMemory::fading;
    if (name == "viscous") woven.parallel.viscous = rheology::viscous::Parameters{1e6, 1};
    if (name == "thesis") woven.law = card::LawKind::thesis;
    if (name == "bending")
      card.bending =
          card::Bending{15e-6, 12e-6, 5e-6, card::BendingFriction{2e-6, 10}, card::BendingFriction{2e-6, 10}};
    for (const bool triangles : {false, true}) {
      auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.1, 3, 3));
      if (triangles) mesh::split(*mesh, 3);
      const auto model = std::make_shared<model::Model>(mesh, card, model::Options{});
      mechanics::Assembly two(*model), one(*model);
      one.terms().find<mechanics::Cloth>()->update_in_place();
      const auto expected = after_steps(two), got = after_steps(one);
      CHECK(got == expected);
      CHECK(std::any_of(got.begin(), got.end(), [](double v) { return v != 0; }));
      CHECK(std::equal(one.internal().on_x.begin(), one.internal().on_x.end(), two.internal().on_x.begin()));
    }
  }
}

TEST_CASE("states in place go back to the committed bits, whichever thread saved them") {
  using namespace fabricsh;
  const int usual = omp_get_max_threads();
  const auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.1, 20, 20));
  const auto model = std::make_shared<model::Model>(mesh, test::blend(), model::Options{});
  mechanics::Assembly a(*model);
  a.terms().find<mechanics::Cloth>()->update_in_place();
  const auto push = [&a](double way) {
    const auto x = a.state().x();
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += way * std::sin(static_cast<double>(17 * i));
    a.state().touch();
    REQUIRE(a.forces({0, 1}));
  };
  for (const int threads : {3, 1, 2}) {
    omp_set_num_threads(threads);
    push(1e-4);
    a.commit(threads);
    const auto before = states_of(a);
    push(5e-4);
    CHECK(states_of(a) != before);
    a.rollback();
    CHECK(states_of(a) == before);
  }
  omp_set_num_threads(usual);
}
