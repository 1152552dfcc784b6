// Positive definiteness, the criterion violated by the thesis' law, bending, and the explicit step.
#include <algorithm>
#include <cmath>
#include <limits>

#include "law/backbone.hpp"
#include "law/check_parts.hpp"
#include "law/text.hpp"

namespace fabricsh::law {

namespace {

// Smaller eigenvalue of the symmetric part of [[a, b], [c, d]].
double least_eigenvalue(double a, double b, double c, double d) {
  const double half = 0.5 * (a - d), off = 0.5 * (b + c);
  return 0.5 * (a + d) - std::sqrt(half * half + off * off);
}

struct Least {
  double ratio = std::numeric_limits<double>::infinity();  // least eigenvalue over the larger diagonal entry
  double E11 = 0, E22 = 0, m1 = 0, m2 = 0;
};

// Evaluates the tangent at one strain, after a history that stretched the yarns to m1 and m2.
void look(const Law& law, double m1, double m2, double E11, double E22, Least& least) {
  double virgin[most_states] = {}, state[most_states] = {}, trial[most_states], S[5], C[25];
  const double peak[5] = {m1, m2, 0, 0, 0}, E[5] = {E11, E22, 0, 0, 0};
  evaluate(law, Step{}, peak, virgin, state, S, nullptr);
  // The tangent at the strain itself is needed: for the comparison laws that of a step which ends there.
  evaluate(law, Step{}, E, state, trial, S, nullptr);
  double again[most_states];
  evaluate(law, Step{}, E, trial, again, S, C);
  const double ratio = least_eigenvalue(C[0], C[1], C[5], C[6]) / std::max(C[0], C[6]);
  if (ratio < least.ratio) least = {ratio, E11, E22, m1, m2};
}

// Strains on every branch of one axis after a stretch to m: slack, at the residual strain, unloading, virgin.
std::vector<double> probes(const AxisData& axis, double m) {
  const double residual = m - backbone_at(axis.curve, m).P / axis.unloading;
  const double top = 2 * axis.curve.tested;
  return {-0.1, 0.5 * residual, residual, 0.5 * (residual + m), m, 0.5 * (m + top), top};
}

Least scan_definite(const Law& law) {
  Least least;
  const auto &warp = law.woven.axis[0], &weft = law.woven.axis[1];
  for (const double a : {0.0, 0.01, 0.1, 0.3, 0.6, 1.0, 1.5})
    for (const double b : {0.0, 0.01, 0.1, 0.3, 0.6, 1.0, 1.5}) {
      const double m1 = a * warp.curve.tested, m2 = b * weft.curve.tested;
      for (const double E11 : probes(warp, m1))
        for (const double E22 : probes(weft, m2)) look(law, m1, m2, E11, E22, least);
    }
  return least;
}

void definite_item(const Law& law, const Least& least, CheckReport& report) {
  const bool fine = least.ratio > 0;
  const std::string where = "E11 = " + number(least.E11) + ", E22 = " + number(least.E22) + " after " +
                            number(least.m1) + ", " + number(least.m2);
  const std::string value = "least eigenvalue of the symmetric part " + percent(least.ratio) +
                            " of the larger diagonal entry, at " + where;
  const Severity bad = law.kind == CompiledKind::potential ? Severity::error : Severity::warning;
  report.items.push_back(
      {"definite",
       fine ? Severity::note : bad,
       (fine ? "tangent positive definite on every branch scanned: "
             : "tangent NOT positive definite, Newton may find no solution: ") +
           value,
       {{"least", least.ratio}, {"E11", least.E11}, {"E22", least.E22}, {"m1", least.m1}, {"m2", least.m2}}});
}

double branch_modulus(const AxisData& axis, LoadBranch branch, double E) {
  if (branch == LoadBranch::slack) return axis.curve.initial;
  return branch == LoadBranch::unloading ? axis.unloading : backbone_slope(axis.curve, E).D;
}

// One path and pair of branches: strain along warp and weft as functions of the strain along the pull.
struct Scan {
  std::string path;
  LoadBranch warp, weft;
  double along_warp, along_weft, end;
};

double first_violation(const WovenData& w, const Scan& scan) {
  const double nu12 = w.axis[0].poisson, nu21 = w.axis[1].poisson;
  const auto violated = [&](double e) {
    const double D1 = branch_modulus(w.axis[0], scan.warp, std::max(scan.along_warp * e, 0.0));
    const double D2 = branch_modulus(w.axis[1], scan.weft, std::max(scan.along_weft * e, 0.0));
    const double cross = nu21 * D1 + nu12 * D2;
    return 4 * D1 * D2 < cross * cross;
  };
  if (violated(0)) return 0;
  constexpr int samples = 4000;
  for (int i = 1; i <= samples; ++i) {
    double high = scan.end * i / samples, low = scan.end * (i - 1) / samples;
    if (!violated(high)) continue;
    for (int k = 0; k < 60; ++k) (violated(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    return high;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::string pair_name(const CriterionRow& row) {
  return row.path + " " + name(row.warp) + "/" + name(row.weft);
}

}  // namespace

std::vector<CriterionRow> criterion_table(const card::Woven&, const Law& law) {
  const WovenData& w = law.woven;
  const double e1 = w.axis[0].curve.tested, e2 = w.axis[1].curve.tested, both = std::min(e1, e2);
  using B = LoadBranch;
  const Scan scans[] = {
      {"warp", B::virgin, B::slack, 1, 0, e1},          {"warp", B::unloading, B::slack, 1, 0, e1},
      {"weft", B::slack, B::virgin, 0, 1, e2},          {"weft", B::slack, B::unloading, 0, 1, e2},
      {"biaxial", B::virgin, B::virgin, 1, 1, both},    {"biaxial", B::unloading, B::virgin, 1, 1, both},
      {"biaxial", B::virgin, B::unloading, 1, 1, both}, {"biaxial", B::unloading, B::unloading, 1, 1, both}};
  std::vector<CriterionRow> rows;
  for (const auto& scan : scans)
    rows.push_back({scan.path, scan.warp, scan.weft, first_violation(w, scan), scan.end});
  return rows;
}

void check_criterion(const card::Woven& woven, const Law& law, CheckReport& report) {
  CheckItem item{"criterion", Severity::note, "", {}};
  std::string broken;
  for (const auto& row : criterion_table(woven, law)) {
    item.numbers.emplace_back(pair_name(row), row.first);
    if (std::isnan(row.first)) continue;
    broken += (broken.empty() ? "" : "; ") + pair_name(row) +
              (row.first == 0 ? " from the start" : " from " + number(row.first));
  }
  const bool concerned = law.kind != CompiledKind::potential;
  item.text =
      broken.empty()
          ? "the printed law keeps 4 D1 D2 >= (nu21 D1 + nu12 D2)^2 on every branch pair"
          : "4 D1 D2 < (nu21 D1 + nu12 D2)^2 breaks the printed law (path warp branch/weft branch): " +
                broken + (concerned ? "" : "; the law of this card (potential) does not need this condition");
  if (concerned && !broken.empty()) item.severity = Severity::warning;
  report.items.push_back(item);
}

void check_definite(const Law& law, CheckReport& report) {
  if (law.kind == CompiledKind::elastic) {
    const auto& e = law.elastic;
    const double ratio = least_eigenvalue(e.C11, e.C12, e.C12, e.C22) / std::max(e.C11, e.C22);
    report.items.push_back(
        {"definite",
         ratio > 0 ? Severity::note : Severity::error,
         "least eigenvalue of the tangent " + percent(ratio) + " of the larger diagonal entry",
         {{"least", ratio}}});
    return;
  }
  definite_item(law, scan_definite(law), report);
}

void check_bending(const card::Card& card, const Law& law, CheckReport& report) {
  // N.m. Warns outside of low to high; of 618 measured cloths [feng2022] nine in ten lie within the usual
  // ones.
  constexpr double low = 1e-6, high = 1e-4, usual_low = 1e-6, usual_high = 70e-6;
  const double third = card.thickness * card.thickness * card.thickness / 12;
  const char* names[] = {"warp", "weft"};
  for (int i = 0; i < 2; ++i) {
    const bool own = card.bending.has_value();
    const double B =
        own ? (i == 0 ? card.bending->warp : card.bending->weft) : backbone_modulus(law, i + 1, 0.0) * third;
    const double stiff = law.kind == CompiledKind::elastic ? B : law.woven.axis[i].unloading * third;
    std::string text = std::string(own ? "the card's own rigidity " : "thickness integration implies ") +
                       number(B * 1e6) + " uN.m";
    if (!own && law.kind != CompiledKind::elastic)
      text += " near zero strain and " + number(stiff * 1e6) + " on unloading";
    text += "; nine measured cloths in ten have " + number(usual_low * 1e6) + " to " +
            number(usual_high * 1e6) + " uN.m";
    const bool odd = (B < low || B > high) && !(card.through_thickness && !own);
    if (odd && !own)
      text += ". Give the card a bending = {warp=, weft=, twist=} of its own where folds matter";
    if (odd && !own)
      text += std::string(", or use ") +
              (card.estimate ? "its estimated bending, fabric.card(name"
                             : "the estimate for its areal mass, fabric.card(card") +
              ", { bending='estimated' })";
    report.items.push_back({std::string("bending.") + names[i],
                            odd ? Severity::warning : Severity::note,
                            text,
                            {{"rigidity", B}, {"unloading", stiff}}});
  }
}

// dt0 = h sqrt(rho / K), K the largest eigenvalue of the stiffest tangent; and the limit that true rotary
// inertia would set, t sqrt(rho / (3 G_t)).
void check_step(const card::Card& card, const Law& law, double element_size, CheckReport& report) {
  const double K = stiffest(law), G = transverse_modulus(law);
  const double dt = element_size * std::sqrt(card.density / K);
  const double rotary = card.thickness * std::sqrt(card.density / (3 * G));
  report.items.push_back(
      {"step",
       Severity::note,
       "largest stable explicit step " + number(dt * 1e6) + " us for elements of " +
           number(element_size * 1e3) + " mm (unscaled rotary inertia would cap it at " +
           number(rotary * 1e6) + " us)",
       {{"step", dt}, {"element_size", element_size}, {"rotary", rotary}, {"stiffest", K}}});
}

}  // namespace fabricsh::law
