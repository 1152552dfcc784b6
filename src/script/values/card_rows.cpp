// The fields of cards as argument rows, and cards read from Lua tables; both use the rows in
// card/fields.cpp.
#include "script/values/card_rows.hpp"

#include <algorithm>

#include "base/number.hpp"
#include "card/fields.hpp"
#include "law/provenance.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

using card::Card;
using card::Field;
using card::FieldTable;
using card::FieldType;

namespace {

unsigned kinds_of(FieldType holds) {
  switch (holds) {
    case FieldType::number:
      return number;
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

std::vector<Argument> arguments_of(const FieldTable& table);

Argument argument_of(const Field& field) {
  Argument row{field.name, kinds_of(field.holds), field.unit, field.range, field.sentence, field.required};
  if (const auto* x = std::get_if<double>(&field.fallback)) row.fallback = *x;
  if (const auto* flag = std::get_if<bool>(&field.fallback)) row.fallback = *flag;
  if (const auto* words = std::get_if<std::string>(&field.fallback)) row.fallback = *words;
  row.choices = field.words;
  row.rows = arguments_of(field.rows);
  row.usual = field.cloth;
  row.hint = field.question;
  return row;
}

std::vector<Argument> arguments_of(const FieldTable& table) {
  std::vector<Argument> rows;
  for (const Field& field : table) rows.push_back(argument_of(field));
  return rows;
}

// Reads pairs of numbers from the table on top of the stack, which is `name` of the table at `path`.
card::Points read_pairs(const Fields& fields, const std::string& path, const Field& field) {
  const std::string &name = field.name, x = field.parts.at(0), y = field.parts.at(1);
  lua_State* L = fields.L();
  card::Points points;
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
card::Points read_curve_points(const Fields& fields, const std::string& path, const Field& field) {
  const std::string& name = field.name;
  const card::Points points = read_pairs(fields, path, field);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [x, y] = points[i];
    if (i == 0 && (x != 0 || y != 0))
      fields.refuse(name, "expected the first point to be {0, 0}, got {" + exact_number(x) + ", " +
                              exact_number(y) + "}");
    if (i > 0 && (x <= points[i - 1].first || y <= points[i - 1].second))
      fields.refuse(name, "expected " + field.parts[0] + " and " + field.parts[1] +
                              " to increase, at point " + std::to_string(i + 1) + " they do not");
  }
  if (points.size() < 2) fields.refuse(name, "expected at least two points, got one");
  return points;
}

card::Value read_points(const Fields& fields, const Field& field, const std::string& path) {
  fields.push(field.name);
  card::Points points = read_pairs(fields, path, field);
  lua_pop(fields.L(), 1);
  if (const std::string fault = field.check(points); !fault.empty()) fields.refuse(field.name, fault);
  return points;
}

card::Value read_curve(const Fields& fields, const Field& field, const std::string& path) {
  lua_State* L = fields.L();
  card::Value curve;
  fields.push(field.name);
  const bool points = lua_rawgeti(L, -1, 1) == LUA_TTABLE;
  lua_pop(L, 1);
  if (points) {
    curve = read_curve_points(fields, path, field);
  } else {
    check_value(L, -1, {field.name, numbers, field.unit, everything, ""}, path, false);
    curve = read_numbers(L, -1);
  }
  lua_pop(L, 1);
  return curve;
}

std::vector<double> read_parts(const Fields& fields, const Field& field) {
  const auto n = field.parts.size();
  if (field.holds == FieldType::ratios && fields.is(field.name, LUA_TNUMBER))
    return std::vector<double>(n, fields.number(field.name));
  auto values = fields.numbers(field.name);
  if (n == 0 || values.size() == n) return values;
  std::string names;
  for (const std::string& part : field.parts) names += (names.empty() ? "" : ", ") + part;
  fields.refuse(field.name, "expected {" + names + "}, got " + counted(values.size(), "number"));
}

card::Value read_value(const Fields& fields, const Field& field, const std::string& path) {
  switch (field.holds) {
    case FieldType::number:
      return fields.number(field.name);
    case FieldType::flag:
      return fields.flag(field.name);
    case FieldType::text:
      return fields.text(field.name);
    case FieldType::number_or_curve:
      if (fields.is(field.name, LUA_TNUMBER)) return fields.number(field.name);
      [[fallthrough]];
    case FieldType::curve:
      return read_curve(fields, field, path);
    case FieldType::points:
      return read_points(fields, field, path);
    default:
      return read_parts(fields, field);
  }
}

// path: "warp." inside the table warp.
void read_fields(const Fields& fields, const FieldTable& table, const std::string& path, Card& card) {
  for (const Field& field : table) {
    if (fields.has(field.name)) {
      if (field.holds == FieldType::group) {
        field.make(card);
        read_fields(fields.fields(field.name), field.rows, path + field.name + ".", card);
        lua_pop(fields.L(), 1);
      } else {
        field.set(card, read_value(fields, field, path));
      }
    } else if (!std::holds_alternative<std::monostate>(field.fallback)) {
      field.set(card, field.fallback);
    }
  }
}

// --- checks that involve several fields ---

// A band must have as many numbers as the group of its name has parameters.
void check_bands(const Fields& fields, const Card& card) {
  const Fields bands = fields.fields("bands");
  for (const Field& part : card::find_field(card::fields(card), "bands")->rows) {
    if (part.holds != FieldType::group || !bands.has(part.name)) continue;
    const Fields band = bands.fields(part.name);
    const std::size_t n = parameters(*card::find_field(card::fields(card), part.name), card).size();
    for (const char* name : {"low", "high", "covariance"}) {
      const std::size_t got = band.numbers(name).size(), want = std::string(name) == "covariance" ? n * n : n;
      if (got != want)
        band.refuse(name, "expected " + std::to_string(want) + " numbers, got " + std::to_string(got));
    }
    lua_pop(fields.L(), 1);
  }
  lua_pop(fields.L(), 1);
}

void check_svk(const Fields& fields, const card::Svk& law) {
  if (law.nu12 * law.nu21 >= 1)
    fields.refuse("poisson", "expected nu12 nu21 < 1, got " + exact_number(law.nu12) + " x " +
                                 exact_number(law.nu21) + " = " + exact_number(law.nu12 * law.nu21));
  for (const char* name : {"warp", "weft", "shear"}) {
    if (fields.has("young") && fields.has(name))
      fields.refuse(name, "expected either young or warp, weft and shear, got both");
    if (!fields.has("young") && !fields.has(name))
      fields.refuse(name,
                    "expected " + expected(fields.row(name)) + " (or young for an isotropic sheet), got nil");
  }
}

law::Provenance read_provenance(const Fields& f) {
  law::Provenance out;
  lua_State* L = f.L();
  f.push("provenance");
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
    const auto& known = law::provenance_fields();
    const std::string name = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : describe(L, -2);
    if (std::find(known.begin(), known.end(), name) == known.end())
      f.refuse("provenance", unknown("field", name, known));
    if (lua_type(L, -1) != LUA_TSTRING)
      f.refuse("provenance", "expected words for '" + name + "', got " + describe(L, -1));
    const std::string words = lua_tostring(L, -1);
    if (!law::is_origin(words))
      f.refuse("provenance",
               "expected words that begin with fitted, measured, copied, typed or assumed for '" + name +
                   "', got '" + words + "'");
    out.emplace_back(name, words);
  }
  lua_pop(L, 1);
  std::sort(out.begin(), out.end());
  return out;
}

card::Ranges read_ranges(const Fields& f, const Card& card) {
  card::Ranges out;
  lua_State* L = f.L();
  f.push("ranges");
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
    const auto& known = law::provenance_fields();
    const std::string name = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : describe(L, -2);
    if (std::find(known.begin(), known.end(), name) == known.end())
      f.refuse("ranges", unknown("field", name, known));
    std::array<double, 2> range{std::nan(""), std::nan("")};
    for (int i = 0; lua_type(L, -1) == LUA_TTABLE && i < 2; ++i) {
      if (lua_rawgeti(L, -1, i + 1) == LUA_TNUMBER) range[static_cast<std::size_t>(i)] = lua_tonumber(L, -1);
      lua_pop(L, 1);
    }
    if (!(range[0] >= 0) || !(range[1] > range[0]) || !std::isfinite(range[1]))
      f.refuse("ranges", "expected {lowest, highest} from 0 on, ascending, for '" + name + "', got " +
                             (std::isnan(range[0]) || std::isnan(range[1])
                                  ? describe(L, -1)
                                  : "{" + exact_number(range[0]) + ", " + exact_number(range[1]) + "}"));
    if (!law::is_assumed(card, name))
      f.refuse("ranges", "expected fields whose provenance begins with assumed, got '" + name + "'");
    out.emplace_back(name, range);
  }
  lua_pop(L, 1);
  std::sort(out.begin(), out.end());
  return out;
}

// The rows of a card's fields, and its origins.
std::vector<Argument> rows_of(const std::string& kind) {
  std::vector<Argument> rows = arguments_of(card::fields(kind));
  const auto place =
      std::find_if(rows.begin(), rows.end(), [](const Argument& row) { return row.name == "bending"; });
  rows.insert(
      place + 1,
      value_(
          "provenance", table,
          "where values come from: {['warp.loading']='fitted to 4 specimens', ['shear.unloading']='assumed: "
          "...'}; words begin with fitted, measured, copied, typed or assumed")
          .optional());
  const auto origins =
      std::find_if(rows.begin(), rows.end(), [](const Argument& row) { return row.name == "provenance"; });
  rows.insert(origins + 1,
              value_("ranges", table,
                     "where assumed numbers may lie, for fabric.budget: {['warp.poisson']={0.1, 0.6}, "
                     "['warp.loading']={0.5, 2}}; Poisson's ratios as they are, others as factors")
                  .optional());
  return rows;
}

}  // namespace

const std::vector<Argument>& card_rows(const std::string& kind) {
  static const std::vector<Argument> woven = rows_of("woven"), svk = rows_of("svk"),
                                     linear = rows_of("linear");
  return kind == "svk" ? svk : kind == "linear" ? linear : woven;
}

Card card_from(const Fields& fields, const std::string& kind) {
  luaL_checkstack(fields.L(), 20, "card");
  Card card = card::blank(kind);
  read_fields(fields, card::fields(kind), "", card);
  if (const auto found = card::clash(card)) fields.refuse(found->field, found->words);
  if (fields.has("provenance")) card.provenance = read_provenance(fields);
  if (fields.has("ranges")) card.ranges = read_ranges(fields, card);
  if (kind == "woven" && fields.has("bands")) check_bands(fields, card);
  if (const auto* svk = std::get_if<card::Svk>(&card.law)) check_svk(fields, *svk);
  return card;
}

Card read_card(lua_State* L, int index, const std::string& kind) {
  return card_from(Fields(L, index, card_rows(kind)), kind);
}

}  // namespace fabricsh::script
