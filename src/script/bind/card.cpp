// fabric.woven, fabric.svk, fabric.linear, fabric.card, fabric.cards, and the methods of a card.
#include <algorithm>
#include <set>

#include "base/number.hpp"
#include "card/estimate.hpp"
#include "card/fields.hpp"
#include "law/provenance.hpp"
#include "model/outlook.hpp"
#include "script/bind/rooms.hpp"
#include "script/call/parts.hpp"
#include "script/call/words.hpp"
#include "script/sandbox/sandbox.hpp"
#include "script/show/show.hpp"
#include "script/values/card_rows.hpp"
#include "system/gate.hpp"
#include "system/paths.hpp"

namespace fabricsh::script {

using card::Card;

namespace {

int push_new_card(lua_State* L, Card card) { return push_object(L, std::make_shared<Card>(std::move(card))); }

int construct(Call& call) { return push_new_card(call.L(), card_from(call, last_word(call.entry().name))); }

const Card* card_at(lua_State* L, int index) { return to_object<Card>(L, index).get(); }

// For a name that is not a field: a method, or an error with the nearest name.
int other_name(lua_State* L) {
  push_class(L, "card", nullptr);
  lua_getfield(L, -1, "methods");
  lua_pushvalue(L, 2);
  if (lua_rawget(L, -2) != LUA_TNIL) return 1;
  std::string message;
  {
    std::vector<std::string> known = {"write", "with", "check", "kind"};
    for (const Argument& row : card_rows(card::kind(*card_at(L, 1)))) known.push_back(row.name);
    message = position(L) + "card: " + unknown("field", luaL_tolstring(L, 2, nullptr), known);
  }
  lua_pushstring(L, message.c_str());
  return lua_error(L);
}

int card_index(lua_State* L) { return push_card_field(L, card_at) ? 1 : other_name(L); }

bool is_group(lua_State* L, int index) { return lua_istable(L, index) && lua_rawlen(L, index) == 0; }

bool is_empty(lua_State* L, int table) {
  lua_pushnil(L);
  if (lua_next(L, table) == 0) return true;
  lua_pop(L, 2);
  return false;
}

const Argument* row_of(lua_State* L, int key, const std::vector<Argument>& rows) {
  if (lua_type(L, key) != LUA_TSTRING) return nullptr;
  const std::string name = lua_tostring(L, key);
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const Argument& r) { return r.name == name; });
  return row == rows.end() ? nullptr : &*row;
}

// Copies the fields of the table at `from` to the one at `to`; tables of named fields are merged. False drops
// a part that a card can do without, and does nothing where the card has none.
void merge(lua_State* L, int to, int from, const std::vector<Argument>& rows) {
  static const std::vector<Argument> no_rows;
  luaL_checkstack(L, 8, "tables nested too deeply");
  for (lua_pushnil(L); lua_next(L, from) != 0; lua_pop(L, 1)) {
    make_plain(L);
    const int key = lua_gettop(L) - 1, value = key + 1;
    const Argument* row = row_of(L, key, rows);
    const bool is_false = lua_isboolean(L, value) && lua_toboolean(L, value) == 0;
    lua_pushvalue(L, key);
    const bool merges = lua_rawget(L, to) == LUA_TTABLE && is_group(L, -1) && is_group(L, value);
    if (is_false && row != nullptr && !row->required && (row->kinds & boolean) == 0) {
      lua_pushnil(L);
    } else if (merges) {
      merge(L, lua_gettop(L), value, row == nullptr ? no_rows : row->rows);
      lua_pushvalue(L, -1);
    } else if (row != nullptr && !row->rows.empty() && is_group(L, value)) {
      lua_newtable(L);
      merge(L, lua_gettop(L), value, row->rows);
      // The changes take away only what the card does not have.
      if (is_empty(L, lua_gettop(L)) && !is_empty(L, value)) lua_pushnil(L);
    } else {
      lua_pushvalue(L, value);
    }
    lua_pushvalue(L, key);
    lua_insert(L, -2);
    lua_rawset(L, to);
    lua_settop(L, value);
  }
}

