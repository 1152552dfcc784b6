#include "script/session/called_off.hpp"

namespace fabricsh::script {

namespace {

constexpr const char* key = "fabricsh.called_off";  // registry

void set(Session& session, bool value) {
  lua_pushboolean(session.active(), value ? 1 : 0);
  lua_setfield(session.active(), LUA_REGISTRYINDEX, key);
}

}  // namespace

void call_off(Session& session) {
  session.set_stopped_by_interrupt();
  set(session, true);
}

void begin_input(Session& session) { set(session, false); }

bool is_called_off(Session& session) {
  lua_State* L = session.active();
  lua_getfield(L, LUA_REGISTRYINDEX, key);
  const bool off = lua_toboolean(L, -1) != 0;
  lua_pop(L, 1);
  return off;
}

}  // namespace fabricsh::script
