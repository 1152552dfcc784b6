// One row describes one field of what a deck declares: of a card, or an option of a run. Reading, writing,
// printing, checks, messages, help and the reference page all use that row, so that a field is described in
// one place only, beside the struct that has it.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/range.hpp"

namespace fabricsh::field {

using Points = std::vector<std::pair<double, double>>;
// The value of a field; monostate if its owner does not have it.
using Value = std::variant<std::monostate, double, bool, std::string, std::vector<double>, Points>;

enum class FieldType {
  number,
  integer,  // its value is a double
  flag,
  text,     // one of `words`, or any text if there are none
  numbers,  // one for each name in `parts`, or any number if there are none
  ratios,   // like numbers; a single number stands for all
  curve,    // coefficients of a tangent modulus, or ascending points from (0, 0)
  number_or_curve,
  points,  // pairs of two numbers that satisfy `check`
  group,   // contains fields of its own
};

// The description of a field. Units are SI.
struct FieldRow {
  std::string name;
  FieldType holds = FieldType::number;
  std::string unit;
  Range range;
  std::string sentence;
  bool required = true;
  Value fallback;                  // used if the deck does not give the field
  std::string without;             // in words, what holds if it has neither: "duration/20"
  std::vector<std::string> words;  // the permitted texts
  std::vector<std::string> parts;  // names of the numbers, "nu12", "nu21"; of a curve: its coordinates
  // Returns what is wrong with points, "expected ..., got ...", or an empty text.
  std::function<std::string(const Points&)> check;
  Range cloth;  // usual range for cloth; outside it `question` is asked. For a curve: its slope at 0
  std::string question;
  bool measured = false;  // may have a confidence band
  // In place of a number also accepted: true, which stands for `on`, and false for 0; a word, which leaves
  // the initial value.
  std::optional<double> on;
  std::string word;
  // An option that may change during a run: its place in the settings of a checkpoint, from 1; 0: it may not.
  // A place that has been released is not given to another one.
  int place = 0;
  // An option on which results depend: a checkpoint of a run with another value than the initial one is of
  // another method.
  bool decides = false;
  // Layout in a card's text. beside: on the previous field's line; below: under it, inside a group; tall:
  // each field of a group on its own line; rare: omitted if it is the fallback; last: after all others.
  bool beside = false, below = false, tall = false, rare = false, last = false;
  // Layout when printed for people. With `column` the field is a cell of the table at the top,
  // otherwise a phrase on a line. `line` is the title of that row or line, by default the name
  // of the group or of the field; for numbers in a column, `lines` has one title per number. "#
  // mN" with the scale 1000 prints 0.002 as "2 mN". Without a phrase the field is not printed.
  std::string column, line, phrase;
  std::vector<std::string> lines;
  double scale = 1;
};

template <class Owner>
struct FieldOf : FieldRow {
  std::function<Value(const Owner&)> get;
  std::function<void(Owner&, const Value&)> set;
  std::function<std::string(const Owner&)> say;  // replaces the phrase; "": print nothing
  // For a group: whether the card has it, and a function that creates it.
  std::function<bool(const Owner&)> there;
  std::function<void(Owner&)> make;
  std::vector<FieldOf> rows;

