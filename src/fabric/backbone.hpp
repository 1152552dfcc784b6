// Evaluation of a backbone over a number type T (double or Pack).
#pragma once
#include "fabric/data.hpp"
#include "tensor/pack.hpp"

namespace fabricsh::fabric {
inline namespace FABRICSH_ISA {

template <class T>
struct BackboneValue {
  T D, P, U;
};

// Polynomial pieces share this Horner rule; the number of terms is a compile-time constant.
template <int terms, class T>
T horner(const T* c, T t) {
  T sum = c[terms - 1];
  for (int k = terms - 2; k >= 0; --k) sum = sum * t + c[k];
  return sum;
}

template <class T>
T horner_at(const double* c, int terms, T t) {
  T sum(c[terms - 1]);
  for (int k = terms - 2; k >= 0; --k) sum = sum * t + T(c[k]);
  return sum;
}

// Coefficients of the piece that holds x, lane by lane.
template <int terms, class T>
struct PieceAt {
  T start, P0, U0, d[terms], p[terms], u[terms];
};

template <int terms, class T>
PieceAt<terms, T> piece_at(const Backbone& curve, T x) {
  PieceAt<terms, T> q;
  const auto take = [&](const Piece& from, auto pick) {
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

// The guard without a branch: values at min(x, limit), extended with a constant D.
template <int terms, class T>
BackboneValue<T> backbone_terms(const Backbone& curve, T x) {
  const T inside = min(x, T(curve.limit));
  const T beyond = x - inside;
  const auto q = piece_at<terms>(curve, inside);
  const T t = inside - q.start;
  const T D = horner<terms>(q.d, t);
  const T P = q.P0 + t * horner<terms>(q.p, t);
  const T U = q.U0 + t * (q.P0 + t * horner<terms>(q.u, t));
  return {D, P + D * beyond, U + beyond * (P + T(0.5) * D * beyond)};
}

// x >= 0. NaN gives NaN.
template <class T>
BackboneValue<T> backbone_at(const Backbone& curve, T x) {
  return curve.terms == 4 ? backbone_terms<4>(curve, x) : backbone_terms<max_terms>(curve, x);
}

// D and dD/dx at x >= 0; beyond the limit dD/dx = 0.
template <class T>
struct BackboneSlope {
  T D, slope;
};

template <int terms, class T>
BackboneSlope<T> slope_terms(const Backbone& curve, T x) {
  const T inside = min(x, T(curve.limit));
  const auto q = piece_at<terms>(curve, inside);
  const T t = inside - q.start;
  T D = q.d[terms - 1], slope(0.0);
  for (int k = terms - 2; k >= 0; --k) {
    slope = slope * t + D;
    D = D * t + q.d[k];
  }
  return {D, select(x > T(curve.limit), T(0.0), slope)};
}

template <class T>
BackboneSlope<T> backbone_slope(const Backbone& curve, T x) {
  return curve.terms == 4 ? slope_terms<4>(curve, x) : slope_terms<max_terms>(curve, x);
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::fabric
