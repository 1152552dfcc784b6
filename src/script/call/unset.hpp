// Variables of a deck that have no value where they are read.
#pragma once
#include <lua.hpp>

namespace fabricsh::script {

// From now on the session warns where the code of a file reads a global variable that has no value: to Lua it
// is nil, and a field or the end of a list that is nil is none. Where the code tests it (`if N`, `N or 20`)
// it does not warn.
void watch_globals(lua_State* L);

}  // namespace fabricsh::script
