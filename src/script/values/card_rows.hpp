// The fields of a card's constructor, and the card that a checked table of them makes.
#pragma once
#include <string>
#include <vector>

#include "card/card.hpp"
#include "script/call/call.hpp"

namespace fabricsh::script {

// In Lua's registry: the tables that were read off cards, with their cards, for as long as they live.
inline constexpr const char* parts_key = "fabricsh.card_parts";

// kind: "woven", "svk" or "linear".
const std::vector<Argument>& card_rows(const std::string& kind);
card::Card card_from(const Fields& fields, const std::string& kind);

}  // namespace fabricsh::script
