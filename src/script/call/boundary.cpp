// The boundary of C++ and Lua: every binding is called through enter(), which converts C++ exceptions to Lua
// errors. Lua's own errors are C++ exceptions of a type private to Lua; they pass through and run the
// destructors on their way.
#include "script/call/boundary.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "base/error.hpp"
#include "script/call/call.hpp"
#include "script/call/chain.hpp"
#include "script/call/push.hpp"
#include "script/call/words.hpp"
#include "system/atomic.hpp"
#include "system/memory.hpp"
#include "system/paths.hpp"

namespace fabricsh::script {

bool own_module(const char* source) {
  if (source[0] != '@') return false;
  for (const std::string& root : data_roots()) {
    const std::string modules = root + "/lua/fabric";
    if (std::strncmp(source + 1, modules.c_str(), modules.size()) == 0) return true;
  }
  return false;
}

std::string position(lua_State* L) {
  lua_Debug frame;
  std::string own;
  for (int level = 0; lua_getstack(L, level, &frame) != 0; ++level) {
    lua_getinfo(L, "Sl", &frame);
    if (frame.currentline <= 0) continue;
    const char* file = frame.source[0] == '@' ? frame.source + 1 : frame.short_src;
    const std::string here = std::string(file) + ":" + std::to_string(frame.currentline) + ": ";
    if (!own_module(frame.source)) return here;
    if (own.empty()) own = here;
  }
  return own;
}

namespace {

constexpr const char* later_key =
    "fabricsh.later";  // registry: {name = module} of define_later(), and `require`
constexpr const char* module_field = "__module";  // of metatables: the module's name

int failure_text(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  return push_text(L, raw_text(L, 1, "where") + raw_text(L, 1, "message"));
}

void push_failure(lua_State* L, const std::string& call, const NumericalFailure& failure) {
  push_record(L, "kind", "numerical", "message", call + ": " + failure.what(), "time", failure.time);
  if (failure.element >= 0) put(L, "element", failure.element + 1);
  if (!failure.yarn.empty()) put(L, "yarn", failure.yarn);
  if (!failure.why.empty()) {
    lua_pushstring(L, failure.why.c_str());
    lua_pushvalue(L, -1);
    lua_setfield(L, LUA_REGISTRYINDEX, why_key);
    lua_setfield(L, -2, "why");
  }
  put(L, "where", position(L));
  if (luaL_newmetatable(L, "fabricsh.failure") != 0) {
    put(L, "__tostring", failure_text, "__name", "numerical failure", "__metatable", false);
  }
  lua_setmetatable(L, -2);
}

void push_error(lua_State* L, const std::string& call, const std::string& message) {
  const bool named = message.compare(0, call.size() + 2, call + ": ") == 0;
  lua_pushstring(L, (position(L) + (named ? "" : call + ": ") + message).c_str());
}

// The system's reason for a file error.
std::string system_words(const std::filesystem::filesystem_error& trouble) {
  const std::string path = trouble.path1().string();
  return (path.empty() ? "the current folder" : "'" + path + "'") + ": " + trouble.code().message();
}

// Counts what the machine refused, a file or memory, which another run of the same deck may get.
void count_refusal(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, refusals_key);
  const lua_Integer before = lua_tointeger(L, -1);
  lua_pop(L, 1);
  lua_pushinteger(L, before + 1);
  lua_setfield(L, LUA_REGISTRYINDEX, refusals_key);
}

// After Ctrl-C a drawing program is ended too; its message is then not the reason for the failure.
bool interrupted_by_now(lua_State* L) {
  Session& session = Session::of(L);
  if (session.drives() || !session.take_interrupt()) return false;
  session.rest_hook(L);
  session.call_off();
  return true;
}

int enter(lua_State* L) {
  const Entry& entry = *static_cast<const Entry*>(lua_touserdata(L, lua_upvalueindex(1)));
  const std::string call = last_word(entry.name);
  try {
    const ActiveState active(Session::of(L), L);
    if (system::stack_is_short())
      throw Error("calls are nested too deeply for the stack of this process (ulimit -s)");
    Call arguments(L, entry);
    return Session::of(L).execute(arguments);
  } catch (const Raised& raised) {
    raised.push(L);
  } catch (const NumericalFailure& failure) {
    push_failure(L, call, failure);
  } catch (const Error& error) {
    if (dynamic_cast<const system::CannotWrite*>(&error) != nullptr) count_refusal(L);
    push_error(L, call, interrupted_by_now(L) ? "interrupted" : error.what());
  } catch (const std::bad_alloc&) {
    count_refusal(L);
    push_error(L, call, no_memory_text(Session::of(L).limits() != nullptr));
  } catch (const std::filesystem::filesystem_error& trouble) {
    count_refusal(L);
    push_error(L, call, system_words(trouble));
  } catch (const std::exception& bug) {
    push_error(L, call, std::string("internal error: ") + bug.what());
  }
  return lua_error(L);
}

// object.name: a property (its function is called with the object), or a method, or an error with the nearest
// name. Upvalues: methods, properties, class name.
int index_object(lua_State* L) {
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(2)) != LUA_TNIL) {
    lua_pushvalue(L, 1);
    lua_call(L, 1, 1);
    return 1;
  }
  lua_pop(L, 1);
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return 1;
  std::string message = position(L) + lua_tostring(L, lua_upvalueindex(3)) + ": ";
  {
    auto known = keys_of(L, lua_upvalueindex(1));
    for (auto& name : keys_of(L, lua_upvalueindex(2))) known.push_back(name);
    std::sort(known.begin(), known.end());
    message += unknown("field", luaL_tolstring(L, 2, nullptr), known);
  }
  lua_pushstring(L, message.c_str());
  return lua_error(L);
}

