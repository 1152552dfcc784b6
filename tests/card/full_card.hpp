// A card of a kind in which every field of its table has a value of its own that is not the fallback.
#pragma once
#include <algorithm>
#include <cmath>

#include "card/fields.hpp"

namespace fabricsh::test {

namespace detail {

// A number in the row's range, another one each time.
inline double next_number(const card::FieldRow& row, int& count) {
  double x = 0.25 + 1e-3 * ++count;
  if (!row.range.holds(x)) x = (row.range.low + row.range.high) / 2 + 1e-6 * count;
  return x;
}

inline card::Value next_value(const card::Field& field, int& count) {
  switch (field.holds) {
    case card::FieldType::number:
      return next_number(field, count);
    case card::FieldType::flag:
      return !std::get<bool>(field.fallback);
    case card::FieldType::text:
      return field.words.empty() ? "words \"" + std::to_string(++count) + "\"\n" : field.words.back();
    case card::FieldType::curve:
    case card::FieldType::number_or_curve:
      return std::vector{1e6 + ++count, 2e7 + ++count};
    case card::FieldType::points:
      ++count;
      return card::Points{{1e-4 * count, 5e3 * count}, {2e-4 * count, 50.0 * count}};
    default:
      break;
  }
  const std::size_t n = field.parts.empty() ? 1 : field.parts.size();
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(next_number(field, count));
  return values;
}

inline void fill(const card::FieldTable& table, card::Card& card, int& count) {
  for (const card::Field& field : table) {
    if (field.name == "young") continue;  // stands for others
    if (field.holds == card::FieldType::group) {
      field.make(card);
      fill(field.rows, card, count);
    } else {
      field.set(card, next_value(field, count));
    }
  }
}

}  // namespace detail

inline card::Card full_card(const std::string& kind) {
  card::Card card = card::blank(kind);
  int count = 0;
  detail::fill(card::fields(kind), card, count);
  if (auto* woven = std::get_if<card::Woven>(&card.law)) {
    woven->law = card::LawKind::potential;  // the only one that takes all parts
    for (const auto& [part, place] : card::banded_parts) {
      const std::size_t n = parameters(*card::find_field(card::fields(card), part), card).size();
      auto& band = *woven->bands.*place;
      band.low.resize(n), band.high.resize(n), band.covariance.resize(n * n);
      for (std::size_t i = 1; i < n; ++i)
        band.covariance[i * n + i] = 0.5;  // no part goes along with another
    }
  }
  return card;
}

}  // namespace fabricsh::test
