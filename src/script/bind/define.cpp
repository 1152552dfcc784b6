// require "fabric.define": registers a function written in Lua, with argument checks.
//
//   define{ name="fabric.lab.uniaxial", sentence="...", example="...",
//           arguments={ {name="card", of="card", ...} }, run=function(t) ... end }
//
// An argument has name, sentence, kind ("number|text"; `of` implies "object"), unit, low, high,
// above, default, optional, choices, rows. define.fail(message) raises an error with the deck's
// line; define.check(call, path, value, rows) raises one unless the value is a table that matches rows of
// arguments; define.warnings(define.log_end()) is what runs and decks warn of from then on, define.say(text)
// shows a warning without adding it to these; define.later(module, name...) defers a module of the library;
// define.keep_caller(f) is f for decks, whose line is known even in `return f()`; define.registry has rows,
// name_of, class_of, card_of, nearest and show of bind/registry.cpp. run receives one table with all defaults
// filled in; with positional=true, the values in order.
#include <cmath>
#include <memory>
#include <new>

#include "run/job.hpp"
#include "script/bind/rooms.hpp"
#include "script/call/boundary.hpp"
#include "script/call/words.hpp"
#include "script/session/warning_log.hpp"
#include "script/show/show.hpp"

namespace fabricsh::script {

namespace {

constexpr const char* functions_key = "fabricsh.defined";

constexpr int deepest_rows = 8;  // limit of nested rows

std::string get_text(lua_State* L, int index, const char* name) {
  const bool is_text = lua_getfield(L, index, name) == LUA_TSTRING;
  const std::string value = is_text ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  return value;
}

std::vector<std::string> get_texts(lua_State* L, int index, const char* name) {
  std::vector<std::string> texts;
  if (lua_getfield(L, index, name) == LUA_TTABLE)
    for (lua_Integer i = 1; lua_rawgeti(L, -1, i) == LUA_TSTRING || (lua_pop(L, 1), false); ++i) {
      texts.emplace_back(lua_tostring(L, -1));
      lua_pop(L, 1);
    }
  lua_pop(L, 1);
  return texts;
}

unsigned kind_named(const std::string& word) {
  for (const auto& [name, kind] : kind_names)
    if (word == name) return kind;
  throw Error("unknown kind '" + word + "'");
}

unsigned read_kinds(const std::string& words) {
  unsigned kinds = 0;
  for (std::size_t from = 0; from <= words.size();) {
    const std::size_t bar = std::min(words.find('|', from), words.size());
    kinds |= kind_named(words.substr(from, bar - from));
    from = bar + 1;
  }
  return kinds;
}

void read_range(lua_State* L, Argument& row) {
  if (lua_getfield(L, -1, "low") == LUA_TNUMBER) row.range.low = lua_tonumber(L, -1);
  if (lua_getfield(L, -2, "high") == LUA_TNUMBER) row.range.high = lua_tonumber(L, -1);
  if (lua_getfield(L, -3, "above") == LUA_TNUMBER) {
    row.range.low = lua_tonumber(L, -1);
    row.range.low_open = true;
  }
  lua_pop(L, 3);
}

void read_default(lua_State* L, Argument& row) {
  switch (lua_getfield(L, -1, "default")) {
    case LUA_TNUMBER:
      row = row.or_else(lua_tonumber(L, -1));
      break;
    case LUA_TSTRING:
      row = row.or_else(lua_tostring(L, -1));
      break;
    case LUA_TBOOLEAN:
      row = row.or_else(lua_toboolean(L, -1) != 0);
      break;
    default:
      break;
  }
  if (lua_getfield(L, -2, "optional") == LUA_TBOOLEAN) row.required = row.required && !lua_toboolean(L, -1);
  lua_pop(L, 2);
}

std::vector<Argument> read_rows(lua_State* L, int index, int depth);

// Reads the argument row on top of the stack.
Argument read_row(lua_State* L, int depth) {
  want_table(L, -1, "a row of arguments");
  Argument row;
  row.name = get_text(L, -1, "name");
  row.sentence = get_text(L, -1, "sentence");
  row.unit = get_text(L, -1, "unit");
  row.of = get_text(L, -1, "of");
  const std::string kinds = get_text(L, -1, "kind");
  row.kinds = kinds.empty() ? 0u : read_kinds(kinds);
  if (!row.of.empty()) row.kinds |= object;
  if (row.kinds == 0) row.kinds = any;
  if (row.name.empty()) throw Error("a row of arguments: field 'name': expected a name, got none");
  read_range(L, row);
  read_default(L, row);
  row.choices = get_texts(L, -1, "choices");
  if (lua_getfield(L, -1, "rows") == LUA_TTABLE) row.rows = read_rows(L, -1, depth + 1);
  lua_pop(L, 1);
  return row;
}

std::vector<Argument> read_rows(lua_State* L, int index, int depth) {
  if (depth > deepest_rows)
    throw Error("rows of arguments lie more than " + std::to_string(deepest_rows) + " deep in one another");
  luaL_checkstack(L, 10, "define");
  std::vector<Argument> rows;
  index = lua_absindex(L, index);
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, index));
  for (lua_Integer i = 1; i <= n; ++i) {
    lua_rawgeti(L, index, i);
    rows.push_back(read_row(L, depth));
    lua_pop(L, 1);
  }
  return rows;
}

