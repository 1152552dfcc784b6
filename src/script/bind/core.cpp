// fabric.version, fabric.units, fabric.poly, fabric.globals, and functions used by the other bindings.
#include "base/version.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"
#include "script/show/transcript.hpp"

namespace fabricsh::script {

void push_warnings(lua_State* L, const WarningLog::Warnings& warnings) {
  push_list(L, warnings, [L](const run::Warning& w) {
    push_record(L, "code", w.code, "text", w.text, "time", w.time);
    if (w.element >= 0) put(L, "element", w.element + 1);
    put(L, "serious", w.serious);
  });
}

namespace {

struct Unit {
  const char* name;
  double factor;
};
constexpr double kGravity = 9.80665;
constexpr double pound = 0.45359237;
constexpr double yard = 0.9144;
constexpr double degrees_per_radian = 57.295779513082320877;
constexpr Unit units[] = {{"m", 1},
                          {"mm", 1e-3},
                          {"cm", 1e-2},
                          {"um", 1e-6},
                          {"inch", 0.0254},
                          {"yd", yard},
                          {"Pa", 1},
                          {"kPa", 1e3},
                          {"MPa", 1e6},
                          {"GPa", 1e9},
                          {"N", 1},
                          {"kN", 1e3},
                          {"daN", 10},
                          {"cN", 1e-2},
                          {"mN", 1e-3},
                          {"kgf", kGravity},
                          {"gf", kGravity * 1e-3},
                          {"lbf", kGravity* pound},
                          {"kg", 1},
                          {"g", 1e-3},
                          {"lb", pound},
                          {"oz", pound / 16},
                          {"gsm", 1e-3},
                          {"tex", 1e-6},
                          {"dtex", 1e-7},
                          {"den", 1e-3 / 9000},
                          {"s", 1},
                          {"ms", 1e-3},
                          {"us", 1e-6},
                          {"deg", 1},
                          {"rad", degrees_per_radian}};

void push_units(lua_State* L) {
  lua_newtable(L);
  for (const Unit& unit : units) put(L, unit.name, unit.factor);
}

int poly(Call& call) {
  auto values = call.numbers("coefficients");
  for (double& value : values) value *= call.number("unit");
  return push_numbers(call.L(), values);
}

// Copies the string-keyed fields of the table on top to globals that do not exist yet, and pops the table.
void copy_to_globals(lua_State* L) {
  lua_pushglobaltable(L);
  lua_pushnil(L);
  while (lua_next(L, -3) != 0) {
    lua_pushvalue(L, -2);
    const bool free = lua_rawget(L, -4) == LUA_TNIL;
    lua_pop(L, 1);
    if (free) {
      lua_pushvalue(L, -2);
      lua_insert(L, -2);
      lua_rawset(L, -4);
    } else {
      lua_pop(L, 1);
    }
  }
  lua_pop(L, 2);
}

int globals(Call& call) {
  lua_State* L = call.L();
  lua_getfield(L, LUA_REGISTRYINDEX, "fabric");
  load_members(L, -1);
  push_raw(L, -1, "units");
  want_table(L, -1, "fabric.units");
  lua_insert(L, -2);
  copy_to_globals(L);
  copy_to_globals(L);
  lua_getglobal(L, "fabric");
  if (lua_isnil(L, -1)) {
    lua_getfield(L, LUA_REGISTRYINDEX, "fabric");
    lua_setglobal(L, "fabric");
  }
  return 0;
}

int checking(Call& call) { return push_value(call.L(), call.session().options().check); }

// The number after --case, 'list' under --cases; else nothing.
int asked_case(Call& call) {
  const StudyOptions& study = call.session().options().study;
  if (study.list) return lua_pushliteral(call.L(), "list"), 1;
  if (study.only == 0) return 0;
  return push_value(call.L(), study.only);
}

int warn(Call& call) {
  call.session().warn("deck", position(call.L()) + call.text("text"));
  return 0;
}

std::vector<Entry> core_entries() {
  return {
      {"fabric.poly()",
       {{"coefficients", numbers, "", everything, "ascending powers"},
        number_("unit", "", everything, "a multiplier of fabric.units").or_else(1.0)},
       "A table of coefficients times a unit: fabric.poly({8, 826}, MPa).",
       "local fabric = require 'fabric'; assert(fabric.poly({8, 826}, fabric.units.MPa)[2] == 826e6)",
       poly},
      {"fabric.globals()",
       {},
       "Makes the fields of fabric and fabric.units global, except where a global of that name exists.",
       "require 'fabric'.globals(); assert(3*inch > 76*mm)",
       globals},
      {"fabric.checking()",
       {},
       "True under --check, where analyses run nothing and no file is written.",
       "assert(require 'fabric'.checking() == false)",
       checking},
      kernel("asked_case()", {}, asked_case),
      {"fabric.warn()",
       {value_("text", text, "what to say")},
       "Prints a warning on stderr with the deck's line, each text once.",
       "require 'fabric'.warn 'the strip is narrower than one repeat of the weave'",
       warn},
  };
}

}  // namespace

void bind_core(Session& session) {
  install(session, core_entries());
  lua_State* L = session.lua();
  lua_getfield(L, LUA_REGISTRYINDEX, "fabric");
  put(L, "version", version(), "units", [&] { push_units(L); });
  watch_module(L, "fabric");
  lua_pop(L, 1);
}

void bind_all(Session& session) {
  bind_core(session);
  bind_history(session);
  bind_mesh(session);
  bind_card(session);
  bind_point(session);
  bind_model(session);
  bind_files(session);
  bind_plot(session);
  bind_render(session);
  bind_gltf(session);
  bind_analysis(session);
  bind_joints(session);
  bind_runs(session);
  bind_modes(session);
  bind_outputs(session);
  bind_keep(session);
  bind_check(session);
  bind_table(session);
  bind_lab(session);
  bind_photographs(session);
  bind_identify(session);
  bind_sample(session);
  bind_prompt(session);
}

}  // namespace fabricsh::script
