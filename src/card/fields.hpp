// The fields of each kind of card, and operations on all of them at once.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "card/field.hpp"

namespace fabricsh::card {

// "woven", "svk" or "linear": the names of the constructors in decks.
std::string kind(const Card& card);
// An empty card of that kind.
Card blank(const std::string& kind);

const FieldTable& fields(const std::string& kind);
inline const FieldTable& fields(const Card& card) { return fields(kind(card)); }
// Finds a field by its path, "warp.poisson"; null if the kind has no such field.
const Field* find_field(const FieldTable& table, const std::string& path);

// The numbers of a group to which confidence bands refer, in the order of
// its rows; for a yarn: the coefficients of loading, unloading, poisson. None
// if the card has no such group.
std::vector<double> parameters(const Field& group, const Card& card);
void set_parameters(const Field& group, Card& card, const std::vector<double>& values);

// A part that the card's law cannot have beside another one: the path of its field, and what was expected.
struct Clash {
  std::string field, words;
};
std::optional<Clash> clash(const Card& card);

// Checks every number against the range in its row, and that no parts clash. Error:
// "card 'x': field 'bending.weft': expected ..., got ...".
void require(const Card& card);
// The beginning of an error message: "card 'blend': field 'warp': ".
std::string at_field(const Card& card, const std::string& path);

// A number outside the usual range for cloth, most often because of a wrong unit.
struct UnusualValue {
  std::string field, unit, question;
  double value;
  Range cloth;
};
std::vector<UnusualValue> doubts(const Card& card);

// The card as a Lua file; reading it gives an equal card.
std::string lua_text(const Card& card);

}  // namespace fabricsh::card
