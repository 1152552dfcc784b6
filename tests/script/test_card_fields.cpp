// A card in Lua: whatever rows the tables of its fields have, each can be written, read back and printed.
#include <functional>

#include "card/full_card.hpp"
#include "catch.hpp"
#include "script/bind/rooms.hpp"
#include "script/open/open_session.hpp"
#include "script/values/card_rows.hpp"

using namespace fabricsh;
using namespace fabricsh::script;

namespace {

// Runs a chunk that returns one value, which stays on the stack.
void run_chunk(lua_State* L, const std::string& chunk) {
  const bool good = luaL_loadstring(L, chunk.c_str()) == LUA_OK && lua_pcall(L, 0, 1, 0) == LUA_OK;
  INFO(chunk << "\n" << luaL_tolstring(L, -1, nullptr));
  lua_pop(L, 1);
  REQUIRE(good);
}

void each_path(const card::FieldTable& table, const std::string& path,
               const std::function<void(const std::string&, const card::Field&)>& visit) {
  for (const card::Field& field : table) {
    visit(path + "." + field.name, field);
    each_path(field.rows, path + "." + field.name, visit);
  }
}

}  // namespace

TEST_CASE("every field of a card is written, read and read back", "[card]") {
  for (const std::string kind : {"woven", "svk", "linear"}) {
    const card::Card full = test::full_card(kind);
    OpenSession session{SessionOptions{}};
    lua_State* L = session.lua();
    run_chunk(L, card::lua_text(full));
    lua_setglobal(L, "card");
    lua_getglobal(L, "card");
    const auto again = to_object<card::Card>(L, -1);
    REQUIRE(again != nullptr);
    CHECK(card::lua_text(*again) == card::lua_text(full));
    each_path(card::fields(kind), "card", [&](const std::string& path, const card::Field& field) {
      INFO(path);
      if (!field.get && field.holds != card::FieldType::group) return;
      run_chunk(L, "return " + path + " ~= nil");
      CHECK(lua_toboolean(L, -1) == 1);
      lua_pop(L, 1);
      if (field.holds != card::FieldType::number) return;
      run_chunk(L, "return " + path);
      CHECK(lua_tonumber(L, -1) == std::get<double>(field.get(full)));
      lua_pop(L, 1);
    });
    run_chunk(L, "return card:with{ name='words \"1\"\\n' } == card and #tostring(card) > 100");
    CHECK(lua_toboolean(L, -1) == 1);
  }
}
