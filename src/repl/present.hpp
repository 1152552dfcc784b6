// Printing values at the prompt.
#pragma once
#include <lua.hpp>

namespace fabricsh::repl {

// A Lua function: all its arguments as one text, separated by tabs. Of tables the first entries are shown.
int present_all(lua_State* L);

}  // namespace fabricsh::repl
