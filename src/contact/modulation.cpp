#include "contact/modulation.hpp"

#include <algorithm>

namespace fabricsh::contact {
namespace {

constexpr double parallel = 0.02;  // squared sine of the angle below which two segments fade

// A number with its derivatives by the five products on which the closest points of two lines depend:
// u.u, u.v, v.v, u.r, v.r; u and v are the segments, and r goes from the second's start to the first's.
template <bool second>
struct Jet {
  static constexpr int n = 5;
  double value = 0;
  double first[n] = {};
  double twice[second ? n : 1][second ? n : 1] = {};
};

template <bool second>
Jet<second> variable(double value, int place) {
  Jet<second> out;
  out.value = value;
  out.first[place] = 1;
  return out;
}

// The values and derivatives of f(a, b): fa = df/da, fab = d2f/da db, ...
struct Rule {
  double value, fa, fb, faa, fab, fbb;
};

template <bool second>
Jet<second> combine(const Jet<second>& a, const Jet<second>& b, const Rule& f) {
  Jet<second> out;
  out.value = f.value;
  for (int i = 0; i < Jet<second>::n; ++i) out.first[i] = f.fa * a.first[i] + f.fb * b.first[i];
  if constexpr (second)
    for (int i = 0; i < Jet<second>::n; ++i)
      for (int j = 0; j < Jet<second>::n; ++j)
        out.twice[i][j] = f.fa * a.twice[i][j] + f.fb * b.twice[i][j] + f.faa * a.first[i] * a.first[j] +
                          f.fab * (a.first[i] * b.first[j] + b.first[i] * a.first[j]) +
                          f.fbb * b.first[i] * b.first[j];
  return out;
}

template <bool second>
Jet<second> operator*(const Jet<second>& a, const Jet<second>& b) {
  return combine(a, b, {a.value * b.value, b.value, a.value, 0, 1, 0});
}
template <bool second>
Jet<second> operator-(const Jet<second>& a, const Jet<second>& b) {
  return combine(a, b, {a.value - b.value, 1, -1, 0, 0, 0});
}
template <bool second>
Jet<second> operator/(const Jet<second>& a, const Jet<second>& b) {
  const double i = 1 / b.value, q = a.value * i;
  return combine(a, b, {q, i, -q * i, 0, -i * i, 2 * q * i * i});
}
template <bool second>
Jet<second> chain(const Jet<second>& a, double value, double slope, double curvature) {
  return combine(a, Jet<second>{}, {value, slope, 0, curvature, 0, 0});
}

// 1 - (1 - k/k0)^3, where k is the squared sine of the angle.
template <bool second>
Jet<second> fade_parallel(const Jet<second>& k) {
  const double left = 1 - k.value / parallel;
  if (left <= 0) return chain(k, 1, 0, 0);
  return chain(k, 1 - left * left * left, 3 * left * left / parallel, -6 * left / (parallel * parallel));
}

// Rises from 0 at an end of a segment to 1 at the distance `zone` (share of its length) from it.
template <bool second>
Jet<second> fade_end(const Jet<second>& s, double zone) {
  const double turn = s.value > 0.5 ? -1 : 1,
               x = std::clamp((turn > 0 ? s.value : 1 - s.value) / zone, 0.0, 1.0);
  return chain(s, x * x * x * (10 + x * (6 * x - 15)), turn * 30 * x * x * (1 - x) * (1 - x) / zone,
               60 * x * (1 - x) * (1 - 2 * x) / (zone * zone));
}

// Converts derivatives by the products to derivatives by u, v, r, and these
// to derivatives by the corners: u = x1 - x0, v = x3 - x2, r = x0 - x2.
struct ByVectors {
  Eigen::Matrix<double, 9, 5> slope = Eigen::Matrix<double, 9, 5>::Zero();
  ByVectors(const Vec3& u, const Vec3& v, const Vec3& r) {
    slope.block<3, 1>(0, 0) = 2 * u;
    slope.block<3, 1>(0, 1) = v;
    slope.block<3, 1>(3, 1) = u;
    slope.block<3, 1>(3, 2) = 2 * v;
    slope.block<3, 1>(0, 3) = r;
    slope.block<3, 1>(6, 3) = u;
    slope.block<3, 1>(3, 4) = r;
    slope.block<3, 1>(6, 4) = v;
  }
};

constexpr double to_corner[3][4] = {{-1, 1, 0, 0}, {0, 0, -1, 1}, {1, 0, -1, 0}};

Vector12 gradient_by_corners(const ByVectors& by, const double* first) {
  const Eigen::Matrix<double, 9, 1> g = by.slope * Eigen::Map<const Eigen::Matrix<double, 5, 1>>(first);
  Vector12 out = Vector12::Zero();
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 4; ++i)
      if (to_corner[k][i] != 0) out.segment<3>(3 * i) += to_corner[k][i] * g.segment<3>(3 * k);
  return out;
}

Matrix12 hessian_by_corners(const ByVectors& by, const Jet<true>& jet) {
  using Row5 = Eigen::Matrix<double, 5, 5, Eigen::RowMajor>;
  Eigen::Matrix<double, 9, 9> h = by.slope * Eigen::Map<const Row5>(&jet.twice[0][0]) * by.slope.transpose();
  const double own[3][3] = {{2 * jet.first[0], jet.first[1], jet.first[3]},
                            {jet.first[1], 2 * jet.first[2], jet.first[4]},
                            {jet.first[3], jet.first[4], 0}};
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l) h.block<3, 3>(3 * k, 3 * l).diagonal().array() += own[k][l];
  Eigen::Matrix<double, 9, 12> map = Eigen::Matrix<double, 9, 12>::Zero();
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 4; ++i) map.block<3, 3>(3 * k, 3 * i).diagonal().array() = to_corner[k][i];
  return map.transpose() * h * map;
}

