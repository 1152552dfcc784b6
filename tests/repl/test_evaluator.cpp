// The prompt without a terminal.
#include <algorithm>
#include <csignal>
#include <sstream>

#include "catch.hpp"
#include "repl/evaluator.hpp"
#include "repl/interrupt.hpp"
#include "repl/prompt.hpp"
#include "script/open/open_session.hpp"

using namespace fabricsh;
using repl::EvaluationOutcome;

namespace {

struct Talk {
  std::string out, err;
};

// A whole session that types these lines.
Talk talk(const std::string& input) {
  script::OpenSession session{script::SessionOptions{}};
  REQUIRE(repl::spill_globals(session).outcome == EvaluationOutcome::done);
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
  script::OpenSession session{script::SessionOptions{}};
  for (const char* part :
       {"for i = 1, 2 do", "1 +", "x =", "{1,", "f(", "x = [[", "-- [[\n--[[", "mesh.rectangle{ width=1,"})
    CHECK(repl::is_incomplete(session, part));
  for (const char* whole :
       {"for i = 1, 2 do\nend", "x = = 1", "1 + 1", "x = 'a", "end", "=1", "goto nowhere"})
    CHECK_FALSE(repl::is_incomplete(session, whole));
  CHECK(lua_gettop(session.lua()) == 0);
  CHECK(repl::evaluate(session, "x = = 1").outcome == EvaluationOutcome::deck_error);
  CHECK(talk("x = {\n1,\n2}\n#x\n").out == "2\n");
  CHECK(talk("1 +\n\n2\n").out == "3\n");
  CHECK(talk("x = {\n").err.find("near <eof>") != std::string::npos);  // the lines end before the input does
}

TEST_CASE("characters that a terminal would obey are shown as Lua writes them") {
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

TEST_CASE("quit and exit end the session, as names they are the user's") {
  for (const char* word : {"quit", "exit", "quit()", " exit () ", "exit()"})
    CHECK(talk(std::string("1\n") + word + "\n2\n").out == "1\n");
  CHECK(talk("quit = 3\nquit\n").out == "3\n");
  CHECK(talk("x = {\nquit\n}\n2\n").out == "2\n");  // within an input it is a name
}

TEST_CASE("help, ? and ? word mean calls of help") {
  script::OpenSession session{script::SessionOptions{}};
  REQUIRE(repl::spill_globals(session).outcome == EvaluationOutcome::done);
  const auto as_lua = [&](const char* input) { return repl::command_as_lua(session, input); };
  for (const char* asked : {"help", " help ", "?", "? "}) CHECK(as_lua(asked) == "help()");
  for (const char* asked : {"? mesh:set", "?mesh:set", "help mesh:set"})
    CHECK(as_lua(asked) == "help(\"mesh:set\")");
  CHECK(as_lua("? 'two words'") == "help('two words')");
  for (const char* asked : {"? drape  height", "help drape  height"})
    CHECK(as_lua(asked) == "help(\"drape  height\")");
  CHECK(as_lua("? mesh:set of nodes") == "help(\"mesh:set of nodes\")");
  for (const char* lua :
       {"help()", "help 'shear'", "help = 3", "helper", "x = help", "1 + 1", "help(mesh)", "help .. x"})
    CHECK(as_lua(lua) == lua);
  CHECK(repl::run_text(session, "help = 3", "=t").outcome == EvaluationOutcome::done);
  CHECK(as_lua("help") == "help");
  CHECK(as_lua("?") == "require('fabric').help()");
}

TEST_CASE("a name of the library's, a unit or one of Lua's that is assigned over is told once") {
  CHECK(talk("m = 3\nm = 4\n").err == "warning: m is no longer the unit; fabric.units.m still is\n");
  CHECK(talk("model = 3\n").err ==
        "warning: model is no longer what fabric has under that name; fabric.model still is\n");
  CHECK(talk("print = nil\n").err == "warning: print is no longer Lua's own\n");
  CHECK(talk("fabric = 1\nfabric = 2\n").err ==
        "warning: fabric is no longer the library; require 'fabric' still is\n");
  CHECK(talk("function card() end\n").err.find("warning: card is no longer") == 0);
  CHECK(talk("x = 3\nx = 4\nlong = 2\nfabric.units.mm\n").err.empty());
}

TEST_CASE("records show as a table") {
  CHECK(talk("{ {t=0, x='a'}, {t=1, x='bcd'}, {t=22.5, x='e'}, {t=3, x='f'} }\n").out ==
        "  t     x\n  0     \"a\"\n  1     \"bcd\"\n  22.5  \"e\"\n  3     \"f\"\n");
  const std::string many = talk("r = {} for i = 1, 99 do r[i] = {n=i, twice=2*i} end\nr\n{ rows=r }\n").out;
  CHECK(many.find("  40  80\n  ... and 59 more\n{rows = <99 rows of n, twice>}\n") != std::string::npos);
  const std::string wide = "x=('y'):rep(60), z=('y'):rep(60)";
  CHECK(talk("{ {" + wide + "}, {" + wide + "}, {" + wide + "}, {" + wide + "} }\n").out ==
        "<4 rows of x, z>\n");
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

TEST_CASE("an error in a function of the library's own Lua has the place of the input") {
  CHECK(talk("c = columns{ {E=0} }\nc:max('Q')\n").err.starts_with("prompt:1: columns: expected a number Q"));
  CHECK(talk("columns{ {E=0}, {E=2} }:max('E')\n(function() end)()\n1, nil\n").out == "2\t{E = 2}\n1\tnil\n");
}

TEST_CASE("below an error stands who called whom") {
  script::OpenSession session{script::SessionOptions{}};
  const auto error_of = [&](const std::string& text) {
    return repl::run_text(session, text, "@deck.lua").message;
  };
  const std::string helpers =
      "local fabric = require 'fabric'\n"
      "local function strip(w)\n"
      "  local m = fabric.mesh.rectangle{ width=w, height=1, nx=1, ny=1 }\n"
      "  return m\n"
      "end\n"
      "function study(w)\n"
      "  local m = strip(w)\n"
      "  return m\n"
      "end\n";
  const std::string first =
      "deck.lua:3: rectangle: field 'width': expected a positive number in m, got -1\n"
      "  called from deck.lua:7, in 'study'\n"
      "  called from deck.lua:10";
  CHECK(error_of(helpers + "study(-1)\n") == first);
  // typed lines are not told: their author sees them
  CHECK(repl::evaluate(session, "x = study(-1)").message == first.substr(0, first.rfind('\n')));
  CHECK(repl::run_text(session, "x = study(-1)", "=(command line)").message ==
        first.substr(0, first.rfind('\n')));
  // a caught error leaves nothing behind for the next; one that is raised again is told from there
  CHECK(error_of("pcall(study, -1)\n\nerror 'later'\n") == "deck.lua:3: later");
  CHECK(error_of("local _, e = pcall(study, -1)\nerror(e, 0)\n") ==
        first.substr(0, first.find('\n')) + "\n  at deck.lua:2");
  CHECK(error_of("local function check()\n  error('no', 2)\nend\ncheck()\n") == "deck.lua:4: no");
  CHECK(error_of("local function check()\n  error{}\nend\ncheck()\n") ==
        "error without a text: {}\n  at deck.lua:2, in 'check'\n  called from deck.lua:4");
  CHECK(repl::evaluate(session, "error{}").message == "error without a text: {}");
  CHECK(repl::evaluate(session, "x = = 1").message.find("called") == std::string::npos);
  // the library's own Lua lines are passed over, the deck's below them are not
  CHECK(
      error_of(
          "local fabric = require 'fabric'\nlocal function check(x)\n  fabric.expect{ {'x', x, 2} }\nend\n"
          "check(1)\n") ==
      "deck.lua:3: expect: row 'x': expected relative= or absolute= (one of them)\n  called from deck.lua:5");
}

TEST_CASE("of a deep recursion both ends are told") {
  script::OpenSession session{script::SessionOptions{}};
  const std::string endless = "function f(n)\n  return 1 + f(n + 1)\nend\nlocal x = f(1)\n";
  const std::string message = repl::run_text(session, endless, "@deck.lua").message;
  CHECK(message.find("deck.lua:2: stack overflow") == 0);
  CHECK(message.find("calls more ...") != std::string::npos);
  CHECK(message.ends_with("\n  called from deck.lua:4"));
  CHECK(std::count(message.begin(), message.end(), '\n') < 60);
}

TEST_CASE("a numerical failure is told from a deck error") {
  script::OpenSession session{script::SessionOptions{}};
  CHECK(repl::run_text(session, "error{kind='numerical'}", "=t").outcome ==
        EvaluationOutcome::numerical_failure);
  CHECK(repl::run_text(session, "error{kind='other'}", "=t").outcome == EvaluationOutcome::deck_error);
}

TEST_CASE("Ctrl-C between two lines drops what was typed of an input") {
  struct Typist : repl::Lines {
    InputState next(const std::string& before, std::string& line) override {
      befores.push_back(before);
      line = befores.size() == 1 ? "for i = 1, 2 do" : "'new'";
      if (befores.size() == 1) std::raise(SIGINT);
      return befores.size() < 3 ? InputState::line : InputState::end;
    }
    std::vector<std::string> befores;
  } typist;
  script::OpenSession session{script::SessionOptions{}};
  std::ostringstream out, err;
  const repl::InterruptGuard guard(session);
  repl::converse(session, typist, {out, err});
  CHECK(typist.befores == std::vector<std::string>(3, ""));
  CHECK(out.str() == "\nnew\n");
  CHECK(err.str().empty());
}

TEST_CASE("the end of the text within an input is said, and ends nothing but that") {
  struct Typist : repl::Lines {
    InputState next(const std::string&, std::string& line) override {
      line = count == 0 ? "function f()" : "'still'";
      return ++count == 2 ? InputState::end : count < 4 ? InputState::line : InputState::end;
    }
    int count = 0;
  } typist;
  script::OpenSession session{script::SessionOptions{}};
  std::ostringstream out, err;
  CHECK(repl::converse(session, typist, {out, err}) == EvaluationOutcome::deck_error);
  CHECK(out.str() == "still\n");
  CHECK(err.str() == "prompt:1: 'end' expected near <eof>\n");
}
