// Operations on all fields of a card at once.
#include <cmath>

#include "base/error.hpp"
#include "base/number.hpp"
#include "card/fields.hpp"

namespace fabricsh::card {

namespace {

// Calls visit(path, field, value) for every field that the card has, except groups.
template <class Visit>
void visit_fields(const FieldTable& table, const Card& card, const std::string& path, const Visit& visit) {
  for (const Field& field : table) {
    if (field.holds == FieldType::group) {
      if (field.there(card)) visit_fields(field.rows, card, path + field.name + ".", visit);
    } else if (field.get) {
      const Value value = field.get(card);
      if (!std::holds_alternative<std::monostate>(value)) visit(path + field.name, field, value);
    }
  }
}

double initial_modulus(const Value& curve) {
  if (const auto* points = std::get_if<Points>(&curve))
    return points->size() > 1 ? (*points)[1].second / (*points)[1].first : 0.0;
  const auto& coefficients = std::get<std::vector<double>>(curve);
  return coefficients.empty() ? 0.0 : coefficients.front();
}

// The number that is compared with the usual range for cloth.
std::optional<double> compared_number(const Field& field, const Value& value) {
  if (const auto* x = std::get_if<double>(&value)) return *x;
  if (field.holds == FieldType::curve) return initial_modulus(value);
  return {};
}

}  // namespace

const Field* find_field(const FieldTable& table, const std::string& path) {
  const auto dot = path.find('.');
  for (const Field& field : table)
    if (field.name == path.substr(0, dot))
      return dot == std::string::npos ? &field : find_field(field.rows, path.substr(dot + 1));
  return nullptr;
}

namespace {

// Calls visit(x) for every number of a measured value to which bands refer: of points, their ordinates beyond
// the origin.
template <class AnyValue, class Visit>
void visit_numbers(AnyValue& value, const Visit& visit) {
  if (auto* one = std::get_if<double>(&value)) visit(*one);
  if (auto* many = std::get_if<std::vector<double>>(&value))
    for (auto& x : *many) visit(x);
  if (auto* points = std::get_if<Points>(&value))
    for (auto& [x, y] : *points)
      if (x != 0) visit(y);
}

}  // namespace

namespace {

// Calls visit(field) for every field of a group to which bands refer, also of the groups in it that the card
// has.
template <class Visit>
void visit_measured(const Field& group, const Card& card, const Visit& visit) {
  if (!group.there(card)) return;
  for (const Field& field : group.rows) {
    if (field.holds == FieldType::group)
      visit_measured(field, card, visit);
    else if (field.measured)
      visit(field);
  }
}

}  // namespace

std::vector<double> parameters(const Field& group, const Card& card) {
  std::vector<double> out;
  visit_measured(group, card, [&](const Field& field) {
    const Value value = field.get(card);
    visit_numbers(value, [&](double x) { out.push_back(x); });
  });
  return out;
}

void set_parameters(const Field& group, Card& card, const std::vector<double>& values) {
  auto next = values.begin();
  visit_measured(group, card, [&](const Field& field) {
    Value value = field.get(card);
    visit_numbers(value, [&](double& x) { x = *next++; });
    field.set(card, value);
  });
}

std::string at_field(const Card& card, const std::string& path) {
  return (card.name.empty() ? "the card" : "card '" + card.name + "'") + ": field '" + path + "': ";
}

std::optional<Clash> clash(const Card& card) {
  const auto* woven = std::get_if<Woven>(&card.law);
  if (woven == nullptr || woven->law == LawKind::potential) return {};
  const char* kind = law_words[static_cast<std::size_t>(woven->law)];
  const auto of = [&](const char* field) {
    return Clash{
        field,
        std::string("expected law = \"potential\", the only one that takes it, got law = \"") + kind + "\""};
  };
  if (woven->warp.loop) return of("warp.loop");
  if (woven->weft.loop) return of("weft.loop");
  if (woven->shear.friction) return of("shear.friction");
  std::optional<Clash> found;
  rheology::for_each([&](auto element, auto given, auto) {
    if (!found && woven->parallel.*given) found = of(element.name);
  });
  return found;
}

void require(const Card& card) {
  if (const auto found = clash(card)) throw Error(at_field(card, found->field) + found->words);
  visit_fields(fields(card), card, "", [&](const std::string& path, const Field& field, const Value& value) {
    const auto refuse = [&](double x) {
      throw Error(at_field(card, path) + "expected " + number_words(field.range, field.unit) + ", got " +
                  fabricsh::number(x));
    };
    const auto check = [&](double x) {
      if (!std::isfinite(x) || !field.range.holds(x)) refuse(x);
    };
    if (const auto* x = std::get_if<double>(&value)) check(*x);
    if (field.check)
      if (const std::string fault = field.check(std::get<Points>(value)); !fault.empty())
        throw Error(at_field(card, path) + fault);
    if (field.holds == FieldType::ratios || field.holds == FieldType::numbers)
      for (const double x : std::get<std::vector<double>>(value)) check(x);
  });
}

std::vector<UnusualValue> doubts(const Card& card) {
  std::vector<UnusualValue> out;
  visit_fields(fields(card), card, "", [&](const std::string& path, const Field& field, const Value& value) {
    const auto x = compared_number(field, value);
    if (x && *x > 0 && !field.question.empty() && !field.cloth.holds(*x))
      out.push_back({path, field.unit, field.question, *x, field.cloth});
  });
  return out;
}

}  // namespace fabricsh::card
