
#include "script/call/push.hpp"
#include "script/show/peek.hpp"
#include "script/show/transcript.hpp"

namespace fabricsh::script {

namespace {

// Pushes fabric.units, Lua's own globals, or fabric.
void push_home(lua_State* L, int which) {
  if (which == 1) {
    lua_getfield(L, LUA_REGISTRYINDEX, own_globals_key);
    return;
  }
  lua_getfield(L, LUA_REGISTRYINDEX, "fabric");
  if (which == 2) return;
  peek_field(L, -1, "units");
  lua_remove(L, -2);
}

constexpr int homes = 3;
constexpr const char* library = "fabric";

// Whether the whole library is still where the prompt has put it.
bool library_is_there(lua_State* L) {
  lua_pushglobaltable(L);
  push_raw(L, -1, library);
  lua_getfield(L, LUA_REGISTRYINDEX, library);
  const bool same = lua_rawequal(L, -1, -2) != 0;
  lua_pop(L, 3);
  return same;
}

// Whether the table at `home` has a value with this name, and whether it equals the global one.
bool holds(lua_State* L, int home, const std::string& name, bool same) {
  if (!lua_istable(L, home)) return false;
  push_raw(L, home, name);
  lua_pushglobaltable(L);
  push_raw(L, -1, name);
  const bool found = !lua_isnil(L, -3) && (!same || lua_rawequal(L, -1, -3) != 0);
  lua_pop(L, 3);
  return found;
}

}  // namespace

std::set<std::string> names_as_made(lua_State* L) {
  luaL_checkstack(L, 10, "names");
  std::set<std::string> names;
  for (int which = 0; which < homes; ++which) {
    push_home(L, which);
    const int home = lua_gettop(L);
    if (lua_istable(L, home))
      for (const std::string& name : names_in(L, home, false).names)
        if (holds(L, home, name, true)) names.insert(name);
    lua_settop(L, home - 1);
  }
  if (library_is_there(L)) names.insert(library);
  return names;
}

std::string covered_words(lua_State* L, const std::string& name) {
  luaL_checkstack(L, 10, "names");
  if (name == library) return "warning: fabric is no longer the library; require 'fabric' still is";
  const std::string sorts[homes] = {"the unit; fabric.units." + name + " still is", "Lua's own",
                                    "what fabric has under that name; fabric." + name + " still is"};
  for (int which = 0; which < homes; ++which) {
    push_home(L, which);
    const bool here = holds(L, lua_gettop(L), name, false);
    lua_pop(L, 1);
    if (here) return "warning: " + name + " is no longer " + sorts[which];
  }
  return {};
}

bool is_of_fabric(lua_State* L, const std::string& name) {
  push_home(L, 2);
  const bool same = holds(L, lua_gettop(L), name, true);
  lua_pop(L, 1);
  return same;
}

}  // namespace fabricsh::script
