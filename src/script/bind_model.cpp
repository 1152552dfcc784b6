// fabric.model: supports, motions, loads.
#include "script/bind_model.hpp"

#include "fabric/check.hpp"
#include "model/model.hpp"
#include "script/bind.hpp"
#include "script/bind_run.hpp"
#include "script/words.hpp"

namespace fabricsh::script {

using model::Model;

Vec3 read_vector(const std::vector<double>& v, const std::string& what) {
  if (v.size() != 3) throw Error(what + ": expected {x, y, z}, got " + counted(v.size(), "number"));
  return {v[0], v[1], v[2]};
}

Mat3 read_frame(const Call& call) {
  if (!call.has("options")) return model::global_frame();
  const Fields options = call.fields("options");
  if (!options.has("frame")) return model::global_frame();
  lua_State* L = call.L();
  options.push("frame");
  Vec3 axis[2];
  for (int i = 0; i < 2; ++i) {
    const Argument row{std::to_string(i + 1), numbers, "", everything, ""};
    lua_rawgeti(L, -1, i + 1);
    check_value(L, -1, row, "options.frame.", true);
    axis[i] = read_vector(read_numbers(L, -1), "argument 'options.frame'");
    lua_pop(L, 1);
  }
  return model::frame_from(axis[0], axis[1]);
}

int return_self(const Call& call) {
  lua_pushvalue(call.L(), 1);
  return 1;
}

model::Components read_components(const Call& call) {
  model::Components components;
  const std::string what = last_word(call.entry().name) + " '" + call.text("set") + "': field '";
  const Fields given = call.fields("components");
  const char* const axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    if (given.push(axes[i]) != LUA_TNIL)
      components[i] = read_history(call.session(), call.L(), -1, what + axes[i] + "'");
    lua_pop(call.L(), 1);
  }
  return components;
}

std::string sample_model() {
  return "local fabric = require 'fabric'\n"
         "local mesh = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=1, ny=3 }\n"
         "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend', warp=90 }\n";
}

Argument frame_row() {
  return fields_("options",
                 {value_("frame", table, "{e1, e2}: x and y of the call count along them").optional()},
                 "frame = {e1, e2} for oblique directions")
      .optional();
}

Argument components_row(const char* unit, const char* sentence) {
  return fields_("components",
                 {history_("x", unit, "history along x"), history_("y", unit, "history along y"),
                  history_("z", unit, "history along z")},
                 sentence);
}

