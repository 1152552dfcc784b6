// Plain values as Lua tables.
#pragma once
#include <lua.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::script {

class Session;

// Arrays as Lua tables; ids count from 0 in C++ and from 1 in Lua. Each push returns 1, as a function of
// Lua with this one result.
int push_numbers(lua_State* L, const std::vector<double>& values);
int push_text(lua_State* L, const std::string& text);
int push_texts(lua_State* L, const std::vector<std::string>& texts);
int push_ids(lua_State* L, const std::vector<mesh::Index>& ids);
// A list of what `push` leaves on the stack for each.
template <class All, class Push>
int push_list(lua_State* L, const All& all, Push push) {
  lua_newtable(L);
  lua_Integer place = 0;
  for (const auto& one : all) {
    push(one);
    lua_rawseti(L, -2, ++place);
  }
  return 1;
}
// A value of C++ as one of Lua: what counts is an integer, a double a number; a function without arguments
// leaves what it pushes.
template <class Value>
int push_value(lua_State* L, const Value& value) {
  if constexpr (std::is_same_v<Value, bool>)
    lua_pushboolean(L, value ? 1 : 0);
  else if constexpr (std::is_integral_v<Value>)
    lua_pushinteger(L, static_cast<lua_Integer>(value));
  else if constexpr (std::is_floating_point_v<Value>)
    lua_pushnumber(L, value);
  else if constexpr (std::is_same_v<Value, std::vector<double>>)
    push_numbers(L, value);
  else if constexpr (std::is_same_v<Value, std::vector<std::string>>)
    push_texts(L, value);
  else if constexpr (std::is_same_v<Value, std::vector<mesh::Index>>)
    push_ids(L, value);
  else if constexpr (std::is_function_v<Value>)
    lua_pushcfunction(L, value);
  else if constexpr (std::is_invocable_v<Value>)
    value();
  else
    push_text(L, value);
  return 1;
}
// Fields of the table on top of the stack: put(L, "time", 0.5, "warp", "loading").
template <class Value, class... More>
void put(lua_State* L, const char* name, const Value& value, const More&... more) {
  push_value(L, value);
  lua_setfield(L, -2, name);
  if constexpr (sizeof...(More) > 0) put(L, more...);
}
// A new table with these fields.
template <class... All>
int push_record(lua_State* L, const All&... all) {
  lua_createtable(L, 0, sizeof...(All) / 2);
  put(L, all...);
  return 1;
}
// Gives the result table on top of the stack a protected metatable with a __tostring, one per name. The deck
// may change the table, so the function must not rely on its entries.
void set_text_of(lua_State* L, const char* name, lua_CFunction text);
int report_text(lua_State* L);  // the field `text` of a report, for set_text_of()
// Pushes the entry `name` of the table at index without calling metamethods, and returns its type.
int push_raw(lua_State* L, int index, const std::string& name);
// Pushes a table with the entries of the one at index, without its metatable.
void copy_entries(lua_State* L, int index);
// The entry `name` of the table at index if it is a string, else empty; calls no metamethods.
std::string raw_text(lua_State* L, int index, const char* name);
// Sets a metamethod of a class; f is called without protection and must not throw.
void set_meta(Session& session, const std::string& cls, const char* name, lua_CFunction f);

}  // namespace fabricsh::script
