#include <cmath>
#include <memory>

#include "catch.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/configuration.hpp"
#include "mechanics/law_states.hpp"
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

double law(const LawStates& s) { return s.current()[1]; }

}  // namespace

TEST_CASE("the law's state is the last evaluated one, and the committed one after a commit or rollback") {
  LawStates s(3);
  CHECK(law(s) == 0);
  evaluate(s, 1);
  CHECK(law(s) == 1);
  evaluate(s, 2);  // a second iterate starts from the committed state again
  CHECK(law(s) == 2);
  s.rollback();
  CHECK(law(s) == 0);
  evaluate(s, 3);
  s.commit();
  CHECK(law(s) == 3);
  s.commit();  // nothing evaluated in between: the state stays
  CHECK(law(s) == 3);
  evaluate(s, 4);
  CHECK(law(s) == 7);
  CHECK(s.committed()[1] == 3);
  s.commit();
  s.rollback();
  CHECK(law(s) == 7);
}

TEST_CASE("what is kept brings back configuration and law, whatever was tried since") {
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
  CHECK(law(s) == 1);
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
  std::get<fabricsh::card::Woven>(card.law).viscous = fabricsh::card::Viscous{{1e6, 1}};
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
