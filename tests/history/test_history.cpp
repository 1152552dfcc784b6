#include <cmath>
#include <limits>

#include "history/history.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using history::History;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("a constant", "[history]") {
  const History h = History::constant(2.5);
  CHECK(h.value(-1) == 2.5);
  CHECK(h.value(1e9) == 2.5);
  CHECK(h.kinks().empty());
  CHECK_THROWS_AS(History::constant(not_a_number), Error);
}

TEST_CASE("a table is linear between its rows, exact on them, held outside", "[history]") {
  const History h = History::table({{1, 0}, {2, 4}, {4, -2}});
  CHECK(h.value(0) == 0);
  CHECK(h.value(1) == 0);
  CHECK(h.value(1.5) == 2);
  CHECK(h.value(2) == 4);
  CHECK(h.value(3) == 1);
  CHECK(h.value(4) == -2);
  CHECK(h.value(9) == -2);
  CHECK(h.kinks() == std::vector<double>{1, 2, 4});
}

TEST_CASE("a ramp rises and is held", "[history]") {
  const History h = History::ramp(6, 3);
  CHECK(h.value(-1) == 0);
  CHECK(h.value(1) == 2);
  CHECK(h.value(3) == 6);
  CHECK(h.value(30) == 6);
  CHECK(h.kinks() == std::vector<double>{0, 3});
}

TEST_CASE("a callback has values and no kinks", "[history]") {
  const History h = History::callback([](double t) { return std::sin(t); });
  CHECK(h.value(1) == std::sin(1.0));
  CHECK(h.kinks().empty());
}

TEST_CASE("bad histories are refused with row and value", "[history]") {
  says(message_of([] { History::table({}); }), "at least one row");
  says(message_of([] { History::table({{0, 0}, {1, 1}, {1, 2}}); }), "row 3");
  says(message_of([] { History::table({{0, 0}, {2, 1}, {1, 2}}); }), "later than 2, got 1");
  says(message_of([] { History::table({{0, not_a_number}}); }), "row 1: expected a finite value, got nan");
  says(message_of([] { History::table({{infinity, 0}}); }), "finite time");
  says(message_of([] { History::ramp(1, 0); }), "positive time");
  says(message_of([] { History::ramp(1, not_a_number); }), "positive time");
  says(message_of([] { History::ramp(not_a_number, 1); }), "'value'");
  says(message_of([] { History::callback({}); }), "function");
}

TEST_CASE("a callback that turns NaN names the time", "[history]") {
  const History h = History::callback([](double t) { return t > 0.5 ? not_a_number : 0.0; });
  CHECK(h.value(0.5) == 0);
  says(message_of([&] { h.value(0.75); }), "at time 0.75 s, got nan");
}
