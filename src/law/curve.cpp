#include "law/curve.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/error.hpp"
#include "law/backbone.hpp"
#include "law/text.hpp"

namespace fabricsh::law {

namespace {

constexpr double slack_in_Du = 1e-9;  // relative tolerance by which D may exceed Du

// The first x in (from, to] where `holds` is true, found by scanning and bisection; NaN if there is none.
double first_where(double from, double to, const std::function<bool(double)>& holds) {
  const double step = (to - from) / 4000;
  for (double low = from; low < to; low += step) {
    double high = std::min(low + step, to);
    if (!holds(high)) continue;
    double outside = low;
    for (int i = 0; i < 200 && high - outside > 1e-15 * high; ++i) {
      const double middle = 0.5 * (outside + high);
      (holds(middle) ? high : outside) = middle;
    }
    return high;
  }
  return std::nan("");
}

// x_c: the smallest x >= x_t where D >= Du or D stops rising. The intervals searched become ever longer.
double guard_from(const std::vector<CurvePiece>& pieces, double Du, double tested) {
  const auto acts = [&](double x) {
    const RawCurve at = raw_curve(pieces, x);
    return at.D >= Du || at.slope <= 0;
  };
  if (acts(tested)) return tested;
  double low = tested;
  for (double high = 2 * tested; high < 1e3; low = high, high *= 2) {
    const double x = first_where(low, high, acts);
    if (!std::isnan(x)) return x;
  }
  return low;
}

// x_c if the curve violates 0 < D <= Du inside the range:
// where D reaches Du, or the last maximum before D falls to 0.
double guard_inside(const std::vector<CurvePiece>& pieces, const Departure& leaves) {
  if (!leaves.too_soft) return leaves.x;
  constexpr int samples = 4000;
  double best = 0, high = leaves.x;
  for (int i = samples; i > 0; --i) {
    const double x = leaves.x * i / samples;
    if (raw_curve(pieces, x).slope >= 0) {
      best = x;
      break;
    }
    high = x;
  }
  for (int i = 0; i < 100 && best > 0; ++i) {
    const double middle = 0.5 * (best + high);
    (raw_curve(pieces, middle).slope >= 0 ? best : high) = middle;
  }
  return best;
}

void check_coefficients(const card::Curve& curve, const CurveSpec& spec) {
  const std::string where = "card '" + spec.card + "': field '" + spec.field + "': ";
  if (curve.coefficients.empty() == curve.points.empty())
    throw Error(where + "expected either polynomial coefficients or points, got " +
                (curve.points.empty() ? "neither" : "both"));
  if (curve.coefficients.size() > max_terms)
    throw Error(where + "expected at most " + std::to_string(max_terms) + " coefficients, got " +
                std::to_string(curve.coefficients.size()));
  for (const double c : curve.coefficients)
    if (!std::isfinite(c)) throw Error(where + "expected finite coefficients, got " + number(c));
}

void check_points(const card::Curve& curve, const CurveSpec& spec) {
  const std::string where = "card '" + spec.card + "': field '" + spec.field + "': ";
  const auto& points = curve.points;
  if (points.size() < 2 || points[0].first != 0 || points[0].second != 0)
    throw Error(where + "expected at least two points, the first (0, 0)");
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto [x, y] = points[i];
    if (std::isfinite(x) && std::isfinite(y) && x > points[i - 1].first && y > points[i - 1].second) continue;
    throw Error(where + "expected strain and stress both rising strictly, got (" + number(x) + ", " +
                pressure(y) + ") as point " + std::to_string(i + 1));
  }
}

// Refuses the card unless 0 < D <= Du and P <= Du x over the tested range.
void refuse(const CurveSpec& spec, const std::vector<CurvePiece>& pieces, const Departure& leaves) {
  if (!leaves.found) return;
  const RawCurve at = raw_curve(pieces, leaves.x);
  const double user = leaves.x / spec.scale;
  const std::string range =
      spec.tested > 0 ? " up to the tested " + spec.strain + " = " + number(spec.tested / spec.scale)
                      : " at zero strain";
  const std::string wanted =
      leaves.too_soft ? "a positive modulus D"
                      : "a modulus D not above unloading (" + pressure(spec.unloading * spec.scale) + ")";
  throw Error("card '" + spec.card + "': field '" + spec.field + "': expected " + wanted + range +
              ", got D = " + pressure(at.D * spec.scale) + " at " + spec.strain + " = " + number(user) +
              " (P/Du = " + number(at.P / spec.unloading / spec.scale) + ")");
}

// End of the range to be checked, in the backbone's argument.
double tested_end(const card::Curve& curve, const CurveSpec& spec) {
  if (curve.points.empty()) return spec.tested > 0 ? spec.tested : spec.assumed;
  const double last = spec.scale * curve.points.back().first;
  return spec.tested > 0 ? std::min(spec.tested, last) : last;
}

}  // namespace

Departure departure(const std::vector<CurvePiece>& pieces, double Du, double end) {
  const auto leaves = [&](double x) {
    const double D = raw_curve(pieces, x).D;
    return !(D > 0) || D > Du * (1 + slack_in_Du);
  };
  const double x = leaves(0) ? 0.0 : first_where(0, end, leaves);
  if (std::isnan(x)) return {end, false, false};
  return {x, true, !(raw_curve(pieces, x).D > 0)};
}

Backbone compile_curve(const card::Curve& curve, const CurveSpec& spec, std::vector<CurvePiece>& pieces) {
  check_coefficients(curve, spec);
  if (!curve.points.empty()) check_points(curve, spec);
  pieces = curve.points.empty() ? polynomial_pieces(curve.coefficients, spec.scale)
                                : pchip_pieces(curve.points, spec.scale);
  Backbone out;
  out.tested = tested_end(curve, spec);
  const Departure leaves = departure(pieces, spec.unloading, out.tested);
  const bool may_leave = (spec.lenient || spec.tested <= 0) && leaves.x > 0;
  if (!may_leave) refuse(spec, pieces, leaves);
  out.limit = leaves.found ? guard_inside(pieces, leaves) : guard_from(pieces, spec.unloading, out.tested);
  if (!curve.points.empty()) out.limit = std::min(out.limit, spec.scale * curve.points.back().first);
  out.piece = pieces.data();
  out.pieces = static_cast<int>(pieces.size());
  out.terms = curve.coefficients.size() > 4 ? max_terms : 4;
  const auto end = backbone_at(out, out.limit);
  out.D_limit = end.D;
  out.P_limit = end.P;
  out.U_limit = end.U;
  out.initial = raw_curve(pieces, 0).D;
  return out;
}

}  // namespace fabricsh::law
