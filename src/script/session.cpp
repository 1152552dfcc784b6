#include "script/session.hpp"

#include <unistd.h>

#include <cstdlib>

#include "base/error.hpp"
#include "script/bind/rooms.hpp"
#include "script/bind/run.hpp"
#include "script/call/call.hpp"
#include "script/call/words.hpp"
#include "script/checkpoint.hpp"
#include "script/sandbox/sandbox.hpp"
#include "script/show/said_once.hpp"
#include "script/warning_log.hpp"
#include "system/paths.hpp"

namespace fabricsh::script {

Session::Session(Options options)
    : process_(getpid()),
      options_(std::move(options)),
      notices_(said_once_by_copies(options_.notice)),
      log_(std::make_unique<WarningLog>()) {
  main_ = luaL_newstate();
  if (main_ == nullptr) throw std::bad_alloc();
  active_ = main_;
  journal_ = std::make_shared<run::Journal>(journal_of(options_));
  *static_cast<Session**>(lua_getextraspace(main_)) = this;
  open_libraries();
  if (!options_.safe) return;
  confine(*this);
  limits_ = std::make_unique<Limits>(*options_.safe);
  limits_->watch(main_);
}

void Session::warn(const char* code, const std::string& text) {
  log_->add({code, text});
  notices_.once(text, "warning: " + text);
}

bool Session::forked() const { return getpid() != process_; }

void Session::rest_hook(lua_State* L) {
  if (limits_)
    limits_->rest_hook(L);
  else
    lua_sethook(L, nullptr, 0, 0);
}

Session::~Session() { lua_close(main_); }

Session& Session::of(lua_State* L) { return **static_cast<Session**>(lua_getextraspace(L)); }

namespace {

// Puts lua/?.lua of all data roots before the entries of LUA_PATH.
void set_module_path(lua_State* L) {
  std::string path;
  for (const std::string& root : data_roots()) path += root + "/lua/?.lua;" + root + "/lua/?/init.lua;";
  lua_getglobal(L, "package");
  lua_getfield(L, -1, "path");
  path += lua_tostring(L, -1);
  lua_pop(L, 1);
  lua_pushstring(L, path.c_str());
  lua_setfield(L, -2, "path");
  lua_pop(L, 1);
}

constexpr const char* library_file = "lua/fabric/library.lua";

// The message of a program that was copied without its files.
std::string no_data_text() {
  const char* home = std::getenv("FABRICSH_HOME");
  const bool set = home != nullptr && *home != '\0';
  return std::string("the program's own files are missing: ") + library_file + " is neither " +
         (set ? "in FABRICSH_HOME ('" + std::string(home) + "') nor " : "") +
         "in share/fabricsh beside the program nor in the source tree of its build; set FABRICSH_HOME to the "
         "folder "
         "that holds lua/ and share/cards/ (PREFIX/share/fabricsh of an installation, or the source tree)";
}

// require "fabric": the bindings, and the additions of lua/fabric/library.lua (which may itself require
// "fabric").
int open_fabric(lua_State* L) {
  if (data_file(library_file).empty()) {
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

}  // namespace

void Session::open_libraries() {
  lua_State* L = main_;
  luaL_openlibs(L);
  set_module_path(L);
  lua_newtable(L);
  lua_setfield(L, LUA_REGISTRYINDEX, "fabric");
  bind_all(*this);
  lua_getglobal(L, "package");
  lua_getfield(L, -1, "preload");
  lua_pushcfunction(L, open_fabric);
  lua_setfield(L, -2, "fabric");
  lua_pushcfunction(L, open_define);
  lua_setfield(L, -2, "fabric.define");
  lua_settop(L, 0);
}

namespace {

// Keeps a reference to the value on top of the stack and pops it. All holders are objects of the same state,
// so the reference does not outlive it.
std::shared_ptr<const int> reference_to_top(Session& session, lua_State* L) {
  const int reference = luaL_ref(L, LUA_REGISTRYINDEX);
  return {new int(reference), [owner = &session](const int* r) {
            luaL_unref(owner->active(), LUA_REGISTRYINDEX, *r);
            delete r;
          }};
}

struct Work {
  const std::function<void()>& run;
  std::exception_ptr trouble = nullptr;
};

int run_work(lua_State* L) {
  auto& work = *static_cast<Work*>(lua_touserdata(L, 1));
  try {
    work.run();
  } catch (const std::exception&) {  // not Lua's own exception, which is not a std::exception
    work.trouble = std::current_exception();
  }
  return 0;
}

}  // namespace

Raised::Raised(Session& session, lua_State* L) : reference_(reference_to_top(session, L)) {}

void Raised::push(lua_State* L) const { lua_rawgeti(L, LUA_REGISTRYINDEX, *reference_); }

void in_protected_call(Session& session, const std::function<void()>& run) {
  lua_State* L = session.active();
  luaL_checkstack(L, 8, "too many nested callbacks");
  Work work{run};
  lua_pushcfunction(L, run_work);
  lua_pushlightuserdata(L, &work);
  if (lua_pcall(L, 1, 0, 0) != LUA_OK) throw Raised(session, L);
  if (work.trouble) std::rethrow_exception(work.trouble);
}

Function::Function(Session& session, lua_State* L, int index) : session_(&session) {
  lua_pushvalue(L, index);
  handle_ = reference_to_top(session, L);
}

lua_State* Function::push() const {
  lua_State* L = session_->active();
  luaL_checkstack(L, 8, "too many nested callbacks");
  lua_rawgeti(L, LUA_REGISTRYINDEX, *handle_);
  return L;
}

}  // namespace fabricsh::script
