// One row per field of a card. Reading it from a deck, writing it, printing it for people, its checks, its
// help and its page of the reference all go through that row, so that a field is told of in one place
// (fields.cpp).
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/range.hpp"
#include "card/card.hpp"

namespace fabricsh::card {

using Points = std::vector<std::pair<double, double>>;
// What a field holds; monostate where the card has no such thing.
using Value = std::variant<std::monostate, double, bool, std::string, std::vector<double>, Points>;

enum class Holds {
  number,
  flag,
  text,     // a word of `words`, or any text where there are none
  numbers,  // as many as `parts` names, or any number of them
  ratios,   // the same; one number stands for all
  curve,    // coefficients of a tangent modulus, or points from (0, 0) on that rise
  number_or_curve,
  group,  // fields of its own
};

// What a row says of its field. Units are SI.
struct Row {
  std::string name;
  Holds holds = Holds::number;
  std::string unit;
  Range range;
  std::string sentence;
  bool required = true;
  Value fallback;                  // where the deck does not say
  std::vector<std::string> words;  // that a text may be
  std::vector<std::string> parts;  // of numbers: "nu12", "nu21"; of a curve what its points are
  Range cloth;  // outside: a question, most often about units. A curve is asked by its beginning
  std::string question;
  bool measured = false;  // a confidence band is about it
  // In the text of a card: on the line of the field before; below it, inside a group; each field of a group
  // on a line of its own; left out where it is the fallback; behind all others, also where it is printed.
  bool beside = false, below = false, tall = false, rare = false, last = false;
  // For people: where it is printed, and how. With a column it is a cell of the table at the top, else a
  // phrase on a line; `line` is the title of that row or line where it is not the group's, or the field's
  // own, name (numbers in a column: a row for each of `lines`). "# mN" with the scale 1000 prints 0.002 as "2
  // mN". No phrase: not printed.
  std::string column, line, phrase;
  std::vector<std::string> lines;
  double scale = 1;
};

template <class Owner>
struct FieldOf : Row {
  std::function<Value(const Owner&)> get;
  std::function<void(Owner&, const Value&)> set;
  std::function<std::string(const Owner&)> say;  // instead of the phrase; "": nothing to say
  // Of a group: is it there, and make it so.
  std::function<bool(const Owner&)> there;
  std::function<void(Owner&)> make;
  std::vector<FieldOf> rows;

  FieldOf optional() const {
    return with([](FieldOf& f) { f.required = false; });
  }
  FieldOf or_else(Value value) const {
    return with([&](FieldOf& f) { f.required = false, f.fallback = std::move(value); });
  }
  FieldOf ask(double low, double high, std::string question) const {
    return with([&](FieldOf& f) { f.cloth = {low, high}, f.question = std::move(question); });
  }
  FieldOf band() const {
    return with([](FieldOf& f) { f.measured = true; });
  }
  FieldOf same_line() const {
    return with([](FieldOf& f) { f.beside = true; });
  }
  FieldOf next_line() const {
    return with([](FieldOf& f) { f.below = true; });
  }
  FieldOf on_lines() const {
    return with([](FieldOf& f) { f.tall = true; });
  }
  FieldOf unless_fallback() const {
    return with([](FieldOf& f) { f.rare = true; });
  }
  FieldOf written_last() const {
    return with([](FieldOf& f) { f.last = true; });
  }
  FieldOf in_column(std::string title, double by = 1, std::string row = "") const {
    return with([&](FieldOf& f) { f.column = std::move(title), f.scale = by, f.line = std::move(row); });
  }
  FieldOf in_rows(std::vector<std::string> rows_) const {
    return with([&](FieldOf& f) { f.lines = std::move(rows_); });
  }
  FieldOf on_line(std::string title) const {
    return with([&](FieldOf& f) { f.line = std::move(title); });
  }
  FieldOf printed(std::string words_, double by = 1) const {
    return with([&](FieldOf& f) { f.phrase = std::move(words_), f.scale = by; });
  }
  FieldOf said(std::function<std::string(const Owner&)> words_) const {
    return with([&](FieldOf& f) { f.say = std::move(words_); });
  }
  FieldOf unprinted() const { return printed(""); }

