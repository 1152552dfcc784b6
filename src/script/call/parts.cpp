#include "script/call/parts.hpp"

#include "script/call/boundary.hpp"
#include "script/call/push.hpp"

namespace fabricsh::script {

namespace {

constexpr const char* parts_key =
    "fabricsh.card_parts";  // registry: tables read from cards, with their cards

char shown_key;  // in the metatable of a part: the table that it shows
char card_key;   // the card
char name_key;   // name of the card's field to which the part belongs

// Pushes the table that the part at index shows; pushes nothing if it is not a part.
bool push_shown(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TTABLE || lua_getmetatable(L, index) == 0) return false;
  const bool part = lua_rawgetp(L, -1, &shown_key) != LUA_TNIL;
  lua_remove(L, -2);
  if (!part) lua_pop(L, 1);
  return part;
}

// Replaces a metatable on top of the stack by a part; other values are kept.
void make_part(lua_State* L) {
  if (lua_type(L, -1) != LUA_TTABLE) return;
  lua_newtable(L);
  lua_insert(L, -2);
  lua_setmetatable(L, -2);
}

// Number of points in the block at index.
lua_Integer points_in(lua_State* L, int index) {
  return static_cast<lua_Integer>(lua_rawlen(L, index) / (2 * sizeof(double)));
}

// Pushes point i of the block at index.
void push_point(lua_State* L, int index, lua_Integer i) {
  const auto* xy = static_cast<const double*>(lua_touserdata(L, index));
  push_numbers(L, {xy[2 * i - 2], xy[2 * i - 1]});
}

void make_own(lua_State* L, int index);

// Upvalue: the table that is shown. A table inside a part is stored in the part when it is first read, so
// that later changes to it are found. A pair of numbers is a plain table, and changes to it cannot be
// noticed; so when one is read, all of them are stored.
int part_index(lua_State* L) {
  constexpr int shown = lua_upvalueindex(1);
  lua_settop(L, 2);
  if (lua_type(L, shown) != LUA_TTABLE) {
    make_own(L, 1);
    lua_rawget(L, 1);
    return 1;
  }
  lua_pushvalue(L, 2);
  if (lua_rawget(L, shown) != LUA_TTABLE) return 1;
  make_part(L);
  lua_pushvalue(L, 2);
  lua_pushvalue(L, -2);
  lua_rawset(L, 1);
  return 1;
}

int part_length(lua_State* L) {
  constexpr int shown = lua_upvalueindex(1);
  const bool points = lua_type(L, shown) == LUA_TUSERDATA;
  return push_value(L, points ? points_in(L, shown) : static_cast<lua_Integer>(lua_rawlen(L, shown)));
}

// Copies to the table at `to`, which has no metatable, the values shown at `shown` that it does not have yet.
void copy_shown(lua_State* L, int shown, int to) {
  luaL_checkstack(L, 8, "card");
  const bool points = lua_type(L, shown) == LUA_TUSERDATA;
  for (lua_Integer i = 1; points && i <= points_in(L, shown); ++i) {
    if (lua_rawgeti(L, to, i) == LUA_TNIL) {
      push_point(L, shown, i);
      lua_rawseti(L, to, i);
    }
    lua_pop(L, 1);
  }
  if (points) return;
  for (lua_pushnil(L); lua_next(L, shown) != 0; lua_pop(L, 1)) {
    lua_pushvalue(L, -2);
    if (lua_rawget(L, to) == LUA_TNIL) {
      lua_pushvalue(L, -3);
      lua_pushvalue(L, -3);
      make_part(L);
      lua_rawset(L, to);
    }
    lua_pop(L, 1);
  }
}

// With a part's metatable on top of the stack: makes the card return another part from now on.
void forget_part(lua_State* L) {
  luaL_checkstack(L, 6, "card");
  const int top = lua_gettop(L);
  lua_rawgetp(L, top, &card_key);
  lua_getiuservalue(L, -1, 1);
  lua_rawgetp(L, top, &name_key);
  lua_rawgeti(L, -2, 1);
  lua_pushvalue(L, -2);
  lua_rawget(L, -2);
  lua_remove(L, -2);
  lua_rawset(L, -3);
  lua_settop(L, top);
}

// Makes the part at index a plain table of the deck.
void make_own(lua_State* L, int index) {
  luaL_checkstack(L, 8, "card");
  lua_getmetatable(L, index);
  forget_part(L);
  lua_rawgetp(L, -1, &card_key);
  remember_part(L, index, lua_gettop(L));
  lua_rawgetp(L, -2, &shown_key);
  lua_pushnil(L);
  lua_setmetatable(L, index);
  copy_shown(L, lua_gettop(L), index);
  lua_pop(L, 3);
}

int part_newindex(lua_State* L) {
  lua_settop(L, 3);
  make_own(L, 1);
  lua_rawset(L, 1);
  return 0;
}

// pairs, next, rawget, rawlen and rawset of a part first make it a plain table.
int part_pairs(lua_State* L) {
  make_own(L, 1);
  lua_getglobal(L, "next");
  lua_pushvalue(L, 1);
  lua_pushnil(L);
  return 3;
}

int on_own(lua_State* L) {
  load_members(L, 1);
  if (push_shown(L, 1)) {
    lua_pop(L, 1);
    make_own(L, 1);
  }
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

}  // namespace

void make_metatable(lua_State* L, const std::string& name) {
  const int shown = lua_gettop(L);
  lua_createtable(L, 0, 7);
  const std::pair<const char*, lua_CFunction> functions[] = {{"__index", part_index}, {"__len", part_length}};
  for (const auto& [event, f] : functions) {
    lua_pushvalue(L, shown);
    lua_pushcclosure(L, f, 1);
    lua_setfield(L, -2, event);
  }
  put(L, "__newindex", part_newindex, "__pairs", part_pairs, "__metatable", false);
  lua_pushvalue(L, shown);
  lua_rawsetp(L, -2, &shown_key);
  lua_pushvalue(L, 1);
  lua_rawsetp(L, -2, &card_key);
  lua_pushlstring(L, name.data(), name.size());
  lua_rawsetp(L, -2, &name_key);
  lua_replace(L, shown);
}

void hold_part(lua_State* L) {
  const bool fresh = lua_rawgetp(L, -1, &shown_key) != LUA_TNIL;
  lua_pop(L, 1);
  if (!fresh) return;
  make_part(L);
  lua_pushvalue(L, 2);
  lua_pushvalue(L, -2);
  lua_rawset(L, -4);
}

void push_absent(lua_State* L) { lua_pushlightuserdata(L, &shown_key); }

void remember_part(lua_State* L, int part, int card) {
  if (luaL_getsubtable(L, LUA_REGISTRYINDEX, parts_key) == 0) {
    push_record(L, "__mode", "k");
    lua_setmetatable(L, -2);
  }
  lua_pushvalue(L, part);
  lua_pushvalue(L, card);
  lua_rawset(L, -3);
  lua_pop(L, 1);
}

void push_card_of(lua_State* L, int part) {
  if (push_shown(L, part)) {
    lua_pop(L, 1);
    lua_getmetatable(L, part);
    lua_rawgetp(L, -1, &card_key);
  } else {
    luaL_getsubtable(L, LUA_REGISTRYINDEX, parts_key);
    lua_pushvalue(L, part);
    lua_rawget(L, -2);
  }
  lua_remove(L, -2);
}

void make_plain(lua_State* L) {
  const int top = lua_gettop(L);
  if (!push_shown(L, top)) return;
  lua_pop(L, 1);
  make_own(L, top);
  for (lua_pushnil(L); lua_next(L, top) != 0; lua_pop(L, 1)) make_plain(L);
}

void know_parts(lua_State* L) {
  for (const char* name : {"next", "rawget", "rawlen", "rawset"}) {
    lua_getglobal(L, name);
    lua_pushcclosure(L, on_own, 1);
    lua_setglobal(L, name);
  }
}

}  // namespace fabricsh::script
