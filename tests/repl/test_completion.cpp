// Completion without a terminal: what may stand at the end of a text.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "repl/completion.hpp"
#include "repl/evaluator.hpp"
#include "script/open/open_session.hpp"

using namespace fabricsh;
using Words = std::vector<std::string>;

namespace {

struct Bench {
  Bench() : session(script::SessionOptions{}) {
    REQUIRE(repl::spill_globals(session).outcome == repl::EvaluationOutcome::done);
    run("sheet = mesh.rectangle{ width=0.1, height=0.1, nx=2, ny=2 }\nsheet:set('seam', {1, 2})\n"
        "blend = card 'blend'\nm = model{ mesh=sheet, card=blend }\nm:fix('left', 'x y z'):fix('all', 'z')\n"
        "a = static{ model=m, duration=1 }\n"
        "shelf = { blend = blend, [2] = sheet, deep = { sheet = sheet }, ['two words'] = 1 }");
  }
  void run(const std::string& chunk) {
    const auto result = repl::run_text(session, chunk, "=t");
    INFO(result.message);
    REQUIRE(result.outcome == repl::EvaluationOutcome::done);
  }
  Words operator()(const std::string& text) { return repl::complete(session, text).candidates; }
  std::string common(const std::string& text) { return repl::complete(session, text).common; }
  script::OpenSession session;
};

bool has(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

TEST_CASE("keywords, globals, fields") {
  Bench words;
  CHECK(words("whi") == Words{"while"});
  CHECK(words("x = she") == Words{"sheet", "shelf"});
  CHECK(words.common("x = she") == "she");
  CHECK(words.common("print(shee") == "sheet");
  CHECK(words("fabric.mesh.rect") == Words{"rectangle"});
  CHECK(has(words("fabric.mesh."), "disk"));
  CHECK(words("shelf.") == Words{"blend", "deep"});  // no name that can't stand behind a dot
  CHECK(words("shelf.deep.") == Words{"sheet"});
  CHECK(words("shelf[\"bl") == Words{"blend"});
  CHECK(words("shelf['two") == Words{"two words"});
  CHECK(words.common("shelf['two") == "two words'");
  CHECK(words("nothing.here.") == Words{});
  CHECK(words("f(x).") == Words{});
  CHECK(words("local speed = 3\nspee") == Words{"speed"});
  CHECK(words("x = 12") == Words{});
  CHECK(words("x = 3 -- she") == Words{});
  CHECK(words("--[[ she") == Words{});
  CHECK(words("print [[she") == Words{});
  const auto whole = repl::complete(words.session, "print(she");
  CHECK(whole.from == 6);
}

TEST_CASE("a large table is completed from a part of it, and no beginning is made up") {
  Bench words;
  words.run("big = {} for i = 1, 30000 do big[('a%05d'):format(i)] = i end big.zebra = 1 big.zeal = 2");
  const auto all = repl::complete(words.session, "big.");
  CHECK(all.candidates.size() == 10'000);
  CHECK(all.common.empty());  // there is a z, too
  CHECK(words("big.ze") == Words{"zeal", "zebra"});
  CHECK(words.common("big.zeb") == "zebra");
  CHECK(words.common("big.a000") == "a000");
  CHECK(words("big.a0000").size() == 9);
  // as many keys as are looked at, then one more
  words.run("list = {} for i = 1, 1e6 do list[i] = i end list.name = 1");
  CHECK(words("list.") == Words{});
  words.run("list[#list] = nil");
  CHECK(words("list.") == Words{"name"});
}

TEST_CASE("methods behind a colon, properties behind a dot") {
  Bench words;
  CHECK(words("sheet:el") == Words{"elements"});
  CHECK(words("shelf[2]:el") == Words{"elements"});
  CHECK(words("shelf.deep.sheet:el") == Words{"elements"});
  CHECK(words("sheet.") == Words{"elements", "nodes", "sets"});
  CHECK(words("a:sol") == Words{"solve"});
  CHECK(has(words("a."), "energy"));
  CHECK_FALSE(has(words("a."), "solve"));
  CHECK(words("a.energy.kin") == Words{"kinetic"});  // read off a property of the program's own
  CHECK(words("blend.pois") == Words{});
  CHECK(words("blend.warp.pois") == Words{"poisson"});
  CHECK(words("m.card.thick") == Words{"thickness"});
  CHECK(words("blend:wi") == Words{"with"});
  words.run("name = 'word'");
  CHECK(words("name:gsu") == Words{"gsub"});
}

TEST_CASE("the result of a call is completed, without calling it") {
  Bench words;
  CHECK(words("m:fix('top', 'z'):fi") == Words{"fix"});
  CHECK(words("m:fix('top', 'z'):move('to") == Words{"top"});
  CHECK(words("m:fix('top', 'z'):fix('seam', 'z'):fix(\"se") == Words{"seam"});
  CHECK(words("m:fix('top', 'z'):force('top', { ") == Words{"x=", "y=", "z="});
  CHECK(words("mesh.rectangle{ width=1, height=1, nx=1, ny=1 }:el") == Words{"elements"});
  CHECK(words("mesh.rectangle{ width=1, height=1, nx=1, ny=1 }.se") == Words{"sets"});
  CHECK(words("card 'denim':wi") == Words{"with"});
  CHECK(words("fabric.card('denim'):with{ thickness=1e-3 }:wr") == Words{"write"});
  CHECK(words("static{ model=m, duration=f(x) }:sol") == Words{"solve"});
  CHECK(has(words("static{ model=m, duration=1 }:solve():"), "field"));
  CHECK(words("static{ model=m, duration=1 }:solve():mean('S1") == Words{"S11", "S12", "S13"});
  CHECK(words("a:solve().energy.kin") == Words{"kinetic"});
  CHECK(words("a.model:li") == Words{"list"});
  CHECK(words("a.mesh.se") == Words{"sets"});
  CHECK(words("f(x).") == Words{});
  CHECK(words("(m):") == Words{});
  CHECK(words("a:field('S11').") == Words{});
  words.run("called = false count = setmetatable({}, { __call=function() called = true end })");
  CHECK(words("count().").empty());
  words.run("assert(not called and a.time == 0)");
}

TEST_CASE("help is asked by name") {
  Bench words;
  CHECK(words("help \"mesh.rec") == Words{"mesh.rectangle"});
  CHECK(words("help('model:fi") == Words{"model:fix"});
  CHECK(words.common("help 'mesh.rec") == "mesh.rectangle'");
}

TEST_CASE("names of arguments, those that are not given yet") {
  Bench words;
  CHECK(words("mesh.rectangle{ wi") == Words{"width="});
  CHECK(words("fabric.mesh.rectangle{ width=1, ") ==
        Words{"grading=", "height=", "nx=", "ny=", "origin=", "triangles="});
  CHECK(words("fabric.mesh.rectangle{\n  width=1,\n  hei") == Words{"height="});
  CHECK(words("fabric.mesh.rectangle({ hei") == Words{"height="});
  CHECK(words("r = fabric.mesh.rectangle{ width=2*m") != Words{});  // a value: any global
  CHECK_FALSE(has(words("fabric.mesh.rectangle{ width="), "height="));
  CHECK(words("m:move('top', { x=1, ") == Words{"turn=", "y=", "z="});
  CHECK(words("woven{ warp={ load") == Words{"loading="});
  CHECK(words("woven{ warp={ loading={1, 2}, unl") == Words{"unloading="});
  CHECK(words("woven{ warp={ loading={1, 2} }, we") == Words{"weft="});
  CHECK(words("a:event{ value=function(run) return run.time, 2 end, tol") == Words{"tolerance="});
  words.run("make = fabric.mesh.rectangle");
  CHECK(words("make{ hei") == Words{"height="});  // the function counts, not its name
}

TEST_CASE("values: words of a choice, objects of the class") {
  Bench words;
  CHECK(words("static{ control=\"") == Words{"arc", "load"});
  CHECK(words("static{ control='a") == Words{"arc"});
  CHECK(words.common("static{ control='a") == "arc'");
  CHECK(words("static{ control=") == Words{"\"arc\"", "\"load\""});
  CHECK(words("static{ control=\"arc\"").empty());
  CHECK(words("static{ model=") == Words{"m"});
  CHECK(words("model{ mesh=") == Words{"sheet"});
  CHECK(words("a:every(\"") == Words{"step"});
  CHECK(words("a:mean('S1") == Words{"S11", "S12", "S13"});
  CHECK(words("a:vtk('out/a', { fields={ 'S', 'd") == Words{"director", "displacement", "dissipated",
                                                            "dissipated_damage", "dissipated_shear",
                                                            "dissipated_warp", "dissipated_weft"});
  CHECK(words("a:field \"resid") == Words{"residual", "residual1", "residual2"});
}

TEST_CASE("sets of the object at hand, freedoms, cards") {
  Bench words;
  CHECK(words("m:fix(\"") == Words{"all", "bottom", "boundary", "corners", "left", "right", "seam", "top"});
  CHECK(words("m:fix \"se") == Words{"seam"});
  CHECK(words.common("m:fix(\"se") == "seam\"");
  CHECK(words("sheet:elements 'bo") == Words{"bottom", "boundary"});
  CHECK(words("sheet:set('se") == Words{"seam"});
  CHECK(words("a:reaction('to") == Words{"top"});
  CHECK(words("a:mean('S11', 'to") == Words{"top"});
  CHECK(words("m:fix('left', 'x y rot") == Words{"rotation"});
  CHECK(repl::complete(words.session, "m:fix('left', 'x y rot").from == 19);
  CHECK(words("card 'de") == Words{"denim"});
  CHECK(words("fabric.card(\"mus") == Words{"muslin"});
}

TEST_CASE("files between other quotes") {
  std::filesystem::create_directories("shed/inner");
  std::ofstream("shed/curve.csv") << "t\n";
  std::ofstream("shed/.hidden") << "t\n";
  Bench words;
  CHECK(words("dofile 'she") == Words{"shed/"});
  CHECK(words.common("dofile 'she") == "shed/");
  CHECK(words("x = \"shed/") == Words{"shed/curve.csv", "shed/inner/"});
  CHECK(words.common("x = \"shed/cu") == "shed/curve.csv\"");
  CHECK(words("x = 'shed/.h") == Words{"shed/.hidden"});
  CHECK(words("x = 'no/such/folder/") == Words{});
}

TEST_CASE("completion never runs what the user wrote") {
  Bench words;
  words.run(
      "ran = 0\n"
      "trap = setmetatable({ inside = 1 }, {\n"
      "  __index = function() ran = ran + 1; error 'run' end, __pairs = function() ran = ran + 1 end,\n"
      "  __len = function() ran = ran + 1 end, __call = function() ran = ran + 1 end,\n"
      "  __tostring = function() ran = ran + 1 return 'x' end, __name = 'mesh' })\n"
      "setmetatable(_G, { __index = function() ran = ran + 1 end, __newindex = rawset })\n"
      "parent = { inherited = 1 }\n"
      "child = setmetatable({}, { __index = parent, __gc = function() ran = ran + 1 end })\n"
      "loop = setmetatable({}, {}) getmetatable(loop).__index = loop\n"
      "function act() ran = ran + 1 end\n"
      "collectgarbage 'stop' for i = 1, 1e3 do setmetatable({}, { __gc = function() ran = ran + 1 end }) "
      "end");
  lua_State* L = words.session.lua();
  lua_gc(L, LUA_GCINC, 1, 1000, 0);  // finalisers are due at the next allocation
  lua_gc(L, LUA_GCRESTART);
  for (int i = 0; i < 100; ++i) CHECK(words("m.card.warp.poi") == Words{"poisson"});  // makes tables
  CHECK(words("trap.") == Words{"inside"});
  CHECK(words("trap:") == Words{});
  CHECK(words("trap.missing.more.") == Words{});
  CHECK(words("trap{ ") != Words{});
  CHECK(words("trap['") == Words{"inside"});
  CHECK(words("missing.") == Words{});
  CHECK(words("act{ inh").empty());
  CHECK(words("act().") == Words{});
  CHECK(words("child.inh") == Words{"inherited"});
  CHECK(words("loop.") == Words{});
  CHECK(lua_gettop(L) == 0);
  lua_pushglobaltable(L);
  lua_pushliteral(L, "ran");
  lua_rawget(L, -2);
  CHECK(lua_tointeger(L, -1) == 0);
  lua_settop(L, 0);
}

TEST_CASE("columns") {
  CHECK(repl::in_columns({"a", "bb", "ccc", "d"}, 8) == "a    ccc\nbb   d\n");
  CHECK(repl::in_columns({"a", "bb"}, 1) == "a\nbb\n");
  CHECK(repl::in_columns({"out/a.csv", "out/sub/"}, 80) == "a.csv  sub/\n");
  CHECK(repl::in_columns({"a", "b", "c"}, 80, 2) == "a  b\n... and 1 more\n");
}
