// Who called whom when an error was raised: the lines that stand below an error's first.
#pragma once
#include <lua.hpp>
#include <string>
#include <vector>

namespace fabricsh::script {

// A call that was under way: "deck.lua:12: " and the function that this line stands in, empty for a file's
// own lines.
struct Caller {
  std::string place, function;
};

// Is the source of a function ("@file") one of lua/fabric?
bool own_module(const char* source);

// The calls of L that the user wrote, innermost first: nothing of lua/fabric, no line typed at the prompt or
// given by -e. Of a deep recursion the first and last ones, with an entry without a place between them.
std::vector<Caller> callers(lua_State* L);

// The lines for below the message: its own place is not said again. Empty, or begins with a line's end.
std::string chain_text(const std::string& message, const std::vector<Caller>& callers);

}  // namespace fabricsh::script