  FieldOf optional() const {
    return with([](FieldOf& f) { f.required = false; });
  }
  FieldOf or_else(Value value) const {
    return with([&](FieldOf& f) { f.required = false, f.fallback = std::move(value); });
  }
  FieldOf or_by(std::string words_) const {
    return with([&](FieldOf& f) { f.required = false, f.without = std::move(words_); });
  }
  FieldOf or_flag(double on_) const {
    return with([&](FieldOf& f) {
      f.on = on_;
      f.set = [on_, as_number = f.set](Owner& o, const Value& v) {
        const auto* flag = std::get_if<bool>(&v);
        as_number(o, flag != nullptr ? Value(*flag ? on_ : 0.0) : v);
      };
    });
  }
  FieldOf or_word(std::string word_) const {
    return with([&](FieldOf& f) {
      f.word = std::move(word_);
      f.set = [as_number = f.set](Owner& o, const Value& v) {
        if (!std::holds_alternative<std::string>(v)) as_number(o, v);
      };
    });
  }
  FieldOf changes(int place_) const {
    return with([&](FieldOf& f) { f.place = place_; });
  }
  FieldOf decisive() const {
    return with([](FieldOf& f) { f.decides = true; });
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

// --- making rows from members ---

template <class Owner>
FieldOf<Owner> row(std::string name, FieldType holds, std::string unit, Range range, std::string sentence) {
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
                row<Owner>(std::move(name), FieldType::number, std::move(unit), range, std::move(sentence)));
}

template <class Owner>
FieldOf<Owner> integer(std::string name, int Owner::*place, Range range, std::string sentence) {
  auto f = row<Owner>(std::move(name), FieldType::integer, "", range, std::move(sentence));
  f.get = [place](const Owner& o) { return Value(static_cast<double>(o.*place)); };
  f.set = [place](Owner& o, const Value& v) { o.*place = static_cast<int>(std::get<double>(v)); };
  return f;
}

template <class Owner>
FieldOf<Owner> numbers(std::string name, std::vector<double> Owner::*place, std::string unit,
                       std::string sentence) {
  return member(place,
                row<Owner>(std::move(name), FieldType::numbers, std::move(unit), {}, std::move(sentence)));
}

// A number that its owner may do without.
template <class Owner>
FieldOf<Owner> number(std::string name, std::optional<double> Owner::*place, std::string unit, Range range,
                      std::string sentence) {
  auto f =
      row<Owner>(std::move(name), FieldType::number, std::move(unit), range, std::move(sentence)).optional();
  f.get = [place](const Owner& o) { return o.*place ? Value(*(o.*place)) : Value(); };
  f.set = [place](Owner& o, const Value& v) { o.*place = std::get<double>(v); };
  return f;
}

// Points that are kept in ascending order, whichever way round they are given.
template <class Owner>
FieldOf<Owner> points(std::string name, Points Owner::*place, std::vector<std::string> parts,
                      std::function<std::string(const Points&)> check, std::string sentence) {
  auto f = row<Owner>(std::move(name), FieldType::points, "", {}, std::move(sentence)).optional();
  f.parts = std::move(parts);
  f.check = std::move(check);
  f.get = [place](const Owner& o) { return (o.*place).empty() ? Value() : Value(o.*place); };
  f.set = [place](Owner& o, const Value& v) {
    o.*place = std::get<Points>(v);
    std::sort((o.*place).begin(), (o.*place).end());
  };
  return f;
}

template <class Owner>
FieldOf<Owner> flag(std::string name, bool Owner::*place, std::string sentence) {
  return member(place, row<Owner>(std::move(name), FieldType::flag, "", {}, std::move(sentence)));
}

template <class Owner>
FieldOf<Owner> text(std::string name, std::string Owner::*place, std::string sentence) {
  return member(place, row<Owner>(std::move(name), FieldType::text, "", {}, std::move(sentence)));
}

// words: names of the enumerators in their order; the first one is the fallback.
template <class Owner, class Enum>
FieldOf<Owner> word(std::string name, Enum Owner::*place, std::vector<std::string> words,
                    std::string sentence) {
  auto f = row<Owner>(std::move(name), FieldType::text, "", {}, std::move(sentence)).or_else(words.front());
  f.words = words;
  f.get = [place, words](const Owner& o) { return Value(words.at(static_cast<std::size_t>(o.*place))); };
  f.set = [place, words](Owner& o, const Value& v) {
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == std::get<std::string>(v)) o.*place = static_cast<Enum>(i);
  };
  return f;
}

// --- making rows of a part into rows of the whole ---

// enter: returns a reference to the part of a whole.
template <class Whole, class Part, class Enter>
FieldOf<Whole> lifted(const FieldOf<Part>& f, Enter enter) {
  FieldOf<Whole> out;
  static_cast<FieldRow&>(out) = f;
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
  auto f = row<Whole>(std::move(name), FieldType::group, "", {}, std::move(sentence));
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

// --- rows of a struct whose initial values are the defaults ---

// A member that begins out of its row's range has no default: it must be given.
template <class Owner>
std::vector<FieldOf<Owner>> with_defaults(std::vector<FieldOf<Owner>> rows) {
  for (auto& f : rows) {
    if (!f.required || f.holds == FieldType::group) continue;
    const Value first = f.get(Owner{});
    const auto* x = std::get_if<double>(&first);
    if (x == nullptr || f.range.holds(*x)) f = f.or_else(first);
  }
  return rows;
}

// "a positive number in s or 'auto'": what a number's row accepts.
std::string expected_number(const FieldRow& row);

// Error, "static: field 'tolerance': expected a number above 0 to below 1, got 2", for a number out of its
// row's range that is not the initial one. path: "damping." in the rows of a group, which is passed over
// where its owner does not have it.
template <class Owner>
void require(const std::string& call, const std::vector<FieldOf<Owner>>& rows, const Owner& owner,
             const std::string& path = {}, const Owner& initial = Owner{}) {
  for (const auto& f : rows) {
    if (f.holds == FieldType::group) {
      if (!f.there(owner)) continue;
      Owner made = initial;
      f.make(made);
      require(call, f.rows, owner, path + f.name + ".", made);
      continue;
    }
    const Value value = f.get(owner);
    const auto* x = std::get_if<double>(&value);
    if (x == nullptr || value == f.get(initial) || (f.range.holds(*x) && std::isfinite(*x))) continue;
    throw Error(call + ": field '" + path + f.name + "': expected " + expected_number(f) + ", got " +
                fabricsh::number(*x));
  }
}

}  // namespace fabricsh::field
