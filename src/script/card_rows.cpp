#include "script/card_rows.hpp"

#include <algorithm>

#include "fabric/provenance.hpp"
#include "script/bind.hpp"
#include "script/words.hpp"

namespace fabricsh::script {

using namespace card;

namespace {

constexpr const char* ask_modulus = "is the modulus in Pa? (write 8*MPa; N/m divided by the thickness)";

Argument modulus(const char* name, Range range, const char* sentence) {
  return number_(name, "Pa", range, sentence).usually(1e3, 1e12, ask_modulus);
}

Argument curve(const char* sentence) { return {"loading", numbers | table, "Pa", everything, sentence}; }

std::vector<Argument> yarn_rows(const char* ratio) {
  return {curve("tangent modulus D(E) = d0 + d1 E + ..., Pa, as {d0, d1, ...}; or measured points {{E, S}, "
                "...} from {0, 0} on"),
          modulus("unloading", positive, "unloading modulus"), number_("poisson", "", not_negative, ratio)};
}

std::vector<Argument> shear_rows() {
  return {curve("tangent modulus in the measure's strain, Pa, as {g0, g1, ...}; or measured points"),
          modulus("unloading", positive, "unloading modulus, in the same measure"),
          value_("measure", text, "tensor: dS12/dE12 in E12; engineering: dS12/d(2E12) in 2E12")
              .one_of({"tensor", "engineering"})
              .or_else("tensor"),
          value_("memory", text,
                 "what the branch left at a reversal keeps: printed forgets it at once, fading lets it fade")
              .one_of({"printed", "fading"})
              .or_else("printed")};
}

std::vector<Argument> tested_rows() {
  return {number_("warp", "", not_negative, "largest E11 tested").or_else(0.0),
          number_("weft", "", not_negative, "largest E22 tested").or_else(0.0),
          number_("shear", "", not_negative, "largest E12 tested (tensor)").or_else(0.0)};
}

std::vector<Argument> biaxial_rows() {
  return {number_("alpha", "", positive, "weight of E22"),
          number_("offset", "", not_negative, "strain where it begins"),
          modulus("loading", positive, "q of T = q y^2 / 2"),
          modulus("unloading", positive, "unloading modulus")};
}

std::vector<Argument> band_rows() {
  return {{"low", numbers, "", everything, "of loading coefficients, unloading, poisson"},
          {"high", numbers, "", everything, "of the same parameters"},
          {"covariance", numbers, "", everything, "of the same parameters, row by row"}};
}

std::vector<Argument> bands_rows() {
  return {number_("level", "", Range{0, 1, true, true}, "of confidence").or_else(0.95),
          fields_("warp", band_rows(), "of the warp's parameters").optional(),
          fields_("weft", band_rows(), "of the weft's parameters").optional(),
          fields_("shear", band_rows(), "of the shear's parameters").optional()};
}

std::vector<Argument> friction_rows() {
  return {number_("moment", "N", positive, "friction moment per width"),
          number_("curvature", "1/m", positive, "curvature over which it builds up")};
}

std::vector<Argument> bending_rows() {
  return {number_("warp", "N.m", not_negative, "bending rigidity along the warp"),
          number_("weft", "N.m", not_negative, "bending rigidity along the weft"),
          number_("twist", "N.m", not_negative, "twisting rigidity, multiplies 2 kappa12"),
          fields_("friction_warp", friction_rows(), "bending hysteresis along the warp").optional(),
          fields_("friction_weft", friction_rows(), "bending hysteresis along the weft").optional()};
}

std::vector<Argument> common_rows() {
  return {
      value_("name", text, "of the fabric").or_else(""),
      value_("source", text, "where the numbers come from").or_else(""),
      number_("density", "kg/m^3", positive, "mass over volume")
          .usually(20, 5000, "mass per area is density * thickness"),
      number_("thickness", "m", positive, "of the sheet").usually(1e-5, 2e-2, "is it in m? (write 0.38*mm)"),
      fields_("bending", bending_rows(), "own bending rigidity instead of integration through the thickness")
          .optional(),
      value_(
          "provenance", table,
          "where values come from: {['warp.loading']='fitted to 4 specimens', ['shear.unloading']='assumed: "
          "...'}; words begin with fitted, measured, copied, typed or assumed")
          .optional()};
}

std::vector<Argument> woven_rows() {
  auto rows = common_rows();
  rows.push_back(
      fields_("warp", yarn_rows("nu12: contraction along weft when pulled along warp"), "along the warp"));
  rows.push_back(
      fields_("weft", yarn_rows("nu21: contraction along warp when pulled along weft"), "along the weft"));
  rows.push_back(fields_("shear", shear_rows(), "in-plane shear"));
  rows.push_back(fields_("tested", tested_rows(), "strains up to which it was measured").optional());
  rows.push_back(value_("law", text, "the law that is compiled from the card")
                     .one_of({"potential", "incremental", "thesis"})
                     .or_else("potential"));
  rows.push_back(value_("transverse", text, "transverse shear of the comparison laws")
                     .one_of({"elastic", "follow"})
                     .or_else("elastic"));
  rows.push_back(value_("shear_hysteresis", boolean, "of the comparison laws").or_else(true));
  rows.push_back(fields_("biaxial", biaxial_rows(), "a fourth spring that acts when both yarns are stretched")
                     .optional());
  rows.push_back(fields_("bands", bands_rows(), "confidence bands of the measured parameters").optional());
  return rows;
}

std::vector<Argument> svk_rows() {
  auto rows = common_rows();
  rows.push_back(modulus("warp", positive, "modulus along the warp").optional());
  rows.push_back(modulus("weft", positive, "modulus along the weft").optional());
  rows.push_back(modulus("shear", positive, "engineering shear modulus, S12 = 2 shear E12").optional());
  rows.push_back(
      modulus("young", positive, "modulus of an isotropic sheet, instead of warp, weft, shear").optional());
  rows.push_back(
      {"poisson", number | numbers, "", Range{-1, 10, true, false}, "{nu12, nu21}, or one number for both"});
  rows.push_back(
      Argument{"transverse", numbers, "Pa", positive, "{G13, G23}; default 5/6 of shear"}.optional());
  return rows;
}

std::vector<Argument> linear_rows() {
  auto rows = common_rows();
  rows.push_back(modulus("warp", positive, "modulus along the warp"));
  rows.push_back(modulus("weft", positive, "modulus along the weft"));
  rows.push_back(modulus("shear", positive, "engineering shear modulus, S12 = 2 shear E12"));
  rows.push_back({"poisson", number | numbers, "", Range{-1, 10, true, false}, "{nu12, nu21}"});
  return rows;
}

// Measured points {{E, S}, ...} in the table on top of the stack.
std::vector<std::pair<double, double>> read_points(const Fields& fields, const std::string& side) {
  lua_State* L = fields.L();
  std::vector<std::pair<double, double>> points;
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= n; ++i) {
    lua_rawgeti(L, -1, i);
    const std::string place = std::to_string(i);
    const Argument pair{place + "]", numbers, "", everything, "strain and stress"};
    if (!lua_istable(L, -1) || lua_rawlen(L, -1) != 2)
      fields.refuse("loading", "expected {strain, stress} at point " + place + ", got " + describe(L, -1));
    check_value(L, -1, pair, side + "loading[", false);
    const auto xy = read_numbers(L, -1);
    lua_pop(L, 1);
    if (points.empty() && (xy[0] != 0 || xy[1] != 0))
      fields.refuse("loading", "expected the first point to be {0, 0}, got {" + number_text(xy[0]) + ", " +
                                   number_text(xy[1]) + "}");
    if (!points.empty() && (xy[0] <= points.back().first || xy[1] <= points.back().second))
      fields.refuse("loading", "expected strain and stress to increase, at point " + place + " they do not");
    points.emplace_back(xy[0], xy[1]);
  }
  if (points.size() < 2) fields.refuse("loading", "expected at least two points, got one");
  return points;
}

// side: "warp.", for messages.
Curve read_curve(const Fields& fields, const std::string& side) {
  lua_State* L = fields.L();
  Curve curve;
  fields.push("loading");
  if (lua_rawgeti(L, -1, 1) == LUA_TTABLE) {
    lua_pop(L, 1);
    curve.points = read_points(fields, side);
  } else {
    lua_pop(L, 1);
    const Argument coefficients{"loading", numbers, "Pa", everything, ""};
    check_value(L, -1, coefficients, side, false);
    curve.coefficients = read_numbers(L, -1);
  }
  lua_pop(L, 1);
  return curve;
}

Yarn read_yarn(const Fields& fields, const std::string& side) {
  return {read_curve(fields, side), fields.number("unloading"), fields.number("poisson")};
}

Shear read_shear(const Fields& fields) {
  return {read_curve(fields, "shear."), fields.number("unloading"),
          fields.text("measure") == "tensor" ? Measure::tensor : Measure::engineering,
          fields.text("memory") == "printed" ? ShearMemory::printed : ShearMemory::fading};
}

Band read_band(const Fields& bands, const char* part, std::size_t parameters) {
  if (!bands.has(part)) return {};
  const Fields f = bands.fields(part);
  const Band band{f.numbers("low"), f.numbers("high"), f.numbers("covariance")};
  const auto check = [&](const char* name, std::size_t got, std::size_t want) {
    if (got != want)
      f.refuse(name, "expected " + std::to_string(want) + " numbers, got " + std::to_string(got));
  };
  check("low", band.low.size(), parameters);
  check("high", band.high.size(), parameters);
  check("covariance", band.covariance.size(), parameters * parameters);
  return band;
}

Bands read_bands(const Fields& bands, const Woven& law) {
  return {bands.number("level"), read_band(bands, "warp", law.warp.loading.coefficients.size() + 2),
          read_band(bands, "weft", law.weft.loading.coefficients.size() + 2),
          read_band(bands, "shear", law.shear.loading.coefficients.size() + 1)};
}

LawKind read_law(const std::string& word) {
  if (word == "potential") return LawKind::potential;
  return word == "incremental" ? LawKind::incremental : LawKind::thesis;
}

Woven read_woven(const Fields& f) {
  Woven law;
  law.warp = read_yarn(f.fields("warp"), "warp.");
  law.weft = read_yarn(f.fields("weft"), "weft.");
  law.shear = read_shear(f.fields("shear"));
  if (f.has("tested")) {
    const Fields tested = f.fields("tested");
    law.tested = {tested.number("warp"), tested.number("weft"), tested.number("shear")};
  }
  law.law = read_law(f.text("law"));
  law.transverse = f.text("transverse") == "elastic" ? Transverse::elastic : Transverse::follow;
  law.shear_hysteresis = f.flag("shear_hysteresis");
  if (f.has("biaxial")) {
    const Fields b = f.fields("biaxial");
    law.biaxial = Biaxial{b.number("alpha"), b.number("offset"), b.number("loading"), b.number("unloading")};
  }
  if (f.has("bands")) law.bands = read_bands(f.fields("bands"), law);
  return law;
}

std::pair<double, double> read_ratios(const Fields& f) {
  const auto pair = f.numbers("poisson");
  if (pair.empty()) return {f.number("poisson"), f.number("poisson")};
  if (pair.size() != 2)
    f.refuse("poisson", "expected {nu12, nu21}, got " + std::to_string(pair.size()) + " numbers");
  return {pair[0], pair[1]};
}

Svk read_svk(const Fields& f) {
  Svk law;
  std::tie(law.nu12, law.nu21) = read_ratios(f);
  if (law.nu12 * law.nu21 >= 1)
    f.refuse("poisson", "expected nu12 nu21 < 1, got " + number_text(law.nu12) + " x " +
                            number_text(law.nu21) + " = " + number_text(law.nu12 * law.nu21));
  if (f.has("young")) {
    for (const char* name : {"warp", "weft", "shear"})
      if (f.has(name)) f.refuse(name, "expected either young or warp, weft and shear, got both");
    law.warp = law.weft = f.number("young");
    law.shear = law.warp / (2 * (1 + law.nu12));
  } else {
    for (const char* name : {"warp", "weft", "shear"})
      if (!f.has(name))
        f.refuse(name, "expected " + expected(f.row(name)) + " (or young for an isotropic sheet), got nil");
    law.warp = f.number("warp");
    law.weft = f.number("weft");
    law.shear = f.number("shear");
  }
  const auto transverse = f.numbers("transverse");
  if (transverse.empty()) return law;
  if (transverse.size() != 2)
    f.refuse("transverse", "expected {G13, G23}, got " + counted(transverse.size(), "number"));
  law.g13 = transverse[0];
  law.g23 = transverse[1];
  return law;
}

Linear read_linear(const Fields& f) {
  const auto [nu12, nu21] = read_ratios(f);
  return {f.number("warp"), f.number("weft"), f.number("shear"), nu12, nu21};
}

std::optional<BendingFriction> read_friction(const Fields& bending, const char* name) {
  if (!bending.has(name)) return {};
  const Fields f = bending.fields(name);
  return BendingFriction{f.number("moment"), f.number("curvature")};
}

fabric::Provenance read_provenance(const Fields& f) {
  fabric::Provenance out;
  lua_State* L = f.L();
  f.push("provenance");
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
    const auto& known = fabric::provenance_fields();
    const std::string name = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : describe(L, -2);
    if (std::find(known.begin(), known.end(), name) == known.end())
      f.refuse("provenance", unknown("field", name, known));
    if (lua_type(L, -1) != LUA_TSTRING)
      f.refuse("provenance", "expected words for '" + name + "', got " + describe(L, -1));
    const std::string words = lua_tostring(L, -1);
    if (!fabric::is_origin(words))
      f.refuse("provenance",
               "expected words that begin with fitted, measured, copied, typed or assumed for '" + name +
                   "', got '" + words + "'");
    out.emplace_back(name, words);
  }
  lua_pop(L, 1);
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

const std::vector<Argument>& card_rows(const std::string& kind) {
  static const std::vector<Argument> woven = woven_rows(), svk = svk_rows(), linear = linear_rows();
  return kind == "svk" ? svk : kind == "linear" ? linear : woven;
}

Card card_from(const Fields& f, const std::string& kind) {
  luaL_checkstack(f.L(), 20, "card");
  const int top = lua_gettop(f.L());
  Card card;
  card.name = f.text("name");
  card.source = f.text("source");
  card.density = f.number("density");
  card.thickness = f.number("thickness");
  if (f.has("bending")) {
    const Fields b = f.fields("bending");
    card.bending = Bending{b.number("warp"), b.number("weft"), b.number("twist"),
                           read_friction(b, "friction_warp"), read_friction(b, "friction_weft")};
  }
  if (f.has("provenance")) card.source = fabric::with_provenance(card.source, read_provenance(f));
  if (kind == "svk")
    card.law = read_svk(f);
  else if (kind == "linear")
    card.law = read_linear(f);
  else
    card.law = read_woven(f);
  lua_settop(f.L(), top);
  return card;
}

Card read_card(lua_State* L, int index, const std::string& kind) {
  return card_from(Fields(L, index, card_rows(kind)), kind);
}

}  // namespace fabricsh::script
