// model:list: the declarations of a model, call by call.
#include <algorithm>
#include <numbers>

#include "base/number.hpp"
#include "model/model.hpp"
#include "script/bind/model.hpp"
#include "script/bind/rooms.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"
#include "script/show/show.hpp"

namespace fabricsh::script {

using model::Model;

namespace {

std::string brief_number(double x) { return fabricsh::number(x, 7); }

constexpr const char* model_key = "model";
constexpr const char* axis_names[] = {"x", "y", "z"};

// number: index among its kind, from 0; -1: part of the model's construction, which cannot be removed.
struct Declared {
  std::string kind, set, what;
  Model::DeclarationKind declaration = Model::DeclarationKind::fix;
  int number = -1;
  void (*take)(Model& model, std::size_t number) = nullptr;  // removes a load
  void remove_from(Model& model) const {
    const auto i = static_cast<std::size_t>(number);
    take != nullptr ? take(model, i) : model.remove(declaration, i);
  }
};

// The rows of one kind, numbered in their order.
class DeclaredRows {
 public:
  DeclaredRows(std::vector<Declared>& all, std::string kind, Model::DeclarationKind declaration)
      : all_(all), kind_(std::move(kind)), declaration_(declaration) {}
  void add(const std::string& set, const std::string& what) {
    all_.push_back({kind_, set, what, declaration_, count_++});
  }

