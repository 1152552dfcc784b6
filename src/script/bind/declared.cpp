// model:list: the declarations of a model, call by call.
#include <algorithm>
#include <functional>

#include "base/number.hpp"
#include "model/model.hpp"
#include "script/bind/model.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"
#include "script/show/show.hpp"

namespace fabricsh::script {

using model::Model;

namespace {

std::string brief_number(double x) { return fabricsh::number(x, 7); }

constexpr const char* axis_names[] = {"x", "y", "z"};

struct Declared {
  std::string kind, set, what;
  std::function<void(Model&)> remove =
      {};  // empty: part of the model's construction, which cannot be removed
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
  for (const std::string& word : model::held_words(freedoms)) words += (words.empty() ? "" : " ") + word;
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

// A value along each axis along which there is one.
template <class Values>
std::string axis_words(const Values& v) {
  std::string words;
  for (int i = 0; i < 3; ++i)
    if (const double value = v[static_cast<decltype(v.size())>(i)]; value != 0)
      add_word(words, std::string(axis_names[i]) + " " + brief_number(value));
  return words;
}

// The members of a declaration in words. Those that begin with a blank, a comma or a semicolon are last.
class ListWords : public model::DeclarationVisitor {
 public:
  explicit ListWords(const Model& model) : given_(model.interactions()) {}
  std::string where, words, along;
  void set(const std::string& name, auto...) { where = name; }
  void set(const std::string& first, const std::string& second) { where = first + " to " + second; }
  void place(const char* name) { where = name; }
  void sets(const std::vector<std::string>& names) {
    for (const std::string& name : names) add_word(where, name);
  }
  void sides(const std::vector<model::Party>& all) {
    for (const auto& party : all)
      where += (where.empty() ? "" : " and ") + (party.body ? given_.name_of(*party.body) : party.set);
    if (all.size() == 1) where += " on itself";
  }
  void body(const model::RigidPointer& body) { where = given_.name_of(*body); }
  void to(const model::RigidPointer& other) {
    if (other) add(" to " + given_.name_of(*other));
  }
  void freedoms(const model::FixedFreedoms& value) { add(freedom_words(value)); }
  void components(const model::Components& value, const char* unit, auto...) {
    add(component_words(value, unit));
  }
  void history(const char*, const std::optional<model::History>& value, const char* unit,
               const char* phrase = "#", auto...) {
    if (value) add(phrase, history_words(*value, unit));
  }
  void time(const char* name, const std::optional<double>& value, const char* phrase,
            const char* without = "", auto...) {
    value ? number(name, value, phrase) : add(without);
  }
  void number(const char*, const std::optional<double>& value, const char* phrase, double scale = 1,
              auto...) {
    if (value) add(phrase, brief_number(scale * *value));
  }
  void flag(const char*, const std::optional<bool>& value, const std::string& yes = "",
            const std::string& no = "") {
    if (value) add(*value ? yes : no);
  }
  void text(const char*, const std::string& value, const std::string& phrase) { add(phrase, value); }
  void vector(const char*, const std::optional<Vec3>& value, const char* phrase, auto...) {
    if (value) add(phrase, vector_words(*value));
  }
  void stiffness(const std::array<double, 3>& value, const char* unit) {
    add(axis_words(value) + " " + unit);
  }
  void frame(const Mat3& value) { along = oblique(value); }

