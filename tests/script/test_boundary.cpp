// Where C++ meets Lua: destructors run, exceptions become Lua errors, Lua errors pass through.
#include "catch.hpp"
#include "script/call/boundary.hpp"
#include "script/call/call.hpp"
#include "script/open/open_session.hpp"

using namespace fabricsh;
using namespace fabricsh::script;

namespace {

int destroyed = 0;
struct Witness {
  ~Witness() { ++destroyed; }
};

int raise_lua_error(Call& call) {
  const Witness witness;
  return luaL_error(call.L(), "from Lua");
}

int raise_deck_error(Call&) {
  const Witness witness;
  throw Error("field 'x': expected a mesh, got nil");
}

int raise_failure(Call&) {
  const Witness witness;
  throw NumericalFailure("no step", 0.25, 6, "warp");
}

int raise_other(Call&) { throw std::out_of_range("beyond"); }

int call_back(Call& call) {
  const Witness witness;
  const Function f = call.function("f");
  lua_State* L = f.push();
  lua_call(L, 0, 0);
  return 0;
}

// A session in which the functions above are fabric.*; called with a chunk, it runs it as deck.lua.
struct DeckRunner {
  DeckRunner() : session(SessionOptions{}) {
    Entry lua{"fabric.lua_error()"}, deck{"fabric.deck_error()"}, fail{"fabric.failure()"},
        other{"fabric.other()"}, back{"fabric.back()"};
    lua.run = raise_lua_error;
    deck.run = raise_deck_error;
    fail.run = raise_failure;
    other.run = raise_other;
    back.run = call_back;
    back.arguments = {value_("f", function, "to be called")};
    install(session, {lua, deck, fail, other, back});
    destroyed = 0;
  }
  // The value that the chunk returns, as text.
  std::string operator()(const std::string& chunk) {
    lua_State* L = session.lua();
    const std::string whole = "local fabric = require 'fabric' " + chunk;
    if (luaL_loadbuffer(L, whole.data(), whole.size(), "=deck.lua") != LUA_OK ||
        lua_pcall(L, 0, 1, 0) != LUA_OK)
      return "uncaught: " + std::string(luaL_tolstring(L, -1, nullptr));
    const std::string out = luaL_tolstring(L, -1, nullptr);
    lua_settop(L, 0);
    return out;
  }
  OpenSession session;
};

}  // namespace

TEST_CASE("a Lua error raised inside a binding runs C++ destructors") {
  DeckRunner run;
  CHECK(run("return select(2, pcall(fabric.lua_error))") == "from Lua");
  CHECK(destroyed == 1);
}

TEST_CASE("a deck error says deck:line and the call") {
  DeckRunner run;
  CHECK(run("\nfabric.deck_error()") ==
        "uncaught: deck.lua:2: deck_error: field 'x': expected a mesh, got nil");
  CHECK(destroyed == 1);
}

TEST_CASE("a numerical failure is a table with text") {
  DeckRunner run;
  CHECK(run("local ok, e = pcall(function()\n fabric.failure() end) return "
            "e.kind..e.time..e.element..e.yarn..' '..tostring(e)") ==
        "numerical0.257warp deck.lua:2: failure: no step");
}

TEST_CASE("any other exception is an error too, and the session lives") {
  DeckRunner run;
  CHECK(run("return select(2, pcall(function() fabric.other() end))") ==
        "deck.lua:1: other: internal error: beyond");
  CHECK(run("return 1 + 1") == "2");
}

TEST_CASE("an error in a callback keeps its own line and passes through C++") {
  DeckRunner run;
  CHECK(run("\nreturn select(2, pcall(fabric.back, function()\n error 'mine' end))") == "deck.lua:3: mine");
  CHECK(destroyed == 1);
  CHECK(run("return select(2, pcall(fabric.back, function() error({7}) end))[1]") == "7");
}

TEST_CASE("callbacks run on the coroutine that calls") {
  DeckRunner run;
  CHECK(run("local co = coroutine.wrap(function() return pcall(fabric.back, function() error('inside', 0) "
            "end) end) "
            "return select(2, co())") == "inside");
  CHECK(run("local co = coroutine.create(function() fabric.deck_error() end) return select(2, "
            "coroutine.resume(co))") == "deck.lua:1: deck_error: field 'x': expected a mesh, got nil");
}
