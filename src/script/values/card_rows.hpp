// The argument rows of a card's constructor, and the card made from a checked table.
#pragma once
#include <lua.hpp>
#include <string>
#include <vector>

#include "card/card.hpp"
#include "script/call/call.hpp"

namespace fabricsh::script {

// kind: "woven", "svk" or "linear".
const std::vector<Argument>& card_rows(const std::string& kind);
card::Card card_from(const Fields& fields, const std::string& kind);
// Makes a card from the table of its constructor.
card::Card read_card(lua_State* L, int index, const std::string& kind);

// --- Cards as tables of Lua.

// Pushes a plain table with the fields of a card's constructor, "kind" and "provenance".
void push_card_table(lua_State* L, const card::Card& card);

// For the card at 1 and a field's name at 2: pushes the value; false if there is no such field. A list or
// group is a part: reads return the same table until it is written to and so becomes a plain table of the
// deck. Its values are made once per card object, which card_at returns.
bool push_card_field(lua_State* L, const card::Card* (*card_at)(lua_State*, int));

}  // namespace fabricsh::script