 private:
  void add(std::string phrase, const std::string& value) {
    if (const auto at = phrase.find('#'); at != phrase.npos) phrase.replace(at, 1, value);
    add(phrase);
  }
  void add(const std::string& phrase) {
    if (phrase.empty()) return;
    if (phrase.find_first_of(" ,;") == 0)
      along += phrase;
    else
      add_word(words, phrase);
  }
  model::Interactions given_;
};

std::vector<Declared> declared(const Model& m) {
  std::vector<Declared> all;
  add_sheets(m, all);
  m.declarations().each_kind([&]<class D>(const std::vector<D>& kind) {
    for (std::size_t i = 0; i < kind.size(); ++i) {
      ListWords told(m);
      model::tell(kind[i], told);
      all.push_back({model::plain(kind[i]).call(), told.where, told.words + told.along,
                     [i](Model& model) { model.remove<D>(i); }});
    }
  });
  return all;
}

int list_text(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  return push_text(L, rows_text(L, 1, {"kind", "set", "what"}, "no supports, no loads"));
}

int list(Call& call) {
  lua_State* L = call.L();
  const std::vector<Declared> all = declared(*call.self<Model>());
  push_list(L, all,
            [&](const Declared& one) { push_record(L, "kind", one.kind, "set", one.set, "what", one.what); });
  set_text_of(L, "fabricsh.declared", list_text);
  return 1;
}

// The index in m:list() of the argument: a number, or a row; among equal rows the last one.
std::size_t place_of(const Call& call, const std::vector<Declared>& all) {
  if (call.is("row", LUA_TNUMBER)) {
    if (all.empty()) throw Error("remove: expected something declared, the model has nothing in m:list()");
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
      lua_pop(call.L(), 1);
      return i;
    }
  throw Error("remove: the model has no " + kind + " of '" + set + "'" +
              (any ? "" : " with '" + row.text("what") + "'") + " (m:list() shows what it has)");
}

int remove(Call& call) {
  const auto model = call.self<Model>();
  const auto all = declared(*model);
  const Declared& one = all[place_of(call, all)];
  if (!one.remove)
    throw Error("remove: a " + one.kind +
                " is part of the model itself and cannot be removed: make a new model");
  one.remove(*model);
  return return_self(call);
}

// "pressure", or of one set alone "fix left".
void take_away(const Call& call, const std::string& words, Model& model) {
  const auto all = declared(model);
  bool found = false;
  for (std::size_t i = all.size(); i-- > 0;) {
    const Declared& one = all[i];
    if (!one.remove || (words != one.kind && words != one.kind + " " + one.set)) continue;
    one.remove(model);
    found = true;
  }
  if (found) return;
  std::vector<std::string> known;
  for (const Declared& one : all)
    if (one.remove)
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
    if (changes.has("without"))
      for (const std::string& words : changes.texts("without", "texts in the list"))
        take_away(call, words, *made);
    lua_pop(L, 1);
  }
  return push_object(L, made);
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
  lua_getfield(call.L(), -1, "model");
  return 1;
}

int mesh_of_run(Call& call) {
  push_mesh(call.L(), call.self<DeckRun>()->analysis->model());
  return 1;
}

std::vector<Entry> declared_entries() {
  const std::string sample = sample_model();
  return {
      without_arguments("model.mesh", "The mesh it was made of.", sample + "assert(#m.mesh.nodes == 8)",
                        mesh_of),
      without_arguments(
          "model:list",
          "Its supports and loads (before them bodies and regions, if any): rows of kind (the call's name), "
          "set and what, which print as a table.",
          sample + "m:fix('bottom', 'x y z'):gravity{0, 0, -9.81}\nlocal list = m:list()\n"
                   "assert(list[1].kind == 'fix' and list[1].set == 'bottom' and list[1].what == 'x y z')\n"
                   "assert(list[2].what == 'x 0, y 0, z -9.81 m/s^2')",
          list),
      {"model:remove()",
       {[] {
         Argument row = fields_("row",
                                {value_("kind", text, "the call's name"), value_("set", text, "its set"),
                                 value_("what?", text, "as listed; without it the last of them")},
                                "a row of m:list(), or its number");
         row.kinds |= integer;
         return row;
       }()},
       "Takes back (undoes) a support or a load: a row of m:list() or its number.",
       sample + "m:fix('bottom', 'x y z'):gravity{0, 0, -9.81}\nm:remove(m:list()[2])\n"
                "assert(#m:list() == 1)\nm:remove{ kind='fix', set='bottom' }\nassert(#m:list() == 0)",
       remove},
      {"model:copy()",
       {fields_("changes?",
                {value_("without?", text | table,
                        "what the copy does not have: a kind of m:list() or kind and set, 'pressure' or 'fix "
                        "left', or a list of these")},
                "what differs; supports and loads are added by its calls")},
       "A model of the same cloth with the same supports and loads, which may be changed also where a run "
       "has compiled this one.",
       sample + "m:fix('bottom', 'x y z'):gravity{0, 0, -9.81}\nlocal free = m:copy{ without='fix bottom' }\n"
                "assert(#free:list() == 1 and #m:list() == 2)",
       copy},
      without_arguments("analysis.model", "The model that it computes.",
                        sample_run() + "assert(a.model == m and #a.model:list() == 4)", model_of_run),
      without_arguments("analysis.mesh", "The mesh of its model, as it was before the run.",
                        sample_run() + "assert(#a.mesh.elements == #a:field 'E11')", mesh_of_run),
  };
}

}  // namespace

void bind_declared(Session& session) { install(session, declared_entries()); }

}  // namespace fabricsh::script
