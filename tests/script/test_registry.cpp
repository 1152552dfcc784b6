// Every Lua function has a row, the row a sentence for itself and each argument, and an example that runs.
#include <map>
#include <set>

#include "catch.hpp"
#include "draws.hpp"
#include "script/open/open_session.hpp"

using namespace fabricsh::script;

namespace {

std::string error_of(Session& session, const std::string& chunk) {
  lua_State* L = session.lua();
  if (luaL_loadstring(L, chunk.c_str()) != LUA_OK || lua_pcall(L, 0, 0, 0) != LUA_OK) {
    const std::string message = luaL_tolstring(L, -1, nullptr);
    lua_settop(L, 0);
    return message;
  }
  return "";
}

void check_rows(const std::string& name, const std::vector<Argument>& rows) {
  for (const Argument& row : rows) {
    INFO(name << ": argument " << row.name);
    CHECK_FALSE(row.sentence.empty());
    CHECK_FALSE(expected(row).empty());
    if ((row.kinds & fields) != 0) CHECK_FALSE(row.rows.empty());
    check_rows(name, row.rows);
  }
}

// Functions below a table, by their dotted name.
void collect(lua_State* L, const std::string& path, std::set<std::string>& names) {
  lua_pushnil(L);
  while (lua_next(L, -2) != 0) {
    const std::string name = path + "." + lua_tostring(L, -2);
    if (lua_isfunction(L, -1)) names.insert(name);
    if (lua_istable(L, -1)) collect(L, name, names);
    lua_pop(L, 1);
  }
}

}  // namespace

TEST_CASE("every function of the module has a row") {
  OpenSession session{SessionOptions{}};
  REQUIRE(error_of(session, "require 'fabric'") == "");
  std::set<std::string> functions;
  lua_getfield(session.lua(), LUA_REGISTRYINDEX, "fabric");
  collect(session.lua(), "fabric", functions);
  CHECK(functions.size() > 10);
  for (const std::string& name : functions) {
    INFO(name);
    CHECK(session.registry().find(name) != nullptr);
  }
}

TEST_CASE("every method and property has a row") {
  OpenSession session{SessionOptions{}};
  lua_State* L = session.lua();
  for (const char* name : {"mesh", "card", "history", "point", "model", "analysis"}) {
    REQUIRE(lua_getfield(L, LUA_REGISTRYINDEX, ("fabricsh." + std::string(name)).c_str()) == LUA_TTABLE);
    for (const auto& [table, mark] : {std::pair{"methods", ":"}, std::pair{"properties", "."}}) {
      lua_getfield(L, -1, table);
      lua_pushnil(L);
      while (lua_next(L, -2) != 0) {
        const std::string full = std::string(name) + mark + lua_tostring(L, -2);
        INFO(full);
        CHECK(session.registry().find(full) != nullptr);
        lua_pop(L, 1);
      }
      lua_pop(L, 1);
    }
    lua_pop(L, 1);
  }
}

TEST_CASE("every row says what it is") {
  OpenSession session{SessionOptions{}};
  REQUIRE(error_of(session, "require 'fabric'") == "");
  std::map<std::string, int> count;
  for (const Entry& entry : session.registry().entries()) {
    INFO(entry.name);
    CHECK(++count[entry.name] == 1);
    CHECK(entry.sentence.size() > 10);
    CHECK_FALSE(entry.example.empty());
    check_rows(entry.name, entry.arguments);
  }
}

// The short form runs every fourth; scripts/reference.lua runs all that show something, in one session.
TEST_CASE("every example runs, each in a session of its own") {
  std::vector<std::pair<std::string, std::string>> examples;
  {
    OpenSession session{SessionOptions{}};
    REQUIRE(error_of(session, "require 'fabric'") == "");
    for (const Entry& entry : session.registry().entries()) examples.emplace_back(entry.name, entry.example);
  }
  const std::size_t apart = 4 / fabricsh::test::draws(4);
  for (std::size_t i = 0; i < examples.size(); i += apart) {
    const auto& [name, example] = examples[i];
    OpenSession session{SessionOptions{}};
    INFO(name << ":\n" << example);
    const std::string said = error_of(session, example);
    if (said.find("a part that is not installed") == std::string::npos) CHECK(said == "");
  }
}
