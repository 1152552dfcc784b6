// Printing a card: a table with units, from the rows of its fields.
#include <algorithm>

#include "base/number.hpp"
#include "card/fields.hpp"
#include "law/provenance.hpp"
#include "script/call/push.hpp"
#include "script/show/show.hpp"

namespace fabricsh::script {

using card::Card;
using card::Field;
using card::FieldType;

namespace {

std::string say(double x) { return fabricsh::number(x, 4); }

// Replaces the mark in a phrase: "2 mN" from "# mN".
std::string filled(const std::string& phrase, const std::string& words) {
  const auto place = phrase.find('#');
  return place == std::string::npos ? phrase : phrase.substr(0, place) + words + phrase.substr(place + 1);
}

std::string list_words(const std::vector<double>& values, double scale) {
  std::string words;
  for (const double x : values) words += (words.empty() ? "" : ", ") + say(x * scale);
  return words;
}

std::string value_words(const card::Value& value, double scale) {
  if (const auto* x = std::get_if<double>(&value)) return say(*x * scale);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* words = std::get_if<std::string>(&value)) return *words;
  if (const auto* many = std::get_if<std::vector<double>>(&value)) return list_words(*many, scale);
  return "";
}

// Positions by name, in the order of first use.
template <class T>
struct Ordered {
  std::vector<std::pair<std::string, T>> all;
  T& at(const std::string& name) {
    for (auto& [known, value] : all)
      if (known == name) return value;
    return all.emplace_back(name, T{}).second;
  }
};

class Print {
 public:
  explicit Print(const Card& card) : card_(card) {
    for (const bool last : {false, true})
      for (const Field& field : card::fields(card))
        if (field.last == last) add(field, field.name);
    for (const auto& [title, words] : later_) phrase(title, words);
    if (!card.source.empty()) lines_.at("source") = card.source;
    for (const auto& [field, words] : card.provenance) {
      std::string& line = lines_.at(field);  // after the field's own text
      line += (line.empty() ? "" : "; ") + words + law::range_text(card, field);
    }
  }

  std::vector<std::vector<std::string>> rows() const {
    std::vector<std::vector<std::string>> out;
    if (!table_.all.empty()) out.push_back({""});
    for (const auto& [title, at] : columns_.all) out.front().push_back(title);
    for (const auto& [title, cells] : table_.all) {
      out.push_back({title});
      for (const std::string& cell : cells) out.back().push_back(cell);
    }
    for (const auto& [title, words] : lines_.all) out.push_back({title, words});
    return out;
  }

 private:
  // whole: name of the card's field to which it belongs.
  void add(const Field& field, const std::string& whole) {
    if (field.holds == FieldType::group) {
      if (field.there(card_))
        for (const Field& part : field.rows) add(part, whole);
      return;
    }
    const card::Value value = field.get ? field.get(card_) : card::Value();
    if (std::holds_alternative<std::monostate>(value)) return;
    const std::string title = field.line.empty() ? whole : field.line;
    const bool foreign =
        title != whole && field.name != whole;  // belongs to a group, but is printed on another's line
    if (const auto* many = std::get_if<std::vector<double>>(&value); many && !field.lines.empty())
      for (std::size_t i = 0; i < many->size(); ++i)
        cell(field.lines.at(i), field.column, say((*many)[i] * field.scale));
    else if (!field.column.empty())
      cell(title, field.column, field.say ? field.say(card_) : value_words(value, field.scale));
    else if (foreign)
      later_.emplace_back(title, words(field, value));
    else
      phrase(title, words(field, value));
  }

  std::string words(const Field& field, const card::Value& value) const {
    if (field.say) return field.say(card_);
    if (field.phrase.empty() || (field.rare && value == field.fallback)) return "";
    return filled(field.phrase, value_words(value, field.scale));
  }

  void cell(const std::string& row, const std::string& column, const std::string& words) {
    auto& place = columns_.at(column);
    if (place == 0) place = columns_.all.size();
    auto& cells = table_.at(row);
    cells.resize(std::max(cells.size(), place));
    cells[place - 1] = words;
  }

  void phrase(const std::string& title, const std::string& words) {
    if (words.empty()) return;
    std::string& line = lines_.at(title);
    line += (line.empty() ? "" : ", ") + words;
  }

  const Card& card_;
  Ordered<std::size_t> columns_;  // indices, from 1
  Ordered<std::vector<std::string>> table_;
  Ordered<std::string> lines_;
  std::vector<std::pair<std::string, std::string>> later_;
};

}  // namespace

std::string card_words(const Card& card) {
  std::string out = "<card " + (card.name.empty() ? "without name" : card.name) + ", " + card::kind(card) +
                    ", " + say(card.density) + " kg m^-3, " + say(card.thickness * 1e3) + " mm, " +
                    say(card.density * card.thickness * 1e3) + " g m^-2>";
  out += "\n" + columns_text(Print(card).rows());
  out.pop_back();
  return out;
}

}  // namespace fabricsh::script
