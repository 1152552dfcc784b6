// A session saved as a deck: the deck does the same.
#include <cstdio>
#include <fstream>
#include <sstream>

#include "catch.hpp"
#include "repl/prompt.hpp"
#include "scratch.hpp"
#include "script/open/open_session.hpp"
#include "script/show/transcript.hpp"

using namespace fabricsh;
using repl::EvaluationOutcome;
using repl::Result;

namespace {

// Types lines into a session, and gives what stands on its streams.
std::string type(script::Session& session, const std::string& input) {
  std::istringstream in(input);
  std::ostringstream out;
  repl::converse(session, *repl::stream_lines(in), {out, out});
  return out.str();
}

std::string number(script::Session& session, const std::string& expression) {
  const Result result = repl::evaluate(session, expression);
  INFO(result.message);
  REQUIRE(result.outcome == EvaluationOutcome::done);
  return result.shown;
}

Result done(bool expression) { return {EvaluationOutcome::done, "", "", expression}; }

}  // namespace

TEST_CASE("an input as part of a deck") {
  using repl::deck_text;
  CHECK(deck_text("1 + 1", done(true)) == "_show(1 + 1)\n");
  CHECK(deck_text("= x", done(true)) == "_show( x)\n");
  CHECK(deck_text("x -- why", done(true)) == "_show(x -- why\n)\n");
  CHECK(deck_text("x = 1", done(false)) == "x = 1\n");
  CHECK(deck_text("; -- nothing", done(true)) == "; -- nothing\n");
  CHECK(deck_text("(f or g)(1) y = 2", done(false)) == ";(f or g)(1) y = 2\n");
  CHECK(deck_text("local x = 1 y = x", done(false)) == "do\nlocal x = 1 y = x\nend\n");
  CHECK(deck_text("::top:: x = 1", done(false)) == "do\n::top:: x = 1\nend\n");
  CHECK(deck_text("x = 1; return x", done(false)) == "_show((function(...)\nx = 1; return x\nend)(...))\n");
  CHECK(deck_text("error 'a\nb'", {EvaluationOutcome::deck_error, "bad\nthing"}) ==
        "-- error 'a\n-- b'\n--   failed: bad\n");
  CHECK(repl::deck_call("a\"b.lua") == "dofile \"a\\\"b.lua\"\n");
}

TEST_CASE("the deck of a session gives the session's values") {
  std::remove("kept.lua");
  script::OpenSession session{script::SessionOptions{}};
  REQUIRE(repl::spill_globals(session).outcome == EvaluationOutcome::done);
  type(session,
       "sheet = mesh.rectangle{ width=0.0254, height=0.0762,\n  nx=1, ny=3 }\n"
       "m = model{ mesh=sheet, card=card 'blend', warp=90 }\n"
       "m:fix('all', 'z rotation'):fix('bottom', 'x y'):fix('top', 'x')\n"
       "transcript 'kept.lua'\n"
       "local h = ramp(0.018, 1); m:move('top', { y=h })\n"
       "a = static{ model=m, duration=1, step=0.25 }\n"
       "a:no_such_method()\n"
       "a:advance(0.5)\n"
       "(print)('half') -- a bracket first\n"
       "seen = a:mean 'S11'\n"
       "a:solve() -- to the end\n"
       "return a.time\n"
       "=transcript()\n");
  const std::string deck = content_of("kept.lua");
  INFO(deck);
  CHECK(deck.find("transcript 'kept") == std::string::npos);
  CHECK(deck.find("-- a:no_such_method()\n--   failed: ") != std::string::npos);
  CHECK(deck.find("require \"fabric\"; fabric.globals()\n") != std::string::npos);

  script::OpenSession again{script::SessionOptions{}};
  const Result ran = repl::run_deck(again, "kept.lua", {});
  INFO(ran.message);
  REQUIRE(ran.outcome == EvaluationOutcome::done);
  for (const char* value : {"('%a'):format(seen)", "('%a'):format(a:mean 'S11')", "a.time", "h"})
    CHECK(number(session, value) == number(again, value));
  CHECK(number(again, "seen > 0") == "true");
  std::remove("kept.lua");
}

