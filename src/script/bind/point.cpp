// fabric.point: one material point.
#include "law/point.hpp"

#include <cmath>
#include <functional>
#include <span>

#include "base/number.hpp"
#include "law/bending_point.hpp"
#include "law/check.hpp"
#include "script/bind/rooms.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

using law::PointDriver;
using law::StressPoint;

namespace {

// A point in a deck: its law and, once it is used, its bending.
struct DeckPoint : PointDriver {
  DeckPoint(std::shared_ptr<const card::Card> of, const law::Site& site)
      : PointDriver(law::compile(*of), site), card(std::move(of)) {}
  std::shared_ptr<const card::Card> card;
  std::optional<law::BendingPoint> bending;
};

}  // namespace

template <>
struct ClassName<DeckPoint> {
  static constexpr const char* name = "point";
};

namespace {

constexpr double radians_per_degree = 0.017453292519943295769;

struct SampleColumn {
  std::string name;
  std::function<double(const StressPoint&)> value;
};

std::vector<SampleColumn> make_columns() {
  std::vector<SampleColumn> out;
  const auto add = [&out](const char* name, double StressPoint::*value) {
    out.push_back({name, [value](const StressPoint& s) { return s.*value; }});
  };
  add("S11", &StressPoint::S11);
  add("S22", &StressPoint::S22);
  add("S12", &StressPoint::S12);
  add("E11", &StressPoint::E11);
  add("E22", &StressPoint::E22);
  add("E12", &StressPoint::E12);
  add("stored", &StressPoint::stored);
  add("dissipated", &StressPoint::dissipated);
  for (std::size_t i = 0; i < law::dissipations; ++i)
    out.push_back({"dissipated_" + std::string(law::dissipation_names.name[i]),
                   [i](const StressPoint& s) { return s.lost[i]; }});
  add("created", &StressPoint::created);
  add("time", &StressPoint::time);
  // Filled by uniaxial() only.
  add("S", &StressPoint::S);
  add("E", &StressPoint::E);
  add("E_lateral", &StressPoint::E_lateral);
  return out;
}

std::span<const SampleColumn> columns_of(bool uniaxial) {
  static const std::vector<SampleColumn> columns = make_columns();
  return std::span(columns).first(columns.size() - (uniaxial ? 0 : 3));
}

void push_sample(lua_State* L, const StressPoint& s, bool uniaxial) {
  lua_createtable(L, 0, 16);
  for (const SampleColumn& column : columns_of(uniaxial)) put(L, column.name.c_str(), column.value(s));
}

void push_rows(lua_State* L, const std::vector<StressPoint>& samples, bool uniaxial) {
  push_list(L, samples, [&](const auto& one) { push_sample(L, one, uniaxial); });
}

void set_column(lua_State* L, const std::vector<StressPoint>& samples, const SampleColumn& column) {
  push_list(L, samples, [&](const auto& one) { lua_pushnumber(L, column.value(one)); });
  lua_setfield(L, -2, column.name.c_str());
}

const SampleColumn& column_named(const std::string& name, std::span<const SampleColumn> known) {
  std::vector<std::string> names;
  for (const SampleColumn& column : known) {
    if (name == column.name) return column;
    names.emplace_back(column.name);
  }
  throw Error("argument 'columns': " + unknown("column", name, names));
}

// The columns named in the table `columns`, in order.
std::vector<SampleColumn> wanted(const Call& call, bool uniaxial) {
  std::vector<SampleColumn> out;
  for (const std::string& name : call.texts("columns", "names of columns"))
    out.push_back(column_named(name, columns_of(uniaxial)));
  if (out.empty()) call.refuse("columns", "expected at least one name, such as {\"S11\"}");
  return out;
}

// Pushes a list of rows or, if columns are requested, one array for each.
template <class Drive>
int push_curve(const Call& call, bool uniaxial, Drive drive) {
  lua_State* L = call.L();
  if (!call.has("columns")) {
    push_rows(L, drive(), uniaxial);
    return 1;
  }
  const auto names = wanted(call, uniaxial);
  const auto samples = drive();
  lua_newtable(L);
  for (const SampleColumn& column : names) set_column(L, samples, column);
  return 1;
}

int make_point(Call& call) {
  law::Site site;
  if (call.has("size")) site.size.fill(call.number("size"));
  return push_object(call.L(), std::make_shared<DeckPoint>(call.object<card::Card>("card"), site));
}

std::optional<double> given(const Call& call, const char* name) {
  return call.has(name) ? std::optional(call.number(name)) : std::nullopt;
}

// Error if no deformation has this strain: C = 1 + 2 E has a negative squared length in some direction.
void require_possible(const std::string& where, double E11, double E22, double E12) {
  const double C11 = 1 + 2 * E11, C22 = 1 + 2 * E22, C12 = 2 * E12;
  if (C11 > 0 && C22 > 0 && C11 * C22 > C12 * C12) return;
  throw Error(where + "there is no such strain: E11 = " + exact_number(E11) + ", E22 = " + exact_number(E22) +
              ", E12 = " + exact_number(E12) +
              " would make a length zero or less; expected E11 and E22 above -0.5 and (2 E12)^2 below (1 + 2 "
              "E11) (1 + 2 E22)");
}

int strain(Call& call) {
  const auto p = call.self<DeckPoint>();
  const auto E11 = given(call, "E11"), E22 = given(call, "E22"), E12 = given(call, "E12");
  const StressPoint now = p->now();
  require_possible("", E11.value_or(now.E11), E22.value_or(now.E22), E12.value_or(now.E12));
  push_sample(call.L(), p->strain(E11, E22, E12, call.number("over")), false);
  return 1;
}

double angle_of(const Call& call) {
  if (call.is("direction", LUA_TNUMBER)) return call.number("direction") * radians_per_degree;
  return call.text("direction") == "warp" ? 0 : 90 * radians_per_degree;
}

int uniaxial(Call& call) {
  const auto p = call.self<DeckPoint>();
  const double over = call.number("over");
  if (call.is("E", LUA_TTABLE))
    return push_curve(call, true, [&] { return p->uniaxial(angle_of(call), call.numbers("E"), over); });
  if (call.has("columns")) call.refuse("columns", "expected a list of strains E beside them, got a number");
  push_sample(call.L(), p->uniaxial(angle_of(call), call.number("E"), over), true);
  return 1;
}

// Throws an error that explains why row i, on top of the stack, is not {E11, E22, E12} or {E11, E22, E12,
// seconds} with finite numbers.
[[noreturn]] void refuse_row(lua_State* L, lua_Integer i) {
  const Argument row{std::to_string(i), numbers, "", everything, ""};
  check_value(L, -1, row, "strains.", true);
  throw Error("argument 'strains." + row.name + "': expected {E11, E22, E12}, got " +
              std::to_string(lua_rawlen(L, -1)) + " numbers");
}

using StrainRow = std::array<double, 4>;  // E11 E22 E12 and the duration of the increment, s

void require_over(const std::string& where, double over) {
  if (!(over >= 0)) throw Error(where + "expected 0 s or more for an increment, got " + exact_number(over));
}

StrainRow strain_row(lua_State* L, lua_Integer i) {
  const auto n = lua_istable(L, -1) ? static_cast<int>(lua_rawlen(L, -1)) : 0;
  if (n != 3 && n != 4) refuse_row(L, i);
  StrainRow e{};
  for (int k = 0; k < n; ++k) {
    const bool is_number = lua_rawgeti(L, -1, k + 1) == LUA_TNUMBER;
    e[k] = lua_tonumber(L, -1);
    lua_pop(L, 1);
    if (!is_number || !std::isfinite(e[k])) refuse_row(L, i);
  }
  require_over("argument 'strains." + std::to_string(i) + ".4': ", e[3]);
  return e;
}

using Strains = std::vector<StrainRow>;

// { {E11, E22, E12}, ... }, each optionally with the seconds as a fourth number.
Strains strain_rows(lua_State* L) {
  Strains strains;
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, -1));
  strains.reserve(static_cast<std::size_t>(n));
  for (lua_Integer i = 1; i <= n; ++i) {
    lua_rawgeti(L, -1, i);
    strains.push_back(strain_row(L, i));
    lua_pop(L, 1);
  }
  return strains;
}

