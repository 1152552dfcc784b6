// Shared by the comparison laws, both in rate form [williams2010, eqs. 6.11-6.30] with the corrections of
// share/doc/theory.md, 8:
//   thesis       the modulus at the end of the increment is used for all of it [williams2010, eq. 6.31]
//   incremental  the mean modulus along the straight strain path, with switches inside the step resolved
// S11 += (dE1 + nu21 dE2) A1 / (1 - nn), and S22 likewise, where A is the modulus of the respective rule.
#pragma once
#include <array>
#include <limits>

#include "law/backbone.hpp"
#include "law/bound.hpp"
#include "law/response.hpp"
#include "law/springs.hpp"

namespace fabricsh::law {

inline namespace FABRICSH_ISA {

template <class T>
struct PathMean {
  T mean{0.0};   // int f ds: the mean modulus
  T first{0.0};  // int (1 - s) f ds: for the work
};

inline constexpr double far_away = std::numeric_limits<double>::infinity();

// A path; dx is not zero (a path of zero length gets a tiny step in the relevant direction).
template <class T>
struct Path {
  T x0, dx;
};

template <class T>
struct Stretch {
  T a, length;  // beginning and length of a part in s
};

// The part of the path with low <= x < high.
template <class T>
Stretch<T> stretch(const Path<T>& path, T low, T high) {
  const T u = (low - path.x0) / path.dx, v = (high - path.x0) / path.dx;
  const T a = max(min(min(u, v), T(1.0)), T(0.0));
  const T b = max(min(max(u, v), T(1.0)), T(0.0));
  return {a, b - a};
}

template <class T>
void add_constant(PathMean<T>& sum, const Stretch<T>& part, T f) {
  sum.mean += f * part.length;
  sum.first += f * part.length * (T(1.0) - part.a - T(0.5) * part.length);
}

// Gauss-Legendre with five points: exact for the polynomials of one piece (degree 9).
template <class T, class F>
void add_smooth(PathMean<T>& sum, const Path<T>& path, const Stretch<T>& part, F f) {
  constexpr double at[5] = {0.046910077030668004, 0.23076534494715846, 0.5, 0.76923465505284155,
                            0.95308992296933200};
  constexpr double weight[5] = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                0.23931433524968324, 0.11846344252809454};
  for (int i = 0; i < 5; ++i) {
    const T s = part.a + T(at[i]) * part.length;
    const T share = T(weight[i]) * part.length * f(path.x0 + s * path.dx);
    sum.mean += share;
    sum.first += share * (T(1.0) - s);
  }
}

// Integrates D over the part of the path with x >= from, piece by piece, then the guard.
template <class T>
void add_backbone(PathMean<T>& sum, const Backbone& curve, const Path<T>& path, T from) {
  for (int i = 0; i < curve.pieces; ++i) {
    const CurvePiece& piece = curve.piece[i];
    const double end = i + 1 < curve.pieces ? curve.piece[i + 1].start : curve.limit;
    const T stop = min(T(end), T(curve.limit));
    const auto part = stretch(path, max(from, min(T(piece.start), stop)), max(from, stop));
    add_smooth(sum, path, part, [&](T x) { return horner_at(piece.d, curve.terms, x - T(piece.start)); });
  }
  add_constant(sum, stretch(path, max(from, T(curve.limit)), T(far_away)), T(curve.D_limit));
}

}  // namespace FABRICSH_ISA

// State of the comparison laws.
namespace rate_state {
inline constexpr int E = 0;                      // 5-vector, strain at the last commit
inline constexpr int S = 5;                      // 5-vector, stress at the last commit, Pa
inline constexpr int m1 = 10, m2 = 11;           // largest strains so far, not below 0
inline constexpr int g0 = 12, gp = 13;           // E5*, largest |E5 - E5*| [williams2010, eq. 6.28]
inline constexpr int sg = 14;                    // sign of the shear branch; 0 means +1
inline constexpr int W1 = 15, W2 = 16, W3 = 17;  // work on warp, weft and both kinds of shear, J/m^3
inline constexpr int dissipated = 18;            // J/m^3, work less stored energy
inline constexpr int created = 19;               // J/m^3, sum of the decreases of `dissipated`
inline constexpr int count = 20;
}  // namespace rate_state

