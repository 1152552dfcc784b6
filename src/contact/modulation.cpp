#include "contact/jet.hpp"
#include "contact/pair.hpp"

namespace fabricsh::contact {
namespace {

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

Matrix12 hessian_by_corners(const ByVectors& by, const Jet<double, true>& jet) {
  using Row5 = Eigen::Matrix<double, 5, 5, Eigen::RowMajor>;
  const Eigen::Matrix<double, 9, 5> left = by.slope.lazyProduct(Eigen::Map<const Row5>(&jet.twice[0][0]));
  Eigen::Matrix<double, 9, 9> h = left.lazyProduct(by.slope.transpose());
  const double own[3][3] = {{2 * jet.first[0], jet.first[1], jet.first[3]},
                            {jet.first[1], 2 * jet.first[2], jet.first[4]},
                            {jet.first[3], jet.first[4], 0}};
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l) h.block<3, 3>(3 * k, 3 * l).diagonal().array() += own[k][l];
  Eigen::Matrix<double, 12, 9> rows = Eigen::Matrix<double, 12, 9>::Zero();
  Matrix12 out = Matrix12::Zero();
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 4; ++i)
      if (to_corner[k][i] != 0) rows.middleRows<3>(3 * i) += to_corner[k][i] * h.middleRows<3>(3 * k);
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 4; ++i)
      if (to_corner[k][i] != 0) out.middleCols<3>(3 * i) += to_corner[k][i] * rows.middleCols<3>(3 * k);
  return out;
}

template <bool second>
Modulation evaluate(const Vec3& u, const Vec3& v, const Vec3& r, const Fading& fading, Matrix12* hessian) {
  const double products[5] = {u.dot(u), u.dot(v), v.dot(v), u.dot(r), v.dot(r)},
               ends[2] = {fading.first, fading.second};
  const auto m = fade<second>(products, fading.at_ends ? ends : nullptr);
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
