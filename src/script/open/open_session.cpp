#include "script/open/open_session.hpp"

#include <cstdlib>

#include "script/bind/rooms.hpp"
#include "script/call/chain.hpp"
#include "script/call/push.hpp"
#include "script/runs/drive.hpp"
#include "script/sandbox/sandbox.hpp"
#include "system/paths.hpp"

namespace fabricsh::script {

namespace {

// Puts lua/?.lua of all data roots before the entries of LUA_PATH.
void set_module_path(lua_State* L) {
  std::string path;
  for (const std::string& root : data_roots()) path += root + "/lua/?.lua;" + root + "/lua/?/init.lua;";
  lua_getglobal(L, "package");
  lua_getfield(L, -1, "path");
  path += lua_tostring(L, -1);
  lua_pop(L, 1);
  put(L, "path", path);
  lua_pop(L, 1);
}

constexpr const char* kLibraryFile = "lua/fabric/library.lua";

// The message of a program that was copied without its files.
std::string no_data_text() {
  const char* home = std::getenv("FABRICSH_HOME");
  const bool set = home != nullptr && *home != '\0';
  return std::string("the program's own files are missing: ") + kLibraryFile + " is neither " +
         (set ? "in FABRICSH_HOME ('" + std::string(home) + "') nor " : "") +
         "in share/fabricsh beside the program nor in the source tree of its build; set FABRICSH_HOME to the "
         "folder "
         "that holds lua/ and share/cards/ (PREFIX/share/fabricsh of an installation, or the source tree)";
}

// require "fabric": the bindings, and the additions of lua/fabric/library.lua (which may itself require
// "fabric").
int open_fabric(lua_State* L) {
  if (data_file(kLibraryFile).empty()) {
    lua_pushstring(L, no_data_text().c_str());
    return lua_error(L);
  }
  luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  lua_getfield(L, LUA_REGISTRYINDEX, "fabric");
  lua_setfield(L, -2, "fabric");
  lua_getglobal(L, "require");
  lua_pushliteral(L, "fabric.library");
  lua_call(L, 1, 0);
  lua_getfield(L, LUA_REGISTRYINDEX, "fabric");
  return 1;
}

void open_libraries(Session& session) {
  lua_State* L = session.lua();
  luaL_openlibs(L);
  set_module_path(L);
  lua_newtable(L);
  lua_setfield(L, LUA_REGISTRYINDEX, "fabric");
  bind_all(session);
  lua_getglobal(L, "package");
  lua_getfield(L, -1, "preload");
  lua_pushcfunction(L, open_fabric);
  lua_setfield(L, -2, "fabric");
  lua_pushcfunction(L, open_define);
  lua_setfield(L, -2, "fabric.define");
  watch_globals(L);
  lua_settop(L, 0);
}

}  // namespace

OpenSession::OpenSession(SessionOptions given) : Session(std::move(given)) {
  set_journal(std::make_shared<run::Journal>(journal_of(options())));
  set_execute(script::execute);
  open_libraries(*this);
  if (!options().safe) return;
  confine(*this);
  begin_limits();
}
}  // namespace fabricsh::script
