// fabric.lab: the measuring functions used by the Lua library.
#include <cmath>

#include "base/number.hpp"
#include "lab/averaged.hpp"
#include "lab/backbone.hpp"
#include "lab/markers.hpp"
#include "lab/pull.hpp"
#include "lab/statistics.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

namespace {

void same_length(const Call& call, const char* a, const char* b) {
  const auto n = call.numbers(a).size(), m = call.numbers(b).size();
  if (n != m)
    call.refuse(b, "expected as many numbers as in '" + std::string(a) + "' (" + std::to_string(n) +
                       "), got " + std::to_string(m));
}

int reduce(Call& call) {
  same_length(call, "displacement", "force");
  const auto force = call.numbers("force");
  const lab::Specimen specimen{call.number("gauge_length"), call.number("width"), call.number("thickness"),
                               call.count("plies")};
  const auto u = lab::end_displacement(call.numbers("displacement"), force,
                                       {call.number("compliance"), call.number("slip"), 0});
  double slack = call.number("slack");
  if (call.has("contact")) {
    const auto found = lab::first_contact(u, force, call.number("contact"));
    if (!found) call.refuse("contact", "the force never rises above it");
    slack = *found;
  }
  const auto tension = lab::stress_strain(u, force, specimen, slack);
  return push_record(call.L(), "slack", slack, "area", specimen.area(), "displacement", u, "E", tension.E,
                     "S", tension.S);
}

constexpr const char* branch_words[] = {"loading", "unloading", "reloading", "hold"};

int branches(Call& call) {
  return push_list(call.L(), lab::branches(call.numbers("displacement"), call.number("tolerance")),
                   [L = call.L()](const lab::PullBranch& b) {
                     push_record(L, "kind", branch_words[static_cast<std::size_t>(b.kind)], "first",
                                 b.begin + 1, "last", b.end);
                   });
}

// Rows of yield (the tangent falls below half of its largest value) and of failure (the largest stress,
// `kept` of which is left where the strip has failed), nil where there is none.
int marks(Call& call) {
  same_length(call, "E", "S");
  const auto E = call.numbers("E"), S = call.numbers("S");
  const auto marks = lab::yield_and_failure(E, S, E.size(), call.number("kept"));
  lua_newtable(call.L());
  if (marks.yield) put(call.L(), "yield", *marks.yield + 1);
  if (marks.failure) put(call.L(), "failure", *marks.failure + 1);
  return 1;
}

const std::vector<Argument>& curve_rows() {
  static const std::vector<Argument> rows = {
      {"E", numbers, "", everything, "Green-Lagrange strains"},
      {"S", numbers, "Pa", everything, "second Piola-Kirchhoff stresses"}};
  return rows;
}

// Reads the list of {E=, S=} in the argument `curves`.
std::vector<lab::Tension> tensions(const Call& call) {
  lua_State* L = call.L();
  std::vector<lab::Tension> out;
  call.each("curves", [&](lua_Integer i) {
    const std::string path = "curves[" + std::to_string(i) + "]";
    if (!lua_istable(L, -1)) throw Error("field '" + path + "': expected {E=, S=}, got " + describe(L, -1));
    const Fields f(L, -1, curve_rows(), path + ".");
    out.push_back({f.numbers("E"), f.numbers("S")});
    if (out.back().E.size() != out.back().S.size())
      throw Error("field '" + path + "': expected E and S of one length");
  });
  if (out.empty()) call.refuse("curves", "expected at least one curve {E=, S=}");
  return out;
}

void push_candidate(lua_State* L, const lab::DegreeCandidate& c) {
  push_record(L, "degree", static_cast<double>(c.degree), "criterion", c.criterion, "initial", c.initial,
              "least", c.least, "admissible", c.admissible, "specimens", [&] {
                push_list(L, c.specimens, [L](const lab::SpecimenFit& s) {
                  push_record(L, "loading", s.d, "slack", s.slack, "reach", s.reach, "residual", s.residual);
                });
              });
}

std::vector<int> degrees(const Call& call) {
  if (!call.has("degrees")) return {2, 4};
  std::vector<int> out;
  for (const double d : call.numbers("degrees")) {
    if (!(d >= 1 && d <= 20) || d != std::floor(d))
      call.refuse("degrees", "expected whole numbers from 1 to 20, got " + exact_number(d));
    out.push_back(static_cast<int>(d));
  }
  if (out.empty()) call.refuse("degrees", "expected at least one degree");
  return out;
}

int backbone(Call& call) {
  lua_State* L = call.L();
  const auto candidates = lab::fit_backbones(tensions(call), {degrees(call), call.flag("find_slack")});
  push_list(L, candidates, [L](const lab::DegreeCandidate& c) { push_candidate(L, c); });
  if (const auto best = lab::choose(candidates)) put(L, "chosen", *best + 1);
  return 1;
}

// Loading curves averaged over laws and over where contact may have begun: E, specimens={ {S (at E), slack,
// slack_low, slack_high (95 %), none (probability), reach, residual}, ... }, within (covariance of one
// specimen's curve), common (the part alike in all), laws={ {name, weight}, ... }, correlation (of
// neighbouring residuals). E is empty if no law rises. none: probability beforehand that contact begins at
// zero strain; earliest: least stretch of contact less one; degrees: of polynomials, else 2 to 6 and cubic
// splines with 2 to 12 knots.
int averaged(Call& call) {
  lua_State* L = call.L();
  lab::AveragingOptions options;
  if (call.has("degrees")) options.degrees = degrees(call);
  options.probability_none = call.number("none");
  options.earliest = call.number("earliest");
  options.strains = call.count("strains");
  const auto loading = tensions(call);
  for (const lab::Tension& t : loading)
    if (t.E.size() < 6) call.refuse("curves", "expected at least 6 points of every specimen");
  const lab::AveragedCurves c = lab::average_curves(loading, options);
  const auto push_specimen = [L](const lab::AveragedSpecimen& s) {
    push_record(L, "S", s.S, "slack", s.slack, "slack_low", s.slack_low, "slack_high", s.slack_high, "none",
                s.none, "reach", s.reach, "residual", s.residual);
  };
  const auto push_law = [L](const lab::AveragedLaw& law) {
    push_record(L, "name", law.name, "weight", law.weight);
  };
  return push_record(
      L, "E", c.E, "within", c.within, "common", c.common, "correlation", c.correlation, "specimens",
      [&] { push_list(L, c.specimens, push_specimen); }, "laws", [&] { push_list(L, c.laws, push_law); });
}

// Points {{0, 0}, {E, S}, ...} of a strictly rising curve through the means of bins: a card's loading.
int monotone(Call& call) {
  push_list(call.L(), lab::monotone_points(tensions(call), call.count("bins")), [&](const auto& point) {
    const auto& [E, S] = point;
    push_numbers(call.L(), {E, S});
  });
  return 1;
}

int unloading(Call& call) {
  same_length(call, "E", "S");
  const auto modulus = lab::unloading_modulus(
      call.numbers("E"), call.numbers("S"),
      {call.text("rule") == "first" ? lab::UnloadingRule::first : lab::UnloadingRule::robust,
       static_cast<std::size_t>(call.integer("count")), call.number("kept")});
  if (!modulus) return 0;
  return push_value(call.L(), *modulus);
}

std::vector<std::vector<double>> number_lists(const Call& call, const char* name) {
  std::vector<std::vector<double>> out;
  const Argument row{"", numbers, "", everything, ""};
  call.each(name, [&](lua_Integer i) {
    check_value(call.L(), -1, row, std::string(name) + "[" + std::to_string(i) + "]", false);
    out.push_back(read_numbers(call.L(), -1));
  });
  if (out.empty()) call.refuse(name, "expected at least one list of numbers");
  return out;
}

int band(Call& call) {
  const auto estimate =
      lab::band_of(number_lists(call, "specimens"),
                   {call.number("level"), call.count("draws"),
                    static_cast<std::uint64_t>(call.integer("seed")), call.numbers("common")});
  push_record(call.L(), "value", estimate.value);
  if (estimate.low.empty()) return 1;
  put(call.L(), "low", estimate.low, "high", estimate.high, "covariance", estimate.covariance);
  return 1;
}

int student(Call& call) {
  return push_value(call.L(), lab::student_quantile(call.number("probability"), call.number("freedom")));
}

// Points of Sobol's sequence, which fill a cube evenly [joe2008]: numbers between 0 and 1, point after point.
// seed: of a shift of all points; 0: none.
int sobol_points(Call& call) {
  constexpr std::int64_t most = 100000000;  // numbers
  if (call.integer("count") > most / call.integer("dimensions"))
    call.refuse("count", "expected at most " + std::to_string(most / call.integer("dimensions")) +
                             " points of " + std::to_string(call.integer("dimensions")) +
                             " dimensions, got " + std::to_string(call.integer("count")));
  return push_numbers(call.L(), lab::sobol_points(static_cast<std::size_t>(call.integer("count")),
                                                  static_cast<std::size_t>(call.integer("dimensions")),
                                                  static_cast<std::uint64_t>(call.integer("seed"))));
}

int normal(Call& call) { return push_value(call.L(), lab::normal_quantile(call.number("probability"))); }

// Rows common to the marker functions. A lost marker is nan, which Kind::numbers would refuse.
std::vector<Argument> track_rows() {
  return {integer_("rows", Range{2}, "of markers, following each other along the pull"),
          integer_("columns", Range{2}, "of markers, across the pull"),
          value_("x", table, "of every marker, row by row, frame after frame; nan: lost"),
          value_("y", table, "likewise")};
}

lab::Tracks read_tracks(const Call& call) {
  lab::Tracks t{static_cast<std::size_t>(call.integer("rows")),
                static_cast<std::size_t>(call.integer("columns")), 0, call.numbers("x"), call.numbers("y")};
  if (t.rows > (std::size_t{1} << 40) / t.columns)
    call.refuse("x", "expected at least two frames of as many markers as rows times columns");
  t.frames = t.x.size() / t.markers();
  if (t.frames < 2 || t.frames * t.markers() != t.x.size() || t.y.size() != t.x.size())
    call.refuse("x", "expected at least two frames of " + std::to_string(t.markers()) +
                         " markers, and as many y, got " + std::to_string(t.x.size()) + " and " +
                         std::to_string(t.y.size()));
  return t;
}

// Strains of the boxes of a marker grid, box by box, frame after frame: along and across the pull (eq. 3.2),
// E12 between the yarns, warp_stretch, weft_stretch; zones (1, 2, 3) of a bias specimen by each box's part in
// the shear.
int box_strains(Call& call) {
  const auto tracks = read_tracks(call);
  const auto strains = lab::box_strains(tracks);
  std::vector<double> shear, warp, weft;
  for (std::size_t f = 0; f < tracks.frames; ++f)
    for (std::size_t b = 0; b < tracks.boxes(); ++b) {
      const auto s = lab::yarn_shear(lab::box_gradient(tracks, b, f), call.number("warp") * M_PI / 180);
      shear.push_back(s.E12);
      warp.push_back(s.warp_stretch);
      weft.push_back(s.weft_stretch);
    }
  push_record(call.L(), "frames", static_cast<double>(tracks.frames), "boxes",
              static_cast<double>(tracks.boxes()), "along", strains.along, "across", strains.across, "E12",
              shear, "warp_stretch", warp, "weft_stretch", weft);
  const auto zones = lab::bias_zones(lab::shear_ratios(shear, tracks.boxes()));
  put(call.L(), "zones", std::vector<double>{zones.begin(), zones.end()});
  return 1;
}

int ratio(Call& call) {
  const auto ratio = lab::contraction_ratio(read_tracks(call), call.has("noise") ? call.number("noise") : -1,
                                            call.number("least"));
  return push_record(call.L(), "value", ratio.value, "plain", ratio.plain, "noise", ratio.noise,
                     "uncertainty", ratio.uncertainty);
}

Argument list(const char* name, const char* unit, const char* sentence) {
  return argument_(name, numbers, unit, everything, sentence);
}

std::vector<Entry> pull_entries() {
  return {
      {"fabric.lab.reduce{}",
       {list("displacement", "m", "of the crosshead"), list("force", "N", "of one length with it"),
        number_("gauge_length", "m", positive, "between the grips").usually(1e-3, 2, "is it in m?"),
        number_("width", "m", positive, "of the specimen").usually(1e-3, 2, "is it in m?"),
        number_("thickness", "m", positive, "of one ply").usually(1e-5, 2e-2, "is it in m?"),
        integer_("plies", from_one, "layers that bear load: 2 for a sewn loop on two pins"),
        number_("compliance", "m/N", not_negative, "of the frame, elastic").or_else(0.0),
        number_("slip", "m/N", not_negative,
                "in the grips over the largest force so far; it does not come back")
            .or_else(0.0),
        number_("slack", "m", everything, "displacement at first contact").or_else(0.0),
        number_("contact?", "N", positive, "find the slack: where the force rises above this for good")},
       "Stress and strain from displacement and force (eqs. 3.1, 3.2): returns displacement (of the "
       "specimen's end), E, S, slack, area. The specimen's length is gauge_length + slack.",
       "local r = require 'fabric'.lab.reduce{ displacement={0, 0.0762}, force={0, 10}, gauge_length=0.0762, "
       "width=0.0254,\n"
       "  thickness=0.5e-3, plies=2 }\nassert(r.E[2] == 1.5 and math.abs(r.S[2] - 10/(r.area*2)) < 1e-9)",
       reduce},
      {"fabric.lab.branches{}",
       {list("displacement", "m", "of a cyclic test"),
        number_("tolerance", "m", positive, "smallest way back that is a reversal")},
       "Parts of a record between reversals: a list of {kind, first, last}; kind is loading, unloading, "
       "reloading (up to the largest displacement so far) or hold (five rows and more at a reversal).",
       "local b = require 'fabric'.lab.branches{ displacement={0, 2, 1, 3}, tolerance=0.5 }\n"
       "assert(#b == 3 and b[2].kind == 'unloading' and b[3].kind == 'loading')",
       branches},
  };
}

Argument curves_row() { return value_("curves", table, "{ {E=, S=}, ... }, one per specimen"); }

std::vector<Entry> fit_entries() {
  return {
      {"fabric.lab.backbone{}",
       {curves_row(), list("degrees?", "", "of the stress polynomials to try; default {2, 4}"),
        flag_("find_slack", "the stretch at first contact is fitted too")},
       "Stress polynomials through zero, one per specimen and degree: a list of {degree, criterion, initial, "
       "least, admissible, specimens={ {loading, slack, reach, residual}, ... }}; chosen is the place of the "
       "best, nil if none has a positive tangent.",
       "local E, S = {}, {}\nfor i = 1, 50 do E[i] = i/100; S[i] = 2e6*E[i] + 3e6*E[i]^2 end\n"
       "local f = require 'fabric'.lab.backbone{ curves={ {E=E, S=S} }, degrees={2} }\n"
       "assert(math.abs(f[f.chosen].specimens[1].loading[2] - 6e6) < 1)",
       backbone},
      {"fabric.lab.unloading{}",
       {list("E", "", "strains from the first row after a reversal"), list("S", "Pa", "stresses"),
        value_("rule", text, "first: line through the first points; robust: median slope of more of them")
            .one_of({"first", "robust"})
            .or_else("first"),
        integer_("count", Range{2}, "of first points").or_else(3.0),
        number_("kept", "", Range{0, 1, true, true}, "robust: points above this part of the first stress")
            .or_else(0.7)},
       "The unloading modulus in Pa; nothing when there are too few points.",
       "assert(math.abs(require 'fabric'.lab.unloading{ E={0.3, 0.2, 0.1}, S={3, 2, 1} } - 10) < 1e-9)",
       unloading},
      {"fabric.lab.student()",
       {number_("probability", "", Range{0, 1, true, true}, "of values below it"),
        number_("freedom", "", positive, "degrees of freedom")},
       "The quantile of Student's t distribution.",
       "assert(math.abs(require 'fabric'.lab.student(0.975, 4) - 2.7764) < 1e-4)",
       student},
      {"fabric.lab.normal()",
       {number_("probability", "", Range{0, 1, true, true}, "of values below it")},
       "The quantile of the normal distribution with mean 0 and deviation 1.",
       "assert(math.abs(require 'fabric'.lab.normal(0.975) - 1.96) < 1e-4)",
       normal},
      {"fabric.lab.band{}",
       {value_("specimens", table, "one list of parameters per specimen"),
        number_("level", "", Range{0, 1, true, true}, "of confidence").or_else(0.95),
        integer_("draws", Range{100, 1e6}, "of the bootstrap").or_else(2000.0),
        integer_("seed", not_negative, "of the bootstrap").or_else(1.0),
        list("common?", "", "relative standard uncertainties that all specimens share, one per parameter")},
       "Mean parameters and their confidence band by the bootstrap over specimens: value, low, high, "
       "covariance (row by row). The last three are nil for one specimen.",
       "local b = require 'fabric'.lab.band{ specimens={ {1}, {2}, {3} } }\nassert(b.value[1] == 2 and "
       "b.low[1] < 1)",
       band},
  };
}

std::vector<Argument> with(std::vector<Argument> rows, std::initializer_list<Argument> more) {
  rows.insert(rows.end(), more);
  return rows;
}

std::vector<Entry> kernels() {
  return {
      kernel("marks{}",
             {list("E", "", ""), list("S", "Pa", ""),
              number_("kept", "", Range{0, 1, true, true}, "").or_else(0.8)},
             marks),
      kernel("averaged{}",
             {curves_row(), list("degrees?", "", ""), number_("none", "", Range{0, 1}, "").or_else(0.1),
              number_("earliest", "", Range{-0.5, 0}, "").or_else(0.0),
              integer_("strains", Range{5, 1000}, "").or_else(40.0)},
             averaged),
      kernel("monotone{}", {curves_row(), integer_("bins", Range{2, 1000}, "").or_else(20.0)}, monotone),
      kernel("sobol_points()",
             {integer_("count", Range{1, 1e7}, ""),
              integer_("dimensions", Range{1, static_cast<double>(lab::most_dimensions)}, ""),
              integer_("seed", not_negative, "").or_else(1.0)},
             sobol_points),
      kernel("boxes{}", with(track_rows(), {number_("warp", "degrees", everything, "").or_else(90.0)}),
             box_strains),
  };
}

std::vector<Entry> marker_entries() {
  const std::string square = "{ rows=2, columns=2, x={0,1,0,1, 0,0.95,0,0.95}, y={0,0,1,1, 0,0,1.2,1.2}";
  return {
      {"fabric.lab.ratio{}",
       with(track_rows(),
            {number_("noise?", "", not_negative,
                     "of a coordinate (standard deviation); default: from the scatter"),
             number_("least", "", not_negative, "strain along the pull from which on boxes count")
                 .or_else(0.01)}),
       "Contraction ratio of one specimen (eq. 3.3), boxes pooled, corrected for noise in the positions: "
       "value, plain (not corrected), noise, uncertainty (standard, over the boxes).",
       "local r = require 'fabric'.lab.ratio" + square +
           ", noise=0 }\nassert(math.abs(r.value - 0.04875/0.22) < 1e-12)",
       ratio},
  };
}

}  // namespace

void bind_lab(Session& session) {
  install(session, pull_entries());
  install(session, fit_entries());
  install(session, marker_entries());
  install(session, kernels());
}

}  // namespace fabricsh::script
