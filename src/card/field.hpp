// The rows of a card's fields (base/field.hpp), and those that only cards have: curves.
#pragma once
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

}  // namespace fabricsh::card
