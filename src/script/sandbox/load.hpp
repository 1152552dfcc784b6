// Loads Lua files through the gate of the process.
#pragma once
#include <lua.hpp>
#include <string>

namespace fabricsh::script {

// Pushes the chunk of a Lua text file, or an error message; returns LUA_OK or the status of luaL_loadfilex.
// Binary chunks are refused. An empty path means standard input.
int load_file(lua_State* L, const std::string& path);

}  // namespace fabricsh::script
