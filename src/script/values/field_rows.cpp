#include "script/values/field_rows.hpp"

#include "base/number.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

using field::FieldRow;
using field::FieldType;

namespace {

unsigned kinds_of(FieldType holds) {
  switch (holds) {
    case FieldType::number:
      return number;
    case FieldType::integer:
      return integer;
    case FieldType::flag:
      return boolean;
    case FieldType::text:
      return text;
    case FieldType::numbers:
      return numbers;
    case FieldType::ratios:
      return number | numbers;
    case FieldType::curve:
      return numbers | table;
    case FieldType::number_or_curve:
      return number | numbers | table;
    case FieldType::points:
      return table;
    default:
      return fields;
  }
}

// Reads pairs of numbers from the table on top of the stack, which is `name` of the table at `path`.
field::Points read_pairs(const Fields& fields, const std::string& path, const FieldRow& row) {
  const std::string &name = row.name, x = row.parts.at(0), y = row.parts.at(1);
  lua_State* L = fields.L();
  field::Points points;
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= n; ++i) {
    lua_rawgeti(L, -1, i);
    const std::string place = std::to_string(i);
    const Argument pair{place + "]", numbers, "", everything, x + " and " + y};
    if (!lua_istable(L, -1) || lua_rawlen(L, -1) != 2)
      fields.refuse(name, "expected {" + x + ", " + y + "} at point " + place + ", got " + describe(L, -1));
    check_value(L, -1, pair, path + name + "[", false);
    const auto xy = read_numbers(L, -1);
    lua_pop(L, 1);
    points.emplace_back(xy[0], xy[1]);
  }
  return points;
}

// Measured points {{E, S}, ...} of a curve that rises from {0, 0} on.
field::Points read_curve_points(const Fields& fields, const std::string& path, const FieldRow& row) {
  const std::string& name = row.name;
  const field::Points points = read_pairs(fields, path, row);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [x, y] = points[i];
    if (i == 0 && (x != 0 || y != 0))
      fields.refuse(name, "expected the first point to be {0, 0}, got {" + exact_number(x) + ", " +
                              exact_number(y) + "}");
    if (i > 0 && (x <= points[i - 1].first || y <= points[i - 1].second))
      fields.refuse(name, "expected " + row.parts[0] + " and " + row.parts[1] + " to increase, at point " +
                              std::to_string(i + 1) + " they do not");
  }
  if (points.size() < 2) fields.refuse(name, "expected at least two points, got one");
  return points;
}

field::Value read_points(const Fields& fields, const FieldRow& row, const std::string& path) {
  fields.push(row.name);
  field::Points points = read_pairs(fields, path, row);
  lua_pop(fields.L(), 1);
  if (const std::string fault = row.check(points); !fault.empty()) fields.refuse(row.name, fault);
  return points;
}

field::Value read_curve(const Fields& fields, const FieldRow& row, const std::string& path) {
  lua_State* L = fields.L();
  field::Value curve;
  fields.push(row.name);
  const bool points = lua_rawgeti(L, -1, 1) == LUA_TTABLE;
  lua_pop(L, 1);
  if (points) {
    curve = read_curve_points(fields, path, row);
  } else {
    check_value(L, -1, {row.name, numbers, row.unit, everything, ""}, path, false);
    curve = read_numbers(L, -1);
  }
  lua_pop(L, 1);
  return curve;
}

std::vector<double> read_parts(const Fields& fields, const FieldRow& row) {
  const auto n = row.parts.size();
  if (row.holds == FieldType::ratios && fields.is(row.name, LUA_TNUMBER))
    return std::vector<double>(n, fields.number(row.name));
  auto values = fields.numbers(row.name);
  if (n == 0 || values.size() == n) return values;
  std::string names;
  for (const std::string& part : row.parts) names += (names.empty() ? "" : ", ") + part;
  fields.refuse(row.name, "expected {" + names + "}, got " + counted(values.size(), "number"));
}

}  // namespace

Argument argument_of(const FieldRow& row) {
  Argument out{row.name, kinds_of(row.holds), row.unit, row.range, row.sentence, row.required};
  if (const auto* x = std::get_if<double>(&row.fallback)) out.fallback = *x;
  if (const auto* flag = std::get_if<bool>(&row.fallback)) out.fallback = *flag;
  if (const auto* words = std::get_if<std::string>(&row.fallback)) out.fallback = *words;
  if (!row.without.empty()) out.sentence += "; default " + row.without;
  out.choices = row.words;
  if (row.on) out.kinds |= boolean;
  if (!row.word.empty()) out.kinds |= text, out.choices = {row.word};
  out.usual = row.cloth;
  out.hint = row.question;
  return out;
}

field::Value read_value(const Fields& fields, const FieldRow& row, const std::string& path) {
  if (row.on && fields.is(row.name, LUA_TBOOLEAN)) return fields.flag(row.name);
  if (!row.word.empty() && fields.is(row.name, LUA_TSTRING)) return row.word;
  switch (row.holds) {
    case FieldType::number:
      return fields.number(row.name);
    case FieldType::integer:
      return static_cast<double>(fields.count(row.name));
    case FieldType::flag:
      return fields.flag(row.name);
    case FieldType::text:
      return fields.text(row.name);
    case FieldType::number_or_curve:
      if (fields.is(row.name, LUA_TNUMBER)) return fields.number(row.name);
      [[fallthrough]];
    case FieldType::curve:
      return read_curve(fields, row, path);
    case FieldType::points:
      return read_points(fields, row, path);
    default:
      return read_parts(fields, row);
  }
}

}  // namespace fabricsh::script
