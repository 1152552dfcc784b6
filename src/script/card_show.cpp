// A card as it is printed: a table with units.
#include "fabric/provenance.hpp"
#include "script/bind.hpp"
#include "script/show.hpp"

namespace fabricsh::script {

using namespace card;

namespace {

using Row = std::vector<std::string>;
constexpr double per_MPa = 1e-6;

std::string say(double x, const char* format = "%.4g") {
  char text[40];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

// 8 + 826 E, in MPa; or how many measured points.
std::string curve_words(const Curve& curve, const char* variable) {
  if (!curve.points.empty())
    return std::to_string(curve.points.size()) + " points to " + say(curve.points.back().second * per_MPa) +
           " MPa";
  std::string out;
  for (std::size_t i = 0; i < curve.coefficients.size(); ++i) {
    const double d = curve.coefficients[i] * per_MPa;
    if (i == 0)
      out = say(d);
    else
      out += (d < 0 ? " - " : " + ") + say(std::abs(d)) + " " + variable +
             (i > 1 ? "^" + std::to_string(i) : "");
  }
  return out;
}

std::string reach(double strain, const char* name) {
  return strain > 0 ? std::string(name) + " = " + say(strain) : "not stated";
}

const char* law_word(LawKind kind) {
  if (kind == LawKind::potential) return "potential";
  return kind == LawKind::incremental ? "incremental" : "thesis";
}

std::string law_words(const Woven& law) {
  std::string out = law_word(law.law);
  if (law.law != LawKind::potential) {
    out +=
        law.transverse == Transverse::elastic ? ", transverse shear elastic" : ", transverse shear follows";
    if (!law.shear_hysteresis) out += ", no shear hysteresis";
  }
  if (law.shear.memory == ShearMemory::fading) out += ", shear memory fades";
  return out;
}

// Of which parts, and of which not.
std::string bands_words(const Bands& bands) {
  std::string with, without;
  for (const auto& [name, band] :
       {std::pair{"warp", &bands.warp}, {"weft", &bands.weft}, {"shear", &bands.shear}}) {
    std::string& list = band->low.empty() ? without : with;
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  const std::string of = "of " + say(100 * bands.level) + " % confidence";
  if (without.empty()) return of;
  return with.empty() ? "none" : of + " on " + with + ", none on " + without;
}

void add_law(std::vector<Row>& rows, const Woven& law) {
  const bool tensor = law.shear.measure == Measure::tensor;
  rows.push_back({"", "tangent modulus, MPa", "unloading, MPa", "poisson", "tested to"});
  rows.push_back({"warp", curve_words(law.warp.loading, "E11"), say(law.warp.unloading * per_MPa),
                  say(law.warp.poisson), reach(law.tested.warp, "E11")});
  rows.push_back({"weft", curve_words(law.weft.loading, "E22"), say(law.weft.unloading * per_MPa),
                  say(law.weft.poisson), reach(law.tested.weft, "E22")});
  rows.push_back({"shear", curve_words(law.shear.loading, tensor ? "E12" : "2E12"),
                  say(law.shear.unloading * per_MPa), "", reach(law.tested.shear, "E12")});
  rows.push_back({"law", law_words(law)});
  if (law.biaxial)
    rows.push_back({"biaxial", "alpha " + say(law.biaxial->alpha) + ", from " + say(law.biaxial->offset) +
                                   ", " + say(law.biaxial->loading * per_MPa) + " MPa, unloading " +
                                   say(law.biaxial->unloading * per_MPa) + " MPa"});
  if (law.bands) rows.push_back({"bands", bands_words(*law.bands)});
}

template <class Moduli>
void add_moduli(std::vector<Row>& rows, const Moduli& law) {
  rows.push_back({"", "modulus, MPa", "poisson"});
  rows.push_back({"warp", say(law.warp * per_MPa), say(law.nu12)});
  rows.push_back({"weft", say(law.weft * per_MPa), say(law.nu21)});
  rows.push_back({"shear", say(law.shear * per_MPa)});
}

void add_law(std::vector<Row>& rows, const Linear& law) { add_moduli(rows, law); }
void add_law(std::vector<Row>& rows, const Svk& law) {
  add_moduli(rows, law);
  if (law.g13 && law.g23)
    rows.push_back({"transverse", say(*law.g13 * per_MPa) + ", " + say(*law.g23 * per_MPa)});
}

// "warp 8, weft 6, twist 3.5 uN.m", and where there is friction its moment.
std::string bending_words(const Bending& b) {
  std::string out =
      "warp " + say(b.warp * 1e6) + ", weft " + say(b.weft * 1e6) + ", twist " + say(b.twist * 1e6) + " uN.m";
  const auto friction = [&out](const char* name, const std::optional<BendingFriction>& f) {
    if (f) out += std::string("; friction ") + name + " " + say(f->moment * 1e3) + " mN";
  };
  friction("warp", b.friction_warp);
  friction("weft", b.friction_weft);
  return out;
}

}  // namespace

std::string card_words(const Card& card) {
  std::string out = "<card " + (card.name.empty() ? "without name" : card.name) + ", " + card_kind(card) +
                    ", " + say(card.density) + " kg m^-3, " + say(card.thickness * 1e3) + " mm, " +
                    say(card.density * card.thickness * 1e3) + " g m^-2>";
  std::vector<Row> rows;
  std::visit([&rows](const auto& law) { add_law(rows, law); }, card.law);
  if (card.bending) rows.push_back({"bending", bending_words(*card.bending)});
  const std::string source = fabric::without_provenance(card.source);
  if (!source.empty()) rows.push_back({"source", source});
  for (const auto& [field, words] : fabric::provenance_of(card.source)) rows.push_back({field, words});
  out += "\n" + columns_text(rows);
  out.pop_back();
  return out;
}

}  // namespace fabricsh::script
