// The fields of cards as argument rows, and cards read from Lua tables; both use the rows in
// card/fields.cpp.
#include "script/values/card_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/number.hpp"
#include "card/fields.hpp"
#include "law/provenance.hpp"
#include "script/call/parts.hpp"
#include "script/call/push.hpp"
#include "script/call/words.hpp"
#include "script/values/field_rows.hpp"

namespace fabricsh::script {

using card::Card;
using card::Field;
using card::FieldType;

namespace {

// --- checks that involve several fields ---

// Samples are drawn between low and high, with the covariance of a real distribution.
void check_band(const Fields& band, std::size_t n) {
  const auto low = band.numbers("low"), high = band.numbers("high"), c = band.numbers("covariance");
  for (std::size_t i = 0; i < n; ++i) {
    if (high[i] < low[i])
      band.refuse("high", "expected at least " + exact_number(low[i]) + ", that of low, got " +
                              exact_number(high[i]) + " at place " + std::to_string(i + 1));
    for (std::size_t k = 0; k <= i; ++k) {
      const double own = c[i * n + i] * c[k * n + k], one = c[i * n + k], other = c[k * n + i];
      if (c[i * n + i] < 0 || std::abs(one - other) > 1e-4 * std::sqrt(own) || one * one > own * (1 + 1e-4))
        band.refuse("covariance",
                    "expected that of real numbers, symmetric and with correlations from -1 to 1, got " +
                        exact_number(one) + " and " + exact_number(other) + " at row " +
                        std::to_string(i + 1) + ", column " + std::to_string(k + 1));
    }
  }
}

// A band must have as many numbers as the group of its name has parameters.
void check_bands(const Fields& fields, const Card& card) {
  const Fields bands = fields.fields("bands");
  for (const Field& part : card::find_field(card::fields(card), "bands")->rows) {
    if (part.holds != FieldType::group || !bands.has(part.name)) continue;
    const Fields band = bands.fields(part.name);
    const Field& group = *card::find_field(card::fields(card), part.name);
    if (!group.there(card))
      bands.refuse(part.name, "expected a card with " + part.name + " of its own, got one without");
    const std::size_t n = parameters(group, card).size();
    for (const char* name : {"low", "high", "covariance"}) {
      const std::size_t got = band.numbers(name).size(), want = std::string(name) == "covariance" ? n * n : n;
      if (got != want)
        band.refuse(name, "expected " + std::to_string(want) + " numbers, got " + std::to_string(got));
    }
    check_band(band, n);
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

// What `read` makes of each value in the table, on top of the stack, by its name: that of a field with an
// origin.
template <class Read>
auto by_origin(const Fields& f, const char* table, Read read) {
  std::vector<std::pair<std::string, decltype(read(std::string()))>> out;
  lua_State* L = f.L();
  f.push(table);
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
    const auto& known = law::provenance_fields();
    const std::string name = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : describe(L, -2);
    if (std::find(known.begin(), known.end(), name) == known.end())
      f.refuse(table, unknown("field", name, known));
    out.emplace_back(name, read(name));
  }
  lua_pop(L, 1);
  std::sort(out.begin(), out.end());
  return out;
}

law::Provenance read_provenance(const Fields& f) {
  lua_State* L = f.L();
  return by_origin(f, "provenance", [&](const std::string& name) {
    if (lua_type(L, -1) != LUA_TSTRING)
      f.refuse("provenance", "expected words for '" + name + "', got " + describe(L, -1));
    const std::string words = lua_tostring(L, -1);
    if (!law::is_origin(words))
      f.refuse("provenance",
               "expected words that begin with fitted, measured, copied, typed or assumed for '" + name +
                   "', got '" + words + "'");
    return words;
  });
}

card::Ranges read_ranges(const Fields& f, const Card& card) {
  lua_State* L = f.L();
  return by_origin(f, "ranges", [&](const std::string& name) {
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
    return range;
  });
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
  read_rows(fields, card::fields(kind), card);
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

using card::Card;
using card::Field;
using card::FieldTable;
using card::FieldType;
using card::Points;
using card::Value;

namespace {

// --- plain tables ---

void push_points(lua_State* L, const double* xy, lua_Integer n) {
  lua_createtable(L, static_cast<int>(n), 0);
  for (lua_Integer i = 0; i < n; ++i) {
    push_numbers(L, {xy[2 * i], xy[2 * i + 1]});
    lua_rawseti(L, -2, i + 1);
  }
}

const double* flat(const Points& points) {
  static_assert(sizeof(Points::value_type) == 2 * sizeof(double));
  return &points.front().first;
}

void push_plain(lua_State* L, const Value& value) {
  if (const auto* points = std::get_if<Points>(&value))
    return push_points(L, flat(*points), static_cast<lua_Integer>(points->size()));
  if (const auto* x = std::get_if<double>(&value))
    push_value(L, *x);
  else if (const auto* flag = std::get_if<bool>(&value))
    push_value(L, *flag);
  else if (const auto* many = std::get_if<std::vector<double>>(&value))
    push_value(L, *many);
  else if (const auto* words = std::get_if<std::string>(&value))
    push_value(L, *words);
  else
    lua_pushnil(L);
}

void push_plain(lua_State* L, const FieldTable& table, const Card& card) {
  luaL_checkstack(L, 10, "card");
  lua_newtable(L);
  for (const Field& field : table) {
    if (field.holds == FieldType::group && field.there(card))
      push_plain(L, field.rows, card);
    else
      push_plain(L, field.get ? field.get(card) : Value());
    lua_setfield(L, -2, field.name.c_str());
  }
}

void push_shown(lua_State* L, const FieldTable& table, const Card& card, const std::string& top);

// Pushes the value of a field; lists and groups as metatables. top: the card's field to which it belongs.
void push_field(lua_State* L, const Field& field, const Card& card, const std::string& top) {
  if (field.holds == FieldType::group) {
    if (!field.there(card)) return lua_pushnil(L);
    push_shown(L, field.rows, card, top);
    return make_metatable(L, top);
  }
  const Value value = field.get ? field.get(card) : Value();
  if (const auto* points = std::get_if<Points>(&value)) {
    const std::size_t size = points->size() * sizeof(Points::value_type);
    std::memcpy(lua_newuserdatauv(L, size, 0), flat(*points), size);
    return make_metatable(L, top);
  }
  push_plain(L, value);
  if (lua_istable(L, -1)) make_metatable(L, top);
}

void push_shown(lua_State* L, const FieldTable& table, const Card& card, const std::string& top) {
  luaL_checkstack(L, 12, "card");
  lua_createtable(L, 0, static_cast<int>(table.size()) + 2);
  for (const Field& field : table) {
    push_field(L, field, card, top.empty() ? field.name : top);
    lua_setfield(L, -2, field.name.c_str());
  }
}

// Sets kind, source and the origins of fields.
void set_origins(lua_State* L, const Card& card) {
  put(L, "kind", card::kind(card), "source", card.source);
  const auto& provenance = card.provenance;
  if (provenance.empty()) return;
  lua_newtable(L);
  for (const auto& [field, words] : provenance) put(L, field.c_str(), words);
  lua_setfield(L, -2, "provenance");
  if (card.ranges.empty()) return;
  lua_newtable(L);
  for (const auto& [field, range] : card.ranges) {
    lua_createtable(L, 2, 0);
    for (int i = 0; i < 2; ++i) {
      lua_pushnumber(L, range[static_cast<std::size_t>(i)]);
      lua_rawseti(L, -2, i + 1);
    }
    lua_setfield(L, -2, field.c_str());
  }
  lua_setfield(L, -2, "ranges");
}

// Makes the tables in the one on top of the stack metatables.
void show_tables_in(lua_State* L, const char* name) {
  luaL_checkstack(L, 12, "card");
  for (lua_pushnil(L); lua_next(L, -2) != 0;) {
    if (lua_istable(L, -1)) make_metatable(L, name);
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -4);
  }
}

// Pushes the hidden table of the card at 1: its fields, and marks for fields that are known but not set.
void push_card(lua_State* L, const Card& card) {
  const FieldTable& table = card::fields(card);
  push_shown(L, table, card, "");
  set_origins(L, card);
  for (const char* name : {"provenance", "ranges"}) {
    if (lua_getfield(L, -1, name) == LUA_TTABLE) {
      show_tables_in(L, name);
      make_metatable(L, name);
      lua_pushvalue(L, -1);
      lua_setfield(L, -3, name);
    }
    lua_pop(L, 1);
  }
  const auto mark = [L](const char* name) {
    if (lua_getfield(L, -1, name) == LUA_TNIL) {
      push_absent(L);
      lua_setfield(L, -3, name);
    }
    lua_pop(L, 1);
  };
  mark("provenance");
  mark("ranges");
  for (const Field& field : table) mark(field.name.c_str());
  // The metatables by name, needed when a part is forgotten.
  copy_entries(L, -1);
  lua_rawseti(L, -2, 1);
}

}  // namespace

void push_card_table(lua_State* L, const Card& card) {
  push_plain(L, card::fields(card), card);
  set_origins(L, card);
}

bool push_card_field(lua_State* L, const Card* (*card_at)(lua_State*, int)) {
  if (lua_type(L, 1) != LUA_TUSERDATA || lua_getiuservalue(L, 1, 1) != LUA_TTABLE) {
    const Card* card = card_at(L, 1);
    if (card == nullptr) return luaL_error(L, "expected a card, got %s", luaL_typename(L, 1)) != 0;
    lua_settop(L, 2);
    push_card(L, *card);
    lua_pushvalue(L, -1);
    lua_setiuservalue(L, 1, 1);
  }
  lua_pushvalue(L, 2);
  const int type = lua_rawget(L, -2);
  if (type == LUA_TLIGHTUSERDATA) lua_pushnil(L);
  if (type == LUA_TTABLE) hold_part(L);
  return type != LUA_TNIL;
}

}  // namespace fabricsh::script
