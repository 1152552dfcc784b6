// fabric.model: supports, motions, loads.
#include "script/bind/model.hpp"

#include "base/number.hpp"
#include "geometry/box.hpp"
#include "model/outlook.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"

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

int return_self(const Call& call) { return call.itself(); }

// Histories of x, y, z, those that are given.
model::Components read_components(const Call& call) {
  model::Components values;
  const Fields given = call.fields("components");
  const std::string what =
      call.is("set", LUA_TSTRING) ? last_word(call.entry().name) + " '" + call.text("set") + "': " : "";
  const char* const axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    if (given.push(axes[i]) != LUA_TNIL)
      values[i] = read_history(call.session(), call.L(), -1, what + "field '" + axes[i] + "'");
    lua_pop(call.L(), 1);
  }
  return values;
}

std::string sample_model() {
  return "local mesh = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=1, ny=3 }\n"
         "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend', warp=90 }\n";
}

Argument set_or_body_row() { return object_("set", "body", "name of a node set, or a rigid body", text); }

Argument frame_row() {
  return fields_(
      "options?",
      {value_("frame?", table, "{e1, e2}: directions of x and, made normal to it, y in this call")},
      "frame = {e1, e2} for x and y that are not those of space; e2 is made normal to e1");
}

Argument components_row(const char* unit, const char* sentence) {
  return fields_("components",
                 {history_("x", unit, "history along x"), history_("y", unit, "history along y"),
                  history_("z", unit, "history along z")},
                 sentence);
}