// The provenance of a changed card: values changed by hand are marked as typed; a part that is gone has none.
law::Provenance origins_after(const Card& before, const Card& after) {
  law::Provenance out = before.provenance;
  const auto* a = std::get_if<card::Woven>(&before.law);
  const auto* b = std::get_if<card::Woven>(&after.law);
  const auto changed = [&](const std::string& field, bool same) {
    if (same) return;
    for (auto& [name, words] : out)
      if (name == field) words = "typed: changed by card:with";
  };
  const auto dropped = [&](const std::string& field, bool before_has, bool after_has) {
    if (before_has && !after_has)
      std::erase_if(out, [&](const auto& origin) { return origin.first == field; });
  };
  const auto bending = [](const Card& card) {
    Card only;
    only.bending = card.bending;
    return card::lua_text(only);
  };
  for (const char* field : {"bending", "bending.twist"}) {
    changed(field, bending(before) == bending(after));
    dropped(field, before.bending.has_value(), after.bending.has_value());
  }
  changed("density", before.density == after.density);
  changed("thickness", before.thickness == after.thickness);
  if (a == nullptr || b == nullptr) return out;
  const auto curve = [&](const std::string& field, const card::Curve& x, const card::Curve& y) {
    changed(field, x.coefficients == y.coefficients && x.points == y.points);
  };
  curve("warp.loading", a->warp.loading, b->warp.loading);
  curve("weft.loading", a->weft.loading, b->weft.loading);
  curve("shear.loading", a->shear.loading, b->shear.loading);
  changed("warp.unloading", a->warp.unloading == b->warp.unloading);
  changed("weft.unloading", a->weft.unloading == b->weft.unloading);
  changed("shear.unloading", a->shear.unloading == b->shear.unloading);
  const auto loop = [&](const std::string& field, const auto& p, const auto& q) {
    changed(field, p.has_value() == q.has_value() &&
                       (!p || (p->friction == q->friction && p->reach == q->reach && p->curve == q->curve)));
    dropped(field, p.has_value(), q.has_value());
  };
  loop("warp.loop", a->warp.loop, b->warp.loop);
  loop("weft.loop", a->weft.loop, b->weft.loop);
  rheology::for_each([&](auto element, auto given, auto) {
    changed(element.name, a->parallel.*given == b->parallel.*given);
    dropped(element.name, (a->parallel.*given).has_value(), (b->parallel.*given).has_value());
  });
  changed("warp.poisson", a->warp.poisson == b->warp.poisson);
  changed("weft.poisson", a->weft.poisson == b->weft.poisson);
  return out;
}