 private:
  std::vector<Declared>& all_;
  std::string kind_;
  Model::DeclarationKind declaration_;
  int count_ = 0;
};

void add_word(std::string& words, const std::string& more) { words += (words.empty() ? "" : ", ") + more; }

std::string history_words(const model::History& h, const std::string& unit) {
  if (h.is_constant()) return brief_number(h.value(0)) + " " + unit;
  if (h.kinks().empty()) return "function of time";
  return brief_number(h.value(h.kinks().front())) + " to " + brief_number(h.value(h.kinks().back())) + " " +
         unit + " at " + brief_number(h.kinks().back()) + " s";
}

// With the unit once at the end if all components are plain numbers, otherwise after each.
std::string component_words(const model::Components& components, const std::string& unit) {
  std::string words;
  const bool plain =
      std::all_of(components.begin(), components.end(), [](const auto& h) { return !h || h->is_constant(); });
  for (std::size_t i = 0; i < 3; ++i) {
    if (!components[i]) continue;
    add_word(words,
             std::string(axis_names[i]) + " " +
                 (plain ? brief_number(components[i]->value(0)) : history_words(*components[i], unit)));
  }
  return plain ? words + " " + unit : words;
}

std::string oblique(const Mat3& frame) {
  if (frame.isApprox(model::global_frame())) return "";
  std::string words = " along {";
  for (int row = 0; row < 2; ++row)
    words += std::string(row > 0 ? ", " : "") + "{" + brief_number(frame(row, 0)) + ", " +
             brief_number(frame(row, 1)) + ", " + brief_number(frame(row, 2)) + "}";
  return words + "}";
}

std::string freedom_words(const model::FixedFreedoms& freedoms) {
  std::string words;
  const auto add = [&words](bool held, const std::string& word) {
    if (held) words += (words.empty() ? "" : " ") + word;
  };
  for (std::size_t i = 0; i < 3; ++i) add(freedoms.translation[i], axis_names[i]);
  for (std::size_t i = 0; i < 3; ++i) add(freedoms.axis[i], std::string("r") + axis_names[i]);
  add(freedoms.rotation, "rotation");
  return words;
}

std::string vector_words(const Vec3& v) {
  return "{" + brief_number(v.x()) + ", " + brief_number(v.y()) + ", " + brief_number(v.z()) + "}";
}

// Adds bodies and regions, unless there is only one sheet with one card.
void add_sheets(const Model& m, std::vector<Declared>& all) {
  if (m.regions().size() < 2) return;
  for (std::size_t r = 0; r < m.regions().size(); ++r) {
    const auto& region = m.regions()[r];
    const bool is_body = r == 0 || m.regions()[r - 1].body != region.body;
    all.push_back({is_body ? "body" : "region", region.name.empty() ? "all" : region.name,
                   "card " + region.card.name + ", " + brief_number(m.sections()[r].thickness * 1e3) + " mm" +
                       (region.options.warp ? ", warp " + region.options.warp_text : "")});
  }
}

std::string seam_words(const model::Seam& seam) {
  std::string words = seam.over ? "over " + brief_number(*seam.over) + " s" : "from the start";
  if (seam.hinge) words += *seam.hinge ? ", a hinge" : ", bends as one piece";
  if (seam.reverse) words += *seam.reverse ? ", reversed" : ", not reversed";
  if (seam.stiffness) add_word(words, "stiffness " + brief_number(*seam.stiffness) + " N/m^2");
  if (seam.strength)
    add_word(words,
             "strength " + brief_number(*seam.strength) + " N/m, " + brief_number(*seam.energy) + " J/m");
  return words;
}

// A value along each axis along which there is one.
template <class Values>
std::string axis_words(const Values& v) {
  std::string words;
  for (int i = 0; i < 3; ++i)
    if (const double value = v[static_cast<decltype(v.size())>(i)]; value != 0)
      add_word(words, std::string(axis_names[i]) + " " + brief_number(value));
  return words;
}

// The members of a load in words.
struct LoadWords {
  std::string words, along;
  void components(const model::Components& value, const char* unit) {
    add_word(words, component_words(value, unit));
  }
  void history(const char*, const model::History& value, const char* unit) {
    add_word(words, history_words(value, unit));
  }
  void frame(const Mat3& value) { along = oblique(value); }
  void stiffness(const std::array<double, 3>& value, const char* unit) {
    add_word(words, axis_words(value) + " " + unit);
  }
};

// The loads, or what resists.
template <bool resisting>
void tell_loads(const Model& m, std::vector<Declared>& all) {
  model::each_kind(m.loads(), [&all](const auto& loads) {
    using Load = typename std::decay_t<decltype(loads)>::value_type;
    if (model::resists<Load> != resisting) return;
    int number = 0;
    for (const auto& load : loads) {
      LoadWords words;
      load.tell(words);
      all.push_back(
          {Load::call, load.set, words.words + words.along, {}, number++, [](Model& model, std::size_t i) {
             model.remove<Load>(i);
           }});
    }
  });
}

void add_supports(const Model& m, std::vector<Declared>& all) {
  using DeclarationKind = Model::DeclarationKind;
  DeclaredRows fixed(all, "fix", DeclarationKind::fix);
  for (const auto& s : m.supports()) fixed.add(s.set, freedom_words(s.fixed) + oblique(s.frame));
  DeclaredRows moved(all, "move", DeclarationKind::move);
  for (const auto& s : m.motions()) moved.add(s.set, component_words(s.displacement, "m") + oblique(s.frame));
  DeclaredRows turned(all, "turn", DeclarationKind::turn);
  for (const auto& t : m.turns())
    turned.add(t.set, history_words(t.angle, "degrees") + " about " + vector_words(t.axis) +
                          (t.centre ? " through " + vector_words(*t.centre) : ""));
  tell_loads<true>(m, all);
  DeclaredRows zones(all, "tearable", DeclarationKind::tearable);
  for (const auto& zone : m.zones())
    zones.add(zone.set,
              "its joints may open" +
                  (zone.path.empty() ? "" : "; yarns break at the nodes of " + zone.path + " only"));
  DeclaredRows strengths(all, "strength", DeclarationKind::strength);
  for (const auto& s : m.strengths())
    strengths.add(s.set, brief_number(s.factor) + " times the card's" +
                             (s.modulus > 0 ? ", Weibull modulus " + brief_number(s.modulus) : ""));
  DeclaredRows creased(all, "crease", DeclarationKind::crease);
  for (const auto& c : m.creases())
    creased.add(c.set.empty() ? "line" : c.set,
                "at rest at " + brief_number(c.angle) + " degrees" +
                    (c.stiffness ? ", " + brief_number(*c.stiffness) + " N/rad" : ""));
  DeclaredRows banded(all, "band", DeclarationKind::band);
  for (const auto& b : m.bands())
    banded.add(b.set, brief_number(b.stiffness) + " N, " + brief_number(100 * b.ease) + " % shorter" +
                          (b.over ? " over " + brief_number(*b.over) + " s" : ""));
  DeclaredRows sewn(all, "seam", DeclarationKind::seam);
  for (const auto& s : m.seams()) sewn.add(s.first + " to " + s.second, seam_words(s));
  constexpr const char* kinds[] = {"equal", "straight", "rigid", "periodic"};
  DeclaredRows tied(all, "tie", DeclarationKind::tie);
  for (const auto& t : m.ties()) {
    std::string words = kinds[static_cast<int>(t.kind)];
    if (!t.partner.empty()) words += " with " + t.partner;
    if (const std::string freedoms = freedom_words(t.freedoms); !freedoms.empty()) words += ", " + freedoms;
    tied.add(t.set, words);
  }
}

void add_loads(const Model& m, std::vector<Declared>& all) {
  using DeclarationKind = Model::DeclarationKind;
  tell_loads<false>(m, all);
  DeclaredRows gases(all, "gas", DeclarationKind::gas);
  for (const auto& g : m.gases()) {
    std::string sets,
        words = g->mass ? brief_number(*g->mass) + " kg" : brief_number(g->initial) + " Pa at the start";
    for (const auto& set : g->sets) add_word(sets, set);
    add_word(words, "exponent " + brief_number(g->exponent));
    if (g->inflow) add_word(words, "inflow " + history_words(*g->inflow, "kg/s"));
    if (!g->vents.empty()) add_word(words, counted(g->vents.size(), "vent"));
    if (g->leakage) add_word(words, "leakage " + g->leakage_words);
    gases.add(sets, words);
  }
  if (m.gravity()[0] || m.gravity()[1] || m.gravity()[2])
    DeclaredRows(all, "gravity", DeclarationKind::gravity).add("all", component_words(m.gravity(), "m/s^2"));
  DeclaredRows velocities(all, "velocity", DeclarationKind::velocity);
  for (const auto& v : m.velocities()) {
    std::string words = vector_words(v.linear) + " m/s";
    if (!v.spin.isZero())
      words += ", spin " + vector_words(v.spin * 180 / std::numbers::pi) + " degrees/s about " +
               vector_words(v.centre);
    velocities.add(v.set, v.place ? "function of place" : words);
  }
}

// What loads, ties and holds rigid bodies.
void add_body_loads(const model::Interactions& given, std::vector<Declared>& all) {
  using DeclarationKind = Model::DeclarationKind;
  int number = 0;
  for (const auto& load : given.loads())
    all.push_back({load.moment ? "moment" : "force", given.name_of(*load.body),
                   component_words(load.total, load.moment ? "N m" : "N"), DeclarationKind::body_load,
                   number++});
  number = 0;
  for (const auto& s : given.springs())
    all.push_back({s.damper ? "damper" : "spring", given.name_of(*s.body),
                   axis_words(s.stiffness) + (s.damper ? " N s/m" : " N/m") +
                       (s.to      ? " to " + given.name_of(*s.to)
                        : s.place ? ", slack at " + vector_words(*s.place) + " m"
                                  : ""),
                   DeclarationKind::body_spring, number++});
  number = 0;
  for (const auto& s : given.supports())
    all.push_back({"fix", given.name_of(*s.body), freedom_words({s.moves, s.turns, false}),
                   DeclarationKind::body_fix, number++});
}

void add_contacts(const Model& m, std::vector<Declared>& all) {
  const auto& given = m.interactions();
  int number = 0;
  for (const auto& motion : given.motions()) {
    std::string words = component_words(motion.displacement, "m");
    if (motion.turn)
      add_word(words, "turn " + history_words(motion.turn->angle, "degrees") + " about " +
                          vector_words(motion.turn->axis));
    all.push_back({"move", given.name_of(*motion.body), words, Model::DeclarationKind::body_move, number++});
  }
  add_body_loads(given, all);
  number = 0;
  for (const auto& v : given.velocities())
    all.push_back({"velocity", given.name_of(*v.body),
                   vector_words(v.linear) + " m/s, spin " + vector_words(v.spin * 180 / std::numbers::pi) +
                       " degrees/s",
                   Model::DeclarationKind::body_velocity, number++});
  number = 0;
  for (const auto& c : given.contacts()) {
    std::string sides, words = "friction " + brief_number(c.friction);
    if (c.sticking) add_word(words, "static " + brief_number(*c.sticking));
    if (c.across) words += " along the warp, " + brief_number(*c.across) + " across";
    if (c.viscosity)
      add_word(words, "film of " + brief_number(*c.viscosity) + " Pa s, " + brief_number(*c.film) + " m");
    if (c.film_speed > 0)
      add_word(words, "thinner above " + brief_number(c.film_speed) + " m/s, exponent " +
                          brief_number(c.film_exponent));
    for (const auto& party : c.between)
      sides += (sides.empty() ? "" : " and ") + (party.body ? given.name_of(*party.body) : party.set);
    if (c.between.size() == 1) sides += " on itself";
    if (c.thickness) add_word(words, "thickness " + brief_number(*c.thickness) + " m");
    if (c.stiffness) add_word(words, "stiffness " + brief_number(*c.stiffness) + " Pa/m");
    if (c.restitution != model::ContactGiven::usual_restitution)
      add_word(words, "restitution " + brief_number(c.restitution));
    if (c.settle) add_word(words, "settles over " + brief_number(*c.settle) + " s");
    all.push_back({"contact", sides, words, Model::DeclarationKind::contact, number++});
  }
}

std::vector<Declared> declared(const Model& m) {
  std::vector<Declared> all;
  add_sheets(m, all);
  add_supports(m, all);
  add_loads(m, all);
  add_contacts(m, all);
  return all;
}

int list_text(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const std::string words = rows_text(L, 1, {"kind", "set", "what"}, "no supports, no loads");
  lua_pushlstring(L, words.data(), words.size());
  return 1;
}

int list(Call& call) {
  lua_State* L = call.L();
  const std::vector<Declared> all = declared(*call.self<Model>());
  lua_createtable(L, static_cast<int>(all.size()), 0);
  lua_Integer place = 0;
  for (const Declared& one : all) {
    lua_newtable(L);
    set_text(L, "kind", one.kind);
    set_text(L, "set", one.set);
    set_text(L, "what", one.what);
    lua_rawseti(L, -2, ++place);
  }
  set_text_of(L, "fabricsh.declared", list_text);
  return 1;
}

// The index in m:list() of the argument: a number, or a row; among equal rows the last one.
std::size_t place_of(const Call& call, const std::vector<Declared>& all) {
  lua_State* L = call.L();
  if (call.is("row", LUA_TNUMBER)) {
    const auto number = call.integer("row");
    if (number < 1 || number > static_cast<std::int64_t>(all.size()))
      throw Error("remove: argument 'row': expected a number from 1 to " + std::to_string(all.size()) +
                  " of m:list(), got " + std::to_string(number));
    return static_cast<std::size_t>(number) - 1;
  }
  const Fields row = call.fields("row");
  const std::string kind = row.text("kind"), set = row.text("set");
  const bool any = !row.has("what");
  for (std::size_t i = all.size(); i-- > 0;)
    if (all[i].kind == kind && all[i].set == set && (any || all[i].what == row.text("what"))) {
      lua_pop(L, 1);
      return i;
    }
  throw Error("remove: the model has no " + kind + " of '" + set + "'" +
              (any ? "" : " with '" + row.text("what") + "'") + " (m:list() shows what it has)");
}

int remove(Call& call) {
  const auto model = call.self<Model>();
  const auto all = declared(*model);
  const Declared& one = all[place_of(call, all)];
  if (one.number < 0)
    throw Error("remove: a " + one.kind +
                " is part of the model itself and cannot be removed: make a new model");
  one.remove_from(*model);
  return return_self(call);
}

// "pressure", or of one set alone "fix left".
void take_away(const Call& call, const std::string& words, Model& model) {
  const auto all = declared(model);
  bool found = false;
  for (std::size_t i = all.size(); i-- > 0;) {
    const Declared& one = all[i];
    if (one.number < 0 || (words != one.kind && words != one.kind + " " + one.set)) continue;
    one.remove_from(model);
    found = true;
  }
  if (found) return;
  std::vector<std::string> known;
  for (const Declared& one : all)
    if (one.number >= 0)
      for (const std::string& name : {one.kind, one.kind + " " + one.set})
        if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
  call.refuse("changes.without", known.empty() ? "the model has nothing that could be left out"
                                               : unknown("declaration", words, known));
}

int copy(Call& call) {
  lua_State* L = call.L();
  const auto made = call.self<Model>()->copy();
  if (call.has("changes")) {
    const Fields changes = call.fields("changes");
    if (changes.push("without") == LUA_TSTRING) {
      take_away(call, lua_tostring(L, -1), *made);
    } else if (lua_istable(L, -1)) {
      for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; ++i) {
        if (lua_type(L, -1) != LUA_TSTRING)
          call.refuse("changes.without", "expected texts in the list, got " + describe(L, -1));
        take_away(call, lua_tostring(L, -1), *made);
        lua_pop(L, 1);
      }
      lua_pop(L, 1);
    }
    lua_pop(L, 2);
  }
  push_object(L, made);
  return 1;
}

// The mesh object itself refuses changes when an analysis uses the mesh.
void push_mesh(lua_State* L, const Model& model) {
  push_object(L, std::const_pointer_cast<mesh::Mesh>(model.mesh_pointer()));
}

int mesh_of(Call& call) {
  push_mesh(call.L(), *call.self<Model>());
  return 1;
}

// Pushes the model object that the deck made; the run keeps it together with its hooks.
int model_of_run(Call& call) {
  lua_getiuservalue(call.L(), 1, 1);
  lua_getfield(call.L(), -1, model_key);
  return 1;
}

int mesh_of_run(Call& call) {
  push_mesh(call.L(), call.self<DeckRun>()->analysis->model());
  return 1;
}

std::vector<Entry> declared_entries() {
  const std::string sample = sample_model();
  return {
      {"model.mesh",
       Style::property,
       {},
       "The mesh it was made of.",
       sample + "assert(#m.mesh.nodes == 8)",
       mesh_of},
      {"model:list",
       Style::positional,
       {},
       "Its supports and loads (before them bodies and regions, if any): rows of kind "
       "(the call's name), set and what, which print as a "
       "table.",
       sample + "m:fix('bottom', 'x y z'):gravity{0, 0, -9.81}\nlocal list = m:list()\n"
                "assert(list[1].kind == 'fix' and list[1].set == 'bottom' and list[1].what == 'x y z')\n"
                "assert(list[2].what == 'x 0, y 0, z -9.81 m/s^2')",
       list},
      {"model:remove",
       Style::positional,
       {[] {
         Argument row = fields_("row",
                                {value_("kind", text, "the call's name"), value_("set", text, "its set"),
                                 value_("what", text, "as listed; without it the last of them").optional()},
                                "a row of m:list(), or its number");
         row.kinds |= integer;
         return row;
       }()},
       "Takes back (undoes) a support or a load: a row of m:list() or its number.",
       sample + "m:fix('bottom', 'x y z'):gravity{0, 0, -9.81}\nm:remove(m:list()[2])\n"
                "assert(#m:list() == 1)\nm:remove{ kind='fix', set='bottom' }\nassert(#m:list() == 0)",
       remove},
      {"model:copy",
       Style::positional,
       {fields_(
            "changes",
            {value_(
                 "without", text | table,
                 "what the copy does not have: a kind of m:list() or kind and set, 'pressure' or 'fix left', "
                 "or a list of these")
                 .optional()},
            "what differs; supports and loads are added by its calls")
            .optional()},
       "A model of the same cloth with the same supports and loads, which may be changed also where a run "
       "has "
       "compiled this one.",
       sample + "m:fix('bottom', 'x y z'):gravity{0, 0, -9.81}\nlocal free = m:copy{ without='fix bottom' }\n"
                "assert(#free:list() == 1 and #m:list() == 2)",
       copy},
      {"analysis.model",
       Style::property,
       {},
       "The model that it computes.",
       sample_run() + "assert(a.model == m and #a.model:list() == 4)",
       model_of_run},
      {"analysis.mesh",
       Style::property,
       {},
       "The mesh of its model, as it was before the run.",
       sample_run() + "assert(#a.mesh.elements == #a:field 'E11')",
       mesh_of_run},
  };
}

}  // namespace

void keep_model(const Call& call) {
  lua_State* L = call.L();
  lua_getiuservalue(L, -1, 1);
  if (call.push("model") == LUA_TNIL) {  // that of the run from which this one begins
    lua_pop(L, 1);
    call.push("from");
    lua_getiuservalue(L, -1, 1);
    lua_getfield(L, -1, model_key);
    lua_replace(L, -3);
    lua_pop(L, 1);
  }
  lua_setfield(L, -2, model_key);
  lua_pop(L, 1);
}

void bind_declared(Session& session) { install(session, declared_entries()); }

}  // namespace fabricsh::script
