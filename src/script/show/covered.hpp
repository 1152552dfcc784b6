// Globals of the library and of Lua that the user has overwritten.
#pragma once
#include <lua.hpp>
#include <set>
#include <string>

namespace fabricsh::script {

// Names whose values are still those of Lua, fabric or fabric.units: "print", "model", "mm".
std::set<std::string> names_as_made(lua_State* L);

// For a name that has just been overwritten: what it was, and where that is still available.
std::string covered_words(lua_State* L, const std::string& name);

// Whether the global `name` is fabric.<name> itself.
bool is_of_fabric(lua_State* L, const std::string& name);

}  // namespace fabricsh::script