template <bool second>
Modulation evaluate(const Vec3& u, const Vec3& v, const Vec3& r, const Fading& fading, Matrix12* hessian) {
  using J = Jet<second>;
  const J a = variable<second>(u.dot(u), 0), b = variable<second>(u.dot(v), 1),
          c = variable<second>(v.dot(v), 2);
  const J det = a * c - b * b;
  J m = fade_parallel(det / (a * c));
  if (fading.at_ends) {
    const J e = variable<second>(u.dot(r), 3), f = variable<second>(v.dot(r), 4);
    m = m * fade_end((b * f - c * e) / det, fading.first) * fade_end((a * f - b * e) / det, fading.second);
  }
  const ByVectors by(u, v, r);
  Modulation out;
  out.value = m.value;
  out.constant = false;
  out.gradient = gradient_by_corners(by, m.first);
  if constexpr (second) *hessian = hessian_by_corners(by, m);
  return out;
}

bool inside(double s, double zone) { return s >= zone && s <= 1 - zone; }

}  // namespace

Modulation modulation(const Corners& x, const Fading& fading, Matrix12* hessian) {
  const Vec3 u = x[1] - x[0], v = x[3] - x[2], r = x[0] - x[2];
  const double a = u.dot(u), b = u.dot(v), c = v.dot(v), det = a * c - b * b;
  Modulation out;
  if (fading.at_ends) {
    if (!(det > 1e-14 * a * c)) return out;
    const double e = u.dot(r), f = v.dot(r), s = (b * f - c * e) / det, t = (a * f - b * e) / det;
    if (!(s > 0 && s < 1 && t > 0 && t < 1)) return out;
    if (det >= parallel * a * c && inside(s, fading.first) && inside(t, fading.second))
      return out.value = 1, out;
  } else if (det >= parallel * a * c) {
    return out.value = 1, out;
  }
  return hessian != nullptr ? evaluate<true>(u, v, r, fading, hessian)
                            : evaluate<false>(u, v, r, fading, nullptr);
}

}  // namespace fabricsh::contact
