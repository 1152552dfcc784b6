// The prompt without a terminal.
#include <sstream>

#include "catch.hpp"
#include "repl/evaluator.hpp"
#include "repl/prompt.hpp"

using namespace fabricsh;
using repl::Outcome;

namespace {

struct Talk {
  std::string out, err;
};

// A whole session that types these lines.
Talk talk(const std::string& input) {
  script::Session session{script::Options{}};
  REQUIRE(repl::spill_globals(session).outcome == Outcome::done);
  std::istringstream in(input);
  std::ostringstream out, err;
  const auto lines = repl::stream_lines(in);
  repl::converse(session, *lines, out, err);
  return {out.str(), err.str()};
}

}  // namespace

TEST_CASE("expressions print, statements do not") {
  CHECK(talk("1 + 1\nx = 3\nx, 'two'\nnil\n").out == "2\n3\ttwo\nnil\n");
  CHECK(talk("{1, 2, a={b='c'}}\n").out == "{1, 2, a = {b = \"c\"}}\n");
}

TEST_CASE("unfinished input goes on with the next line") {
  script::Session session{script::Options{}};
  CHECK(repl::evaluate(session, "for i = 1, 2 do").outcome == Outcome::incomplete);
  CHECK(repl::evaluate(session, "for i = 1, 2 do\nend").outcome == Outcome::done);
  CHECK(repl::evaluate(session, "x = = 1").outcome == Outcome::deck_error);
  CHECK(talk("x = {\n1,\n2}\n#x\n").out == "2\n");
}

TEST_CASE("globals do not cover Lua's own") {
  CHECK(talk("type(string.format), 3*inch, fabric.units.mm, type(table.concat)\n").out ==
        "function\t0.0762\t0.001\tfunction\n");
}

TEST_CASE("errors never end the session") {
  const std::string deck =
      "local mesh = mesh.rectangle{ width=1, height=1, nx=2, ny=2 }\n"
      "mesh.rectangle{ width=-1, height=1, nx=2, ny=2 }\n"
      "card 'denm'\n"
      "error()\n"
      "error(setmetatable({}, {__tostring=function() error 'again' end}))\n"
      "x = = 2\n"
      "fabric.nothing\n"
      "coroutine.wrap(function() mesh.rectangle{} end)()\n"
      "'alive'\n";
  const Talk t = talk(deck);
  CHECK(t.out == "alive\n");
  CHECK(t.err.find("prompt:1: rectangle: field 'width': expected a positive number in m, got -1") !=
        std::string::npos);
}

TEST_CASE("a numerical failure is told from a deck error") {
  script::Session session{script::Options{}};
  CHECK(repl::run_text(session, "error{kind='numerical'}", "=t").outcome == Outcome::numerical_failure);
  CHECK(repl::run_text(session, "error{kind='other'}", "=t").outcome == Outcome::deck_error);
}
