#include <cmath>

#include "base/error.hpp"
#include "element/shell3.hpp"

namespace fabricsh::element {

namespace {

struct Shape {
  std::array<double, 4> N, N1, N2;  // values and derivatives along xi, eta
};

Shape shape_at(double xi, double eta) {
  static constexpr double sx[4] = {-1, 1, 1, -1}, sy[4] = {-1, -1, 1, 1};
  Shape s;
  for (int a = 0; a < 4; ++a) {
    s.N[a] = (1 + sx[a] * xi) * (1 + sy[a] * eta) / 4;
    s.N1[a] = sx[a] * (1 + sy[a] * eta) / 4;
    s.N2[a] = sy[a] * (1 + sx[a] * xi) / 4;
  }
  return s;
}

Vec3 sum(const std::array<double, 4>& weights, const std::array<Vec3, 4>& v) {
  return weights[0] * v[0] + weights[1] * v[1] + weights[2] * v[2] + weights[3] * v[3];
}

// (v11, v22, 2 v12) of sym(u_i . w_j).
std::array<double, 3> metric(const Vec3& u1, const Vec3& u2, const Vec3& w1, const Vec3& w2) {
  return {u1.dot(w1), u2.dot(w2), u1.dot(w2) + u2.dot(w1)};
}

// Reference samples of the assumed membrane field and the element's distortion.
void put_membrane(const std::array<Vec3, 4>& X, const std::function<void(int, double)>& put) {
  const Vec3 A = (X[2] - X[3]) / 2, B = (X[1] - X[0]) / 2, C = (X[2] - X[1]) / 2, D = (X[3] - X[0]) / 2;
  const Vec3 mid1 = (A + B) / 2, mid2 = (C + D) / 2, distortion = (A - B) / 2;
  const Vec3 n = mid1.cross(mid2), flat = distortion - distortion.dot(n) / n.squaredNorm() * n;
  const double samples[8] = {A.dot(A) / 2,       B.dot(B) / 2,       C.dot(C) / 2,   D.dot(D) / 2,
                             mid1.dot(mid1) / 2, mid2.dot(mid2) / 2, mid1.dot(mid2), flat.dot(flat) / 2};
  for (int i = 0; i < 8; ++i) put(4 + i, samples[i]);
  put(12, distortion.dot(mid2.cross(n)) / n.squaredNorm());
  put(13, distortion.dot(n.cross(mid1)) / n.squaredNorm());
}

// An in-plane point of the reference: position, director, base vectors and the director's derivatives.
struct PointFrame {
  Vec3 X, D, A1, A2, B1, B2;
};

// T11 T12 T21 T22 q1 q2 s w of one thickness point (see Shell4Layout).
std::array<double, 8> point_column(const section::Section& section, std::size_t k, const PointFrame& p,
                                   double weight, const WarpAt& warp) {
  const double z = section.thickness / 2 * (section.points[k].zeta - section.offset);
  const Vec3 G1 = p.A1 + z * p.B1, G2 = p.A2 + z * p.B2, G3 = section.thickness / 2 * p.D;
  const Vec3 normal = G1.cross(G2);
  const double J = normal.dot(G3);
  if (!(J > 0) || !std::isfinite(J))
    throw Error("is degenerate or inverted: its Jacobian is " + std::to_string(J) +
                ", expected a positive number");
  const Vec3 m3 = normal.normalized();
  const Vec3 wanted = warp(p.X, m3);
  const Vec3 along = (wanted - wanted.dot(m3) * m3).normalized();
  const double angle = section.points[k].angle;
  const Vec3 m1 = angle == 0 ? along : Vec3(std::cos(angle) * along + std::sin(angle) * m3.cross(along));
  const Vec3 m2 = m3.cross(m1);
  const Vec3 C1 = G2.cross(G3) / J, C2 = G3.cross(G1) / J, C3 = normal / J;
  return {C1.dot(m1), C2.dot(m1), C1.dot(m2), C2.dot(m2),
          C1.dot(m3), C2.dot(m3), C3.dot(m3), weight * section.points[k].weight * J};
}

}  // namespace

void shell4_geometry(const section::Section& section, const std::array<Vec3, 4>& X,
                     const std::array<Vec3, 4>& D, const WarpAt& warp, double* geometry, int lane,
                     int stride) {
  const Shell4Layout at(static_cast<int>(section.points.size()));
  auto put = [&](int i, double v) { geometry[i * stride + lane] = v; };
  static constexpr int edge[4][2] = {{0, 1}, {3, 2}, {0, 3}, {1, 2}};
  for (int e = 0; e < 4; ++e) {
    const auto [i, j] = std::pair(edge[e][0], edge[e][1]);
    put(e, section.thickness / 8 * (X[j] - X[i]).dot(D[i] + D[j]));
  }
  put_membrane(X, put);
  static const double g = 1 / std::sqrt(3.0);
  const double px[4] = {-g, g, g, -g}, py[4] = {-g, -g, g, g};
  for (int p = 0; p < gauss_points; ++p) {
    const Shape s = shape_at(px[p], py[p]);
    const Vec3 A1 = sum(s.N1, X), A2 = sum(s.N2, X), B1 = sum(s.N1, D), B2 = sum(s.N2, D);
    const auto kappa = metric(A1, A2, B1, B2), rho = metric(B1, B2, B1, B2);
    for (int i = 0; i < 3; ++i) {
      put(at.reference(p) + i, kappa[i]);
      put(at.reference(p) + 3 + i, rho[i] / 2);
    }
    const PointFrame frame{sum(s.N, X), sum(s.N, D), A1, A2, B1, B2};
    for (std::size_t k = 0; k < section.points.size(); ++k) {
      const auto column = point_column(section, k, frame, 1.0, warp);
      for (int i = 0; i < 8; ++i) put(at.point(p, static_cast<int>(k)) + i, column[i]);
    }
  }
}

void shell3_geometry(const section::Section& section, const std::array<Vec3, 3>& X,
                     const std::array<Vec3, 3>& D, const WarpAt& warp, double* geometry, int lane,
                     int stride) {
  const Shell3Layout at(static_cast<int>(section.points.size()));
  auto put = [&](int i, double v) { geometry[i * stride + lane] = v; };
  static constexpr int edge[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int e = 0; e < 3; ++e) {
    const auto [i, j] = std::pair(edge[e][0], edge[e][1]);
    put(e, section.thickness / 4 * (X[j] - X[i]).dot(D[i] + D[j]));
  }
  const Vec3 A1 = X[1] - X[0], A2 = X[2] - X[0], B1 = D[1] - D[0], B2 = D[2] - D[0];
  const auto membrane = metric(A1, A2, A1, A2), kappa = metric(A1, A2, B1, B2), rho = metric(B1, B2, B1, B2);
  for (int i = 0; i < 3; ++i) put(3 + i, membrane[i] / 2);
  static constexpr double r[3] = {1.0 / 6, 2.0 / 3, 1.0 / 6}, s[3] = {1.0 / 6, 1.0 / 6, 2.0 / 3};
  for (int p = 0; p < shell3_points; ++p) {
    for (int i = 0; i < 3; ++i) {
      put(at.reference(p) + i, kappa[i]);
      put(at.reference(p) + 3 + i, rho[i] / 2);
    }
    const PointFrame frame{X[0] + r[p] * A1 + s[p] * A2, D[0] + r[p] * B1 + s[p] * B2, A1, A2, B1, B2};
    for (std::size_t k = 0; k < section.points.size(); ++k) {
      const auto column = point_column(section, k, frame, 1.0 / 6, warp);
      for (int i = 0; i < 8; ++i) put(at.point(p, static_cast<int>(k)) + i, column[i]);
    }
  }
}

}  // namespace fabricsh::element
