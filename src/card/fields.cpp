#include "card/fields.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "card/compression.hpp"

namespace fabricsh::card {

namespace {

template <class Owner>
using Rows = std::vector<FieldOf<Owner>>;

constexpr double per_MPa = 1e-6;

template <class Owner>
FieldOf<Owner> modulus(std::string name, double Owner::*place, std::string sentence) {
  return number(std::move(name), place, "Pa", positive, std::move(sentence))
      .ask(1e3, 1e12, "is the modulus in Pa? (write 8*MPa; N/m divided by the thickness)");
}

std::string in_MPa(double x) { return fabricsh::number(x * per_MPa, 4); }

// For example "8 + 826 E, in MPa", or the number of measured points.
std::string curve_words(const Curve& curve, const std::string& strain) {
  if (!curve.points.empty())
    return std::to_string(curve.points.size()) + " points to " + in_MPa(curve.points.back().second) + " MPa";
  std::string out;
  for (std::size_t i = 0; i < curve.coefficients.size(); ++i) {
    const double d = curve.coefficients[i];
    if (i == 0)
      out = in_MPa(d);
    else
      out += (d < 0 ? " - " : " + ") + in_MPa(std::abs(d)) + " " + strain +
             (i > 1 ? "^" + std::to_string(i) : "");
  }
  return out;
}

Rows<YarnLoop> loop_rows(const std::string& side) {
  return {number("friction", &YarnLoop::friction, "", Range{0, 1, false, true},
                 "fraction of the peak stress due to friction between the fibres: the width of the loop")
              .on_line(side + " loop")
              .printed("friction #"),
          number("reach", &YarnLoop::reach, "", Range{1e-3, 1, false, false},
                 "fraction of the strain from the peak to zero stress over which that friction is lost, and "
                 "built up "
                 "again after a reversal")
              .or_else(0.5)
              .on_line(side + " loop")
              .printed("over # of the way"),
          number("curve", &YarnLoop::curve, "", Range{0, 1},
                 "fraction of the elastic part that grows with the square of that strain; 0: linearly")
              .or_else(0.0)
              .on_line(side + " loop")
              .printed("curve #")};
}

Rows<Yarn> yarn_rows(const std::string& side, const std::string& strain, const std::string& ratio) {
  return {
      curve("loading", &Yarn::loading,
            "tangent modulus D(E) = d0 + d1 E + ..., Pa, as {d0, d1, ...}; or measured points {{E, S}, "
            "...} from {0, 0} on")
          .ask(1e3, 1e11, "is the modulus in Pa?")
          .band()
          .in_column("tangent modulus, MPa")
          .said([strain](const Yarn& yarn) { return curve_words(yarn.loading, strain); }),
      modulus("unloading", &Yarn::unloading, "unloading modulus").band().in_column("unloading, MPa", per_MPa),
      number("poisson", &Yarn::poisson, "", not_negative, ratio)
          .ask(1e-3, 5, "is it the ratio of two strains?")
          .band()
          .in_column("poisson"),
      group("loop", &Yarn::loop, loop_rows(side),
            "unloading and reloading along curves instead of one straight line, with loops inside loops; "
            "unloading is then the secant from the peak to zero stress; law potential only")};
}

Rows<ShearFriction> shear_friction_rows() {
  return {number("stress", &ShearFriction::stress, "Pa", not_negative,
                 "stress at which friction slips at zero strain")
              .on_line("shear friction")
              .printed("# kPa", 1e-3),
          number("growth", &ShearFriction::growth, "Pa", everything,
                 "increase of this stress with the strain, in shear's measure: the loop widens")
              .or_else(0.0)
              .on_line("shear friction")
              .printed("growing by # kPa", 1e-3)};
}

Rows<Shear> shear_rows() {
  return {
      curve("loading", &Shear::loading,
            "tangent modulus in the measure's strain, Pa, as {g0, g1, ...}; or measured points")
          .ask(1e2, 1e10, "is the modulus in Pa?")
          .band()
          .in_column("tangent modulus, MPa")
          .said([](const Shear& shear) {
            return curve_words(shear.loading, shear.measure == StrainMeasure::tensor ? "E12" : "2E12");
          }),
      modulus("unloading", &Shear::unloading, "unloading modulus, in the same measure")
          .band()
          .in_column("unloading, MPa", per_MPa),
      word("measure", &Shear::measure, {"tensor", "engineering"},
           "tensor: dS12/dE12 in E12; engineering: dS12/d(2E12) in 2E12")
          .unprinted(),
      word("memory", &Shear::memory, {"printed", "fading"},
           "memory of the branch left at a reversal: printed, as in the published law, erases it at once; "
           "fading lets it decay with the slip that follows")
          .on_line("law")
          .said([](const Shear& s) { return s.memory == ShearMemory::fading ? "shear memory fades" : ""; }),
      group("friction", &Shear::friction, shear_friction_rows(),
            "elastic-frictional shear: loading is elastic; in parallel, friction sticks with the modulus "
            "unloading less the initial modulus and slips at stress + growth |strain|; law potential only")};
}

FieldOf<Tested> tested(std::string name, double Tested::*place, const std::string& strain,
                       std::string sentence) {
  return number(name, place, "", Range{0, 10}, std::move(sentence))
      .or_else(0.0)
      .ask(1e-4, 1, "is it a strain, not per cent?")
      .in_column("tested to", 1, name)
      .said([place, strain](const Tested& t) {
        return t.*place > 0 ? strain + " = " + fabricsh::number(t.*place, 4) : "not stated";
      });
}

Rows<Tested> tested_rows() {
  return {tested("warp", &Tested::warp, "E11", "largest E11 tested"),
          tested("weft", &Tested::weft, "E22", "largest E22 tested"),
          tested("shear", &Tested::shear, "E12", "largest E12 tested (tensor)")};
}

Rows<Biaxial> biaxial_rows() {
  return {
      number("alpha", &Biaxial::alpha, "", positive, "weight of E22").band(),
      number("offset", &Biaxial::offset, "", not_negative, "strain where it begins").band().printed("from #"),
      modulus("loading", &Biaxial::loading, "q of T = q y^2 / 2").band().printed("# MPa", per_MPa),
      modulus("unloading", &Biaxial::unloading, "unloading modulus")
          .band()
          .printed("unloading # MPa", per_MPa)};
}

// The rows of a rheological element; a name with a dot stands in the group before it.
template <class Parameters>
Rows<Parameters> element_rows(const std::vector<rheology::ParameterRow<Parameters>>& rows,
                              const std::string& inside) {
  const auto same = [](auto& parameters) -> auto& { return parameters; };
  Rows<Parameters> out;
  for (const auto& r : rows) {
    if (!r.name.starts_with(inside) || r.name.find('.', inside.size()) != std::string::npos) continue;
    const std::string name = r.name.substr(inside.size());
    if (r.place == nullptr) {
      auto group = grouped<Parameters>(name, element_rows(rows, r.name + "."), same, r.sentence);
      if (!r.required) {
        group = group.optional();
        group.there = [rows, inside = r.name + "."](const Parameters& p) {
          return std::any_of(rows.begin(), rows.end(), [&](const auto& other) {
            return other.place != nullptr && other.name.starts_with(inside) && p.*other.place != 0;
          });
        };
      }
      out.push_back(std::move(group));
      continue;
    }
    auto f = number(name, r.place, r.unit, r.range, r.sentence);
    if (!r.question.empty()) f = f.ask(r.usual.low, r.usual.high, r.question);
    out.push_back(r.phrase.empty() ? f : f.printed(r.phrase, r.scale));
  }
  return out;
}

void add_elements(Rows<Woven>& rows) {
  rheology::for_each([&rows](auto element, auto given, auto) {
    const auto own = group(element.name, given, element_rows(element.rows(), ""), element.sentence);
    rows.push_back(lifted<Woven>(
        own, [](auto& woven) -> auto& { return woven.parallel; }));
  });
}

Rows<ParameterBand> band_rows() {
  return {
      numbers(
          "low", &ParameterBand::low, "",
          "of loading coefficients (of points: their stresses beyond zero strain), unloading, poisson; of "
          "bending: warp, weft, twist, then moment and curvature of each friction; of the biaxial spring: "
          "alpha, offset, loading, unloading")
          .unprinted(),
      numbers("high", &ParameterBand::high, "", "of the same parameters").unprinted(),
      numbers("covariance", &ParameterBand::covariance, "", "of the same parameters, row by row")
          .next_line()
          .unprinted()};
}

FieldOf<ParameterBands> band(const std::string& name, ParameterBand ParameterBands::*place) {
  auto f = group(name, place, band_rows(), "of the " + name + "'s parameters").optional();
  f.there = [place](const ParameterBands& bands) { return !(bands.*place).low.empty(); };
  return f;
}

// Lists the parts that have confidence bands, and those that do not.
std::string bands_words(const ParameterBands& bands) {
  std::string with, without;
  bool further = false;  // beside the three parts that each card has
  for (const auto& [name, place] : banded_parts) {
    const bool has = !(bands.*place).low.empty(),
               own = place == &ParameterBands::bending || place == &ParameterBands::biaxial;
    if (own && !has) continue;
    further = further || own;
    std::string& list = has ? with : without;
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  const std::string of = "of " + fabricsh::number(100 * bands.level, 4) + " % confidence";
  if (without.empty()) return further ? of + " on " + with : of;
  return with.empty() ? "none" : of + " on " + with + ", none on " + without;
}

Rows<ParameterBands> bands_rows() {
  Rows<ParameterBands> rows{
      number("level", &ParameterBands::level, "", Range{0, 1, true, true}, "of confidence")
          .or_else(0.95)
          .said(bands_words)};
  for (const auto& [name, place] : banded_parts) rows.push_back(band(name, place));
  return rows;
}

Rows<BendingFriction> friction_rows(const std::string& side) {
  return {
      number("moment", &BendingFriction::moment, "N", positive, "friction moment per width")
          .band()
          .printed("friction " + side + " # mN", 1e3),
      number("curvature", &BendingFriction::curvature, "1/m", positive, "curvature over which it builds up")
          .band()
          .printed("over # 1/m"),
      word("memory", &BendingFriction::memory, {"slip", "fading"},
           "slip: the friction moment grows linearly until it slips; fading: it approaches its limit "
           "exponentially over that curvature")
          .unless_fallback()
          .said([](const BendingFriction& f) {
            return f.memory == FrictionMemory::fading ? "its memory fades" : "";
          })};
}

// For example "15", or "15 falling to 11 at 100 1/m".
std::string rigidity_words(const std::string& name, double initial, const Curve& curve) {
  const auto micro = [](double B) { return fabricsh::number(1e6 * B, 4); };
  if (!curve.points.empty())
    return name + " " + std::to_string(curve.points.size()) + " points to " +
           fabricsh::number(1e3 * curve.points.back().second, 4) + " mN at " +
           fabricsh::number(curve.points.back().first, 4) + " 1/m";
  std::string words = name + " " + micro(initial);
  for (std::size_t i = 1; i < curve.coefficients.size(); ++i)
    words += (curve.coefficients[i] < 0 ? " - " : " + ") + micro(std::abs(curve.coefficients[i])) + " k" +
             (i > 1 ? "^" + std::to_string(i) : "");
  return words;
}

FieldOf<Bending> rigidity(const std::string& name, double Bending::*place, Curve Bending::*as_curve) {
  auto f = number_or_curve(name, place, as_curve, "N.m", not_negative,
                           "bending rigidity along the " + name +
                               ": a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, "
                               "b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per "
                               "width, N, from {0, 0} on")
               .said([=](const Bending& b) { return rigidity_words(name, b.*place, b.*as_curve); });
  f.parts = {"curvature", "moment"};
  return f.band();
}

Rows<Bending> bending_rows() {
  return {
      rigidity("warp", &Bending::warp, &Bending::warp_curve),
      rigidity("weft", &Bending::weft, &Bending::weft_curve),
      number("twist", &Bending::twist, "N.m", not_negative, "twisting rigidity, multiplies 2 kappa12")
          .band()
          .printed("twist # uN.m", 1e6),
      group("friction_warp", &Bending::friction_warp, friction_rows("warp"),
            "bending hysteresis along the warp"),
      group("friction_weft", &Bending::friction_weft, friction_rows("weft"),
            "bending hysteresis along the weft"),
      number("tested", &Bending::tested, "1/m", not_negative,
             "curvature up to which the rigidities were measured: beyond it they are constant; 0: not stated")
          .or_else(0.0)
          .unless_fallback()
          .printed("tested to # 1/m")};
}

// Marks rows as not printed.
template <class Owner>
Rows<Owner> silent(Rows<Owner> rows) {
  for (auto& row : rows) {
    row.phrase.clear();
    row.say = nullptr;
    row.rows = silent(row.rows);
  }
  return rows;
}

Rows<StrengthScatter> scatter_rows() {
  return {number("modulus", &StrengthScatter::modulus, "", positive,
                 "Weibull modulus of the strength; the larger, the less it scatters")
              .ask(1, 200, "is it the Weibull modulus?")
              .printed("Weibull modulus #"),
          number("length", &StrengthScatter::length, "m", positive,
                 "length of yarn at which the strength was measured; without it strength does not depend on "
                 "length")
              .ask(1e-4, 10, "is the length in m?")
              .printed("at # mm", 1e3),
          number("exponent", &StrengthScatter::exponent, "", not_negative,
                 "strength goes with length^-exponent; default 1 / modulus, the weakest link")
              .printed("size exponent #")};
}

Rows<YarnBreak> break_rows(const std::string& side) {
  const std::string line = side + " breaks";
  return {
      number("strength", &YarnBreak::strength, "N/m", positive,
             "mean force per width at which these yarns break")
          .ask(100, 1e6, "is the strength in N/m of width?")
          .on_line(line)
          .printed("at # kN/m", 1e-3),
      number("energy", &YarnBreak::energy, "J/m", positive,
             "energy that breaking these yarns takes, per metre of the tear")
          .ask(0.1, 1e5, "is the energy in J per metre of tear?")
          .on_line(line)
          .printed("energy # J/m"),
      group("scatter", &YarnBreak::scatter, scatter_rows(), "how the strength differs from place to place"),
      number("yarns", &YarnBreak::yarns, "1/m", positive,
             "yarns per metre of the line on which they break; with scatter each yarn has a strength of its "
             "own, and a place of the mesh the mean of its yarns")
          .ask(100, 1e5, "is it the number of yarns per metre?")
          .on_line(line)
          .printed("# yarns/cm", 1e-2)};
}

Rows<Rupture> rupture_rows() {
  return {
      group("warp", &Rupture::warp, break_rows("warp"), "breaking of the warp yarns; without it they hold"),
      group("weft", &Rupture::weft, break_rows("weft"), "breaking of the weft yarns; without it they hold")};
}

Rows<BendingEstimate> estimate_rows() {
  return silent<BendingEstimate>(
      {group("bending", &BendingEstimate::bending, bending_rows(), "of the bending"),
       text("source", &BendingEstimate::source, "where the estimate comes from")});
}

Rows<Woven> woven_rows() {
  Rows<Woven> rows = {
      group("warp", &Woven::warp,
            yarn_rows("warp", "E11", "nu12: contraction along weft when pulled along warp"),
            "along the warp"),
      group("weft", &Woven::weft,
            yarn_rows("weft", "E22", "nu21: contraction along warp when pulled along weft"),
            "along the weft"),
      group("shear", &Woven::shear, shear_rows(), "in-plane shear"),
      group("tested", &Woven::tested, tested_rows(), "strains up to which it was measured").optional(),
      word("law", &Woven::law, {std::begin(law_words), std::end(law_words)},
           "the law that is compiled from the card")
          .printed("#"),
      word("transverse", &Woven::transverse, {"elastic", "follow"}, "transverse shear of the comparison laws")
          .unless_fallback()
          .on_line("law")
          .said([](const Woven& law) {
            if (law.law == LawKind::potential) return "";
            return law.transverse == Transverse::elastic ? "transverse shear elastic"
                                                         : "transverse shear follows";
          }),
      flag("shear_hysteresis", &Woven::shear_hysteresis, "of the comparison laws")
          .or_else(true)
          .unless_fallback()
          .on_line("law")
          .said([](const Woven& law) {
            return law.law == LawKind::potential || law.shear_hysteresis ? "" : "no shear hysteresis";
          }),
      group("biaxial", &Woven::biaxial, biaxial_rows(),
            "a fourth spring that acts when both yarns are stretched")};
  add_elements(rows);
  rows.push_back(
      group("bands", &Woven::bands, bands_rows(), "confidence bands of the measured parameters").on_lines());
  return rows;
}

template <class Law>
FieldOf<Law> ratios(std::string sentence) {
  auto f = row<Law>("poisson", FieldType::ratios, "", Range{-1, 10, true, false}, std::move(sentence))
               .in_column("poisson")
               .in_rows({"warp", "weft"});
  f.parts = {"nu12", "nu21"};
  f.get = [](const Law& law) { return Value(std::vector{law.nu12, law.nu21}); };
  f.set = [](Law& law, const Value& v) {
    const auto& pair = std::get<std::vector<double>>(v);
    law.nu12 = pair.at(0), law.nu21 = pair.at(1);
  };
  return f;
}

template <class Law>
Rows<Law> moduli() {
  const auto direction = [](std::string name, double Law::*place, std::string sentence) {
    return modulus(name, place, std::move(sentence)).in_column("modulus, MPa", per_MPa, name);
  };
  return {direction("warp", &Law::warp, "modulus along the warp"),
          direction("weft", &Law::weft, "modulus along the weft").same_line(),
          direction("shear", &Law::shear, "engineering shear modulus, S12 = 2 shear E12").same_line()};
}

FieldOf<Svk> young() {
  auto f = row<Svk>("young", FieldType::number, "Pa", positive,
                    "modulus of an isotropic sheet, instead of warp, weft, shear")
               .ask(1e3, 1e12, "is the modulus in Pa? (write 8*MPa; N/m divided by the thickness)")
               .optional();
  f.set = [](Svk& law, const Value& v) {  // to be set after the ratios
    law.warp = law.weft = std::get<double>(v);
    law.shear = law.warp / (2 * (1 + law.nu12));
  };
  return f;
}

FieldOf<Svk> transverse() {
  auto f = row<Svk>("transverse", FieldType::numbers, "Pa", positive, "{G13, G23}; default 5/6 of shear")
               .optional();
  f.parts = {"G13", "G23"};
  f.get = [](const Svk& law) {
    const double usual = 5.0 / 6.0 * law.shear;
    if (!law.g13 && !law.g23) return Value();
    return Value(std::vector{law.g13.value_or(usual), law.g23.value_or(usual)});
  };
  f.set = [](Svk& law, const Value& v) {
    const auto& pair = std::get<std::vector<double>>(v);
    law.g13 = pair.at(0), law.g23 = pair.at(1);
  };
  return f.printed("#", per_MPa);
}

Rows<Svk> svk_rows() {
  Rows<Svk> rows;
  for (const auto& f : moduli<Svk>()) rows.push_back(f.optional());
  rows.push_back(ratios<Svk>("{nu12, nu21}, or one number for both"));
  rows.push_back(young());
  rows.push_back(transverse());
  return rows;
}

Rows<LinearElastic> linear_rows() {
  auto rows = moduli<LinearElastic>();
  rows.push_back(ratios<LinearElastic>("{nu12, nu21}"));
  return rows;
}

std::string compression_words(const Points& curve) {
  if (curve.empty()) return "";
  const auto point = [](const std::pair<double, double>& p) {
    return fabricsh::number(1e3 * p.first, 4) + " mm at " + fabricsh::number(1e-3 * p.second, 4) + " kPa";
  };
  return std::to_string(curve.size()) + " points from " + point(curve.back()) + " to " + point(curve.front());
}

// Name, source, density and thickness form the heading of a printed card.
template <class Law>
FieldTable table_of(const Rows<Law>& law) {
  FieldTable rows = {text("name", &Card::name, "of the fabric").or_else("").unprinted(),
                     text("source", &Card::source, "where the numbers come from").or_else("").unprinted(),
                     number("density", &Card::density, "kg/m^3", positive, "mass over volume")
                         .ask(20, 5000, "mass per area is density * thickness")
                         .unprinted(),
                     number("thickness", &Card::thickness, "m", positive, "of the sheet")
                         .ask(1e-5, 2e-2, "is it in m? (write 0.38*mm)")
                         .same_line()
                         .unprinted()};
  rows.push_back(group("bending", &Card::bending, bending_rows(),
                       "own bending rigidity instead of integration through the thickness")
                     .written_last());
  rows.push_back(flag("through_thickness", &Card::through_thickness,
                      "bending by integration through the thickness is intended where the card has no "
                      "bending of its own: no warning, even if that is far stiffer than cloth")
                     .or_else(false)
                     .unless_fallback()
                     .written_last()
                     .on_line("bending")
                     .said([](const Card& c) { return c.through_thickness ? "through the thickness" : ""; }));
  rows.push_back(
      group("estimate", &Card::estimate, estimate_rows(),
            "estimates of what was not measured, used by fabric.card(name, { bending='estimated' })")
          .written_last());
  rows.push_back(points("compression", &Card::compression, {"gap", "pressure"}, compression_fault,
                        "one sheet pressed between two plates, {{gap, pressure}, ...}: gap, m, is its "
                        "thickness then, which is also how far apart the middles of two such sheets are, "
                        "pressure in Pa; what contact presses with")
                     .written_last()
                     .said([](const Card& c) { return compression_words(c.compression); }));
  rows.push_back(number("fibre_density", &Card::fibre_density, "kg/m^3", positive,
                        "of what the yarns are made of; areal mass over it is how thin the sheet can be "
                        "pressed at most; default 1500 (cotton 1540, polyester 1380)")
                     .ask(500, 10000, "is it the density of the fibres, in kg/m^3?")
                     .written_last()
                     .on_line("fibres")
                     .printed("# kg/m^3"));
  rows.push_back(word("folds", &Card::folds, {std::begin(fold_words), std::end(fold_words)},
                      "where compressed cloth folds: resolved, in the shape of the mesh alone; within "
                      "elements too, which then carry no more than folds of their size would; or free, the "
                      "same without any force")
                     .unless_fallback()
                     .written_last()
                     .on_line("bending")
                     .said([](const Card& c) {
                       return c.folds == Folds::resolved
                                  ? std::string()
                                  : std::string("folds ") + fold_words[static_cast<std::size_t>(c.folds)];
                     }));
  rows.push_back(group("rupture", &Card::rupture, rupture_rows(),
                       "where yarns break: in tearable zones of a model, see model:tearable")
                     .on_lines()
                     .written_last());
  const auto enter = [](auto& card) -> auto& { return std::get<Law>(card.law); };
  for (const auto& f : law) rows.push_back(lifted<Card>(f, enter));
  return rows;
}

}  // namespace

std::string kind(const Card& card) {
  if (std::holds_alternative<Svk>(card.law)) return "svk";
  return std::holds_alternative<LinearElastic>(card.law) ? "linear" : "woven";
}

Card blank(const std::string& kind) {
  Card card;
  if (kind == "svk") card.law = Svk{};
  if (kind == "linear") card.law = LinearElastic{};
  return card;
}

const FieldTable& fields(const std::string& kind) {
  static const FieldTable woven = table_of(woven_rows()), svk = table_of(svk_rows()),
                          linear = table_of(linear_rows());
  return kind == "svk" ? svk : kind == "linear" ? linear : woven;
}

}  // namespace fabricsh::card
