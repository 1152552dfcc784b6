// A card as Lua tables: a plain copy for the reader, and the one behind card.warp.poisson, which is made once
// per card and is read-only.
#include "script/values/card_table.hpp"

#include <cstring>

#include "card/fields.hpp"
#include "script/call/parts.hpp"
#include "script/call/push.hpp"

namespace fabricsh::script {

using card::Card;
using card::Field;
using card::FieldTable;
using card::FieldType;
using card::Points;
using card::Value;

namespace {

// --- plain tables ---

void push_points(lua_State* L, const double* xy, lua_Integer n) {
  lua_createtable(L, static_cast<int>(n), 0);
  for (lua_Integer i = 0; i < n; ++i) {
    push_numbers(L, {xy[2 * i], xy[2 * i + 1]});
    lua_rawseti(L, -2, i + 1);
  }
}

const double* flat(const Points& points) {
  static_assert(sizeof(Points::value_type) == 2 * sizeof(double));
  return &points.front().first;
}

void push_plain(lua_State* L, const Value& value) {
  if (const auto* points = std::get_if<Points>(&value))
    return push_points(L, flat(*points), static_cast<lua_Integer>(points->size()));
  if (const auto* x = std::get_if<double>(&value))
    push_value(L, *x);
  else if (const auto* flag = std::get_if<bool>(&value))
    push_value(L, *flag);
  else if (const auto* many = std::get_if<std::vector<double>>(&value))
    push_value(L, *many);
  else if (const auto* words = std::get_if<std::string>(&value))
    push_value(L, *words);
  else
    lua_pushnil(L);
}

void push_plain(lua_State* L, const FieldTable& table, const Card& card) {
  luaL_checkstack(L, 10, "card");
  lua_newtable(L);
  for (const Field& field : table) {
    if (field.holds == FieldType::group && field.there(card))
      push_plain(L, field.rows, card);
    else
      push_plain(L, field.get ? field.get(card) : Value());
    lua_setfield(L, -2, field.name.c_str());
  }
}

void push_shown(lua_State* L, const FieldTable& table, const Card& card, const std::string& top);

// Pushes the value of a field; lists and groups as metatables. top: the card's field to which it belongs.
void push_field(lua_State* L, const Field& field, const Card& card, const std::string& top) {
  if (field.holds == FieldType::group) {
    if (!field.there(card)) return lua_pushnil(L);
    push_shown(L, field.rows, card, top);
    return make_metatable(L, top);
  }
  const Value value = field.get ? field.get(card) : Value();
  if (const auto* points = std::get_if<Points>(&value)) {
    const std::size_t size = points->size() * sizeof(Points::value_type);
    std::memcpy(lua_newuserdatauv(L, size, 0), flat(*points), size);
    return make_metatable(L, top);
  }
  push_plain(L, value);
  if (lua_istable(L, -1)) make_metatable(L, top);
}

void push_shown(lua_State* L, const FieldTable& table, const Card& card, const std::string& top) {
  luaL_checkstack(L, 12, "card");
  lua_createtable(L, 0, static_cast<int>(table.size()) + 2);
  for (const Field& field : table) {
    push_field(L, field, card, top.empty() ? field.name : top);
    lua_setfield(L, -2, field.name.c_str());
  }
}

// Sets kind, source and the origins of fields.
void set_origins(lua_State* L, const Card& card) {
  put(L, "kind", card::kind(card), "source", card.source);
  const auto& provenance = card.provenance;
  if (provenance.empty()) return;
  lua_newtable(L);
  for (const auto& [field, words] : provenance) put(L, field.c_str(), words);
  lua_setfield(L, -2, "provenance");
  if (card.ranges.empty()) return;
  lua_newtable(L);
  for (const auto& [field, range] : card.ranges) {
    lua_createtable(L, 2, 0);
    for (int i = 0; i < 2; ++i) {
      lua_pushnumber(L, range[static_cast<std::size_t>(i)]);
      lua_rawseti(L, -2, i + 1);
    }
    lua_setfield(L, -2, field.c_str());
  }
  lua_setfield(L, -2, "ranges");
}

// Makes the tables in the one on top of the stack metatables.
void show_tables_in(lua_State* L, const char* name) {
  luaL_checkstack(L, 12, "card");
  for (lua_pushnil(L); lua_next(L, -2) != 0;) {
    if (lua_istable(L, -1)) make_metatable(L, name);
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -4);
  }
}

// Pushes the hidden table of the card at 1: its fields, and marks for fields that are known but not set.
void push_card(lua_State* L, const Card& card) {
  const FieldTable& table = card::fields(card);
  push_shown(L, table, card, "");
  set_origins(L, card);
  for (const char* name : {"provenance", "ranges"}) {
    if (lua_getfield(L, -1, name) == LUA_TTABLE) {
      show_tables_in(L, name);
      make_metatable(L, name);
      lua_pushvalue(L, -1);
      lua_setfield(L, -3, name);
    }
    lua_pop(L, 1);
  }
  const auto mark = [L](const char* name) {
    if (lua_getfield(L, -1, name) == LUA_TNIL) {
      push_absent(L);
      lua_setfield(L, -3, name);
    }
    lua_pop(L, 1);
  };
  mark("provenance");
  mark("ranges");
  for (const Field& field : table) mark(field.name.c_str());
  // The metatables by name, needed when a part is forgotten.
  lua_newtable(L);
  for (lua_pushnil(L); lua_next(L, -3) != 0;) {
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -4);
  }
  lua_rawseti(L, -2, 1);
}

}  // namespace

void push_card_table(lua_State* L, const Card& card) {
  push_plain(L, card::fields(card), card);
  set_origins(L, card);
}

bool push_card_field(lua_State* L, const Card* (*card_at)(lua_State*, int)) {
  if (lua_type(L, 1) != LUA_TUSERDATA || lua_getiuservalue(L, 1, 1) != LUA_TTABLE) {
    const Card* card = card_at(L, 1);
    if (card == nullptr) return luaL_error(L, "expected a card, got %s", luaL_typename(L, 1)) != 0;
    lua_settop(L, 2);
    push_card(L, *card);
    lua_pushvalue(L, -1);
    lua_setiuservalue(L, 1, 1);
  }
  lua_pushvalue(L, 2);
  const int type = lua_rawget(L, -2);
  if (type == LUA_TLIGHTUSERDATA) lua_pushnil(L);
  if (type == LUA_TTABLE) hold_part(L);
  return type != LUA_TNIL;
}

}  // namespace fabricsh::script
