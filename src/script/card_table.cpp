// A card as the table of its constructor, and as a Lua file.
#include "fabric/provenance.hpp"
#include "script/bind.hpp"
#include "script/card_rows.hpp"
#include "script/words.hpp"

namespace fabricsh::script {

using namespace card;

namespace {

void push_curve(lua_State* L, const Curve& curve) {
  if (curve.points.empty()) {
    push_numbers(L, curve.coefficients);
  } else {
    lua_newtable(L);
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      push_numbers(L, {curve.points[i].first, curve.points[i].second});
      lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
    }
  }
  lua_setfield(L, -2, "loading");
}

void set_yarn(lua_State* L, const char* name, const Yarn& yarn) {
  lua_newtable(L);
  push_curve(L, yarn.loading);
  set_number(L, "unloading", yarn.unloading);
  set_number(L, "poisson", yarn.poisson);
  lua_setfield(L, -2, name);
}

void set_shear(lua_State* L, const Shear& shear) {
  lua_newtable(L);
  push_curve(L, shear.loading);
  set_number(L, "unloading", shear.unloading);
  set_text(L, "measure", shear.measure == Measure::tensor ? "tensor" : "engineering");
  set_text(L, "memory", shear.memory == ShearMemory::printed ? "printed" : "fading");
  lua_setfield(L, -2, "shear");
}

void set_fields(lua_State* L, const char* name, const std::vector<std::pair<const char*, double>>& values) {
  lua_newtable(L);
  for (const auto& [field, value] : values) set_number(L, field, value);
  lua_setfield(L, -2, name);
}

const char* law_word(LawKind law) {
  if (law == LawKind::potential) return "potential";
  return law == LawKind::incremental ? "incremental" : "thesis";
}

void set_band(lua_State* L, const char* part, const Band& band) {
  if (band.low.empty()) return;
  lua_newtable(L);
  for (const auto& [name, values] :
       {std::pair{"low", &band.low}, {"high", &band.high}, {"covariance", &band.covariance}}) {
    push_numbers(L, *values);
    lua_setfield(L, -2, name);
  }
  lua_setfield(L, -2, part);
}

void set_bands(lua_State* L, const Bands& bands) {
  lua_newtable(L);
  set_number(L, "level", bands.level);
  set_band(L, "warp", bands.warp);
  set_band(L, "weft", bands.weft);
  set_band(L, "shear", bands.shear);
  lua_setfield(L, -2, "bands");
}

void set_law(lua_State* L, const Woven& law) {
  set_yarn(L, "warp", law.warp);
  set_yarn(L, "weft", law.weft);
  set_shear(L, law.shear);
  set_fields(L, "tested",
             {{"warp", law.tested.warp}, {"weft", law.tested.weft}, {"shear", law.tested.shear}});
  set_text(L, "law", law_word(law.law));
  set_text(L, "transverse", law.transverse == Transverse::elastic ? "elastic" : "follow");
  lua_pushboolean(L, law.shear_hysteresis);
  lua_setfield(L, -2, "shear_hysteresis");
  if (law.biaxial)
    set_fields(L, "biaxial",
               {{"alpha", law.biaxial->alpha},
                {"offset", law.biaxial->offset},
                {"loading", law.biaxial->loading},
                {"unloading", law.biaxial->unloading}});
  if (law.bands) set_bands(L, *law.bands);
}

template <class Moduli>
void set_moduli(lua_State* L, const Moduli& law) {
  set_number(L, "warp", law.warp);
  set_number(L, "weft", law.weft);
  set_number(L, "shear", law.shear);
  push_numbers(L, {law.nu12, law.nu21});
  lua_setfield(L, -2, "poisson");
}

void set_law(lua_State* L, const Linear& law) { set_moduli(L, law); }
void set_law(lua_State* L, const Svk& law) {
  set_moduli(L, law);
  if (!law.g13 || !law.g23) return;
  push_numbers(L, {*law.g13, *law.g23});
  lua_setfield(L, -2, "transverse");
}

void set_bending(lua_State* L, const Bending& bending) {
  lua_newtable(L);
  set_number(L, "warp", bending.warp);
  set_number(L, "weft", bending.weft);
  set_number(L, "twist", bending.twist);
  const auto friction = [L](const char* name, const std::optional<BendingFriction>& f) {
    if (f) set_fields(L, name, {{"moment", f->moment}, {"curvature", f->curvature}});
  };
  friction("friction_warp", bending.friction_warp);
  friction("friction_weft", bending.friction_weft);
  lua_setfield(L, -2, "bending");
}

std::string quoted(const std::string& words) {
  std::string out = "\"";
  for (const char c : words) {
    if (c == '\n') {
      out += "\\n";
    } else if (c == '\r') {
      out += "\\r";
    } else if (c == '\0') {
      out += "\\0";
    } else {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
  }
  return out + "\"";
}

std::string points_text(const std::vector<std::pair<double, double>>& points) {
  std::string out = "{";
  for (const auto& [x, y] : points)
    out += (out.size() > 1 ? ", {" : " {") + number_text(x) + ", " + number_text(y) + "}";
  return out + " }";
}

std::string list_text(const std::vector<double>& values) {
  std::string out = "{";
  for (const double v : values) out += (out.size() > 1 ? ", " : "") + number_text(v);
  return out + "}";
}

std::string curve_text(const Curve& curve) {
  return "loading = " + (curve.points.empty() ? list_text(curve.coefficients) : points_text(curve.points));
}

std::string yarn_text(const char* name, const Yarn& yarn) {
  return std::string("  ") + name + " = { " + curve_text(yarn.loading) +
         ", unloading = " + number_text(yarn.unloading) + ", poisson = " + number_text(yarn.poisson) +
         " },\n";
}

std::string band_text(const char* part, const Band& band) {
  if (band.low.empty()) return "";
  return std::string("    ") + part + " = { low = " + list_text(band.low) +
         ", high = " + list_text(band.high) + ",\n      covariance = " + list_text(band.covariance) + " },\n";
}

// Of loading coefficients, unloading, poisson.
std::string bands_text(const Bands& bands) {
  return "  bands = { level = " + number_text(bands.level) + ",\n" + band_text("warp", bands.warp) +
         band_text("weft", bands.weft) + band_text("shear", bands.shear) + "  },\n";
}

std::string law_text(const Woven& law) {
  std::string out = yarn_text("warp", law.warp) + yarn_text("weft", law.weft);
  out += "  shear = { " + curve_text(law.shear.loading) +
         ", unloading = " + number_text(law.shear.unloading) + ", measure = \"" +
         (law.shear.measure == Measure::tensor ? "tensor" : "engineering") + "\", memory = \"" +
         (law.shear.memory == ShearMemory::printed ? "printed" : "fading") + "\" },\n";
  out += "  tested = { warp = " + number_text(law.tested.warp) + ", weft = " + number_text(law.tested.weft) +
         ", shear = " + number_text(law.tested.shear) + " },\n";
  out += std::string("  law = \"") + law_word(law.law) + "\",\n";
  if (law.transverse == Transverse::follow) out += "  transverse = \"follow\",\n";
  if (!law.shear_hysteresis) out += "  shear_hysteresis = false,\n";
  if (law.biaxial)
    out += "  biaxial = { alpha = " + number_text(law.biaxial->alpha) +
           ", offset = " + number_text(law.biaxial->offset) +
           ", loading = " + number_text(law.biaxial->loading) +
           ", unloading = " + number_text(law.biaxial->unloading) + " },\n";
  if (law.bands) out += bands_text(*law.bands);
  return out;
}

template <class Moduli>
std::string moduli_text(const Moduli& law) {
  return "  warp = " + number_text(law.warp) + ", weft = " + number_text(law.weft) +
         ", shear = " + number_text(law.shear) + ",\n  poisson = " + list_text({law.nu12, law.nu21}) + ",\n";
}

std::string law_text(const Linear& law) { return moduli_text(law); }
std::string law_text(const Svk& law) {
  std::string out = moduli_text(law);
  if (law.g13 && law.g23) out += "  transverse = " + list_text({*law.g13, *law.g23}) + ",\n";
  return out;
}

std::string bending_text(const Bending& b) {
  std::string out = "  bending = { warp = " + number_text(b.warp) + ", weft = " + number_text(b.weft) +
                    ", twist = " + number_text(b.twist);
  const auto friction = [&out](const char* name, const std::optional<BendingFriction>& f) {
    if (f)
      out += std::string(", ") + name + " = { moment = " + number_text(f->moment) +
             ", curvature = " + number_text(f->curvature) + " }";
  };
  friction("friction_warp", b.friction_warp);
  friction("friction_weft", b.friction_weft);
  return out + " },\n";
}

}  // namespace

void push_card_table(lua_State* L, const Card& card) {
  luaL_checkstack(L, 10, "card");
  lua_newtable(L);
  set_text(L, "kind", card_kind(card));
  set_text(L, "name", card.name);
  set_text(L, "source", fabric::without_provenance(card.source));
  set_number(L, "density", card.density);
  set_number(L, "thickness", card.thickness);
  std::visit([L](const auto& law) { set_law(L, law); }, card.law);
  if (card.bending) set_bending(L, *card.bending);
  const auto provenance = fabric::provenance_of(card.source);
  if (provenance.empty()) return;
  lua_newtable(L);
  for (const auto& [field, words] : provenance) set_text(L, field.c_str(), words);
  lua_setfield(L, -2, "provenance");
}

std::string card_text(const Card& card) {
  std::string out = "-- SI units: Pa, m, kg/m^3; strains are Green-Lagrange, tensor components.\n";
  out += "local fabric = require \"fabric\"\nreturn fabric." + card_kind(card) + "{\n";
  out += "  name = " + quoted(card.name) + ",\n  source = " + quoted(card.source) + ",\n";
  out += "  density = " + number_text(card.density) + ", thickness = " + number_text(card.thickness) + ",\n";
  out += std::visit([](const auto& law) { return law_text(law); }, card.law);
  if (card.bending) out += bending_text(*card.bending);
  return out + "}\n";
}

}  // namespace fabricsh::script
