// Globals of the library's and of Lua's that are assigned over.
#pragma once
#include <lua.hpp>
#include <set>
#include <string>
#include <vector>

namespace fabricsh::script {

// Names that stand for what Lua, fabric or fabric.units put there: "print", "model", "mm".
std::set<std::string> names_as_made(lua_State* L);

// Says of a name that has just been assigned over what it was, and where that still is.
std::string covered_words(lua_State* L, const std::string& name);

// Is the global `name` fabric.<name> itself?
bool is_of_fabric(lua_State* L, const std::string& name);

}  // namespace fabricsh::script
