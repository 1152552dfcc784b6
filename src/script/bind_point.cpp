// fabric.point: one material point.
#include "point/point.hpp"
#include "script/bind.hpp"
#include "script/words.hpp"

namespace fabricsh::script {

using point::PointDriver;
using point::Sample;

template <>
struct ClassName<PointDriver> {
  static constexpr const char* name = "point";
};

namespace {

constexpr double radians_per_degree = 0.017453292519943295769;

void push_sample(lua_State* L, const Sample& s, bool uniaxial) {
  lua_createtable(L, 0, 16);
  const std::pair<const char*, double> values[] = {{"S11", s.S11},
                                                   {"S22", s.S22},
                                                   {"S12", s.S12},
                                                   {"E11", s.E11},
                                                   {"E22", s.E22},
                                                   {"E12", s.E12},
                                                   {"stored", s.stored},
                                                   {"dissipated", s.dissipated},
                                                   {"dissipated_warp", s.dissipated_warp},
                                                   {"dissipated_weft", s.dissipated_weft},
                                                   {"dissipated_shear", s.dissipated_shear},
                                                   {"created", s.created}};
  for (const auto& [name, value] : values) set_number(L, name, value);
  if (!uniaxial) return;
  set_number(L, "S", s.S);
  set_number(L, "E", s.E);
  set_number(L, "E_lateral", s.E_lateral);
}

void push_samples(lua_State* L, const std::vector<Sample>& samples, bool uniaxial) {
  lua_createtable(L, static_cast<int>(samples.size()), 0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    push_sample(L, samples[i], uniaxial);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
}

int make(Call& call) {
  push_object(call.L(), std::make_shared<PointDriver>(fabric::compile(*call.object<card::Card>("card"))));
  return 1;
}

std::optional<double> given(const Call& call, const char* name) {
  return call.has(name) ? std::optional(call.number(name)) : std::nullopt;
}

int strain(Call& call) {
  push_sample(call.L(),
              call.self<PointDriver>()->strain(given(call, "E11"), given(call, "E22"), given(call, "E12")),
              false);
  return 1;
}

double angle_of(const Call& call) {
  if (call.is("direction", LUA_TNUMBER)) return call.number("direction") * radians_per_degree;
  return call.text("direction") == "warp" ? 0 : 90 * radians_per_degree;
}

int uniaxial(Call& call) {
  const auto p = call.self<PointDriver>();
  if (call.is("E", LUA_TTABLE))
    push_samples(call.L(), p->uniaxial(angle_of(call), call.numbers("E")), true);
  else
    push_sample(call.L(), p->uniaxial(angle_of(call), call.number("E")), true);
  return 1;
}

std::array<double, 3> strain_row(lua_State* L, lua_Integer i) {
  const Argument row{std::to_string(i), numbers, "", everything, ""};
  check_value(L, -1, row, "strains.", true);
  const auto e = read_numbers(L, -1);
  if (e.size() != 3)
    throw Error("argument 'strains." + row.name + "': expected {E11, E22, E12}, got " +
                std::to_string(e.size()) + " numbers");
  return {e[0], e[1], e[2]};
}

int path(Call& call) {
  lua_State* L = call.L();
  std::vector<std::array<double, 3>> strains;
  call.push("strains");
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= n; ++i) {
    lua_rawgeti(L, -1, i);
    strains.push_back(strain_row(L, i));
    lua_pop(L, 1);
  }
  push_samples(L, call.self<PointDriver>()->path(strains), false);
  return 1;
}

int biaxial(Call& call) {
  push_samples(call.L(), call.self<PointDriver>()->biaxial(call.number("ratio"), call.numbers("E")), false);
  return 1;
}

int reset(Call& call) {
  call.self<PointDriver>()->reset();
  return 0;
}

Argument strain_(const char* name, const char* sentence) {
  return number_(name, "", everything, sentence).usually(1e-12, 5, "strains are numbers, not per cent");
}

std::vector<Entry> rows() {
  const std::string sample = "local fabric = require 'fabric'\nlocal p = fabric.point(fabric.card 'blend')\n";
  return {
      {"fabric.point",
       Style::positional,
       {object_("card", "card", "the fabric")},
       "One material point of virgin cloth, to be driven by strains.",
       sample,
       make},
      {"point:strain",
       Style::fields,
       {strain_("E11", "along the warp").optional(), strain_("E22", "along the weft").optional(),
        strain_("E12", "shear, tensor component").optional()},
       "Reaches a total strain in one straight increment and commits it; components not named stay. Returns "
       "S11 S22 S12 E11 E22 "
       "E12 stored dissipated.",
       sample + "assert(p:strain{ E11=0.05 }.S11 > 0)",
       strain},
      {"point:uniaxial",
       Style::positional,
       {{"direction",
         number | text,
         "degrees from the warp",
         everything,
         "warp, weft or an angle",
         true,
         {},
         {"warp", "weft"}},
        {"E", number | numbers, "", everything, "strain along it, or a list of strains"}},
       "Strain along a direction with the other stresses driven to zero. Returns the same and S, E, "
       "E_lateral.",
       sample + "local r = p:uniaxial('warp', 0.1)\nassert(math.abs(r.E_lateral / r.E + 0.25) < 1e-9)",
       uniaxial},
      {"point:path",
       Style::positional,
       {value_("strains", table, "{ {E11, E22, E12}, ... }")},
       "Many straight increments in one call; a list of results.",
       sample + "local r = p:path{ {0.1, 0, 0}, {0, 0, 0} }\nassert(r[2].dissipated > 0)",
       path},
      {"point:biaxial",
       Style::positional,
       {number_("ratio", "", everything, "E22 over E11"), {"E", numbers, "", everything, "values of E11"}},
       "E11 = E and E22 = ratio E, for each E of a list.",
       sample + "assert(#p:biaxial(1, {0.05, 0.1}) == 2)",
       biaxial},
      {"point:reset",
       Style::positional,
       {},
       "Back to virgin cloth at zero strain.",
       sample + "p:reset()",
       reset},
  };
}

}  // namespace

void bind_point(Session& session) { install(session, rows()); }

}  // namespace fabricsh::script
