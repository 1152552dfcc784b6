// The chain of calls at an error: the lines below the first line of a message.
#pragma once
#include <lua.hpp>
#include <string>
#include <vector>

namespace fabricsh::script {

// An active call: "deck.lua:12: " and the function to which this line belongs, empty for the main part of a
// file.
struct Caller {
  std::string place, function;
};

// Whether the source of a function ("@file") is a file of lua/fabric.
bool own_module(const char* source);

// The user's active calls in L, innermost first, without those in lua/fabric and those typed at the prompt or
// given by -e. In a deep recursion the first and last ones, with an entry without position between them.
std::vector<Caller> callers(lua_State* L);

// The lines for below the message, without its own position. Empty, or begins with a newline.
std::string chain_text(const std::string& message, const std::vector<Caller>& callers);

// --- Variables of a deck that have no value where they are read.

// From now on the session warns where the code of a file reads a global variable that has no value: to Lua it
// is nil, and a field or the end of a list that is nil is none. Where the code tests it (`if N`, `N or 20`)
// it does not warn.
void watch_globals(lua_State* L);

}  // namespace fabricsh::script