 private:
  template <class Change>
  FieldOf with(const Change& change) const {
    FieldOf copy = *this;
    change(copy);
    return copy;
  }
};

// --- rows out of members ---

template <class Owner>
FieldOf<Owner> row(std::string name, Holds holds, std::string unit, Range range, std::string sentence) {
  FieldOf<Owner> f;
  f.phrase = name + " #" + (unit.empty() ? "" : " " + unit);
  f.name = std::move(name);
  f.holds = holds;
  f.unit = std::move(unit);
  f.range = range;
  f.sentence = std::move(sentence);
  return f;
}

template <class T, class Owner>
FieldOf<Owner> member(T Owner::*place, FieldOf<Owner> f) {
  f.get = [place](const Owner& o) { return Value(o.*place); };
  f.set = [place](Owner& o, const Value& v) { o.*place = std::get<T>(v); };
  return f;
}

template <class Owner>
FieldOf<Owner> number(std::string name, double Owner::*place, std::string unit, Range range,
                      std::string sentence) {
  return member(place,
                row<Owner>(std::move(name), Holds::number, std::move(unit), range, std::move(sentence)));
}

template <class Owner>
FieldOf<Owner> numbers(std::string name, std::vector<double> Owner::*place, std::string unit,
                       std::string sentence) {
  return member(place, row<Owner>(std::move(name), Holds::numbers, std::move(unit), {}, std::move(sentence)));
}

template <class Owner>
FieldOf<Owner> flag(std::string name, bool Owner::*place, std::string sentence) {
  return member(place, row<Owner>(std::move(name), Holds::flag, "", {}, std::move(sentence)));
}

template <class Owner>
FieldOf<Owner> text(std::string name, std::string Owner::*place, std::string sentence) {
  return member(place, row<Owner>(std::move(name), Holds::text, "", {}, std::move(sentence)));
}

// words: of the enumerators, in their order; the first one is the fallback.
template <class Owner, class Enum>
FieldOf<Owner> word(std::string name, Enum Owner::*place, std::vector<std::string> words,
                    std::string sentence) {
  auto f = row<Owner>(std::move(name), Holds::text, "", {}, std::move(sentence)).or_else(words.front());
  f.words = words;
  f.get = [place, words](const Owner& o) { return Value(words.at(static_cast<std::size_t>(o.*place))); };
  f.set = [place, words](Owner& o, const Value& v) {
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == std::get<std::string>(v)) o.*place = static_cast<Enum>(i);
  };
  return f;
}

template <class Owner>
FieldOf<Owner> curve(std::string name, Curve Owner::*place, std::string sentence) {
  auto f = row<Owner>(std::move(name), Holds::curve, "Pa", {}, std::move(sentence));
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

// A number, or in its place a curve whose slope at zero it stands for.
template <class Owner>
FieldOf<Owner> number_or_curve(std::string name, double Owner::*place, Curve Owner::*as_curve,
                               std::string unit, Range range, std::string sentence) {
  auto f = curve(std::move(name), as_curve, std::move(sentence));
  f.holds = Holds::number_or_curve;
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

// --- rows of a part as rows of the whole ---

// enter: from the whole to its part, as a reference.
template <class Whole, class Part, class Enter>
FieldOf<Whole> lifted(const FieldOf<Part>& f, Enter enter) {
  FieldOf<Whole> out;
  static_cast<Row&>(out) = f;
  if (f.get) out.get = [get = f.get, enter](const Whole& w) { return get(enter(w)); };
  if (f.set) out.set = [set = f.set, enter](Whole& w, const Value& v) { set(enter(w), v); };
  if (f.say) out.say = [say = f.say, enter](const Whole& w) { return say(enter(w)); };
  if (f.there) out.there = [there = f.there, enter](const Whole& w) { return there(enter(w)); };
  if (f.make) out.make = [make = f.make, enter](Whole& w) { make(enter(w)); };
  for (const auto& r : f.rows) out.rows.push_back(lifted<Whole>(r, enter));
  return out;
}

template <class Whole, class Part, class Enter>
FieldOf<Whole> grouped(std::string name, const std::vector<FieldOf<Part>>& rows, Enter enter,
                       std::string sentence) {
  auto f = row<Whole>(std::move(name), Holds::group, "", {}, std::move(sentence));
  f.there = [](const Whole&) { return true; };
  f.make = [](Whole&) {};
  for (const auto& r : rows) f.rows.push_back(lifted<Whole>(r, enter));
  return f;
}

template <class Whole, class Part>
FieldOf<Whole> group(std::string name, Part Whole::*place, const std::vector<FieldOf<Part>>& rows,
                     std::string sentence) {
  const auto enter = [place](auto& w) -> auto& { return w.*place; };
  return grouped<Whole>(std::move(name), rows, enter, std::move(sentence));
}

template <class Whole, class Part>
FieldOf<Whole> group(std::string name, std::optional<Part> Whole::*place,
                     const std::vector<FieldOf<Part>>& rows, std::string sentence) {
  const auto enter = [place](auto& w) -> auto& { return *(w.*place); };
  auto f = grouped<Whole>(std::move(name), rows, enter, std::move(sentence)).optional();
  f.there = [place](const Whole& w) { return (w.*place).has_value(); };
  f.make = [place](Whole& w) { (w.*place).emplace(); };
  return f;
}

using Field = FieldOf<Card>;
using FieldTable = std::vector<Field>;

}  // namespace fabricsh::card
