// A plain Lua table as bytes: numbers, strings, booleans and tables of these, including shared tables and
// cycles.
#pragma once
#include <lua.hpp>
#include <string>

namespace fabricsh::script {

// Error, with the path of the entry ("keep.hits[3]"): a function, userdata, coroutine, or a table with a
// metatable.
std::string pack_table(lua_State* L, int index, const std::string& name);

// Restores the table, and the tables in it, in place, so that other references to them see the change. Error:
// damaged bytes.
void fill_table(lua_State* L, int index, const std::string& bytes);

}  // namespace fabricsh::script
