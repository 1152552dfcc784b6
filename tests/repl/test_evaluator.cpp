// The prompt without a terminal.
#include <csignal>
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
  repl::converse(session, *lines, {out, err});
  return {out.str(), err.str()};
}

}  // namespace

TEST_CASE("expressions print, statements do not") {
  CHECK(talk("1 + 1\nx = 3\nx, 'two'\nnil\n").out == "2\n3\ttwo\nnil\n");
  CHECK(talk("{1, 2, a={b='c'}}\n").out == "{1, 2, a = {b = \"c\"}}\n");
  CHECK(talk("{['end']=1, ['a b']=2}\n").out == "{[\"a b\"] = 2, [\"end\"] = 1}\n");
}

TEST_CASE("unfinished input goes on with the next line") {
  script::Session session{script::Options{}};
  for (const char* part :
       {"for i = 1, 2 do", "1 +", "x =", "{1,", "f(", "x = [[", "-- [[\n--[[", "mesh.rectangle{ width=1,"})
    CHECK(repl::wants_more(session, part));
  for (const char* whole :
       {"for i = 1, 2 do\nend", "x = = 1", "1 + 1", "x = 'a", "end", "=1", "goto nowhere"})
    CHECK_FALSE(repl::wants_more(session, whole));
  CHECK(lua_gettop(session.lua()) == 0);
  CHECK(repl::evaluate(session, "x = = 1").outcome == Outcome::deck_error);
  CHECK(talk("x = {\n1,\n2}\n#x\n").out == "2\n");
  CHECK(talk("1 +\n\n2\n").out == "3\n");
  CHECK(talk("x = {\n").err.find("near <eof>") != std::string::npos);  // the lines end before the input does
}

TEST_CASE("what a terminal would obey is shown as Lua writes it") {
  CHECK(talk("'a\\0b\\27[31m'\n").out == "a\\0b\\27[31m\n");
}

TEST_CASE("the reading that came further says where it went wrong") {
  CHECK(talk("1 +\n)\n").err.find("prompt:2: unexpected symbol near") != std::string::npos);
  CHECK(talk("x = = 2\n").err.find("prompt:1: unexpected symbol near") != std::string::npos);
}

TEST_CASE("a leading = shows a value") { CHECK(talk("=1 + 1\n = 'a', 2\n").out == "2\na\t2\n"); }

TEST_CASE("local at the prompt is warned about, and runs") {
  const Talk t = talk("local x = 3; print(x)\nx\n");
  CHECK(t.out == "nil\n");  // print goes to stdout, not here
  CHECK(t.err == "warning: local x is gone on the next line; to keep it leave 'local' out\n");
  CHECK(repl::advice("local a <const>, b = 1, 2").find("local a, b are gone") != std::string::npos);
  CHECK(repl::advice("local function f() end").find("local f is gone") != std::string::npos);
  for (const char* fine :
       {"x = 1", "do local x = 1 end", "function f() local x end", "'local x'", "-- local x",
        "for i = 1, 2 do local x = i end", "x = { f = function() local y end }"})
    CHECK(repl::advice(fine).empty());
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

TEST_CASE("Ctrl-C between two lines drops what was typed of an input") {
  struct Typist : repl::Lines {
    State next(const std::string& before, std::string& line) override {
      befores.push_back(before);
      line = befores.size() == 1 ? "for i = 1, 2 do" : "'new'";
      if (befores.size() == 1) std::raise(SIGINT);
      return befores.size() < 3 ? State::line : State::end;
    }
    std::vector<std::string> befores;
  } typist;
  script::Session session{script::Options{}};
  std::ostringstream out, err;
  const repl::InterruptGuard guard(session);
  repl::converse(session, typist, {out, err});
  CHECK(typist.befores == std::vector<std::string>(3, ""));
  CHECK(out.str() == "\nnew\n");
  CHECK(err.str().empty());
}

TEST_CASE("the end of the text within an input is said, and ends nothing but that") {
  struct Typist : repl::Lines {
    State next(const std::string&, std::string& line) override {
      line = count == 0 ? "function f()" : "'still'";
      return ++count == 2 ? State::end : count < 4 ? State::line : State::end;
    }
    int count = 0;
  } typist;
  script::Session session{script::Options{}};
  std::ostringstream out, err;
  CHECK(repl::converse(session, typist, {out, err}) == Outcome::deck_error);
  CHECK(out.str() == "still\n");
  CHECK(err.str() == "prompt:1: 'end' expected near <eof>\n");
}