void push_default(lua_State* L, const Argument& row) {
  if (const double* x = std::get_if<double>(&row.fallback);
      x && (row.kinds & integer) != 0 && std::abs(*x) < 0x1p63)
    lua_pushinteger(L, static_cast<lua_Integer>(*x));
  else if (x)
    lua_pushnumber(L, *x);
  else if (const std::string* word = std::get_if<std::string>(&row.fallback))
    lua_pushstring(L, word->c_str());
  else if (const bool* flag = std::get_if<bool>(&row.fallback))
    lua_pushboolean(L, *flag);
  else
    lua_pushnil(L);
}

void push_argument(Call& call, const Argument& row) {
  if (call.push(row.name) != LUA_TNIL) return;
  lua_pop(call.L(), 1);
  push_default(call.L(), row);
}

// Gives the result of a virtual test, on top of the stack, the field `warnings`: of all runs that it made and
// of what it said itself.
void add_warnings(lua_State* L, const WarningLog& log, WarningLog::LogPosition from) {
  if (!log.ran_since(from)) return;
  lua_pushliteral(L, "warnings");
  if (lua_pushvalue(L, -1), lua_rawget(L, -3) == LUA_TNIL) {
    lua_pop(L, 1);
    push_warnings(L, log.since(from));
    lua_rawset(L, -3);
  } else {
    lua_pop(L, 2);
  }
}

// Calls the Lua function of the row with checked arguments.
int run_defined(Call& call) {
  lua_State* L = call.L();
  const Entry& entry = call.entry();
  lua_getfield(L, LUA_REGISTRYINDEX, functions_key);
  const int base = lua_gettop(L),
            given = base - 2;  // the table of named arguments and the table of functions are on top
  luaL_checkstack(L, static_cast<int>(entry.arguments.size()) + 20, "too many arguments");
  lua_rawgetp(L, base, &entry);
  if (entry.style == Style::fields) lua_newtable(L);
  for (const Argument& row : entry.arguments) {
    push_argument(call, row);
    if (entry.style == Style::fields) lua_setfield(L, -2, row.name.c_str());
  }
  // An absent argument without a default is not passed, so that it can be distinguished from nil.
  if (entry.style != Style::fields)
    while (lua_gettop(L) > base + 1 + given && lua_isnil(L, -1)) lua_pop(L, 1);
  const WarningLog::LogPosition place = call.session().log().end();
  lua_call(L, lua_gettop(L) - base - 1, LUA_MULTRET);
  const int results = lua_gettop(L) - base;
  if (results != 1 || !lua_istable(L, -1)) return results;
  if (entry.name.starts_with("fabric.lab.")) add_warnings(L, call.session().log(), place);
  name_result(L, entry.name);
  return results;
}

// A valid name is "fabric.lab.uniaxial" or "card:fit": words with full stops or one colon between them, the
// first being fabric or a class.
void check_name(const std::string& name) {
  const std::size_t colon = std::min(name.find(':'), name.size());
  const bool method = colon < name.size();
  bool good = method ? is_name(name.substr(0, colon)) : name.starts_with("fabric.");
  for (std::size_t from = method ? colon + 1 : 7; good && from <= name.size();) {
    const std::size_t dot = method ? name.size() : std::min(name.find('.', from), name.size());
    good = is_name(name.substr(from, dot - from));
    from = dot + 1;
  }
  if (!good) throw Error("field 'name': expected one like fabric.lab.uniaxial, got '" + name + "'");
}

void remember(lua_State* L, const Entry& entry) {
  if (lua_getfield(L, LUA_REGISTRYINDEX, functions_key) != LUA_TTABLE) {
    lua_pop(L, 1);
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_setfield(L, LUA_REGISTRYINDEX, functions_key);
  }
  lua_getfield(L, 1, "run");
  luaL_checktype(L, -1, LUA_TFUNCTION);
  lua_rawsetp(L, -2, &entry);
  lua_pop(L, 1);
}

int define(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  std::string problem;
  try {
    Session& session = Session::of(L);
    Entry entry;
    entry.name = get_text(L, 1, "name");
    check_name(entry.name);
    lua_getfield(L, 1, "run");
    if (!lua_isfunction(L, -1)) throw Error("field 'run': expected a function, got " + describe(L, -1));
    lua_pop(L, 1);
    lua_getfield(L, 1, "positional");
    entry.style = lua_toboolean(L, -1) ? Style::positional : Style::fields;
    if (lua_getfield(L, 1, "arguments") == LUA_TTABLE) entry.arguments = read_rows(L, -1, 1);
    lua_pop(L, 2);
    entry.retired = get_texts(L, 1, "retired");
    entry.sentence = get_text(L, 1, "sentence");
    entry.example = get_text(L, 1, "example");
    entry.run = run_defined;
    const Entry& kept = session.registry().add(std::move(entry));
    remember(L, kept);
    place(L, kept);
    return 0;
  } catch (const std::exception& error) {
    problem = error.what();
  }
  return luaL_error(L, "define: %s", problem.c_str());
}

}  // namespace

