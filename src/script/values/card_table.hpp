// Cards as tables of Lua.
#pragma once
#include <lua.hpp>

#include "card/card.hpp"

namespace fabricsh::script {

// A plain table of the fields of a card's constructor, "kind" and "provenance".
void push_card_table(lua_State* L, const card::Card& card);

// For the card at 1 and the name of a field at 2: pushes its value; false: no field has that name. A list or
// group is a part: a table that is the same at every read until it is written to, and the deck's own from
// then on. What it shows is made once per card object, which card_at gives.
bool push_card_field(lua_State* L, const card::Card* (*card_at)(lua_State*, int));
// Makes a part on top of the stack, and those in it, the plain table that it reads as; anything else stays.
// What looks into a table without its metamethods (lua_next, lua_rawgeti) asks for this first.
void make_plain(lua_State* L);
// Sees to it that Lua's rawset, rawget, rawlen and next know of parts.
void know_parts(lua_State* L);

// Remembers that the table at `part` was read off the card at `card`, and pushes that card, or nil.
void remember_part(lua_State* L, int part, int card);
void push_card_of(lua_State* L, int part);

}  // namespace fabricsh::script
