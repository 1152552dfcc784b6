// Values as a person wants to see them at the prompt.
#pragma once
#include <lua.hpp>

namespace fabricsh::repl {

// A Lua function: all its arguments as one text, separated by tabs. Tables show their first entries.
int present_all(lua_State* L);

}  // namespace fabricsh::repl