namespace {

// Holds a rigid body in some directions.
int fix_body(Call& call, model::RigidPointer body) {
  if (call.has("options")) call.refuse("options", "a rigid body is held along global axes: expected nothing");
  const auto fixed = model::parse_freedoms(call.text("freedoms"));
  model::BodySupport support{std::move(body), fixed.translation, fixed.axis};
  if (fixed.rotation) support.turns = {true, true, true};
  return declare(call, std::move(support));
}

int fix(Call& call) {
  if (auto body = call.object<const model::Rigid>("set")) return fix_body(call, std::move(body));
  return declare(
      call, model::Support{call.text("set"), model::parse_freedoms(call.text("freedoms")), read_frame(call)});
}

// Warns of a motion that is many times as long as the mesh, which is most often a wrong unit.
void ask_about_motion(const Call& call, const model::Components& components) {
  constexpr double many = 10;
  const double length = box_of(call.self<Model>()->mesh().nodes).size().norm();
  for (std::size_t i = 0; i < 3; ++i) {
    if (!components[i]) continue;
    const auto& history = *components[i];
    double farthest = history.is_constant() ? std::abs(history.value(0)) : 0;
    for (const double t : history.kinks()) farthest = std::max(farthest, std::abs(history.value(t)));
    if (farthest <= many * length) continue;
    const std::string words = position(call.L()) + "move '" + call.text("set") + "': field '" + "xyz"[i] +
                              "': " + exact_number(farthest) + " m is " +
                              fabricsh::number(farthest / length, 7) + " times the size of the mesh (" +
                              fabricsh::number(length, 7) + " m): is it in m?";
    call.session().warn("units", words);
  }
}

// Sets position and rotation of a rigid body.
int move_body(Call& call, model::RigidPointer body) {
  model::BodyMotion motion{std::move(body), read_components(call), {}};
  const Fields given = call.fields("components");
  if (call.has("options")) call.refuse("options", "a rigid body moves along global axes: expected nothing");
  if (given.has("turn")) {
    const Fields turn = given.fields("turn");
    turn.push("angle");
    motion.turn = model::BodyTurn{read_vector(turn.numbers("axis"), "move: field 'turn.axis'"),
                                  read_history(call.session(), call.L(), -1, "field 'turn.angle'"),
                                  {}};
    if (turn.has("centre"))
      motion.turn->centre = read_vector(turn.numbers("centre"), "move: field 'turn.centre'");
  }
  return declare(call, std::move(motion));
}

// Refuses fields that apply to bodies only, if the call is for a set.
void refuse_turn(const Call& call) {
  const Fields given = call.fields("components");
  if (given.has("turn"))
    given.refuse("turn",
                 "expected a rigid body, got the set '" + call.text("set") + "' (m:turn turns a set)");
}

Argument turn_row() {
  return fields_("turn?",
                 {value_("axis", numbers, "{x, y, z}: direction of the axis"),
                  history_("angle", "degrees", "angle about the axis"),
                  value_("centre?", numbers,
                         "{x, y, z}, m: a point of the axis; default the body's centre, of a surface "
                         "without a mass that of its area")},
                 "of a rigid body: {axis=, angle=, centre=}");
}

Argument motion_row() {
  Argument row = components_row("m", "{x=, y=, z=, turn=}: displacement from the reference position");
  row.rows.push_back(turn_row());
  return row;
}

int move(Call& call) {
  if (auto body = call.object<const model::Rigid>("set")) return move_body(call, std::move(body));
  refuse_turn(call);
  auto components = read_components(call);
  ask_about_motion(call, components);
  return declare(call, model::PrescribedMotion{call.text("set"), std::move(components), read_frame(call)});
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
  return declare(call, model::Gravity{std::move(acceleration)});
}

int thickness(Call& call) { return push_value(call.L(), call.self<Model>()->thickness()); }

int card_of(Call& call) {
  return push_object(call.L(), std::make_shared<card::Card>(call.self<Model>()->card()));
}

int model_text(lua_State* L) { return push_text(L, "<" + to_object<Model>(L, 1)->describe() + ">"); }

int check_mesh(Call& call) {
  std::string text;
  for (const auto& region : model::outlook(*call.self<Model>()))
    for (const std::string& line : model::words(region)) text += (text.empty() ? "" : "\n") + line;
  return push_text(call.L(), text);
}

std::vector<Entry> model_entries() {
  const std::string sample = sample_model();
  return {
      {"fabric.model{}", model_rows(),
       "The declared problem: a mesh of a fabric, or several, to be held, moved and loaded.",
       sample + "assert(m.thickness == 0.38e-3)\n"
                "local both = fabric.model{ bodies={ { name='front', mesh=mesh, card=fabric.card 'blend' },\n"
                "  { name='back', mesh=mesh, card=fabric.card 'denim' } } }\n"
                "both:fix('front.left', 'x y z')",
       make_model},
      {"model:fix()",
       {set_or_body_row(),
        value_("freedoms", text,
               "some of x y z rx ry rz rotation; rotation is both of the director's, or all three of a body"),
        frame_row()},
       "Holds freedoms of a node set, or of a rigid body that forces place in the others; fixing twice is "
       "harmless.",
       sample + "m:fix('bottom', 'x y z rotation')",
       fix},
      {"model:move()",
       {set_or_body_row(), motion_row(), frame_row()},
       "Prescribes displacements of a node set, or of a rigid body, as histories (number, function(t), "
       "fabric.history, fabric.ramp).",
       sample + "m:move('top', { y=fabric.ramp(0.018, 1) })",
       move},
      {"model:gravity()",
       {Argument{"acceleration", table, "m/s^2", everything, "{gx, gy, gz}, each a history"}},
       "Lets gravity act on the whole cloth, and on rigid bodies that have a mass and forces place. A second "
       "call takes the place of the first.",
       sample + "m:gravity{0, 0, -9.81}",
       gravity},
      without_arguments(
          "model:check",
          "The suitability of the mesh for this cloth, as two lines for each region: how yarns "
          "cross its elements, and how large folds are beside elements, by weight and on bodies that "
          "give way.",
          sample + "print(m:check())\nassert(m:check():find 'folds')", check_mesh),
      without_arguments("model.thickness", "Thickness of the sheet, m; of several bodies the first one's.",
                        sample + "assert(m.thickness > 0)", thickness),
      without_arguments("model.card", "The card it was made of; of several bodies the first one's.",
                        sample + "assert(m.card.name == 'blend')", card_of),
  };
}

}  // namespace

void bind_model(Session& session) {
  install(session, model_entries());
  bind_loads(session);
  set_meta(session, "model", "__tostring", model_text);
}

}  // namespace fabricsh::script
