// Means of a tangent modulus along a straight strain path x(s) = x0 + s dx, 0 <= s <= 1. The path is
// divided at every switch, where the modulus changes its formula, and each part is integrated exactly.
#pragma once
#include <limits>

#include "law/backbone.hpp"

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
}  // namespace fabricsh::law
