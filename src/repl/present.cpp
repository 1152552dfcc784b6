#include "repl/present.hpp"

#include <cctype>
#include <string>

namespace fabricsh::repl {

namespace {

constexpr int most_entries = 12;
constexpr int most_depth = 2;

std::string present(lua_State* L, int index, int depth);

bool is_name(const std::string& word) {
  if (word.empty() || std::isdigit(static_cast<unsigned char>(word[0]))) return false;
  for (const char c : word)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_') return false;
  return true;
}

std::string key_text(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TSTRING && is_name(lua_tostring(L, index))) return lua_tostring(L, index);
  return "[" + present(L, index, most_depth) + "]";
}

std::string table_text(lua_State* L, int index, int depth) {
  if (depth >= most_depth) return "{...}";
  index = lua_absindex(L, index);
  luaL_checkstack(L, 6, "table");
  const auto listed = static_cast<lua_Integer>(lua_rawlen(L, index));
  std::string out;
  int shown = 0;
  lua_pushnil(L);
  while (lua_next(L, index) != 0) {
    if (++shown > most_entries) {
      lua_pop(L, 2);
      return "{" + out + ", ...}";
    }
    const bool in_list = lua_isinteger(L, -2) && lua_tointeger(L, -2) >= 1 && lua_tointeger(L, -2) <= listed;
    out += (out.empty() ? "" : ", ") + (in_list ? std::string() : key_text(L, -2) + " = ") +
           present(L, -1, depth + 1);
    lua_pop(L, 1);
  }
  return "{" + out + "}";
}

bool has_text(lua_State* L, int index) {
  if (luaL_getmetafield(L, index, "__tostring") == LUA_TNIL) return false;
  lua_pop(L, 1);
  return true;
}

std::string present(lua_State* L, int index, int depth) {
  if (lua_istable(L, index) && !has_text(L, index)) return table_text(L, index, depth);
  if (lua_type(L, index) == LUA_TSTRING && depth > 0)
    return "\"" + std::string(lua_tostring(L, index)) + "\"";
  std::string words = luaL_tolstring(L, index, nullptr);
  lua_pop(L, 1);
  return words;
}

}  // namespace

int present_all(lua_State* L) {
  const int count = lua_gettop(L);
  std::string out;
  for (int i = 1; i <= count; ++i) out += (i > 1 ? "\t" : "") + present(L, i, 0);
  lua_pushlstring(L, out.data(), out.size());
  return 1;
}

}  // namespace fabricsh::repl