struct RateKind {
  static constexpr int numbers = rate_state::count;
  static constexpr bool symmetric = false;
  static constexpr int stored_stress = rate_state::S;
  static Bound bound(const WovenData& w) {
    const double D1 = w.axis[0].unloading, D2 = w.axis[1].unloading;
    const double nu12 = w.axis[0].poisson, nu21 = w.axis[1].poisson;
    // The coupling of [williams2010, eq. 6.24] adds to Du_max / (1 - nn); the eigenvalue includes it.
    return {larger_eigenvalue(D1, nu21 * D1, nu12 * D2, D2) / (1.0 - nu12 * nu21), w.shear.unloading, 0};
  }
};

inline namespace FABRICSH_ISA {

inline constexpr double standing = 1e-300;  // the step used for a path of zero length
inline constexpr double creeping = 1e-9;    // below this step a difference quotient is not used

// The modulus of an increment: its mean, int (1 - s) f ds for the work, and d mean / d(end strain).
template <class T>
struct StepModulus {
  T mean, first, rate;
};

// Axial modulus of one yarn that has been stretched to m [williams2010, 6.3.1]: D(0) in compression; Du
// below 0.999 lambda_max; from there to lambda_max linear in lambda from Du to D(m); then virgin D(E).
template <class T>
struct YarnModulus {
  T m, D0, Du, Dm;
  T lambda_b, lambda_m, E_b;

  YarnModulus(const AxisData& axis, T m0)
      : m(m0), D0(axis.curve.initial), Du(axis.unloading), Dm(backbone_slope(axis.curve, m0).D) {
    lambda_m = sqrt(T(1.0) + T(2.0) * m);
    lambda_b = T(0.999) * lambda_m;
    E_b = T(0.5) * (lambda_b * lambda_b - T(1.0));
  }
  T band_slope() const { return (Dm - Du) / (lambda_m - lambda_b); }
  T stretch_of(T E) const { return sqrt(T(1.0) + T(2.0) * max(E, T(0.0))); }
  T band(T E) const { return Du + band_slope() * (stretch_of(E) - lambda_b); }

  BackboneSlope<T> at(const AxisData& axis, T E) const {
    const auto top = backbone_slope(axis.curve, max(E, m));
    const auto in_band = E >= E_b;
    BackboneSlope<T> out{select(in_band, band(E), Du), select(in_band, band_slope() / stretch_of(E), T(0.0))};
    out = {select(E >= m, top.D, out.D), select(E >= m, top.slope, out.slope)};
    return {select(E < T(0.0), D0, out.D), select(E < T(0.0), T(0.0), out.slope)};
  }
  PathMean<T> along(const AxisData& axis, const Path<T>& path) const {
    const T low = max(E_b, T(0.0));
    PathMean<T> sum;
    add_constant(sum, stretch(path, T(-far_away), T(0.0)), D0);
    add_constant(sum, stretch(path, T(0.0), low), Du);
    add_smooth(sum, path, stretch(path, low, m), [this](T E) { return band(E); });
    add_backbone(sum, axis.curve, path, m);
    return sum;
  }
};

// d mean / d end from the value at the end; half the slope if the step is too small for a quotient.
template <class T>
T mean_rate(T end, T mean, T slope, T step) {
  const auto small = abs(step) < T(creeping);
  return select(small, T(0.5) * slope, (end - mean) / select(small, T(1.0), step));
}

template <class T>
T moving(T step, AtSwitch at) {
  const T still(at == AtSwitch::loading ? standing : -standing);
  return select(abs(step) < T(standing), still, step);
}

template <bool exact, class T>
StepModulus<T> yarn_step(const AxisData& axis, AtSwitch at, T E0, T E, T m) {
  const YarnModulus<T> law(axis, m);
  const T dE = E - E0;
  const auto end = law.at(axis, E);
  StepModulus<T> out{end.D, T(0.5) * end.D, end.slope};
  if constexpr (exact) {
    const auto path = law.along(axis, Path<T>{E0, moving(dE, at)});
    out = {path.mean, path.first, mean_rate(end.D, path.mean, end.slope, dE)};
  }
  if (at == AtSwitch::unloading) {  // after a reversal; the transition is 0.1 % of a stretch wide
    const auto turning = (dE == T(0.0)) & (E >= m) & (m > T(0.0));
    out = {select(turning, T(axis.unloading), out.mean), out.first, select(turning, T(0.0), out.rate)};
  }
  return out;
}

// In-plane shear over an increment: stress, slope, and the modulus for transverse shear that follows it.
template <class T>
struct ShearIncrement {
  T S, C;
  StepModulus<T> modulus;
};

// G at the distance r on the branch at the beginning of the step: virgin
// above its peak, Gu down to zero stress, then the reverse branch.
template <class T>
PathMean<T> shear_along(const ShearData& shear, const Path<T>& path, T peak, T zero) {
  PathMean<T> sum;
  add_backbone(sum, shear.curve, path, peak);
  add_constant(sum, stretch(path, zero, peak), T(shear.unloading));
  add_backbone(sum, shear.curve, Path<T>{zero - path.x0, -path.dx}, T(0.0));
  return sum;
}

// The closed form of the shear spring, and the path from gamma0.
template <class T>
ShearIncrement<T> shear_exact(const ShearData& shear, AtSwitch at, T gamma0, T gamma, ShearState<T>& s) {
  s.sign = select(s.sign < T(0.0), T(-1.0), T(1.0));
  const T peak = s.peak, dgamma = gamma - gamma0;
  const T zero = peak - backbone_at(shear.curve, peak).P / T(shear.unloading);
  const Path<T> path{s.sign * (gamma0 - s.origin), moving(s.sign * dgamma, at)};
  const auto sum = shear_along(shear, path, peak, zero);
  const auto end = shear_spring(shear, at, gamma, s);
  const T r = s.sign * (gamma - s.origin);
  const T slope = select(r >= s.peak, s.sign * backbone_slope(shear.curve, s.peak).slope, T(0.0));
  return {end.S, end.C, {sum.mean, sum.first, mean_rate(end.C, sum.mean, slope, dgamma)}};
}

// Without hysteresis: S12 = sign P(|gamma|).
template <class T>
ShearIncrement<T> shear_elastic(const ShearData& shear, AtSwitch at, T gamma0, T gamma) {
  const T sign = select(gamma < T(0.0), T(-1.0), T(1.0));
  const auto curve = backbone_at(shear.curve, abs(gamma));
  const T slope = sign * backbone_slope(shear.curve, abs(gamma)).slope;
  const Path<T> path{gamma0, moving(gamma - gamma0, at)};
  const auto sum = shear_along(shear, path, T(0.0), T(0.0));
  return {
      sign * curve.P, curve.D, {sum.mean, sum.first, mean_rate(curve.D, sum.mean, slope, gamma - gamma0)}};
}

// [williams2010, 6.3.3 and 6.4]: loading if S dE >= 0, and virgin if also |E5 - E5*|
// >= its peak. E5* is set at the end of the step in which the stress changed its sign.
template <class T>
ShearIncrement<T> shear_endpoint(const ShearData& shear, AtSwitch at, T gamma0, T gamma, T S0,
                                 ShearState<T>& s) {
  const T dgamma = gamma - gamma0, way = gamma - s.origin;
  const auto curve = backbone_slope(shear.curve, abs(way));
  auto is_virgin = (S0 * dgamma >= T(0.0)) & (abs(way) >= s.peak);
  if (at == AtSwitch::unloading) is_virgin = is_virgin & !((dgamma == T(0.0)) & (s.peak > T(0.0)));
  if (!shear.hysteresis) is_virgin = is_virgin | (s.peak >= T(0.0));
  const T G = select(is_virgin, curve.D, T(shear.unloading));
  const T sign = select(way < T(0.0), T(-1.0), T(1.0));
  const T rate = select(is_virgin, sign * curve.slope, T(0.0));
  const T S = S0 + G * dgamma;
  if (shear.hysteresis) {
    const auto crossed = S0 * S < T(0.0);
    s.peak = select(crossed, T(0.0), select(is_virgin, max(s.peak, abs(way)), s.peak));
    s.origin = select(crossed, gamma, s.origin);
  }
  return {S, G + rate * dgamma, {G, T(0.5) * G, rate}};
}

template <bool exact, class T>
ShearIncrement<T> shear_step(const ShearData& shear, AtSwitch at, const T* s0, T gamma, T* s1) {
  using namespace rate_state;
  ShearState<T> s{s0[g0], s0[gp], s0[sg], T(0.0), T(0.0)};
  const T gamma0 = s0[rate_state::E + 4], S0 = s0[rate_state::S + 4];
  ShearIncrement<T> out;
  if constexpr (exact)
    out =
        shear.hysteresis ? shear_exact(shear, at, gamma0, gamma, s) : shear_elastic(shear, at, gamma0, gamma);
  else
    out = shear_endpoint(shear, at, gamma0, gamma, S0, s);
  s1[g0] = s.origin;
  s1[gp] = s.peak;
  s1[sg] = s.sign;
  return out;
}

// Work on one component over the step, dE (S0 + dE
// first); `reach` replaces the dE in dS = reach mean.
template <class T>
T step_work(T dE, T S0, T reach, T first) {
  return dE * (S0 + reach * first);
}

// Axial stresses of both yarns [williams2010, eqs. 6.11, 6.24].
template <bool exact, class T>
void axial_rates(const WovenData& law, AtSwitch at, const T E[5], const T* s0, T* s1, Response<T>& out) {
  using namespace rate_state;
  const T nu12(law.axis[0].poisson), nu21(law.axis[1].poisson);
  const T factor = T(1.0) / (T(1.0) - nu12 * nu21);
  const T d1 = E[0] - s0[0], d2 = E[1] - s0[1];
  const auto warp = yarn_step<exact>(law.axis[0], at, s0[0], E[0], s0[m1]);
  const auto weft = yarn_step<exact>(law.axis[1], at, s0[1], E[1], s0[m2]);
  const T reach1 = factor * (d1 + nu21 * d2), reach2 = factor * (d2 + nu12 * d1);
  out.S[0] = s0[S] + reach1 * warp.mean;
  out.S[1] = s0[S + 1] + reach2 * weft.mean;
  out.C11 = factor * warp.mean + warp.rate * reach1;
  out.C12 = factor * nu21 * warp.mean;
  out.C22 = factor * weft.mean + weft.rate * reach2;
  out.C21 = factor * nu12 * weft.mean;
  s1[m1] = max(E[0], s0[m1]);
  s1[m2] = max(E[1], s0[m2]);
  s1[W1] = s0[W1] + step_work(d1, s0[S], reach1, warp.first);
  s1[W2] = s0[W2] + step_work(d2, s0[S + 1], reach2, weft.first);
}

// Transverse shear: elastic, or 5/6 of the switching in-plane modulus [williams2010, eq. 6.30].
template <class T>
void transverse_rates(const WovenData& law, const T E[5], const T* s0, T* s1, const StepModulus<T>& G,
                      Response<T>& out) {
  using namespace rate_state;
  const T share(5.0 / 6.0), d3 = E[2] - s0[2], d4 = E[3] - s0[3];
  transverse_elastic(T(law.transverse), T(law.transverse), E, out);
  T mean(law.transverse), first(0.5 * law.transverse);
  if (law.follow) {
    mean = share * G.mean;
    first = share * G.first;
    out.S[2] = s0[S + 2] + mean * d3;
    out.S[3] = s0[S + 3] + mean * d4;
    out.C33 = out.C44 = mean;
    out.C35 = share * G.rate * d3;
    out.C45 = share * G.rate * d4;
  }
  s1[W3] = s0[W3] + step_work(d3, s0[S + 2], d3, first) + step_work(d4, s0[S + 3], d4, first);
}

// Stored energy by the convention of share/doc/law.md, S11^2 / (2 Du1)
// + S22^2 / (2 Du2) + S12^2 / (2 Gu) + transverse, and its parts.
template <class T>
struct RateStored {
  T warp, weft, shear;
};

template <class T>
RateStored<T> rate_stored(const WovenData& law, const T* stress) {
  const T half(0.5);
  const double Gt = law.follow ? 5.0 / 6.0 * law.shear.unloading : law.transverse;
  return {half * stress[0] * stress[0] / T(law.axis[0].unloading),
          half * stress[1] * stress[1] / T(law.axis[1].unloading),
          half * stress[4] * stress[4] / T(law.shear.unloading) +
              half * (stress[2] * stress[2] + stress[3] * stress[3]) / T(Gt)};
}

template <bool exact, class T>
Response<T> rate_update(const WovenData& law, AtSwitch at, const T E[5], const T* s0, T* s1) {
  using namespace rate_state;
  Response<T> out;
  axial_rates<exact>(law, at, E, s0, s1, out);
  const auto shear = shear_step<exact>(law.shear, at, s0, E[4], s1);
  transverse_rates(law, E, s0, s1, shear.modulus, out);
  out.S[4] = shear.S;
  out.C55 = shear.C;
  const T dgamma = E[4] - s0[4];
  s1[W3] += step_work(dgamma, s0[S + 4], dgamma, shear.modulus.first);
  for (int i = 0; i < 5; ++i) {
    s1[rate_state::E + i] = E[i];
    s1[S + i] = out.S[i];
  }
  const auto stored = rate_stored(law, out.S);
  s1[dissipated] = s1[W1] + s1[W2] + s1[W3] - stored.warp - stored.weft - stored.shear;
  s1[created] = s0[created] + max(s0[dissipated] - s1[dissipated], T(0.0));
  return out;
}

// Common parts of both laws, by the names that the room expects of a law.
namespace rate {

// These laws record the work; the part that is not stored counts as dissipated.
template <class T>
EnergyOf<T> energy(const WovenData& w, const T*, const T* s) {
  using namespace rate_state;
  const auto stored = rate_stored(w, s + S);
  EnergyOf<T> out(stored.warp + stored.weft + stored.shear);
  out.dissipated[0] = s[W1] - stored.warp;
  out.dissipated[1] = s[W2] - stored.weft;
  out.dissipated[2] = s[W3] - stored.shear;
  out.created = s[rate_state::created];
  return out;
}

inline Internal internal(const WovenData& w, const double E[5], const double* s) {
  using namespace rate_state;
  const auto yarn = [](double x, double m) {
    return x >= m - switch_width ? LoadBranch::virgin : x < 0 ? LoadBranch::slack : LoadBranch::unloading;
  };
  Internal out;
  out.residual1 = s[m1] - backbone_at(w.axis[0].curve, s[m1]).P * w.axis[0].softness;
  out.residual2 = s[m2] - backbone_at(w.axis[1].curve, s[m2]).P * w.axis[1].softness;
  out.slack1 = max(-E[0], 0.0);
  out.slack2 = max(-E[1], 0.0);
  out.warp = yarn(E[0], s[m1]);
  out.weft = yarn(E[1], s[m2]);
  const bool virgin = !w.shear.hysteresis || abs(E[4] - s[g0]) >= s[gp] - switch_width;
  out.shear = virgin ? LoadBranch::virgin : LoadBranch::unloading;
  return out;
}

template <class Entry>
auto peaks(Entry s) {
  return std::array{s(rate_state::E), s(rate_state::E + 1), abs(s(rate_state::E + 4))};
}

}  // namespace rate

}  // namespace FABRICSH_ISA

}  // namespace fabricsh::law
