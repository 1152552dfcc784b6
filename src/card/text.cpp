// Writes a card as a Lua file.
#include "base/number.hpp"
#include "card/fields.hpp"

namespace fabricsh::card {

namespace {

std::string quoted(const std::string& words) {
  std::string out = "\"";
  for (const char c : words) {
    if (c == '\n') {
      out += "\\n";
    } else if (c == '\r') {
      out += "\\r";
    } else if (c == '\0') {
      out += "\\000";  // all digits, since the next character may be one
    } else {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
  }
  return out + "\"";
}

// Minus zero is written without its sign, because Lua would not read the sign back.
std::string text_of(double x) { return exact_number(x == 0 ? 0.0 : x); }

std::string text_of(const std::vector<double>& values) {
  std::string out = "{";
  for (const double v : values) out += (out.size() > 1 ? ", " : "") + text_of(v);
  return out + "}";
}

std::string text_of(const Points& points) {
  std::string out = "{";
  for (const auto& [x, y] : points)
    out += (out.size() > 1 ? ", {" : " {") + text_of(x) + ", " + text_of(y) + "}";
  return out + " }";
}

struct ValueText {
  std::string operator()(std::monostate) const { return "nil"; }
  std::string operator()(double x) const { return text_of(x); }
  std::string operator()(bool flag) const { return flag ? "true" : "false"; }
  std::string operator()(const std::string& words) const { return quoted(words); }
  std::string operator()(const std::vector<double>& values) const { return text_of(values); }
  std::string operator()(const Points& points) const { return text_of(points); }
};

bool written(const Field& field, const Card& card) {
  if (field.holds == FieldType::group) return field.there(card);
  if (!field.get) return false;
  const Value value = field.get(card);
  return !std::holds_alternative<std::monostate>(value) && !(field.rare && value == field.fallback);
}

std::string field_text(const Field& field, const Card& card, const std::string& indent);

std::string group_text(const Field& group, const Card& card, const std::string& indent) {
  const std::string deeper = indent + "  ";
  std::string out;
  for (const Field& field : group.rows) {
    if (!written(field, card)) continue;
    if (!out.empty()) out += group.tall || field.below ? ",\n" + deeper : ", ";
    out += field_text(field, card, deeper);
  }
  return "{ " + out + (group.tall ? ",\n" + indent + "}" : " }");
}

std::string field_text(const Field& field, const Card& card, const std::string& indent) {
  return field.name + " = " +
         (field.holds == FieldType::group ? group_text(field, card, indent)
                                          : std::visit(ValueText{}, field.get(card)));
}

std::string provenance_text(const Provenance& provenance) {
  std::string out = "\n  provenance = {";
  for (const auto& [field, words] : provenance)
    out += "\n    [" + quoted(field) + "] = " + quoted(words) + ",";
  return out + "\n  },";
}

std::string ranges_text(const Ranges& ranges) {
  std::string out = "\n  ranges = { ";
  for (const auto& [field, range] : ranges)
    out += (out.ends_with("{ ") ? "[" : ", [") + quoted(field) + "] = { " + exact_number(range[0]) + ", " +
           exact_number(range[1]) + " }";
  return out + " },";
}

}  // namespace

std::string lua_text(const Card& card) {
  std::string out =
      "-- SI units: Pa, m, kg/m^3; strains are Green-Lagrange, tensor components.\n"
      "local fabric = require \"fabric\"\nreturn fabric." +
      kind(card) + "{";
  for (const bool last : {false, true})
    for (const Field& field : fields(card))
      if (field.last == last && written(field, card))
        out += (field.beside ? " " : "\n  ") + field_text(field, card, "  ") + ",";
  if (!card.provenance.empty()) out += provenance_text(card.provenance);
  if (!card.ranges.empty()) out += ranges_text(card.ranges);
  return out + "\n}\n";
}

}  // namespace fabricsh::card
