// The parts of a card in Lua. The deck reads card.warp as a table that stays empty: its metatable refers to
// hidden tables with the values of the card, made once and never given to a deck. When the table is written
// to, it becomes a plain table with a copy of all values, detached from the card: the next read of card.warp
// gives a new one.
#pragma once
#include <lua.hpp>
#include <string>

namespace fabricsh::script {

// Replaces a table, or a block of points, on top of the stack by the metatable for its parts. The card is at
// 1; name: that of the card's field.
void make_metatable(lua_State* L, const std::string& name);
// Replaces a metatable on top of the stack by a new part, which is stored in the card's hidden table, the
// value below, under the name at 2. A part that is stored already is kept.
void hold_part(lua_State* L);
// Pushes the mark for a field that is known but not set.
void push_absent(lua_State* L);

// Converts a part on top of the stack, and the parts in it, to plain tables; other values are kept. To be
// called before tables are read without metamethods (lua_next, lua_rawgeti).
void make_plain(lua_State* L);
// Replaces Lua's rawset, rawget, rawlen and next by functions that handle parts.
void know_parts(lua_State* L);

// Records that the table at `part` was read from the card at `card`, and pushes that card, or nil.
void remember_part(lua_State* L, int part, int card);
void push_card_of(lua_State* L, int part);

}  // namespace fabricsh::script
