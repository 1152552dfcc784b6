// Numbers with their derivatives by the five products on which the closest points of two lines depend, and
// the weight of two crossing segments as such a number: for one pair (T = double) or a pack of pairs.
//
// The products are u.u, u.v, v.v, u.r, v.r; u and v are the segments, and r goes from the second's start to
// the first's.
#pragma once
#include "simd/pack.hpp"

namespace fabricsh::contact {
inline namespace FABRICSH_ISA {

constexpr double parallel = 0.02;  // squared sine of the angle below which two segments fade

template <class T, bool second>
struct Jet {
  static constexpr int n = 5;
  T value{};
  T first[n] = {};
  T twice[second ? n : 1][second ? n : 1] = {};
};

template <class J, class T>
J variable(T value, int place) {
  J out;
  out.value = value;
  out.first[place] = 1;
  return out;
}

// The values and derivatives of f(a, b): fa = df/da, fab = d2f/da db, ...
template <class T>
struct Rule {
  T value, fa, fb, faa, fab, fbb;
};

template <class T, bool second>
Jet<T, second> combine(const Jet<T, second>& a, const Jet<T, second>& b, const Rule<T>& f) {
  Jet<T, second> out;
  out.value = f.value;
  for (int i = 0; i < out.n; ++i) out.first[i] = f.fa * a.first[i] + f.fb * b.first[i];
  if constexpr (second)
    for (int i = 0; i < out.n; ++i)
      for (int j = 0; j < out.n; ++j)
        out.twice[i][j] = f.fa * a.twice[i][j] + f.fb * b.twice[i][j] + f.faa * a.first[i] * a.first[j] +
                          f.fab * (a.first[i] * b.first[j] + b.first[i] * a.first[j]) +
                          f.fbb * b.first[i] * b.first[j];
  return out;
}

template <class T, bool second>
Jet<T, second> operator*(const Jet<T, second>& a, const Jet<T, second>& b) {
  return combine(a, b, {a.value * b.value, b.value, a.value, 0, 1, 0});
}
template <class T, bool second>
Jet<T, second> operator-(const Jet<T, second>& a, const Jet<T, second>& b) {
  return combine(a, b, {a.value - b.value, 1, -1, 0, 0, 0});
}
template <class T, bool second>
Jet<T, second> operator/(const Jet<T, second>& a, const Jet<T, second>& b) {
  const T i = 1 / b.value, q = a.value * i;
  return combine(a, b, {q, i, -q * i, 0, -i * i, 2 * q * i * i});
}
template <class T, bool second>
Jet<T, second> chain(const Jet<T, second>& a, T value, T slope, T curvature) {
  return combine(a, Jet<T, second>{}, {value, slope, 0, curvature, 0, 0});
}

// 1 - (1 - k/k0)^3, where k is the squared sine of the angle.
template <class T, bool second>
Jet<T, second> fade_parallel(const Jet<T, second>& k) {
  const T left = max(1 - k.value / parallel, 0);
  return chain<T, second>(k, 1 - left * left * left, 3 * left * left / parallel,
                          -6 * left / (parallel * parallel));
}

// Rises from 0 at an end of a segment to 1 at the distance `zone` (share of its length) from it.
template <class T, bool second>
Jet<T, second> fade_end(const Jet<T, second>& s, T zone) {
  const T turn = select(s.value > 0.5, T(-1), T(1)),
          x = min(max(select(turn > 0, s.value, 1 - s.value) / zone, 0), 1);
  return chain<T, second>(s, x * x * x * (10 + x * (6 * x - 15)),
                          turn * 30 * x * x * (1 - x) * (1 - x) / zone,
                          60 * x * (1 - x) * (1 - 2 * x) / (zone * zone));
}

// ends: null, or for each segment the share of its length over which it fades.
template <bool second, class T>
Jet<T, second> fade(const T (&products)[5], const T* ends) {
  using J = Jet<T, second>;
  const J a = variable<J>(products[0], 0), b = variable<J>(products[1], 1), c = variable<J>(products[2], 2);
  const J det = a * c - b * b;
  const J m = fade_parallel(det / (a * c));
  if (ends == nullptr) return m;
  const J e = variable<J>(products[3], 3), f = variable<J>(products[4], 4);
  return m * fade_end((b * f - c * e) / det, ends[0]) * fade_end((a * f - b * e) / det, ends[1]);
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::contact
