// model:list: what a model was told, call by call.
#include <algorithm>
#include <numbers>

#include "model/model.hpp"
#include "script/bind.hpp"
#include "script/bind_model.hpp"
#include "script/bind_run.hpp"
#include "script/show.hpp"
#include "script/words.hpp"

namespace fabricsh::script {

using model::Model;

namespace {

constexpr const char* model_key = "model";
constexpr const char* axes[] = {"x", "y", "z"};

struct Declared {
  std::string kind, set, what;
};

void add_word(std::string& words, const std::string& more) { words += (words.empty() ? "" : ", ") + more; }

std::string history_words(const model::History& h, const std::string& unit) {
  if (h.is_constant()) return brief_number(h.value(0)) + " " + unit;
  if (h.kinks().empty()) return "function of time";
  return brief_number(h.value(h.kinks().front())) + " to " + brief_number(h.value(h.kinks().back())) + " " +
         unit + " at " + brief_number(h.kinks().back()) + " s";
}

// The unit once where all of them are plain numbers, else behind each number.
std::string component_words(const model::Components& components, const std::string& unit) {
  std::string words;
  const bool plain =
      std::all_of(components.begin(), components.end(), [](const auto& h) { return !h || h->is_constant(); });
  for (std::size_t i = 0; i < 3; ++i) {
    if (!components[i]) continue;
    add_word(words,
             std::string(axes[i]) + " " +
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

std::string freedom_words(const model::Freedoms& freedoms) {
  std::string words;
  const auto add = [&words](bool held, const std::string& word) {
    if (held) words += (words.empty() ? "" : " ") + word;
  };
  for (std::size_t i = 0; i < 3; ++i) add(freedoms.translation[i], axes[i]);
  for (std::size_t i = 0; i < 3; ++i) add(freedoms.axis[i], std::string("r") + axes[i]);
  add(freedoms.rotation, "rotation");
  return words;
}

std::string vector_words(const Vec3& v) {
  return "{" + brief_number(v.x()) + ", " + brief_number(v.y()) + ", " + brief_number(v.z()) + "}";
}

void add_supports(const Model& m, std::vector<Declared>& all) {
  for (const auto& s : m.supports()) all.push_back({"fix", s.set, freedom_words(s.fixed) + oblique(s.frame)});
  for (const auto& s : m.motions())
    all.push_back({"move", s.set, component_words(s.displacement, "m") + oblique(s.frame)});
  for (const auto& t : m.turns())
    all.push_back({"turn", t.set,
                   history_words(t.angle, "degrees") + " about " + vector_words(t.axis) +
                       (t.centre ? " through " + vector_words(*t.centre) : "")});
  for (const auto& s : m.springs()) {
    std::string words;
    for (std::size_t i = 0; i < 3; ++i)
      if (s.stiffness[i] != 0) add_word(words, std::string(axes[i]) + " " + brief_number(s.stiffness[i]));
    all.push_back({"spring", s.set, words + " N/m" + oblique(s.frame)});
  }
  constexpr const char* kinds[] = {"equal", "straight", "rigid", "periodic"};
  for (const auto& t : m.ties()) {
    std::string words = kinds[static_cast<int>(t.kind)];
    if (!t.partner.empty()) words += " with " + t.partner;
    if (const std::string freedoms = freedom_words(t.freedoms); !freedoms.empty()) words += ", " + freedoms;
    all.push_back({"tie", t.set, words});
  }
}

void add_loads(const Model& m, std::vector<Declared>& all) {
  for (const auto& f : m.forces())
    all.push_back({"force", f.set, component_words(f.total, "N") + oblique(f.frame)});
  for (const auto& f : m.moments())
    all.push_back({"moment", f.set, component_words(f.total, "N m") + oblique(f.frame)});
  for (const auto& t : m.tractions())
    all.push_back({"traction", t.set, component_words(t.intensity, "N/m^2 or N/m") + oblique(t.frame)});
  for (const auto& p : m.pressures()) all.push_back({"pressure", p.set, history_words(p.value, "Pa")});
  if (m.gravity()[0] || m.gravity()[1] || m.gravity()[2])
    all.push_back({"gravity", "all", component_words(m.gravity(), "m/s^2")});
  for (const auto& v : m.velocities()) {
    std::string words = vector_words(v.linear) + " m/s";
    if (!v.spin.isZero())
      words += ", spin " + vector_words(v.spin * 180 / std::numbers::pi) + " degrees/s about " +
               vector_words(v.centre);
    all.push_back({"velocity", v.set, v.place ? "function of place" : words});
  }
}

int list_text(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const std::string words = rows_text(L, 1, {"kind", "set", "what"}, "no supports, no loads");
  lua_pushlstring(L, words.data(), words.size());
  return 1;
}

int list(Call& call) {
  lua_State* L = call.L();
  std::vector<Declared> all;
  const auto model = call.self<Model>();
  add_supports(*model, all);
  add_loads(*model, all);
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

// The object refuses changes by itself once an analysis uses the mesh.
void push_mesh(lua_State* L, const Model& model) {
  push_object(L, std::const_pointer_cast<mesh::Mesh>(model.mesh_pointer()));
}

int mesh_of(Call& call) {
  push_mesh(call.L(), *call.self<Model>());
  return 1;
}

// The object that the deck made; with it the run keeps its hooks there.
int model_of_run(Call& call) {
  lua_getiuservalue(call.L(), 1, 1);
  lua_getfield(call.L(), -1, model_key);
  return 1;
}

int mesh_of_run(Call& call) {
  push_mesh(call.L(), call.self<Run>()->analysis->model());
  return 1;
}

std::vector<Entry> rows() {
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
       "What it was told, supports first: rows of kind (the call's name), set and what, which print as a "
       "table.",
       sample + "m:fix('bottom', 'x y z'):gravity{0, 0, -9.81}\nlocal told = m:list()\n"
                "assert(told[1].kind == 'fix' and told[1].set == 'bottom' and told[1].what == 'x y z')\n"
                "assert(told[2].what == 'x 0, y 0, z -9.81 m/s^2')",
       list},
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
  call.push("model");
  lua_setfield(L, -2, model_key);
  lua_pop(L, 1);
}

void bind_declared(Session& session) { install(session, rows()); }

}  // namespace fabricsh::script
