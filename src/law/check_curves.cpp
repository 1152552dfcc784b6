// Moduli over the tested range, range guards, jumps at reversal, continuity at the switches.
#include <algorithm>
#include <cmath>

#include "law/check_parts.hpp"
#include "law/potential.hpp"
#include "law/text.hpp"

namespace fabricsh::law {

namespace {

struct SpringCurve {
  const char* name;
  const char* strain;
  const Backbone* curve;
  double unloading;  // the first modulus after a reversal
  double secant;     // from the peak to zero stress; the same unless the yarn has a loop
  double scale;      // argument of the backbone = scale * the user's strain
  double stated;     // tested strain on the card, in the user's measure
};

// Smallest and largest D up to the end of the tested range, and their strains.
struct Extremes {
  double low, low_at, high, high_at;
};

Extremes extremes(const Backbone& curve, double end) {
  Extremes out{1e300, 0, -1e300, 0};
  constexpr int samples = 2000;
  for (int i = 0; i <= samples; ++i) {
    const double x = end * i / samples, D = backbone_slope(curve, x).D;
    if (D < out.low) out.low = D, out.low_at = x;
    if (D > out.high) out.high = D, out.high_at = x;
  }
  return out;
}

void modulus_item(const SpringCurve& s, CheckReport& report) {
  const auto e = extremes(*s.curve, s.curve->tested);
  const auto shown = [&](double x) { return std::string(s.strain) + " = " + number(x / s.scale); };
  report.items.push_back({std::string("modulus.") + s.name,
                          Severity::note,
                          "D from " + pressure(e.low * s.scale) + " (" + shown(e.low_at) + ") to " +
                              pressure(e.high * s.scale) + " (" + shown(e.high_at) +
                              "), positive over the tested range to " + shown(s.curve->tested),
                          {{"least", e.low * s.scale},
                           {"least_at", e.low_at / s.scale},
                           {"most", e.high * s.scale},
                           {"most_at", e.high_at / s.scale},
                           {"initial", s.curve->initial * s.scale},
                           {"tested", s.curve->tested / s.scale}}});
}

void guard_item(const SpringCurve& s, CheckReport& report) {
  const double at = s.curve->limit / s.scale, tested = s.curve->tested / s.scale;
  const bool inside = s.curve->limit < s.curve->tested * (1 - 1e-12);
  std::string text = std::string("range guard from ") + s.strain + " = " + number(at) + " on: D stays " +
                     pressure(s.curve->D_limit * s.scale);
  if (inside) text += "; that is INSIDE the tested range (" + number(tested) + ")";
  if (s.stated <= 0) text += "; no tested strain is stated, " + number(tested) + " is taken";
  const bool loud = inside || s.stated <= 0;
  report.items.push_back({std::string("guard.") + s.name,
                          loud ? Severity::warning : Severity::note,
                          text,
                          {{"strain", at}, {"tested", tested}, {"modulus", s.curve->D_limit * s.scale}}});
}

void jump_item(const SpringCurve& s, CheckReport& report) {
  const double D = backbone_slope(*s.curve, s.curve->tested).D;
  const double ratio = s.unloading / D, first = s.unloading / s.curve->initial;
  report.items.push_back({std::string("jump.") + s.name,
                          Severity::note,
                          "at a reversal the stiffness jumps by " + number(ratio) +
                              " at the end of the tested range, by " + number(first) + " near zero strain",
                          {{"at_tested", ratio}, {"at_zero", first}}});
}

// The slopes of a curved loop, and what a whole one (to zero stress and back) loses of the way down.
void loop_item(const SpringCurve& s, const LoopData& loop, CheckReport& report) {
  double lost = 0;
  for (int j = 0; j < loop_strands; ++j) lost += loop.stiffness[j] * loop.reach[j] * (1 - loop.reach[j]);
  report.items.push_back(
      {std::string("loop.") + s.name,
       Severity::note,
       "unloads along a curve, from " + pressure(s.unloading) + " at the peak to " +
           pressure(s.secant * loop.flattest) + " before zero stress; a loop to zero stress and back loses " +
           percent(lost / loop.stored) + " of what the way down gives",
       {{"first", s.unloading}, {"last", s.secant * loop.flattest}, {"lost", lost / loop.stored}}});
}

// Jump of S at x. The comparison laws are rate laws, so they are first taken to x.
double stress_jump(const Law& law, const double* state, int component, double x) {
  double at[5] = {}, low[5] = {}, high[5] = {}, Sl[5], Sh[5], here[most_states] = {}, scratch[most_states];
  const double gap = 1e-12 * (1 + std::fabs(x));
  at[component] = x;
  low[component] = x - gap;
  high[component] = x + gap;
  std::copy(state, state + law.state_size, here);
  if (law.kind != CompiledKind::potential) evaluate(law, Step{}, at, state, here, Sl, nullptr);
  evaluate(law, Step{}, low, here, scratch, Sl, nullptr);
  evaluate(law, Step{}, high, here, scratch, Sh, nullptr);
  return std::fabs(Sh[component] - Sl[component]);
}

}  // namespace

void check_curves(const card::Woven& woven, const Law& law, CheckReport& report) {
  const WovenData& w = law.woven;
  const bool tensor = woven.shear.measure == card::StrainMeasure::tensor;
  const SpringCurve springs[] = {{"warp", "E11", &w.axis[0].curve, w.axis[0].unloading * w.loop[0].steepest,
                                  w.axis[0].unloading, 1, woven.tested.warp},
                                 {"weft", "E22", &w.axis[1].curve, w.axis[1].unloading * w.loop[1].steepest,
                                  w.axis[1].unloading, 1, woven.tested.weft},
                                 {"shear", tensor ? "E12" : "2E12", &w.shear.curve, w.shear.unloading,
                                  w.shear.unloading, tensor ? 2.0 : 1.0, woven.tested.shear}};
  for (const auto& s : springs) modulus_item(s, report);
  for (const auto& s : springs) guard_item(s, report);
  for (const auto& s : springs) jump_item(s, report);
  for (int i = 0; i < 2; ++i)
    if (w.loop[i].on) loop_item(springs[i], w.loop[i], report);
}

void check_continuity(const Law& law, CheckReport& report) {
  double worst = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int component = axis == 2 ? 4 : axis;
    const Backbone& curve = axis == 2 ? law.woven.shear.curve : law.woven.axis[axis].curve;
    const double Du = axis == 2 ? law.woven.shear.unloading : law.woven.axis[axis].unloading;
    for (const double fraction : {0.1, 0.5, 1.0, 2.0}) {
      double E[5] = {}, virgin[most_states] = {}, state[most_states] = {}, S[5];
      E[component] = fraction * curve.tested;
      evaluate(law, Step{}, E, virgin, state, S, nullptr);
      const double residual = E[component] - backbone_at(curve, E[component]).P / Du;
      for (const double x : {E[component], residual, 0.0})
        worst = std::max(worst, stress_jump(law, state, component, x) / (Du * curve.tested));
    }
  }
  const bool fine = worst < 1e-8;
  report.items.push_back({"continuity",
                          fine ? Severity::note : Severity::error,
                          std::string("stress is ") + (fine ? "" : "NOT ") +
                              "continuous at every switch (largest jump " + number(worst) +
                              " of Du x tested strain)",
                          {{"jump", worst}}});
}

}  // namespace fabricsh::law