int refuse_assignment(lua_State* L) {
  const std::string message = position(L) + lua_tostring(L, lua_upvalueindex(1)) + ": field '" +
                              luaL_tolstring(L, 2, nullptr) + "' cannot be assigned";
  lua_pushstring(L, message.c_str());
  return lua_error(L);
}

// Loads the module of the library that defines the function, if there is one.
void load_for(lua_State* L, const std::string& name) {
  luaL_checkstack(L, 10, "library");
  luaL_getsubtable(L, LUA_REGISTRYINDEX, later_key);
  if (push_raw(L, -1, name) == LUA_TSTRING) {
    push_raw(L, -2, "require");
    lua_insert(L, -2);
    lua_call(L, 1, 0);
  } else {
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
}

// module.x with an x that is not there yet, or with an unknown x: an error with the nearest name. Upvalue:
// the module's name.
int index_module(lua_State* L) {
  const std::string module = lua_tostring(L, lua_upvalueindex(1));
  if (lua_type(L, 2) == LUA_TSTRING && lua_istable(L, 1)) {
    load_for(L, module + "." + lua_tostring(L, 2));
    if (push_raw(L, 1, lua_tostring(L, 2)) != LUA_TNIL) return 1;
  }
  load_defined_later(L, module);
  std::string message = position(L) + module + ": ";
  message += unknown("field", luaL_tolstring(L, 2, nullptr),
                     lua_istable(L, 1) ? keys_of(L, 1) : std::vector<std::string>{});
  lua_pushstring(L, message.c_str());
  return lua_error(L);
}

// module{...}: its function `of`.
int call_module(lua_State* L) {
  if (push_raw(L, 1, "of") == LUA_TNIL) {
    const std::string name = lua_tostring(L, lua_upvalueindex(1));
    load_defined_later(L, name);
    lua_pushstring(L, (position(L) + name + ": it is no function; it holds functions, as " + name + "." +
                       keys_of(L, 1).front())
                          .c_str());
    return lua_error(L);
  }
  lua_replace(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

int next_member(lua_State* L) {
  lua_settop(L, 2);
  return lua_next(L, 1) != 0 ? 2 : 0;
}

// pairs(module): of all that it holds. Upvalue: the module's name.
int pairs_of_module(lua_State* L) {
  load_defined_later(L, lua_tostring(L, lua_upvalueindex(1)));
  lua_pushcfunction(L, next_member);
  lua_pushvalue(L, 1);
  return 2;
}

}  // namespace

void watch_module(lua_State* L, const std::string& name) {
  lua_newtable(L);
  const luaL_Reg events[] = {
      {"__index", index_module}, {"__call", call_module}, {"__pairs", pairs_of_module}, {nullptr, nullptr}};
  lua_pushstring(L, name.c_str());
  luaL_setfuncs(L, events, 1);
  put(L, module_field, name, "__metatable", false);
  lua_setmetatable(L, -2);
}

namespace {

// Pushes the table that holds the last word of fabric.a.b, creating missing tables on the
// way.
void push_home(lua_State* L, const std::string& name) {
  lua_getfield(L, LUA_REGISTRYINDEX, "fabric");
  std::size_t from = name.find('.') + 1;
  for (std::size_t dot = name.find('.', from); dot != std::string::npos; dot = name.find('.', from)) {
    const std::string part = name.substr(from, dot - from);
    if (push_raw(L, -1, part) != LUA_TTABLE) {
      lua_pop(L, 1);
      lua_newtable(L);
      watch_module(L, name.substr(0, dot));
      lua_pushvalue(L, -1);
      lua_setfield(L, -3, part.c_str());
    }
    lua_remove(L, -2);
    from = dot + 1;
  }
}

}  // namespace

void define_later(lua_State* L, const std::string& name, const std::string& module) {
  push_home(L, name);
  luaL_getsubtable(L, LUA_REGISTRYINDEX, later_key);
  put(L, name.c_str(), module);
  lua_getglobal(L, "require");
  lua_setfield(L, -2, "require");
  lua_pop(L, 2);
}

void load_defined_later(lua_State* L, const std::string& home) {
  luaL_checkstack(L, 10, "library");
  luaL_getsubtable(L, LUA_REGISTRYINDEX, later_key);
  const auto names = keys_of(L, -1);
  lua_pop(L, 1);
  for (const std::string& name : names)
    if (home.empty() || name.substr(0, name.rfind('.')) == home) load_for(L, name);
}

void load_members(lua_State* L, int index) {
  const int type = luaL_getmetafield(L, index, module_field);
  if (type == LUA_TSTRING) load_defined_later(L, lua_tostring(L, -1));
  if (type != LUA_TNIL) lua_pop(L, 1);
}

void place(lua_State* L, const Entry& entry) {
  const std::string word = last_word(entry.name);
  if (entry.is_private()) {
    luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
    luaL_getsubtable(L, -1, "fabric.kernels");
    lua_remove(L, -2);
  } else if (entry.owner().empty()) {
    push_home(L, entry.name);
  } else {
    push_class(L, entry.owner(), nullptr);
    lua_getfield(L, -1, entry.method() ? "methods" : "properties");
    lua_remove(L, -2);
  }
  push_function(L, entry);
  lua_setfield(L, -2, word.c_str());
  lua_pop(L, 1);
}

void push_function(lua_State* L, const Entry& entry) {
  lua_pushlightuserdata(L, const_cast<Entry*>(&entry));
  lua_pushcclosure(L, enter, 1);
}

const Entry* entry_of(lua_State* L, int index) {
  if (lua_tocfunction(L, index) != enter || lua_getupvalue(L, index, 1) == nullptr) return nullptr;
  const auto* entry = static_cast<const Entry*>(lua_touserdata(L, -1));
  lua_pop(L, 1);
  return entry;
}

void push_class(lua_State* L, const std::string& name, lua_CFunction gc) {
  if (luaL_newmetatable(L, class_key(name).c_str()) != 0) {
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_setfield(L, -3, "methods");
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_setfield(L, -4, "properties");
    lua_pushstring(L, name.c_str());
    lua_pushcclosure(L, index_object, 3);
    lua_setfield(L, -2, "__index");
    lua_pushstring(L, name.c_str());
    lua_pushcclosure(L, refuse_assignment, 1);
    lua_setfield(L, -2, "__newindex");
    put(L, "__name", name, "__metatable", name);
  }
  if (gc != nullptr) put(L, "__gc", *gc);
}

namespace {

void read_style(Entry& entry) {
  const bool fields = entry.name.ends_with("{}"), in_order = entry.name.ends_with("()");
  if (fields || in_order) entry.name.resize(entry.name.size() - 2);
  entry.style = fields ? Style::fields : in_order || entry.method() ? Style::positional : Style::property;
}

Touches touched_by(const Entry& entry) {
  constexpr const char* own[] = {"solve",    "advance",  "step",   "reach", "restore",     "stop",    "set",
                                 "every",    "event",    "record", "vtk",   "checkpoint",  "restart", "steps",
                                 "snapshot", "duration", "model",  "mesh",  "stable_step", "cut",     "join"};
  const auto takes_run = [](const Argument& row) { return row.of == "analysis"; };
  if (entry.owner() != "analysis")
    return std::any_of(entry.arguments.begin(), entry.arguments.end(), takes_run) ? Touches::whole_run
                                                                                  : Touches::nothing;
  const std::string word = last_word(entry.name);
  return std::find(std::begin(own), std::end(own), word) == std::end(own) ? Touches::results
                                                                          : Touches::nothing;
}

bool weighs(const std::string& name) {
  constexpr const char* heavy[] = {"fabric.static", "fabric.dynamic", "fabric.model", "analysis:snapshot"};
  return name.starts_with("fabric.mesh.") ||
         std::find(std::begin(heavy), std::end(heavy), name) != std::end(heavy);
}

}  // namespace

void install(Session& session, std::vector<Entry> entries) {
  for (Entry& entry : entries) {
    read_style(entry);
    entry.touches = touched_by(entry);
    entry.weighs = weighs(entry.name);
    place(session.lua(), session.registry().add(std::move(entry)));
  }
}

}  // namespace fabricsh::script
