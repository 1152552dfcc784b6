#include <algorithm>

#include "law/curve.hpp"

namespace fabricsh::law {

namespace {

// Computes the coefficients of P and U from those of D.
void integrate(CurvePiece& piece) {
  for (int k = 0; k < max_terms; ++k) {
    piece.p[k] = piece.d[k] / (k + 1);
    piece.u[k] = piece.d[k] / ((k + 1) * (k + 2));
  }
}

// P and U of a piece at distance t from its start.
std::pair<double, double> integrals_at(const CurvePiece& piece, double t) {
  double P = 0, U = 0;
  for (int k = max_terms - 1; k >= 0; --k) {
    P = P * t + piece.p[k];
    U = U * t + piece.u[k];
  }
  return {piece.P0 + t * P, piece.U0 + t * (piece.P0 + t * U)};
}

// Three-point estimate of the slope at an end, kept positive and within the monotone range.
double end_slope(double h0, double h1, double s0, double s1) {
  const double slope = ((2 * h0 + h1) * s0 - h0 * s1) / (h0 + h1);
  return std::clamp(slope, 0.1 * s0, 2.9 * s0);
}

// Slopes at the knots: weighted harmonic means of the slopes of the neighbouring secants.
std::vector<double> knot_slopes(const std::vector<double>& h, const std::vector<double>& secant) {
  const std::size_t n = h.size();
  if (n == 1) return {secant[0], secant[0]};
  std::vector<double> slope(n + 1);
  for (std::size_t i = 1; i < n; ++i) {
    const double w1 = 2 * h[i] + h[i - 1], w2 = h[i] + 2 * h[i - 1];
    slope[i] = (w1 + w2) / (w1 / secant[i - 1] + w2 / secant[i]);
  }
  slope[0] = end_slope(h[0], h[1], secant[0], secant[1]);
  slope[n] = end_slope(h[n - 1], h[n - 2], secant[n - 1], secant[n - 2]);
  return slope;
}

}  // namespace

std::vector<CurvePiece> polynomial_pieces(const std::vector<double>& coefficients, double scale) {
  CurvePiece piece;
  double power = scale;
  for (std::size_t k = 0; k < coefficients.size(); ++k, power *= scale) piece.d[k] = coefficients[k] / power;
  integrate(piece);
  return {piece};
}

std::vector<CurvePiece> pchip_pieces(const std::vector<std::pair<double, double>>& points, double scale) {
  std::vector<double> x, y;
  for (const auto& [strain, stress] : points) {
    x.push_back(scale * strain);
    y.push_back(stress);
  }
  std::vector<double> h, secant;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    h.push_back(x[i + 1] - x[i]);
    secant.push_back((y[i + 1] - y[i]) / h.back());
  }
  const auto slope = knot_slopes(h, secant);
  std::vector<CurvePiece> pieces;
  double U = 0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    CurvePiece piece;
    piece.start = x[i];
    piece.P0 = y[i];
    piece.U0 = U;
    piece.d[0] = slope[i];
    piece.d[1] = 2 * (3 * secant[i] - 2 * slope[i] - slope[i + 1]) / h[i];
    piece.d[2] = 3 * (slope[i] + slope[i + 1] - 2 * secant[i]) / (h[i] * h[i]);
    integrate(piece);
    U = integrals_at(piece, h[i]).second;
    pieces.push_back(piece);
  }
  return pieces;
}

RawCurve raw_curve(const std::vector<CurvePiece>& pieces, double x) {
  const auto after = std::upper_bound(pieces.begin() + 1, pieces.end(), x,
                                      [](double at, const CurvePiece& p) { return at < p.start; });
  const CurvePiece& piece = *(after - 1);
  const double t = x - piece.start;
  double D = 0, slope = 0;
  for (int k = max_terms - 1; k >= 0; --k) {
    slope = slope * t + D;
    D = D * t + piece.d[k];
  }
  return {D, slope, integrals_at(piece, t).first};
}

}  // namespace fabricsh::law
