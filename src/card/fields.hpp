// The fields of each kind of card, and operations on all of them at once.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/field.hpp"
#include "card/card.hpp"

namespace fabricsh::card {

using field::FieldOf;
using field::FieldRow;
using field::FieldType;
using field::Points;
using field::Value;
// Makers of rows.
using field::flag;
using field::group;
using field::grouped;
using field::lifted;
using field::member;
using field::number;
using field::numbers;
using field::points;
using field::row;
using field::text;
using field::word;

template <class Owner>
FieldOf<Owner> curve(std::string name, Curve Owner::*place, std::string sentence) {
  auto f = row<Owner>(std::move(name), FieldType::curve, "Pa", {}, std::move(sentence));
  f.parts = {"strain", "stress"};
  f.get = [place](const Owner& o) {
    const Curve& c = o.*place;
    return c.points.empty() ? Value(c.coefficients) : Value(c.points);
  };
  f.set = [place](Owner& o, const Value& v) {
    o.*place = {};
    if (const auto* points = std::get_if<Points>(&v))
      (o.*place).points = *points;
    else
      (o.*place).coefficients = std::get<std::vector<double>>(v);
  };
  return f;
}

// A number, or in its place a curve; the number is then the slope of the curve at zero.
template <class Owner>
FieldOf<Owner> number_or_curve(std::string name, double Owner::*place, Curve Owner::*as_curve,
                               std::string unit, Range range, std::string sentence) {
  auto f = curve(std::move(name), as_curve, std::move(sentence));
  f.holds = FieldType::number_or_curve;
  f.unit = std::move(unit);
  f.range = range;
  f.get = [place, as_curve](const Owner& o) {
    const Curve& c = o.*as_curve;
    if (!c.points.empty()) return Value(c.points);
    return c.coefficients.empty() ? Value(o.*place) : Value(c.coefficients);
  };
  f.set = [place, as_curve, as_one = f.set](Owner& o, const Value& v) {
    o.*as_curve = {};
    if (const auto* x = std::get_if<double>(&v)) {
      o.*place = *x;
      return;
    }
    as_one(o, v);
    const Curve& c = o.*as_curve;
    o.*place = c.points.empty() ? c.coefficients.at(0) : c.points.at(1).second / c.points.at(1).first;
  };
  return f;
}

using Field = FieldOf<Card>;
using FieldTable = std::vector<Field>;

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
