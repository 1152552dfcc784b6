// From a card's loading curve to a compiled backbone: polynomial or measured points, range guard, refusals.
#pragma once
#include <string>
#include <vector>

#include "law/data.hpp"

namespace fabricsh::law {

// What a curve is compiled for. Strains are in the backbone's own argument: E on an axis, gamma in shear.
struct CurveSpec {
  std::string card, field;  // for messages: card name, "warp.loading"
  std::string strain;       // what the user calls the argument: "E11", "E12", "2E12"
  double scale = 1;         // argument = scale * the user's strain (2 for tensor shear)
  double unloading = 0;     // Du in the backbone's argument, Pa
  double tested = 0;        // x_t in the backbone's argument; 0: not stated
  double assumed = 0.3;     // x_t when not stated
  bool lenient = false;     // the guard may act inside the tested range (shear measure "engineering")
};

// Pieces of a polynomial or of points. A user's strain e becomes scale * e, a modulus becomes D / scale.
std::vector<Piece> polynomial_pieces(const std::vector<double>& coefficients, double scale);

// Monotone piecewise cubic through (0, 0) and the points [Fritsch and Carlson 1980, Fritsch and Butland
// 1984].
std::vector<Piece> pchip_pieces(const std::vector<std::pair<double, double>>& points, double scale);

// The backbone on `pieces` (which must outlive it), with its guard. Throws Error on a refused curve.
Backbone compile_curve(const card::Curve& curve, const CurveSpec& spec, std::vector<Piece>& pieces);

// Unguarded D, D' and P of the pieces at x >= 0.
struct RawCurve {
  double D, slope, P;
};
RawCurve raw_curve(const std::vector<Piece>& pieces, double x);

// First x in (0, end] where D <= 0 or D > Du; end itself and found = false if there is none.
struct Departure {
  double x;
  bool found;
  bool too_soft;  // D <= 0 (else D > Du)
};
Departure departure(const std::vector<Piece>& pieces, double Du, double end);

}  // namespace fabricsh::law
