// Evaluation of a backbone over a number type T (double or Pack).
#pragma once
#include "law/data.hpp"
#include "simd/pack.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

template <class T>
struct BackboneValue {
  T D, P, U;
};

// Horner's rule for all polynomial pieces; the number of terms is a compile-time constant.
template <int terms, class C, class T>
T horner(const C* c, T t) {
  T sum(c[terms - 1]);
  for (int k = terms - 2; k >= 0; --k) sum = sum * t + T(c[k]);
  return sum;
}

template <class T>
T horner_at(const double* c, int terms, T t) {
  T sum(c[terms - 1]);
  for (int k = terms - 2; k >= 0; --k) sum = sum * t + T(c[k]);
  return sum;
}

// Coefficients of the piece that contains x, lane by lane (the same in all lanes if there is only one piece).
template <int terms, class T>
struct PieceAt {
  T start, P0, U0, d[terms], p[terms], u[terms];
};

template <int terms, class T>
PieceAt<terms, T> piece_at(const Backbone& curve, T x) {
  PieceAt<terms, T> q;
  const auto take = [&](const CurvePiece& from, auto pick) {
    q.start = pick(from.start, q.start);
    q.P0 = pick(from.P0, q.P0);
    q.U0 = pick(from.U0, q.U0);
    for (int k = 0; k < terms; ++k) {
      q.d[k] = pick(from.d[k], q.d[k]);
      q.p[k] = pick(from.p[k], q.p[k]);
      q.u[k] = pick(from.u[k], q.u[k]);
    }
  };
  take(curve.piece[0], [](double a, T) { return T(a); });
  for (int i = 1; i < curve.pieces; ++i) {
    const auto here = x >= T(curve.piece[i].start);
    take(curve.piece[i], [&](double a, T old) { return select(here, T(a), old); });
  }
  return q;
}

// The range guard without a branch: values at t inside the piece, continued over `beyond` with constant D.
template <int terms, class T, class P>
BackboneValue<T> extended(const P& piece, T inside, T beyond) {
  const T t = inside - T(piece.start);
  const T D = horner<terms>(piece.d, t);
  const T stress = T(piece.P0) + t * horner<terms>(piece.p, t);
  const T U = T(piece.U0) + t * (T(piece.P0) + t * horner<terms>(piece.u, t));
  return {D, stress + D * beyond, U + beyond * (stress + T(0.5) * D * beyond)};
}

template <int terms, class T>
BackboneValue<T> backbone_terms(const Backbone& curve, T x) {
  const T inside = min(x, T(curve.limit));
  if (curve.pieces == 1) return extended<terms>(curve.piece[0], inside, x - inside);
  return extended<terms>(piece_at<terms>(curve, inside), inside, x - inside);
}

// The backbone at x >= 0. NaN gives NaN.
template <class T>
BackboneValue<T> backbone_at(const Backbone& curve, T x) {
  return curve.terms == 4 ? backbone_terms<4>(curve, x) : backbone_terms<max_terms>(curve, x);
}

template <class T>
BackboneValue<T> backbone_at(const CubicBackbone& curve, T x) {
  const T inside = min(x, T(curve.limit));
  return extended<4>(curve, inside, x - inside);
}

// D and dD/dx at x >= 0; beyond the limit dD/dx = 0.
template <class T>
struct BackboneSlope {
  T D, slope;
};

template <int terms, class T, class P>
BackboneSlope<T> slope_in(const P& piece, T inside) {
  const T t = inside - T(piece.start);
  T D(piece.d[terms - 1]), slope(0.0);
  for (int k = terms - 2; k >= 0; --k) {
    slope = slope * t + D;
    D = D * t + T(piece.d[k]);
  }
  return {D, slope};
}

template <int terms, class T>
BackboneSlope<T> slope_terms(const Backbone& curve, T x) {
  const T inside = min(x, T(curve.limit));
  const auto at = curve.pieces == 1 ? slope_in<terms>(curve.piece[0], inside)
                                    : slope_in<terms>(piece_at<terms>(curve, inside), inside);
  return {at.D, select(x > T(curve.limit), T(0.0), at.slope)};
}

template <class T>
BackboneSlope<T> backbone_slope(const Backbone& curve, T x) {
  return curve.terms == 4 ? slope_terms<4>(curve, x) : slope_terms<max_terms>(curve, x);
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
