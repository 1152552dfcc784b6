// require "fabric.define": a function written in Lua gets a row in the registry, and with it argument checks.
//
//   define{ name="fabric.lab.uniaxial", sentence="...", example="...", arguments={ {name="card", of="card",
//   ...} },
//           run=function(t) ... end }
//
// An argument has name, sentence, kind ("number|text", "object" is implied by of), unit, low, high, above,
// default, optional, choices, rows. define.fail(message) raises an error at the deck's line; define.registry
// holds rows, name_of, class_of, nearest and show of bind_registry.cpp. run gets one table with every default
// filled in; with positional=true, the values in order.
#include "script/bind.hpp"
#include "script/show.hpp"
#include "script/words.hpp"

namespace fabricsh::script {

namespace {

constexpr const char* functions_key = "fabricsh.defined";

std::string get_text(lua_State* L, int index, const char* name) {
  const bool is_text = lua_getfield(L, index, name) == LUA_TSTRING;
  const std::string value = is_text ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  return value;
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

std::vector<Argument> read_rows(lua_State* L, int index);

// The argument row in the table on top of the stack.
Argument read_row(lua_State* L) {
  Argument row;
  row.name = get_text(L, -1, "name");
  row.sentence = get_text(L, -1, "sentence");
  row.unit = get_text(L, -1, "unit");
  row.of = get_text(L, -1, "of");
  const std::string kinds = get_text(L, -1, "kind");
  row.kinds = kinds.empty() ? 0u : read_kinds(kinds);
  if (!row.of.empty()) row.kinds |= object;
  if (row.kinds == 0) row.kinds = any;
  read_range(L, row);
  read_default(L, row);
  if (lua_getfield(L, -1, "choices") == LUA_TTABLE)
    for (lua_Integer i = 1; lua_rawgeti(L, -1, i) == LUA_TSTRING || (lua_pop(L, 1), false); ++i) {
      row.choices.emplace_back(lua_tostring(L, -1));
      lua_pop(L, 1);
    }
  lua_pop(L, 1);
  if (lua_getfield(L, -1, "rows") == LUA_TTABLE) row.rows = read_rows(L, -1);
  lua_pop(L, 1);
  return row;
}

std::vector<Argument> read_rows(lua_State* L, int index) {
  std::vector<Argument> rows;
  index = lua_absindex(L, index);
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, index));
  for (lua_Integer i = 1; i <= n; ++i) {
    lua_rawgeti(L, index, i);
    rows.push_back(read_row(L));
    lua_pop(L, 1);
  }
  return rows;
}

void push_default(lua_State* L, const Argument& row) {
  if (const double* x = std::get_if<double>(&row.fallback); x && (row.kinds & integer) != 0)
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

void push_value(Call& call, const Argument& row) {
  if (call.push(row.name) != LUA_TNIL) return;
  lua_pop(call.L(), 1);
  push_default(call.L(), row);
}

// Runs the Lua function of the row with checked arguments.
int run_defined(Call& call) {
  lua_State* L = call.L();
  const Entry& entry = call.entry();
  lua_getfield(L, LUA_REGISTRYINDEX, functions_key);
  const int base = lua_gettop(L);
  lua_rawgetp(L, base, &entry);
  if (entry.style == Style::fields) lua_newtable(L);
  for (const Argument& row : entry.arguments) {
    push_value(call, row);
    if (entry.style == Style::fields) lua_setfield(L, -2, row.name.c_str());
  }
  lua_call(L, entry.style == Style::fields ? 1 : static_cast<int>(entry.arguments.size()), LUA_MULTRET);
  const int results = lua_gettop(L) - base;
  if (results == 1 && lua_istable(L, -1)) name_result(L, entry.name);
  return results;
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
    lua_getfield(L, 1, "positional");
    entry.style = lua_toboolean(L, -1) ? Style::positional : Style::fields;
    if (lua_getfield(L, 1, "arguments") == LUA_TTABLE) entry.arguments = read_rows(L, -1);
    lua_pop(L, 2);
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

// fail(message): an error at the line of the deck, not at that of the library.
int fail(lua_State* L) {
  const char* message = luaL_checkstring(L, 1);
  lua_pushstring(L, position(L).c_str());
  lua_pushstring(L, message);
  lua_concat(L, 2);
  return lua_error(L);
}

int call_define(lua_State* L) {
  lua_remove(L, 1);
  return define(L);
}

}  // namespace

int open_define(lua_State* L) {
  lua_newtable(L);
  lua_pushcfunction(L, fail);
  lua_setfield(L, -2, "fail");
  push_registry(L);
  lua_setfield(L, -2, "registry");
  lua_newtable(L);
  lua_pushcfunction(L, call_define);
  lua_setfield(L, -2, "__call");
  lua_setmetatable(L, -2);
  return 1;
}

}  // namespace fabricsh::script
