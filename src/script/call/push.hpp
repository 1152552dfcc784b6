// Plain values as Lua tables.
#pragma once
#include <lua.hpp>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::script {

class Session;

// Arrays as Lua tables; ids count from 0 in C++ and from 1 in Lua.
void push_numbers(lua_State* L, const std::vector<double>& values);
void push_texts(lua_State* L, const std::vector<std::string>& texts);
void push_ids(lua_State* L, const std::vector<mesh::Index>& ids);
// A list of what `push` leaves on the stack for each.
template <class All, class Push>
void push_list(lua_State* L, const All& all, Push push) {
  lua_newtable(L);
  lua_Integer place = 0;
  for (const auto& one : all) {
    push(one);
    lua_rawseti(L, -2, ++place);
  }
}
void set_numbers(lua_State* L, const char* name, const std::vector<double>& values);
void set_number(lua_State* L, const char* name, double value);
void set_integer(lua_State* L, const char* name, lua_Integer value);
void set_flag(lua_State* L, const char* name, bool value);
void set_text(lua_State* L, const char* name, const std::string& value);
int push_text(lua_State* L, const std::string& text);  // as the one result of a function: returns 1
// Gives the result table on top of the stack a protected metatable with a __tostring, one per name. The deck
// may change the table, so the function must not rely on its entries.
void set_text_of(lua_State* L, const char* name, lua_CFunction text);
int report_text(lua_State* L);  // the field `text` of a report, for set_text_of()
// The entry `name` of the table at index if it is a string, else empty; calls no metamethods.
std::string raw_text(lua_State* L, int index, const char* name);
// Sets a metamethod of a class; f is called without protection and must not throw.
void set_meta(Session& session, const std::string& cls, const char* name, lua_CFunction f);

}  // namespace fabricsh::script
