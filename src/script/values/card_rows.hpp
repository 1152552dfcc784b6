// The argument rows of a card's constructor, and the card made from a checked table.
#pragma once
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

}  // namespace fabricsh::script