namespace {

// fail(message): an error with the line of the deck instead of that of the library.
int fail(lua_State* L) {
  const char* message = luaL_checkstring(L, 1);
  lua_pushstring(L, position(L).c_str());
  lua_pushstring(L, message);
  lua_concat(L, 2);
  return lua_error(L);
}

// check(call, path, value, rows): an error in the name of the call unless the value is a table that matches
// the rows, which are written as those of arguments.
int check_table(lua_State* L) {
  const std::string call = luaL_checkstring(L, 1), path = luaL_checkstring(L, 2);
  luaL_checktype(L, 4, LUA_TTABLE);
  std::string problem;
  try {
    Argument row = value_(path, fields, "");
    row.rows = read_rows(L, 4, 1);
    check_value(L, 3, row, "", false);
    return 0;
  } catch (const Error& error) {
    problem = position(L) + call + ": " + error.what();
  }
  lua_pushstring(L, problem.c_str());
  return lua_error(L);
}

// Calls the Lua function of the upvalue. Lua does not keep the line of a function that returns the result of
// another Lua function; of one that returns that of a C function it keeps it.
int give_results(lua_State* L, int /*status*/, lua_KContext /*context*/) { return lua_gettop(L); }

int call_kept(lua_State* L) {
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_callk(L, lua_gettop(L) - 1, LUA_MULTRET, 0, give_results);
  return lua_gettop(L);
}

int keep_caller(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_settop(L, 1);
  lua_pushcclosure(L, call_kept, 1);
  return 1;
}

// later(module, name...): the module defines fabric.name when one of these is first asked for.
int later(lua_State* L) {
  const std::string module = luaL_checkstring(L, 1);
  for (int i = lua_gettop(L); i > 1; --i)
    define_later(L, std::string("fabric.") + luaL_checkstring(L, i), module);
  return 0;
}

// refusals(): how often the machine has refused a file or memory to a call of this session.
int refusals(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, refusals_key);
  return push_value(L, lua_tointeger(L, -1));
}

int let_lock_go(lua_State* L) {
  auto* const held = static_cast<std::shared_ptr<const void>*>(lua_touserdata(L, 1));
  held->reset();
  return 0;
}

// lock(path): a value that holds the file against other programs until it is closed; nil and the reason if
// one has it already.
int lock(lua_State* L) {
  constexpr const char* name = "fabricsh.lock";
  std::shared_ptr<const void> lock;
  try {
    lock = Session::of(L).journal()->locks.take(luaL_checkstring(L, 1));
  } catch (const Error& error) {
    lua_pushnil(L);
    lua_pushstring(L, error.what());
    return 2;
  }
  void* const place = lua_newuserdatauv(L, sizeof(std::shared_ptr<const void>), 0);
  new (place) std::shared_ptr<const void>(std::move(lock));
  if (luaL_newmetatable(L, name) != 0)
    for (const char* event : {"__gc", "__close"}) {
      lua_pushcfunction(L, let_lock_go);
      lua_setfield(L, -2, event);
    }
  lua_setmetatable(L, -2);
  return 1;
}

// log_end(): where the log of warnings ends; warnings(place): what was added from there on.
int log_end(lua_State* L) {
  const WarningLog::LogPosition place = Session::of(L).log().end();
  return push_value(L, place.lists);
}

int warnings(lua_State* L) {
  const auto from = static_cast<std::size_t>(luaL_checkinteger(L, 1));
  push_warnings(L, Session::of(L).log().since({from, 0}));
  return 1;
}

// say(text): shows a warning without logging it, because what it says is in the log already.
int say(lua_State* L) {
  Session& session = Session::of(L);
  const std::string text = luaL_checkstring(L, 1);
  session.notices().once(text, "warning: " + text);
  return 0;
}

int call_define(lua_State* L) {
  luaL_checkany(L, 1);
  lua_remove(L, 1);
  return define(L);
}

}  // namespace

int open_define(lua_State* L) {
  lua_newtable(L);
  put(L, "fail", fail, "check", check_table, "keep_caller", keep_caller, "lock", lock, "refusals", refusals,
      "log_end", log_end, "warnings", warnings, "say", say, "later", later, "registry",
      [&] { push_registry(L); });
  lua_newtable(L);
  put(L, "__call", call_define, "__metatable", false);
  lua_setmetatable(L, -2);
  return 1;
}

}  // namespace fabricsh::script
