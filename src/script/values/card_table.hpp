// Cards as tables of Lua.
#pragma once
#include <lua.hpp>

#include "card/card.hpp"

namespace fabricsh::script {

// Pushes a plain table with the fields of a card's constructor, "kind" and "provenance".
void push_card_table(lua_State* L, const card::Card& card);

// For the card at 1 and a field's name at 2: pushes the value; false if there is no such field. A list or
// group is a part: reads return the same table until it is written to and so becomes a plain table of the
// deck. Its values are made once per card object, which card_at returns.
bool push_card_field(lua_State* L, const card::Card* (*card_at)(lua_State*, int));
// Converts a part on top of the stack, and the parts in it, to plain tables; other values are kept. To be
// called before tables are read without metamethods (lua_next, lua_rawgeti).
void make_plain(lua_State* L);
// Replaces Lua's rawset, rawget, rawlen and next by functions that handle parts.
void know_parts(lua_State* L);

// Records that the table at `part` was read from the card at `card`, and pushes that card, or nil.
void remember_part(lua_State* L, int part, int card);
void push_card_of(lua_State* L, int part);

}  // namespace fabricsh::script
