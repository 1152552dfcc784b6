// A plain Lua table as bytes: numbers, texts, booleans and tables of them, also where tables are shared or
// go round in a circle.
#pragma once
#include <lua.hpp>
#include <string>

namespace fabricsh::script {

// Error, with the path of the entry ("keep.hits[3]"): a function, userdata, coroutine, a table with a
// metatable.
std::string pack_table(lua_State* L, int index, const std::string& name);

// Makes the table what it was, and the tables in it, in their places: who holds one of them sees it. Error:
// the bytes are damaged.
void fill_table(lua_State* L, int index, const std::string& bytes);

}  // namespace fabricsh::script
