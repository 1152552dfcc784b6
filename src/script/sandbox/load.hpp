// Lua files, read through the gate of the process.
#pragma once
#include <lua.hpp>
#include <string>

namespace fabricsh::script {

// Pushes the chunk of a Lua text file, or the message why there is none; LUA_OK or luaL_loadfilex's status.
// No binary chunks. An empty path: standard input.
int load_file(lua_State* L, const std::string& path);

}  // namespace fabricsh::script
