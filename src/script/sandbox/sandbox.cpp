#include "script/sandbox/sandbox.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <random>

#include "base/error.hpp"
#include "format/source.hpp"
#include "script/call/boundary.hpp"
#include "script/sandbox/lua.hpp"
#include "system/gate.hpp"
#include "system/paths.hpp"

namespace fabricsh::script {

namespace {

using system::Gate;

// Pushes nil and the reason, as Lua's own functions do.
int refusal(lua_State* L, const Error& error) {
  luaL_pushfail(L);
  lua_pushstring(L, error.what());
  lua_pushinteger(L, EACCES);
  return 3;
}

std::string path_at(lua_State* L, int index) {
  std::size_t length = 0;
  const char* text = luaL_checklstring(L, index, &length);
  return {text, length};
}

int flags_of(const std::string& mode) {
  const bool both = mode.find('+') != std::string::npos;
  const int access = both ? O_RDWR : O_WRONLY;
  if (mode[0] == 'w') return access | O_CREAT | O_TRUNC;
  return mode[0] == 'a' ? access | O_CREAT | O_APPEND : access;
}

bool good_mode(const std::string& mode) {
  std::size_t at = 1;
  if (mode.empty() || std::strchr("rwa", mode[0]) == nullptr) return false;
  if (at < mode.size() && mode[at] == '+') ++at;
  if (at < mode.size() && mode[at] == 'b') ++at;
  return at == mode.size();
}

int close_stream(lua_State* L) {
  auto* stream = static_cast<luaL_Stream*>(luaL_checkudata(L, 1, LUA_FILEHANDLE));
  return luaL_fileresult(L, std::fclose(stream->f) == 0, nullptr);
}

// io.open(path, mode); the stream is an ordinary one of the io library.
int open_stream(lua_State* L) {
  const std::string path = path_at(L, 1), mode = luaL_optstring(L, 2, "r");
  luaL_argcheck(L, good_mode(mode), 2, "invalid mode");
  auto* stream = static_cast<luaL_Stream*>(lua_newuserdatauv(L, sizeof(luaL_Stream), 0));
  stream->closef = nullptr;
  luaL_setmetatable(L, LUA_FILEHANDLE);
  try {
    const Gate& gate = Gate::of_process();
    const bool reads = mode == "r" || mode == "rb";
    const system::Descriptor file = reads ? gate.open(path) : gate.open_to_write(path, flags_of(mode));
    const int number = fcntl(file.number(), F_DUPFD_CLOEXEC, 0);
    stream->f = number < 0 ? nullptr : fdopen(number, mode.c_str());
    if (stream->f == nullptr) return luaL_fileresult(L, 0, path.c_str());
  } catch (const Error& error) {
    return refusal(L, error);
  }
  stream->closef = close_stream;
  return 1;
}

// os.remove(path), os.rename(from, to).
template <bool renames>
int move_file(lua_State* L) {
  try {
    renames ? Gate::of_process().rename(path_at(L, 1), path_at(L, 2))
            : Gate::of_process().remove(path_at(L, 1));
  } catch (const Error& error) {
    return refusal(L, error);
  }
  lua_pushboolean(L, 1);
  return 1;
}

// Creates an empty file with a new name in the output folder.
int temporary_name(lua_State* L) {
  std::random_device random;
  try {
    for (int attempt = 0; attempt < 100; ++attempt) {
      const std::string path = Gate::of_process().writable() + "/lua_" + std::to_string(random());
      if (Gate::of_process().exists(path)) continue;
      const system::Descriptor file = Gate::of_process().open_to_write(path, O_WRONLY | O_CREAT | O_EXCL);
      lua_pushstring(L, path.c_str());
      return 1;
    }
  } catch (const Error& error) {
    lua_pushstring(L, error.what());
    return lua_error(L);
  }
  return luaL_error(L, "unable to generate a unique filename");
}

int file_exists(lua_State* L) {
  lua_pushboolean(L, Gate::of_process().exists(path_at(L, 1)));
  return 1;
}

// loadfile(path [, environment]).
int load_through_gate(lua_State* L) {
  const std::string path = path_at(L, 1);
  const bool has_environment = !lua_isnone(L, 2);
  if (load_file(L, path) != LUA_OK) {
    luaL_pushfail(L);
    lua_insert(L, -2);
    return 2;
  }
  if (has_environment) {
    lua_pushvalue(L, 2);
    if (lua_setupvalue(L, -2, 1) == nullptr) lua_pop(L, 1);
  }
  return 1;
}

int library_file(lua_State* L) {
  const std::string path = path_at(L, 1);
  bool own = false;
  for (const std::string& root : data_roots()) own = own || path.starts_with(root + "/lua/");
  lua_pushboolean(L, own && path.find("..") == std::string::npos);
  return 1;
}

// Only tables return theirs; those of strings, files and objects must not be changed.
int visible_metatable(lua_State* L) {
  luaL_checkany(L, 1);
  if (lua_type(L, 1) != LUA_TTABLE) {
    lua_pushboolean(L, 0);
    return 1;
  }
  if (lua_getmetatable(L, 1) == 0) lua_pushnil(L);
  if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL) return 1;
  return 1;
}

// Refuses finalisers, because no counting hook is active while they run.
int set_metatable(lua_State* L) {
  const int type = lua_type(L, 2);
  luaL_checktype(L, 1, LUA_TTABLE);
  luaL_argexpected(L, type == LUA_TNIL || type == LUA_TTABLE, 2, "nil or table");
  if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL)
    return luaL_error(L, "cannot change a protected metatable");
  if (type == LUA_TTABLE) {
    lua_pushliteral(L, "__gc");
    if (lua_rawget(L, 2) != LUA_TNIL)
      return luaL_error(L, "setmetatable: finalisers (__gc) are not available under --safe");
  }
  lua_settop(L, 2);
  lua_setmetatable(L, 1);
  return 1;
}