// { E11={...}, E22={...}, E12={...}, over={...} }; a component that is not given stays unchanged.
Strains strain_columns(lua_State* L, const StressPoint& now) {
  static const std::vector<Argument> rows = {
      Argument{"E11", numbers, "", everything, "along the warp"}.optional(),
      Argument{"E22", numbers, "", everything, "along the weft"}.optional(),
      Argument{"E12", numbers, "", everything, "shear, tensor component"}.optional(),
      Argument{"over", numbers, "s", everything, "that each increment takes"}.optional()};
  const Fields given(L, -1, rows, "strains.");
  const StrainRow stays{now.E11, now.E22, now.E12, 0};
  Strains strains;
  for (std::size_t k = 0; k < stays.size(); ++k) {
    const auto values = given.numbers(rows[k].name);
    if (values.empty()) continue;
    if (strains.empty()) strains.assign(values.size(), stays);
    if (values.size() != strains.size())
      given.refuse(rows[k].name, "expected as many strains as in the other components (" +
                                     std::to_string(strains.size()) + "), got " +
                                     std::to_string(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (k == 3) require_over("argument 'strains.over." + std::to_string(i + 1) + "': ", values[i]);
      strains[i][k] = values[i];
    }
  }
  return strains;
}

int path(Call& call) {
  lua_State* L = call.L();
  const auto p = call.self<DeckPoint>();
  call.push("strains");
  const auto strains = lua_rawlen(L, -1) > 0 ? strain_rows(L) : strain_columns(L, p->now());
  lua_pop(L, 1);
  for (std::size_t i = 0; i < strains.size(); ++i)
    require_possible("argument 'strains." + std::to_string(i + 1) + "': ", strains[i][0], strains[i][1],
                     strains[i][2]);
  return push_curve(call, false, [&] { return p->path(strains); });
}

int biaxial(Call& call) {
  const auto p = call.self<DeckPoint>();
  const double ratio = call.number("ratio");
  const auto strains = call.numbers("E");
  for (const double E : strains) require_possible("", E, ratio * E, p->now().E12);
  return push_curve(call, false, [&] { return p->biaxial(ratio, strains); });
}

int state(Call& call) {
  const auto p = call.self<DeckPoint>();
  const auto inside = p->internal();
  push_sample(call.L(), p->now(), false);
  put(call.L(), "residual1", inside.residual1, "residual2", inside.residual2, "slack1", inside.slack1,
      "slack2", inside.slack2, "warp", law::name(inside.warp), "weft", law::name(inside.weft), "shear",
      law::name(inside.shear));
  return 1;
}

int bend(Call& call) {
  const auto p = call.self<DeckPoint>();
  if (!p->bending) p->bending.emplace(*p->card);
  const auto s = p->bending->bend(given(call, "k11"), given(call, "k22"), given(call, "k12"));
  return push_record(call.L(), "M11", s.M11, "M22", s.M22, "M12", s.M12, "k11", s.k11, "k22", s.k22, "k12",
                     s.k12, "stored", s.stored, "dissipated", s.dissipated);
}

int reset(Call& call) {
  const auto p = call.self<DeckPoint>();
  p->reset();
  if (p->bending) p->bending->reset();
  return 0;
}

int point_text(lua_State* L) {
  const StressPoint s = to_object<DeckPoint>(L, 1)->now();
  char words[200];
  std::snprintf(words, sizeof words,
                "<point, E11 %.4g, E22 %.4g, E12 %.4g; S11 %.4g, S22 %.4g, S12 %.4g MPa>", s.E11, s.E22,
                s.E12, s.S11 * 1e-6, s.S22 * 1e-6, s.S12 * 1e-6);
  return push_value(L, words);
}

// At the lower end the length is zero: (0 - 1) / 2. No strain reaches it.
constexpr Range above_nothing{-0.5, std::numeric_limits<double>::infinity(), true, false};

Argument strain_(const char* name, const char* sentence, Range range = everything) {
  // However small: where strains are rotated, zeros become their rounding errors.
  return number_(name, "", range, sentence).usually(0, 5, "strains are numbers, not per cent");
}

Argument curvature_(const char* name, const char* sentence) {
  return number_(name, "1/m", everything, sentence).optional();
}

Argument over_() {
  return number_("over", "s", not_negative, "that an increment takes; 0: at once").or_else(0.0);
}

Argument columns_() {
  return value_("columns?", table, "names, such as {'E11', 'S11'}: returns {E11={...}, S11={...}}");
}

std::vector<Entry> point_entries() {
  const std::string sample = "local p = fabric.point(fabric.card 'blend')\n";
  return {
      {"fabric.point()",
       {object_("card", "card", "the fabric"),
        number_("size?", "m", positive,
                "length of cloth that the point stands for, over which yarns that soften break (see damage "
                "of a card); without it they hold")},
       "One material point of virgin cloth, to be driven by strains.",
       sample,
       make_point},
      {"point:strain{}",
       {strain_("E11", "along the warp", above_nothing).optional(),
        strain_("E22", "along the weft", above_nothing).optional(),
        strain_("E12", "shear, tensor component").optional(), over_()},
       "Reaches a total strain in one straight increment and commits it; components not named stay. Returns "
       "S11 S22 S12 E11 E22 E12 stored dissipated.",
       sample + "assert(p:strain{ E11=0.05 }.S11 > 0)",
       strain},
      {"point:uniaxial()",
       {{"direction",
         number | text,
         "degrees from the warp",
         everything,
         "warp, weft or an angle",
         true,
         {},
         {"warp", "weft"}},
        {"E", number | numbers, "", above_nothing, "strain along it, or a list of strains"},
        columns_(),
        over_()},
       "Strain along a direction with the other stresses driven to zero. Returns the same and S, E, "
       "E_lateral; for a list of strains a list of such rows, or the columns named.",
       sample + "local r = p:uniaxial('warp', 0.1)\nassert(math.abs(r.E_lateral / r.E + 0.25) < 1e-9)",
       uniaxial},
      {"point:path()",
       {value_("strains", table,
               "{ {E11, E22, E12}, ... } or { E11={...}, E22={...}, E12={...} }; seconds that an increment "
               "takes as fourth number of a row, or in over={...}"),
        columns_()},
       "Many straight increments in one call: a list of rows, or the columns named. A component without a "
       "column stays.",
       sample + "local r = p:path{ {0.1, 0, 0}, {0, 0, 0} }\nassert(r[2].dissipated > 0)\n"
                "local c = p:path({ E12={0.1, 0.2} }, {'S12', 'stored'})\nassert(c.S12[2] > c.S12[1])",
       path},
      {"point:biaxial()",
       {number_("ratio", "", everything, "E22 over E11"),
        {"E", numbers, "", everything, "values of E11"},
        columns_()},
       "E11 = E and E22 = ratio E, for each E of a list: a list of rows, or the columns named.",
       sample + "assert(#p:biaxial(1, {0.05, 0.1}) == 2)",
       biaxial},
      {"point:bend{}",
       {curvature_("k11", "along the warp"), curvature_("k22", "along the weft"),
        curvature_("k12", "twist, tensor component")},
       "Reaches total curvatures in one straight increment and commits them, by the card's own bending; "
       "components not named stay. Returns M11 M22 M12 (moments per width, N; M12 works on 2 k12), k11 k22 "
       "k12, stored and dissipated (J/m^2).",
       "local card = fabric.card 'blend':with{ bending={ warp=15e-6, "
       "weft=12e-6, twist=7e-6 } }\nassert(math.abs(fabric.point(card):bend{ k11=100 }.M11 - 1.5e-3) < "
       "1e-15)",
       bend},
      without_arguments("point:state",
                        "Where the point is: the row of its last commit, residual strains and slack of both "
                        "yarns, and the branch (virgin, unloading, slack) of warp, weft and shear.",
                        sample + "p:uniaxial('warp', {0.1, 0.098})\nassert(p:state().warp == 'unloading')",
                        state),
      without_arguments("point:reset", "Back to virgin cloth at zero strain and time 0.",
                        sample + "p:reset()", reset),
  };
}

}  // namespace

void bind_point(Session& session) {
  install(session, point_entries());
  set_meta(session, "point", "__tostring", point_text);
}

}  // namespace fabricsh::script
