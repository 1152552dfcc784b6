// The fields of each kind of card, and what can be done with all of them at once.
#pragma once
#include <string>
#include <vector>

#include "card/field.hpp"

namespace fabricsh::card {

// "woven", "svk", "linear"; the constructors of a deck have the same names.
std::string kind(const Card& card);
// A card of that kind with nothing in it.
Card blank(const std::string& kind);

const FieldTable& fields(const std::string& kind);
inline const FieldTable& fields(const Card& card) { return fields(kind(card)); }
// A field by its path, "warp.poisson"; null: the kind has no such field.
const Field* find_field(const FieldTable& table, const std::string& path);

// The numbers of a group that a confidence band is about, in the order of its rows: of a yarn the
// coefficients of loading, unloading, poisson.
std::vector<double> parameters(const Field& group, const Card& card);
void set_parameters(const Field& group, Card& card, const std::vector<double>& values);

// Refuses a number that is not in its row's range. Error: "card 'x': field 'bending.weft': expected ..., got
// ...".
void require(const Card& card);
// "card 'blend': field 'warp': ", for an error.
std::string at_field(const Card& card, const std::string& path);

// A number that is far from what cloth is: most often in another unit.
struct Doubt {
  std::string field, unit, question;
  double value;
  Range cloth;
};
std::vector<Doubt> doubts(const Card& card);

// The card as a Lua file that reads back equal.
std::string lua_text(const Card& card);

}  // namespace fabricsh::card
