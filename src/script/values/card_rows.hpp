// The argument rows of a card's constructor, and the card made from a checked table.
#pragma once
#include <string>
#include <vector>

#include "card/card.hpp"
#include "script/call/call.hpp"

namespace fabricsh::script {

// Registry key: tables that were read from cards, with their cards, as long as they exist.
inline constexpr const char* parts_key = "fabricsh.card_parts";

// kind: "woven", "svk" or "linear".
const std::vector<Argument>& card_rows(const std::string& kind);
card::Card card_from(const Fields& fields, const std::string& kind);

}  // namespace fabricsh::script
