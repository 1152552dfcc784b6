// Every Lua function has a row, the row a sentence for itself and each argument, and an example that runs.
#include <map>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "draws.hpp"
#include "script/call/boundary.hpp"
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

void load_library(OpenSession& session) {
  REQUIRE(error_of(session, "require 'fabric'") == "");
  load_defined_later(session.lua());
}

}  // namespace

TEST_CASE("a module is loaded when one of its functions is asked for") {
  // pull: the functions of this table by name, in a session in which nothing else has asked for them
  const auto names = [](const char* table, const char* pull) {
    OpenSession session{SessionOptions{}};
    INFO(table << ": " << pull);
    REQUIRE(error_of(session, std::string("local fabric = require 'fabric'\nlocal t, names = ") + table +
                                  ", {}\n" + pull + "\ntable.sort(names) found = table.concat(names, ' ')") ==
            "");
    lua_getglobal(session.lua(), "found");
    return std::string(lua_tostring(session.lua(), -1));
  };
  for (const char* table : {"fabric", "fabric.lab", "fabric.export", "fabric.import", "fabric.rigid"}) {
    const std::string all = names(table, "for name in pairs(t) do names[#names + 1] = name end");
    CHECK(
        all ==
        names(table, "local name = next(t) while name do names[#names + 1] = name name = next(t, name) end"));
    // one after the other, each as the first that is asked for
    std::istringstream words(all);
    for (std::string name; words >> name;)
      CHECK(names(table, ("if t." + name + " then names[1] = '" + name + "' end").c_str()) == name);
  }
  OpenSession session{SessionOptions{}};
  const auto modules = [&session] {
    REQUIRE(error_of(session,
                     "local n = 0 for name in pairs(package.loaded) do if name:find '^fabric%.lab%.' then n "
                     "= n + 1 end "
                     "end count = n") == "");
    lua_getglobal(session.lua(), "count");
    return lua_tointeger(session.lua(), -1);
  };
  REQUIRE(error_of(session, "require 'fabric'") == "");
  CHECK(modules() == 0);
  REQUIRE(error_of(session, "assert(require 'fabric'.lab.bias)") == "");
  const auto few = modules();
  CHECK(few > 0);
  load_defined_later(session.lua());
  CHECK(modules() > 5 * few);
}

TEST_CASE("every function of the module has a row") {
  OpenSession session{SessionOptions{}};
  load_library(session);
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
  load_library(session);
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
    load_library(session);
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
