// The origins of the numbers of a card (card::Provenance): which fields have one, and the words it begins
// with.
#pragma once
#include <string>
#include <vector>

#include "card/card.hpp"

namespace fabricsh::law {

using card::Provenance;

// The fields whose origin can be stated, and the words with which an origin begins.
const std::vector<std::string>& provenance_fields();
const std::vector<std::string>& provenance_origins();
bool is_origin(const std::string& words);
bool is_assumed(const card::Card& card, const std::string& field);
// Removes the ranges of fields that are not assumed, as after a change of the card.
void drop_ranges(card::Card& card);
// "; 0.1 to 0.6" or "; 0.5 to 2 times"; empty: the field has no range.
std::string range_text(const card::Card& card, const std::string& field);

// The first line of a source that states an origin as cards of releases before 0.4 were written,
// "warp.loading: fitted to ..."; empty: none. Such lines are words like any others.
std::string line_of_origin(const std::string& source);

}  // namespace fabricsh::law