namespace {

// A direction on top of the stack: an angle or a vector.
model::Direction read_direction(lua_State* L, const std::string& what) {
  if (lua_type(L, -1) == LUA_TNUMBER) return lua_tonumber(L, -1);
  if (!lua_istable(L, -1))
    throw Error(what + ": expected an angle in degrees or {x, y, z}, got " + describe(L, -1));
  return read_vector(read_numbers(L, -1), what);
}

model::WarpField warp_function(const Function& f) {
  return [f](const Vec3& X) {
    lua_State* L = f.push();
    for (int i = 0; i < 3; ++i) lua_pushnumber(L, X[i]);
    lua_call(L, 3, 1);
    const model::Direction direction = read_direction(L, "field 'warp': what the function returned");
    lua_pop(L, 1);
    return direction;
  };
}

void read_warp(const Call& call, model::Options& options) {
  if (!call.has("warp")) return;
  if (const Function f = call.function("warp")) {
    options.warp = warp_function(f);
    options.warp_text = "function";
    return;
  }
  call.push("warp");
  const model::Direction direction = read_direction(call.L(), "field 'warp'");
  options.warp_text =
      lua_isnumber(call.L(), -1) ? number_text(lua_tonumber(call.L(), -1)) + " degrees" : "vector";
  lua_pop(call.L(), 1);
  options.warp = [direction](const Vec3&) { return direction; };
}

// One entry of layers={ {card=, warp=, thickness=}, ... }.
section::Ply read_ply(lua_State* L, const std::vector<Argument>& fields, int number) {
  const Fields given(L, lua_gettop(L), fields, "layers[" + std::to_string(number) + "].");
  const auto card = given.object<card::Card>("card");
  return {*card, given.has("thickness") ? given.number("thickness") : card->thickness,
          given.has("warp") ? given.number("warp") : 0.0};
}

std::vector<Argument> layer_fields() {
  return {object_("card", "card", "the ply's fabric"),
          number_("warp", "degrees", everything, "from the model's warp direction").optional(),
          number_("thickness", "m", positive, "wins over the card's").optional()};
}

void read_layers(const Call& call, model::Options& options) {
  if (!call.has("layers")) return;
  lua_State* L = call.L();
  static const std::vector<Argument> fields = layer_fields();
  call.push("layers");
  const auto count = static_cast<int>(lua_rawlen(L, -1));
  for (int i = 1; i <= count; ++i) {
    if (lua_rawgeti(L, -1, i) != LUA_TTABLE)
      call.refuse("layers", "expected a list of tables {card=, warp=, thickness=}, got " + describe(L, -1));
    options.plies.push_back(read_ply(L, fields, i));
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  if (options.plies.empty()) call.refuse("layers", "expected at least one layer, got an empty table");
}

// A card that fails its check is refused; each of its warnings is said once. That of bending is the run's: it
// knows whether the sheet can leave its surface.
void check_card(const Call& call, const card::Card& card) {
  const auto report = fabric::check(card);
  for (const auto& item : report.items) {
    const std::string words = "card '" + card.name + "': " + item.key + ": " + item.text;
    if (item.severity == fabric::Severity::error) throw Error(words);
    const bool is_bending = item.key.starts_with("bending.");
    if (item.severity == fabric::Severity::warning && !is_bending)
      call.session().notices().once(words, "warning: " + words);
  }
}

int make(Call& call) {
  model::Options options;
  read_layers(call, options);
  if (options.plies.empty() == !call.has("card"))
    call.refuse("card", options.plies.empty()
                            ? "expected either a card or layers={ {card=}, ... }, got neither"
                            : "expected either a card or layers={ {card=}, ... }, got both");
  const card::Card card =
      options.plies.empty() ? *call.object<card::Card>("card") : options.plies.front().card;
  if (call.has("thickness")) options.thickness = call.number("thickness");
  options.points = call.count("points");
  options.offset = call.number("offset");
  read_warp(call, options);
  const auto mesh = call.object<mesh::Mesh>("mesh");
  const Still still(call.session(), mesh.get());
  auto model = std::make_shared<Model>(mesh, card, std::move(options));
  for (const auto& ply : model->options().plies) check_card(call, ply.card);
  if (model->options().plies.empty()) check_card(call, card);
  push_object(call.L(), std::move(model));
  return 1;
}

int fix(Call& call) {
  call.self<Model>()->fix(call.text("set"), model::parse_freedoms(call.text("freedoms")), read_frame(call));
  return return_self(call);
}

// m, the diagonal of the box about a mesh.
double length_of(const mesh::Mesh& mesh) {
  if (mesh.nodes.empty()) return 0;
  Vec3 low = mesh.nodes.front(), high = low;
  for (const Vec3& X : mesh.nodes) {
    low = low.cwiseMin(X);
    high = high.cwiseMax(X);
  }
  return (high - low).norm();
}

// A motion many times as long as the mesh is a wrong unit more often than a flight.
void ask_about_motion(const Call& call, const model::Components& components) {
  constexpr double many = 10;
  const double length = length_of(call.self<Model>()->mesh());
  for (std::size_t i = 0; i < 3; ++i) {
    if (!components[i]) continue;
    const auto& history = *components[i];
    double farthest = history.is_constant() ? std::abs(history.value(0)) : 0;
    for (const double t : history.kinks()) farthest = std::max(farthest, std::abs(history.value(t)));
    if (farthest <= many * length) continue;
    const std::string words = position(call.L()) + "move '" + call.text("set") + "': field '" + "xyz"[i] +
                              "': " + number_text(farthest) + " m is " + brief_number(farthest / length) +
                              " times the size of the mesh (" + brief_number(length) + " m): is it in m?";
    call.session().notices().once(words, "warning: " + words);
  }
}

int move(Call& call) {
  auto components = read_components(call);
  ask_about_motion(call, components);
  call.self<Model>()->move(call.text("set"), std::move(components), read_frame(call));
  return return_self(call);
}

int force(Call& call) {
  call.self<Model>()->force(call.text("set"), read_components(call), read_frame(call));
  return return_self(call);
}

int gravity(Call& call) {
  lua_State* L = call.L();
  call.push("acceleration");
  if (const auto n = lua_rawlen(L, -1); n != 3)
    throw Error("gravity: argument 'acceleration': expected {gx, gy, gz}, got " + std::to_string(n) +
                " values");
  model::Components acceleration;
  for (int i = 0; i < 3; ++i) {
    lua_rawgeti(L, -1, i + 1);
    acceleration[i] = read_history(call.session(), L, -1,
                                   "gravity: argument 'acceleration[" + std::to_string(i + 1) + "]'");
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  call.self<Model>()->gravity(std::move(acceleration));
  return return_self(call);
}

int thickness(Call& call) {
  lua_pushnumber(call.L(), call.self<Model>()->thickness());
  return 1;
}

int card_of(Call& call) {
  push_object(call.L(), std::make_shared<card::Card>(call.self<Model>()->card()));
  return 1;
}

int model_text(lua_State* L) {
  const std::string words = "<" + to_object<Model>(L, 1)->describe() + ">";
  lua_pushlstring(L, words.data(), words.size());
  return 1;
}

Argument set_row() { return value_("set", text, "name of a node set"); }

std::vector<Entry> rows() {
  const std::string sample = sample_model();
  return {
      {"fabric.model",
       Style::fields,
       {object_("mesh", "mesh", "the surface"), object_("card", "card", "the fabric").optional(),
        value_("layers", table, "{ {card=, warp=, thickness=}, ... }: plies from below, in place of a card")
            .optional(),
        number_("thickness", "m", positive, "wins over the card's; mass per area follows")
            .usually(1e-5, 2e-2, "is it in m? (write 0.38*mm)")
            .optional(),
        Argument{"warp", number | numbers | function, "degrees", everything,
                 "warp direction: angle counter-clockwise about the normal from global +x, {x, y, z}, or "
                 "function(x, y, z) "
                 "returning either; default 0 on a flat generated mesh"}
            .optional(),
        integer_("points", Range{1, 9}, "integration points through the thickness").or_else(3),
        number_("offset", "", Range{-1, 1}, "reference surface: -1 lower face, 0 middle, 1 upper face")
            .or_else(0.0)},
       "The declared problem: a mesh of a fabric, to be held, moved and loaded.",
       sample + "assert(m.thickness == 0.38e-3)",
       make},
      {"model:fix",
       Style::positional,
       {set_row(),
        value_("freedoms", text, "some of x y z rx ry rz rotation; rotation is both of the director's"),
        frame_row()},
       "Holds freedoms of a node set; fixing twice is harmless.",
       sample + "m:fix('bottom', 'x y z rotation')",
       fix},
      {"model:move",
       Style::positional,
       {set_row(), components_row("m", "{x=, y=, z=}: displacement from the reference position"),
        frame_row()},
       "Prescribes displacements of a node set as histories (number, function(t), fabric.history, "
       "fabric.ramp).",
       sample + "m:move('top', { y=fabric.ramp(0.018, 1) })",
       move},
      {"model:force",
       Style::positional,
       {set_row(), components_row("N", "{x=, y=, z=}: the total force, shared by length or area"),
        frame_row()},
       "Loads a node set with a total force; a single node takes it whole.",
       sample + "m:force('top', { y=fabric.ramp(10, 1) })",
       force},
      {"model:gravity",
       Style::positional,
       {Argument{"acceleration", table, "m/s^2", everything, "{gx, gy, gz}, each a history"}},
       "Lets gravity act on the whole sheet.",
       sample + "m:gravity{0, 0, -9.81}",
       gravity},
      {"model.thickness",
       Style::property,
       {},
       "Thickness of the sheet, m.",
       sample + "assert(m.thickness > 0)",
       thickness},
      {"model.card",
       Style::property,
       {},
       "The card it was made of.",
       sample + "assert(m.card.name == 'blend')",
       card_of},
  };
}

}  // namespace

void bind_model(Session& session) {
  install(session, rows());
  bind_loads(session);
  set_meta(session, "model", "__tostring", model_text);
}

}  // namespace fabricsh::script
