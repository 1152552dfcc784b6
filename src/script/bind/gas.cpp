// model:gas and analysis:gas.
#include <cmath>

#include "base/number.hpp"
#include "model/declaration_rows.hpp"
#include "run/bodies.hpp"
#include "script/bind/model.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"
#include "script/session/at_work.hpp"
#include "script/values/field_rows.hpp"

namespace fabricsh::script {

using model::GasGiven;
using model::Model;

namespace {

constexpr double kTested = 100;  // Pa, at which tests of air permeability measure [iso9237]

std::vector<std::string> sets_of(const Call& call) {
  if (!call.has("set") || call.is("set", LUA_TSTRING)) return {call.text("set")};
  lua_State* L = call.L();
  std::vector<std::string> names;
  call.each("set", [&](lua_Integer i) {
    if (lua_type(L, -1) != LUA_TSTRING) {
      const std::string got = describe(L, -1);
      call.refuse("set", "expected names of sets, got " + got + " at place " + std::to_string(i) +
                             (got == "a body" ? ": a body closes a hole as one of lids=" : ""));
    }
    names.emplace_back(lua_tostring(L, -1));
  });
  return names;
}

// Lids that close holes: names of the sets of their nodes, or rigid bodies.
void read_lids(const Call& call, GasGiven& gas) {
  if (!call.has("lids")) return;
  lua_State* L = call.L();
  const auto take = [&](lua_Integer place) {
    if (lua_type(L, -1) == LUA_TSTRING)
      gas.lids.emplace_back(lua_tostring(L, -1));
    else if (auto body = to_object<const model::Rigid>(L, -1))
      gas.bodies.push_back(std::move(body));
    else
      call.refuse("lids", "expected names of sets or rigid bodies, got " + describe(L, -1) +
                              (place > 0 ? " at place " + std::to_string(place) : ""));
  };
  if (call.is("lids", LUA_TTABLE)) {
    call.each("lids", take);
    return;
  }
  call.push("lids");
  take(0);
  lua_pop(L, 1);
}

const std::vector<Argument>& vent_rows() {
  static const std::vector<Argument> rows{
      value_("set?", text, "elements whose area at the start is that of the hole"),
      number_("area?", "m2", positive, "of the hole, in place of a set"),
      number_("coefficient", "", {0, 1, true, false},
              "of discharge: the area of the jet over that of the hole")
          .or_else(0.6),
      object_("to?", "gas", "another volume, what m:gas returned; default the outside"),
      number_("opens?", "Pa", positive,
              "pressure difference at which it opens for good; default it is open")};
  return rows;
}

void read_vents(const Call& call, GasGiven& gas) {
  if (!call.has("vents")) return;
  lua_State* L = call.L();
  const auto count = call.each("vents", [&](lua_Integer i) {
    if (!lua_istable(L, -1))
      call.refuse("vents", "expected a list { {set=|area=, coefficient=?, to=?, opens=?}, ... }, got " +
                               describe(L, -1) + " at place " + std::to_string(i));
    const Fields given(L, -1, vent_rows(), "vents[" + std::to_string(i) + "].");
    model::GasVent vent;
    if (given.has("set")) vent.set = given.text("set");
    if (given.has("area")) vent.area = given.number("area");
    vent.coefficient = given.number("coefficient");
    if (given.has("to")) vent.to = given.object<const GasGiven>("to");
    if (given.has("opens")) vent.opens = given.number("opens");
    gas.vents.push_back(std::move(vent));
  });
  if (count == 0)
    call.refuse("vents", "expected a list { {set=|area=, coefficient=?, to=?, opens=?}, ... }, got no entry");
}

void read_gas(const Call& call, GasGiven& gas) {
  if (!call.has("gas")) return;
  if (call.is("gas", LUA_TSTRING)) {
    call.text("gas");  // air alone
    return;
  }
  const Fields given = call.fields("gas");
  gas.molar = given.number("molar");
  gas.cp = given.number("cp");
  lua_pop(call.L(), 1);
}

std::function<double(double)> called(const Function& f) {
  return [f](double difference) {
    lua_State* L = f.push();
    lua_pushnumber(L, difference);
    call_deck(L, 1, 1);
    if (lua_type(L, -1) != LUA_TNUMBER || !(lua_tonumber(L, -1) >= 0) || std::isinf(lua_tonumber(L, -1)))
      throw Error("gas: field 'leakage': expected the function to return 0 or more, m/s, at " +
                  fabricsh::number(difference) + " Pa, got " + describe(L, -1));
    const double speed = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return speed;
  };
}

// In proportion to the pressure, as through the pores of cloth.
void read_leakage(const Call& call, GasGiven& gas) {
  if (!call.has("leakage")) return;
  if (call.is("leakage", LUA_TFUNCTION)) {
    gas.leakage = called(call.function("leakage"));
    gas.leakage_words = "a function of the pressure";
    return;
  }
  double speed = 0, at = kTested;
  if (call.is("leakage", LUA_TNUMBER)) {
    speed = call.number("leakage");
  } else {
    const auto both = call.numbers("leakage");
    if (both.size() != 2 || !(both[0] >= 0) || !(both[1] > 0))
      call.refuse("leakage",
                  "expected {m/s, Pa}: a speed of 0 or more and the positive pressure at which it is, got " +
                      counted(both.size(), "number"));
    speed = both[0];
    at = both[1];
  }
  if (!(speed >= 0)) call.refuse("leakage", "expected 0 or more, m/s, got " + fabricsh::number(speed));
  gas.leakage_words = fabricsh::number(speed) + " m/s at " + fabricsh::number(at) + " Pa";
  if (speed > 0) gas.leakage = [speed, at](double difference) { return speed * difference / at; };
}

int gas(Call& call) {
  GasGiven gas;
  gas.sets = sets_of(call);
  read_lids(call, gas);
  read_rows(call, model::gas_rows(), gas);
  read_gas(call, gas);
  if (call.has("inflow")) {
    lua_State* L = call.L();
    call.push("inflow");
    gas.inflow = lua_istable(L, -1) ? read_points(call, "inflow")
                                    : read_history(call.session(), L, -1, "gas: field 'inflow'");
    lua_pop(L, 1);
  }
  read_vents(call, gas);
  read_leakage(call, gas);
  const auto made = std::make_shared<const GasGiven>(std::move(gas));
  call.self<Model>()->add(made);
  return push_object(call.L(), made);
}

int reading(Call& call) {
  const auto now = run::gas_state(*call.self<DeckRun>()->analysis, *call.object<const GasGiven>("gas"));
  for (const double v : {now.pressure, now.volume, now.mass, now.temperature}) lua_pushnumber(call.L(), v);
  return 4;
}

int gas_text(lua_State* L) { return push_text(L, "<gas " + to_object<const GasGiven>(L, 1)->name() + ">"); }

std::vector<Entry> gas_entries() {
  const auto rows = arguments_of(model::gas_rows());
  const std::string bag =
      "local mesh = fabric.mesh.cylinder{ radius=0.05, length=0.2, around=12, along=6 }\n"
      "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend', warp={0, 0, 1} }\n"
      "m:fix('bottom', 'x y z'):fix('top', 'x y z')\n"
      "local g = m:gas{ lids={'bottom', 'top'}, initial=500 }\n";
  Argument kind = fields_("gas",
                          {number_("molar", "kg/mol", positive, "its molar mass"),
                           number_("cp", "J/(kg K)", positive, "its specific heat at constant pressure")},
                          "\"air\" or {molar=, cp=}");
  kind.kinds |= text;
  kind.choices = {"air"};
  Argument inflow = history_("inflow", "kg/s", "{ {time, kg/s}, ... } or a history: mass that flows in");
  inflow.kinds |= table;
  Argument leakage = value_("leakage?", number | numbers | function,
                            "speed of the air through the cloth, m/s at 100 Pa; {m/s, Pa} at another "
                            "pressure; or function(Pa) returning m/s");
  return {
      {"model:gas{}",
       {value_("set", text | table, "elements that close around the gas: a set, or a list of sets")
            .or_else("all"),
        object_(
            "lids?", "body",
            "rigid bodies that close the holes whose rims lie at them, and sets of nodes around holes that "
            "something closes which weighs nothing: the gas pushes on it, and it on the nodes, evenly",
            text | table),
        rows[0], rows[1], rows[2], kind.optional(), rows[3], inflow,
        value_("vents?", table,
               "{ {set=|area=, coefficient=0.6, to=?, opens=?}, ... }: holes through which gas flows out, or "
               "to another volume, as through a nozzle; a set counts by its area at the start"),
        leakage, rows[4]},
       "Fills a closed volume with gas. Its pressure is the same everywhere and follows from the volume, the "
       "mass and the temperature. Returns the volume, for a:gas and for vents of others.",
       bag + "assert(m:list()[3].kind == 'gas')",
       gas},
      {"analysis:gas()",
       {object_("gas", "gas", "a volume of the model, what m:gas returned")},
       "The gas of a volume as it is: four numbers, the pressure above that outside (Pa), the volume (m3), "
       "the mass (kg), and the temperature (K).",
       bag + "local a = fabric.static{ model=m, duration=1 }\n"
             "local p, V, mass, T = a:gas(g)\nassert(p == 500 and math.abs(mass * 287.05 * T / V - 101825) < "
             "1)",
       reading},
  };
}

}  // namespace

void bind_gas(Session& session) {
  install(session, gas_entries());
  set_meta(session, "gas", "__tostring", gas_text);
}

}  // namespace fabricsh::script
