#include "assembly/state.hpp"
#include "catch.hpp"

using fabricsh::Archive;
using fabricsh::Error;
using fabricsh::assembly::StateStore;

namespace {

// Stands for forces(): every trial law number is its committed one plus `grown`.
void evaluate(StateStore& s, double grown) {
  const auto from = s.committed_law();
  const auto to = s.evaluate_law();
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i] + grown;
}

double law(const StateStore& s) { return s.law()[1]; }

}  // namespace

TEST_CASE("the law's state is the last evaluated one, and the committed one after a commit or rollback") {
  StateStore s(2, 3);
  CHECK(law(s) == 0);
  evaluate(s, 1);
  CHECK(law(s) == 1);
  evaluate(s, 2);  // a second iterate starts from the committed state again
  CHECK(law(s) == 2);
  s.rollback();
  CHECK(law(s) == 0);
  evaluate(s, 3);
  s.commit(0.5);
  CHECK(law(s) == 3);
  CHECK(s.time() == 0.5);
  s.commit(0.6);  // nothing evaluated in between: the state stays
  CHECK(law(s) == 3);
  evaluate(s, 4);
  CHECK(law(s) == 7);
  CHECK(s.committed_law()[1] == 3);
  s.commit(0.7);
  s.rollback();
  CHECK(law(s) == 7);
}

TEST_CASE("a snapshot brings back kinematics and law, whatever was tried since") {
  StateStore s(2, 3);
  s.x()[4] = 5;
  evaluate(s, 1);
  s.commit(1);
  Archive kept;
  s.keep(kept);
  CHECK(kept.bytes().size() == 8 * (1 + 1 + 2 * 9 + 1 + 3));
  s.x()[4] = 6;
  evaluate(s, 1);
  s.commit(2);
  s.x()[4] = 7;
  evaluate(s, 1);
  const auto version = s.version();
  Archive back(kept.bytes());
  s.keep(back);
  CHECK(s.version() > version);
  CHECK(std::as_const(s).x()[4] == 5);
  CHECK(s.committed_kinematics()[4] == 5);
  CHECK(law(s) == 1);
  CHECK(s.time() == 1);
  StateStore other(3, 3);
  Archive again(kept.bytes());
  CHECK_THROWS_AS(other.keep(again), Error);
}