// Whether the table on top of the stack has the field `name` in its table `group`.
bool states_in(lua_State* L, const char* group, const std::string& name) {
  bool found = false;
  if (lua_getfield(L, -1, group) == LUA_TTABLE) {
    found = lua_getfield(L, -1, name.c_str()) != LUA_TNIL;
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return found;
}

// Notes each rigidity that is new while its friction is still that of the previous card, and is not among the
// changes.
void warn_old_friction(Call& call, const std::optional<card::Bending>& before,
                       const std::optional<card::Bending>& after) {
  if (!before || !after) return;
  call.push("changes");
  const auto look = [&](const std::string& yarn, bool changed, const auto& old, const auto& now) {
    if (!changed || !old || !now || old->moment != now->moment || old->curvature != now->curvature) return;
    if (states_in(call.L(), "bending", "friction_" + yarn)) return;
    const std::string words = "card:with: bending." + yarn + " is new and friction_" + yarn +
                              " as before (moment " + fabricsh::number(now->moment) +
                              " N): give it too, or friction_" + yarn + " = false";
    call.session().warn("card", words);
  };
  const auto differs = [](double a, double b, const card::Curve& x, const card::Curve& y) {
    return a != b || x.coefficients != y.coefficients || x.points != y.points;
  };
  look("warp", differs(before->warp, after->warp, before->warp_curve, after->warp_curve),
       before->friction_warp, after->friction_warp);
  look("weft", differs(before->weft, after->weft, before->weft_curve, after->weft_curve),
       before->friction_weft, after->friction_weft);
  lua_pop(call.L(), 1);
}

// A band goes with the part that it is of.
void drop_lost_bands(lua_State* L, int merged) {
  const bool has_bands = lua_getfield(L, merged, "bands") == LUA_TTABLE;
  for (const char* part : {"bending", "biaxial"}) {
    const bool lost = lua_getfield(L, merged, part) == LUA_TNIL;
    lua_pop(L, 1);
    if (!lost || !has_bands) continue;
    lua_pushnil(L);
    lua_setfield(L, -2, part);
  }
  lua_pop(L, 1);
}

int with(Call& call) {
  lua_State* L = call.L();
  const auto card = call.self<Card>();
  push_card_table(L, *card);
  lua_pushnil(L);
  lua_setfield(L, -2, "kind");
  const int merged = lua_gettop(L);
  call.push("changes");
  const bool states_origin = lua_getfield(L, -1, "provenance") != LUA_TNIL;
  lua_pop(L, 1);
  const bool states_ranges = lua_getfield(L, -1, "ranges") != LUA_TNIL;
  lua_pop(L, 1);
  if (!states_ranges) {  // of what stays assumed they are kept
    lua_pushnil(L);
    lua_setfield(L, merged, "ranges");
  }
  merge(L, merged, lua_gettop(L), card_rows(card::kind(*card)));
  const bool states_bands = lua_getfield(L, -1, "bands") != LUA_TNIL;
  lua_pop(L, 2);
  if (!states_bands) drop_lost_bands(L, merged);
  Card changed = read_card(L, merged, card::kind(*card));
  if (!states_origin) changed.provenance = origins_after(*card, changed);
  if (!states_ranges) changed.ranges = card->ranges;
  law::drop_ranges(changed);
  warn_old_friction(call, card->bending, changed.bending);
  return push_new_card(L, std::move(changed));
}

// Thickness of the cloth that nothing presses, m, at which contact begins: where its measured compression
// runs out to no pressure, or without one its own; second, what the fibres alone fill, m, below which nothing
// is pressed.
int free_thickness(Call& call) {
  const model::Loose loose = model::loose(*call.object<Card>("card"));
  return push_value(call.L(), loose.thickness) + push_value(call.L(), loose.solid_thickness);
}

bool is_path(const std::string& name) {
  return name.find('/') != std::string::npos ||
         (name.size() > 4 && name.compare(name.size() - 4, 4, ".lua") == 0);
}

std::vector<std::string> shipped() {
  std::set<std::string> names;
  for (const std::string& root : data_roots()) {
    const system::Gate& gate = system::Gate::of_process();
    if (!gate.exists(root + "/share/cards")) continue;
    for (const std::string& name : gate.names(root + "/share/cards"))
      if (name.ends_with(".lua")) names.insert(name.substr(0, name.size() - 4));
  }
  return {names.begin(), names.end()};
}

// The card with its estimated bending, or with integration through the thickness on purpose.
Card bent(Card card, const std::string& how) {
  auto& origins = card.provenance;
  std::erase_if(origins, [](const auto& origin) { return origin.first.starts_with("bending"); });
  if (how == "thickness") {
    if (card.bending) throw Error(card::at_field(card, "bending") + "it has a rigidity of its own");
    card.through_thickness = true;
  } else {
    if (!card.estimate) card.estimate = card::bending_of_areal_mass(card);
    card.bending = card.estimate->bending;
    if (auto* woven = std::get_if<card::Woven>(&card.law); woven != nullptr && woven->bands)
      woven->bands->bending = {};
    origins.emplace_back("bending", "assumed: estimated, " + card.estimate->source);
    std::sort(origins.begin(), origins.end());
  }
  law::drop_ranges(card);
  return card;
}

// Puts the card that is shipped under the name, or that the file returns, on the stack.
void load_card(Call& call) {
  lua_State* L = call.L();
  const std::string name = call.text("name");
  const std::string path = is_path(name) ? name : data_file("share/cards/" + name + ".lua");
  if (path.empty()) throw Error(unknown("fabric", name, shipped()));
  if (load_file(L, path) != LUA_OK) throw Error(lua_tostring(L, -1));
  lua_call(L, 0, 1);
  if (to_object<Card>(L, -1) == nullptr)
    throw Error(path + ": expected the file to return a card, got " + describe(L, -1));
}

int card_by_name(Call& call) {
  lua_State* L = call.L();
  if (const auto given = call.object<Card>("name"))
    push_object(L, given);
  else
    load_card(call);
  const auto card = to_object<Card>(L, -1);
  if (!call.has("options")) return 1;
  const Fields options = call.fields("options");
  if (!options.has("bending")) return push_new_card(L, *card);
  if (options.text("bending") == "estimated" && card->bending && !card->estimate) {
    const std::string words =
        "card '" + card->name + "': its bending needs no estimate, it is part of the card";
    call.session().notices().remark(words);
    return push_new_card(L, *card);
  }
  return push_new_card(L, bent(*card, options.text("bending")));
}

int cards(Call& call) { return push_texts(call.L(), shipped()); }

int card_string(lua_State* L) { return push_text(L, card_words(*to_object<Card>(L, 1))); }

int card_equal(lua_State* L) {
  const auto a = to_object<Card>(L, 1), b = to_object<Card>(L, 2);
  return push_value(L, a != nullptr && b != nullptr && card::lua_text(*a) == card::lua_text(*b));
}

Argument card_options() {
  Argument bending = value_("bending?", text,
                            "estimated: the card's own estimate of what was not measured, or that for its "
                            "areal mass (a card with a rigidity of its own keeps it); thickness: integration "
                            "through the thickness, without a warning");
  bending.choices = {"estimated", "thickness"};
  Argument options = value_("options?", fields, "changes to the card");
  options.rows = {bending};
  return options;
}

Argument card_or_name_row() {
  Argument row =
      value_("name", text | object, "of a shipped card, or a path (with / or ending in .lua), or a card");
  row.of = "card";
  return row;
}

constexpr const char* woven_example =
    "local u = fabric.units\n"
    "local card = fabric.woven{ name='blend', density=590, thickness=0.38*u.mm,\n"
    "  warp={ loading=fabric.poly({8, 826}, u.MPa), unloading=864*u.MPa, poisson=0.25 },\n"
    "  weft={ loading=fabric.poly({37, 1650}, u.MPa), unloading=1080*u.MPa, poisson=0.42 },\n"
    "  shear={ loading=fabric.poly({2, -18, 90, -24}, u.MPa), unloading=12*u.MPa, measure='tensor' } }\n"
    "assert(card.warp.poisson == 0.25)";

std::vector<Entry> constructors() {
  return {
      {"fabric.woven{}", card_rows("woven"),
       "A woven fabric: loading curves, unloading moduli and Poisson ratios along warp and weft, and in "
       "shear.",
       woven_example, construct},
      {"fabric.svk{}", card_rows("svk"),
       "A St. Venant-Kirchhoff sheet: for comparison, with constant moduli; S12 = 2 shear E12.",
       "local c = require 'fabric'.svk{ young=1.2e6, poisson=0.3, density=500, thickness=0.5e-3 }\n"
       "assert(c.warp == 1.2e6 and c.poisson[2] == 0.3)",
       construct},
      {"fabric.linear{}", card_rows("linear"),
       "A linear orthotropic sheet for small strains; refused unless nu12/warp = nu21/weft.",
       "local c = require 'fabric'.linear{ warp=2e6, weft=1e6, shear=5e5, poisson={0.2, 0.1}, density=500, "
       "thickness=0.5e-3 }\n"
       "assert(c.kind == 'linear')",
       construct},
  };
}

std::vector<Entry> card_entries() {
  return {
      {"fabric.card()",
       {card_or_name_row(), card_options()},
       "A shipped card by name, or the card that a Lua file returns, or a card of the deck's own; with "
       "options.",
       "assert(fabric.card 'denim'.name == 'denim')\n"
       "assert(fabric.card('denim', { bending='estimated' }).bending.warp[1] > 0)",
       card_by_name},
      {"fabric.cards()", {}, "Names of the shipped cards.", "assert(#require 'fabric'.cards() >= 4)", cards},
      {"card:with()",
       {value_("changes", table,
               "fields of the constructor that differ; tables merge deeply, and false drops what a card can "
               "do without, as friction_warp=false, whether it has it or not")},
       "A copy of the card with some fields changed.",
       "local c = require 'fabric'.card 'blend':with{ warp={poisson=0.4} }; assert(c.warp.poisson == 0.4)",
       with},
      kernel("free_thickness()", {object_("card", "card", "")}, free_thickness),
  };
}

}  // namespace

void bind_card(Session& session) {
  install(session, constructors());
  install(session, card_entries());
  set_meta(session, "card", "__index", card_index);
  set_meta(session, "card", "__tostring", card_string);
  set_meta(session, "card", "__eq", card_equal);
  know_parts(session.lua());
}

}  // namespace fabricsh::script
