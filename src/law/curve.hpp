// Compiles the loading curve of a card, a polynomial or points, to a backbone with its range guard.
#pragma once
#include <string>
#include <vector>

#include "law/data.hpp"

namespace fabricsh::law {

// Specification of a curve. Strains are the backbone's own argument: E for a yarn, gamma for shear.
struct CurveSpec {
  std::string card, field;  // for messages: card name, "warp.loading"
  std::string strain;       // the user's name of the argument: "E11", "E12", "2E12"
  double scale = 1;         // argument = scale * the user's strain (2 for tensor shear)
  double unloading = 0;     // Du in the backbone's argument, Pa
  double tested = 0;        // x_t in the backbone's argument; 0: not stated
  double assumed = 0.3;     // x_t if it is not stated
  bool lenient = false;     // the guard may lie inside the tested range (shear measure "engineering")
};

// Pieces of a polynomial or of points. A user's strain e becomes scale * e, a modulus D becomes D / scale.
std::vector<CurvePiece> polynomial_pieces(const std::vector<double>& coefficients, double scale);

// Monotone piecewise cubic interpolation of (0, 0) and the
// points [Fritsch and Carlson 1980, Fritsch and Butland 1984].
std::vector<CurvePiece> pchip_pieces(const std::vector<std::pair<double, double>>& points, double scale);

// The backbone with its guard on `pieces`, which must outlive it. Throws Error if the curve is refused.
Backbone compile_curve(const card::Curve& curve, const CurveSpec& spec, std::vector<CurvePiece>& pieces);

// D, D' and P of the pieces at x >= 0, without the guard.
struct RawCurve {
  double D, slope, P;
};
RawCurve raw_curve(const std::vector<CurvePiece>& pieces, double x);

// The first x in (0, end] where D <= 0 or D > Du; without one x = end and found = false.
struct Departure {
  double x;
  bool found;
  bool too_soft;  // D <= 0; otherwise D > Du
};
Departure departure(const std::vector<CurvePiece>& pieces, double Du, double end);

}  // namespace fabricsh::law