// coroutine.create and coroutine.wrap (the upvalue), with instructions subtracted in advance.
int make_coroutine(lua_State* L) {
  Session::of(L).limits()->charge_coroutine(L);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, 1);
  return 1;
}

int paid(lua_State* L) {
  lua_settop(L, 1);
  lua_pushcclosure(L, make_coroutine, 1);
  return 1;
}

constexpr luaL_Reg natives[] = {{"open", open_stream},
                                {"remove", move_file<false>},
                                {"rename", move_file<true>},
                                {"tmpname", temporary_name},
                                {"exists", file_exists},
                                {"loadfile", load_through_gate},
                                {"library_file", library_file},
                                {"getmetatable", visible_metatable},
                                {"setmetatable", set_metatable},
                                {"paid", paid},
                                {nullptr, nullptr}};

// Skips a byte-order mark and a first line that begins with '#', whose end is kept for the line numbers.
std::string_view text_of(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (bytes.starts_with('#')) bytes.remove_prefix(std::min(bytes.find('\n'), bytes.size()));
  return bytes;
}

}  // namespace

void confine(Session& session) {
  lua_State* L = session.lua();
  if (luaL_loadbufferx(L, sandbox_lua, std::strlen(sandbox_lua), "=safe", "t") != LUA_OK)
    throw Error(lua_tostring(L, -1));
  luaL_newlib(L, natives);
  lua_pushstring(L, "");
  lua_getmetatable(L, -1);
  lua_remove(L, -2);
  if (lua_pcall(L, 2, 0, 0) != LUA_OK) throw Error(lua_tostring(L, -1));
  lua_settop(L, 0);
  load_defined_later(L);  // before limits begin, and with what a deck has not changed
}

int load_file(lua_State* L, const std::string& path) {
  if (path.empty()) return luaL_loadfilex(L, nullptr, "t");
  std::string bytes;
  try {
    bytes = format::read_file(path);
  } catch (const Error& error) {
    lua_pushstring(L, error.what());
    return LUA_ERRFILE;
  }
  const std::string_view text = text_of(bytes);
  return luaL_loadbufferx(L, text.data(), text.size(), ("@" + path).c_str(), "t");
}

}  // namespace fabricsh::script