TEST_CASE("a transcript is a runnable file at any moment, ends, and overwrites nothing") {
  std::remove("steps.lua");
  script::OpenSession session{script::SessionOptions{}};
  REQUIRE(repl::spill_globals(session).outcome == EvaluationOutcome::done);
  type(session, "transcript 'steps.lua'\n");
  for (const char* line : {"x = {\n1,\n2}\n", "local y = 3\n", "x = = 1\n", "#x --[[ long\n]]\n", "x[1]\n"}) {
    type(session, line);
    script::OpenSession fresh{script::SessionOptions{}};
    INFO(content_of("steps.lua"));
    CHECK(repl::run_deck(fresh, "steps.lua", {}).outcome == EvaluationOutcome::done);
  }
  type(session, "transcript(false)\nz = 1\n");
  CHECK(content_of("steps.lua").find("z = 1") == std::string::npos);
  CHECK(type(session, "transcript()\n") == "false\n");
  CHECK(type(session, "transcript 'steps.lua'\n").find("'steps.lua' exists already") != std::string::npos);
  CHECK(type(session, "transcript '/dev/null/a.lua'\n").find("transcript: ") != std::string::npos);
  CHECK(type(session, "transcript(true)\n").find("expected the name of a file") != std::string::npos);
  std::remove("steps.lua");
}

TEST_CASE("a transcript that can't be written is said, and the session goes on") {
  std::remove("gone/t.lua");
  std::remove("gone");
  script::OpenSession session{script::SessionOptions{}};
  REQUIRE(repl::spill_globals(session).outcome == EvaluationOutcome::done);
  type(session, "transcript 'gone/t.lua'\n");
  std::remove("gone/t.lua");
  std::remove("gone");
  std::ofstream("gone") << "a file where the folder was";
  const std::string said = type(session, "x = 1\nx\n");
  CHECK(said.find("warning: transcript: ") != std::string::npos);
  CHECK(said.find("\n1\n") != std::string::npos);
  std::remove("gone");
}

TEST_CASE("under -i the deck comes first") {
  script::SessionOptions options;
  options.deck = "before.lua";
  script::OpenSession session{options};
  type(session, "x = 1\n");
  CHECK(script::transcript_of(session.lua()).deck().find("dofile \"before.lua\"\nx = 1\n") !=
        std::string::npos);
}

TEST_CASE("who() lists what the user's globals hold, objects first, and nothing of fabric's") {
  script::OpenSession session{script::SessionOptions{}};
  REQUIRE(repl::spill_globals(session).outcome == EvaluationOutcome::done);
  CHECK(type(session, "who()\n") == "nothing yet\n");
  const std::string said =
      type(session,
           "a_number = 3\nsheet = mesh.rectangle{ width=1, height=1, nx=2, ny=2 }\nmm = 7\nfunction f() end\n"
           "broken = setmetatable({}, { __tostring=function() error 'no' end })\nalias = mesh.disk\nwho()\n");
  INFO(said);
  CHECK(said.find("  sheet     mesh      ") != std::string::npos);
  CHECK(said.find("sheet") < said.find("a_number"));
  CHECK(said.find("  mm        number    7\n") != std::string::npos);  // no longer fabric's
  CHECK(said.find("broken") != std::string::npos);
  CHECK(said.find("  f         function") != std::string::npos);
  for (const char* own :
       {"\n  inch", "\n  card", "\n  print", "\n  string", "\n  fabric", "\n  arg", "\n  N "})
    CHECK(said.find(own) == std::string::npos);
  CHECK(type(session, "#who(), who()[1].name, who()[1].class\n") == "6\tsheet\tmesh\n");
}
