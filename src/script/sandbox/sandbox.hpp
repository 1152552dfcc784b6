// --safe: the Lua of untrusted decks. share/doc/safe.md states what is guaranteed.
#pragma once
#include <lua.hpp>
#include <string>

#include "script/session/session.hpp"

namespace fabricsh::script {

// Removes what would let a deck out: programs, C modules, binary chunks, the debug library, finalisers. Leads
// every function that opens a file through the gate of the process, and loads the library into an environment
// of its own, so that no deck can change the functions that it calls.
void confine(Session& session);

// --- Loads Lua files through the gate of the process.

// Pushes the chunk of a Lua text file, or an error message; returns LUA_OK or the status of luaL_loadfilex.
// Binary chunks are refused. An empty path means standard input.
int load_file(lua_State* L, const std::string& path);

}  // namespace fabricsh::script
