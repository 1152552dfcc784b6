#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/number.hpp"
#include "element/shell3.hpp"

namespace fabricsh::element {

namespace {

// The components (v11, v22, 2 v12) of sym(u_i . w_j).
std::array<double, 3> metric(const Vec3& u1, const Vec3& u2, const Vec3& w1, const Vec3& w2) {
  return {u1.dot(w1), u2.dot(w2), u1.dot(w2) + u2.dot(w1)};
}

// The reference as in the kernels: half chords of the edges
// A B C D, the base vectors in the middle, and the twist.
struct Edges {
  Vec3 chord[4], beta[4], mid1, mid2, twist;
};

constexpr int kEdge[4][2] = {{3, 2}, {0, 1}, {1, 2}, {0, 3}};

// As lengthen() does in the kernels.
Vec3 lengthened(const Vec3& delta) {
  const double q = delta.squaredNorm();
  return (1 + q * (1.0 / 6 + 3.0 / 40 * q)) * delta;
}

Edges edges_of(const std::array<Vec3, 4>& X, const std::array<Vec3, 4>& D) {
  Edges e;
  for (int i = 0; i < 4; ++i) {
    e.chord[i] = (X[kEdge[i][1]] - X[kEdge[i][0]]) / 2;
    e.beta[i] = lengthened((D[kEdge[i][1]] - D[kEdge[i][0]]) / 2);
  }
  e.mid1 = (e.chord[0] + e.chord[1]) / 2;
  e.mid2 = (e.chord[2] + e.chord[3]) / 2;
  e.twist = (e.chord[0] - e.chord[1]) / 2;
  return e;
}

// An in-plane point of the reference: position, director, base vectors and the director's derivatives.
struct PointFrame {
  Vec3 X, D, A1, A2, B1, B2;
};

PointFrame frame_at(const Edges& e, const std::array<Vec3, 4>& X, const std::array<Vec3, 4>& D, double xi,
                    double eta) {
  const double N[4] = {(1 - xi) * (1 - eta) / 4, (1 + xi) * (1 - eta) / 4, (1 + xi) * (1 + eta) / 4,
                       (1 - xi) * (1 + eta) / 4};
  PointFrame p{Vec3::Zero(),
               Vec3::Zero(),
               e.mid1 + eta * e.twist,
               e.mid2 + xi * e.twist,
               (1 + eta) / 2 * e.beta[0] + (1 - eta) / 2 * e.beta[1],
               (1 + xi) / 2 * e.beta[2] + (1 - xi) / 2 * e.beta[3]};
  for (int a = 0; a < 4; ++a) {
    p.X += N[a] * X[a];
    p.D += N[a] * D[a];
  }
  return p;
}

// The columns T11 T12 T21 T22 q1 q2 s w (see Shell4Layout) of the thickness points at an in-plane point.
// Where the directors are parallel the base vectors do not depend on the height; then only the weights
// differ.
class PointColumns {
 public:
  PointColumns(const section::Section& section, const PointFrame& frame, const WarpAt& warp)
      : section_(section), p_(frame), warp_(warp), G3_(section.thickness / 2 * frame.D) {}

  // k: the thickness point; weight: of the in-plane point.
  std::array<double, 8> operator()(std::size_t k, double weight) {
    const auto& point = section_.points[k];
    const double z = section_.thickness / 2 * (point.zeta - section_.offset);
    const Vec3 G1 = p_.A1 + z * p_.B1, G2 = p_.A2 + z * p_.B2;
    if (!known_ || !same(G1, G1_) || !same(G2, G2_) || point.angle != angle_) {
      G1_ = G1;
      G2_ = G2;
      angle_ = point.angle;
      transform();
      known_ = true;
    }
    column_[7] = weight * point.weight * J_;
    return column_;
  }

 private:
  static bool same(const Vec3& a, const Vec3& b) {
    return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
  }

  void transform() {
    const Vec3 normal = G1_.cross(G2_);
    J_ = normal.dot(G3_);
    if (!(J_ > 0) || !std::isfinite(J_)) throw DegenerateElement(J_);
    const Vec3 m3 = normal.normalized();
    const Vec3 wanted = warp_(p_.X, m3);
    const Vec3 along = (wanted - wanted.dot(m3) * m3).normalized();
    const Vec3 m1 = angle_ == 0 ? along : Vec3(std::cos(angle_) * along + std::sin(angle_) * m3.cross(along));
    const Vec3 m2 = m3.cross(m1);
    const Vec3 C1 = G2_.cross(G3_) / J_, C2 = G3_.cross(G1_) / J_, C3 = normal / J_;
    column_ = {C1.dot(m1), C2.dot(m1), C1.dot(m2), C2.dot(m2), C1.dot(m3), C2.dot(m3), C3.dot(m3), 0};
  }

  const section::Section& section_;
  const PointFrame& p_;
  const WarpAt& warp_;
  const Vec3 G3_;
  bool known_ = false;
  Vec3 G1_ = Vec3::Zero(), G2_ = Vec3::Zero();
  double angle_ = 0, J_ = 0;
  std::array<double, 8> column_{};
};

using Samples = Eigen::Matrix<double, 3, kSamples>;
using Modes = Eigen::Matrix<double, kEnhanced, kSamples>;

// Components of the twist on the base vectors in the middle, and its part in their plane.
std::pair<Eigen::Vector2d, Vec3> distortion_of(const Edges& e) {
  const Vec3 n = e.mid1.cross(e.mid2);
  const double area2 = n.squaredNorm();
  return {{e.twist.dot(e.mid2.cross(n)) / area2, e.twist.dot(n.cross(e.mid1)) / area2},
          e.twist - e.twist.dot(n) / area2 * n};
}

// The tangent that determines the enhanced strains, in the middle's covariant components (11, 22, 2 12):
// the law's if it is constant. Otherwise the unit tangent without coupling, since no single tangent of a
// nonlinear law stays valid: the contraction at rest would restrain cloth that stiffens along a yarn.
Mat3 weighing_tangent(const section::Section& section, const PointFrame& middle, const WarpAt& warp) {
  Mat3 sum = Mat3::Zero();
  constexpr int in_plane[3] = {0, 1, 4};
  const bool linear = std::all_of(section.points.begin(), section.points.end(),
                                  [](const auto& point) { return law::linear(*point.law); });
  PointColumns columns(section, middle, warp);
  for (std::size_t k = 0; k < section.points.size(); ++k) {
    Mat3 C3 = Vec3(1, 1, 0.5).asDiagonal();
    if (linear) {
      double E[5] = {}, S[5], C[25];
      law::evaluate(*section.points[k].law, law::Step{}, E, nullptr, nullptr, S, C);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) C3(i, j) = C[5 * in_plane[i] + in_plane[j]];
    }
    const auto t = columns(k, 1.0);
    Mat3 L;
    L << t[0] * t[0], t[1] * t[1], t[0] * t[1],  //
        t[2] * t[2], t[3] * t[3], t[2] * t[3],   //
        2 * t[0] * t[2], 2 * t[1] * t[3], t[0] * t[3] + t[1] * t[2];
    sum += t[7] * L.transpose() * C3 * L;
  }
  return sum;
}

// alpha = A samples minimises the energy for a tangent C, with the bilinear strain c (3
// x 8 in the samples) and the enhanced strains E alpha j0/j, both in the middle's axes:
//   sum_g (E^T C E j0/j) alpha = -sum_g E^T C c.
// For a homogeneous strain alpha is zero, since E has zero mean [simo1990, section 3].
// held: the mode that is left out, or -1.
Modes enhanced_modes(const Mat3& C, const Eigen::Vector2d& w, int held) {
  Eigen::Matrix4d own = Eigen::Matrix4d::Zero();
  Modes coupling = Modes::Zero();
  for (const double r : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)})
    for (const double s : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
      Samples c;
      c << (1 + s) / 2, (1 - s) / 2, 0, 0, 0, 0, 0, s * s - 1,  //
          0, 0, (1 + r) / 2, (1 - r) / 2, 0, 0, 0, r * r - 1,   //
          r / 2, -r / 2, s / 2, -s / 2, 0, 0, 1, 2 * r * s;
      const double F11 = 1 + s * w[0], F12 = s * w[1], F21 = r * w[0], F22 = 1 + r * w[1];
      Mat3 to_point;  // from the axes in the middle to those at the point
      to_point << F11 * F11, F12 * F12, F11 * F12, F21 * F21, F22 * F22, F21 * F22, 2 * F11 * F21,
          2 * F12 * F22, F11 * F22 + F12 * F21;
      Eigen::Matrix<double, 3, kEnhanced> E;
      E << r, 0, 0, 0, 0, s, 0, 0, 0, 0, r, s;
      own += E.transpose() * C * E / (F11 * F22 - F12 * F21);
      coupling += E.transpose() * C * to_point.inverse() * c;
    }
  if (held >= 0) {
    own.row(held).setZero();
    own.col(held).setZero();
    own(held, held) = 1;
    coupling.row(held).setZero();
  }
  return -own.ldlt().solve(coupling);
}

// A narrow element that stiff fibres cross on the short way bends in its plane without shear, as a beam does,
// which takes an enhanced strain: its sides bulge. Beside another that bends the other way they cannot, since
// the fibres go on there; but such strains are each element's own, and a moment along the fibres, which
// couples that bending with a turn of the directors, would make all of them bend to and fro. Returns the mode
// that is left out there, so that shear holds them: 2, 3 for fibres along eta, xi; else -1.
int held_mode(const section::Section& section, const Edges& e, const std::array<double, 8>& column) {
  constexpr double kNarrow = 2, kStiff = 1000;
  if (!section.bends_apart) return -1;
  for (int f = 0; f < 2; ++f) {
    const auto& over_shear = section.yarns_over_shear;
    if (!(over_shear[f] > kStiff && over_shear[f] > kStiff * over_shear[1 - f])) continue;
    const double xi = e.mid1.norm(), eta = e.mid2.norm();
    const bool along_xi = std::abs(column[2 * f]) * xi > std::abs(column[2 * f + 1]) * eta;
    if ((along_xi ? eta / xi : xi / eta) > kNarrow) return along_xi ? 3 : 2;
  }
  return -1;
}

// The stiffness of a yarn over that of shear up to which its strain varies within any element. For isotropic
// sheets it is at most four.
constexpr double kHeldByShear = 20;

// Writes samples, distortion and enhanced modes of the assumed membrane field.
void put_membrane(const Edges& e, const Mat3& C, int held, const std::function<void(int, double)>& put) {
  const auto [w, flat] = distortion_of(e);
  const double middle[4] = {e.mid1.squaredNorm() / 2, e.mid2.squaredNorm() / 2, e.mid1.dot(e.mid2),
                            flat.squaredNorm() / 2};
  for (int i = 0; i < 4; ++i) {
    put(Shell4Layout::samples + i, e.chord[i].squaredNorm() / 2);
    put(Shell4Layout::samples + 4 + i, middle[i]);
  }
  for (int i = 0; i < 2; ++i) put(Shell4Layout::distortion + i, w[i]);
  const Modes modes = enhanced_modes(C, w, held);
  for (int i = 0; i < kEnhanced; ++i)
    for (int k = 0; k < kSamples; ++k) put(Shell4Layout::modes + kSamples * i + k, modes(i, k));
}

// Stiffness of virgin cloth at an in-plane point, per area of its coordinates: in bending about
// its neutral surface, on (kappa11, kappa22, 2 kappa12), and of the transverse shear, on (g1, g2).
struct VirginStiffness {
  Mat3 bending = Mat3::Zero();
  Eigen::Matrix2d shear = Eigen::Matrix2d::Zero();
};

using Tangent5 = Eigen::Matrix<double, 5, 5, Eigen::RowMajor>;

// Pa, in material axes; size: m, of the element.
Tangent5 virgin_tangent(const law::Law& law, double size, double thickness) {
  std::vector<double> state(static_cast<std::size_t>(law::state_size(law)) + 1, 0.0), next = state;
  if (law::has_initial(law)) {
    law::Site site;
    site.size = {size, size};
    site.thickness = thickness;
    law::set_initial(law, site, state.data());
  }
  const double E[5] = {};
  double S[5];
  Tangent5 C;
  law::evaluate(law, law::Step{}, E, state.data(), next.data(), S, C.data());
  return C;
}

// Rows (E11 E22 2E12) by columns (c11 c22 2c12) of covariant strains; t: a column of the geometry.
Mat3 in_plane_transform(const std::array<double, 8>& t) {
  Mat3 L;
  L << t[0] * t[0], t[1] * t[1], t[0] * t[1],  //
      t[2] * t[2], t[3] * t[3], t[2] * t[3],   //
      2 * t[0] * t[2], 2 * t[1] * t[3], t[0] * t[3] + t[1] * t[2];
  return L;
}

VirginStiffness virgin_stiffness(const section::Section& section, const PointFrame& middle,
                                 const WarpAt& warp) {
  // The least extent of the triangle of A1, A2: the law has been found to bear those along the yarns.
  const double longest = std::max({middle.A1.norm(), middle.A2.norm(), (middle.A2 - middle.A1).norm()});
  const double size = middle.A1.cross(middle.A2).norm() / longest;
  VirginStiffness sum;
  Mat3 stretching = Mat3::Zero(), coupling = Mat3::Zero();
  PointColumns columns(section, middle, warp);
  for (std::size_t k = 0; k < section.points.size(); ++k) {
    const auto& point = section.points[k];
    const Tangent5 C = virgin_tangent(*point.law, size, section.thickness_of(point.ply));
    const auto t = columns(k, 1.0);
    const Mat3 L = in_plane_transform(t);
    Mat3 in_plane;
    constexpr int row[3] = {0, 1, 4};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) in_plane(i, j) = C(row[i], row[j]);
    const Mat3 D = t[7] * L.transpose() * in_plane * L;
    const double z = section.thickness / 2 * (point.zeta - section.offset);
    stretching += D;
    coupling += z * D;
    sum.bending += z * z * D;
    Eigen::Matrix2d shears;  // rows 2 E23, 2 E13
    shears << t[6] * t[2], t[6] * t[3], t[6] * t[0], t[6] * t[1];
    sum.shear += t[7] * shears.transpose() * C.block<2, 2>(2, 2) * shears;
    for (int m = 0; m < 3 && section.bends_apart; ++m)
      sum.bending += t[7] / section.thickness * law::elastic_moment(section.bending[m], 0.0).C *
                     L.row(m).transpose() * L.row(m);
  }
  sum.bending -= coupling.transpose() * stretching.ldlt().solve(coupling);
  return sum;
}

// The components of a bend along an edge, over its curvature.
Vec3 bend_along(const Vec3& A1, const Vec3& A2, const Vec3& edge) {
  const double a = A1.dot(edge), b = A2.dot(edge);
  return Vec3(a * a, b * b, 2 * a * b) / edge.squaredNorm();
}

// p of an edge (see shell3.hpp); infinite without a stiffness of either kind, so that the shear is left
// whole.
double bending_over_shear(const VirginStiffness& of, const section::Section& section, const Vec3& A1,
                          const Vec3& A2, const Vec3& edge) {
  const double l2 = edge.squaredNorm(), a = A1.dot(edge), b = A2.dot(edge);
  const Vec3 kappa = bend_along(A1, A2, edge);
  const Eigen::Vector2d shear = section.thickness / 2 * Eigen::Vector2d(a, b) / std::sqrt(l2);
  const double B = kappa.dot(of.bending * kappa), S = shear.dot(of.shear * shear);
  constexpr double least = 1e-9;  // of S t^2: less bending is rounding
  if (!(S > 0) || !(B > least * S * section.thickness * section.thickness))
    return std::numeric_limits<double>::infinity();
  return 12 * B / (S * l2);
}

// The share of an edge's shear that is left to it where a part of the flexibility of its bending is added.
double share_of(double bending_over_shear, double part = 1) {
  return std::isinf(bending_over_shear) ? 1 : bending_over_shear / (part + bending_over_shear);
}

// The parts that quadrilaterals have of it: for the mean of two edges, and for their difference.
constexpr double kMeanPart = 1.0 / 8, kVaryingPart = 1.0 / 100;

// Share left of the deviation of a yarn's strain from its mean, less one. phi: the yarn's angle in (xi,
// eta) to the element's sides, as the mean over the points of sin^2(2 phi); stiffness: of the yarn over
// shear.
double eased(double oblique, double stiffness) {
  const double excess = stiffness / kHeldByShear - 1;
  if (!(excess > 0) || oblique < 1e-20) return 0;
  return 1 / std::sqrt(1 + oblique * excess) - 1;
}

// Writes the levers and the reference shears of the edges.
void put_shears(const section::Section& section, const PointFrame& middle, const WarpAt& warp,
                const Edges& free, const std::array<Vec3, 4>& D,
                const std::function<void(int, double)>& put) {
  const VirginStiffness stiffness = virgin_stiffness(section, middle, warp);
  for (int along = 0; along < 2; ++along) {
    const Vec3 line = 2 * (along == 0 ? middle.A1 : middle.A2);
    const double p = bending_over_shear(stiffness, section, middle.A1, middle.A2, line);
    const double mean = std::sqrt(share_of(p, kMeanPart)), varying = std::sqrt(share_of(p, kVaryingPart));
    const double own = section.thickness / 4 * (mean + varying),
                 other = section.thickness / 4 * (mean - varying);
    put(Shell4Layout::levers + along, own);
    put(Shell4Layout::levers + 2 + along, other);
    double product[2];
    for (int e = 0; e < 2; ++e) {
      const auto& [i, j] = kEdge[2 * along + e];
      product[e] = free.chord[2 * along + e].dot(D[i] + D[j]) / 2;
    }
    for (int e = 0; e < 2; ++e) put(2 * along + e, own * product[e] + other * product[1 - e]);
  }
}

}  // namespace

DegenerateElement::DegenerateElement(double jacobian)
    : Error("is degenerate or inverted: its Jacobian is " + number(jacobian) +
            ", expected a positive number") {}

void shell4_geometry(const section::Section& section, const std::array<Vec3, 4>& X,
                     const std::array<Vec3, 4>& D, const WarpAt& warp, double* geometry, int lane,
                     int stride) {
  shell4_rest_geometry(section, {X, D}, {X, D}, warp, geometry, lane, stride);
}

void shell4_rest_geometry(const section::Section& section, const Placed<4>& reference, const Placed<4>& free,
                          const WarpAt& warp, double* geometry, int lane, int stride) {
  const auto& [X, D] = reference;
  const Shell4Layout at(static_cast<int>(section.points.size()));
  const auto put = [&](int i, double v) { geometry[i * stride + lane] = v; };
  const Edges edges = edges_of(X, D);
  const Edges free_edges = edges_of(free.X, free.D);
  static const double g = 1 / std::sqrt(3.0);
  const double px[4] = {-g, g, g, -g}, py[4] = {-g, -g, g, g};
  double oblique[2] = {0, 0};
  for (int p = 0; p < gauss_points; ++p) {
    const PointFrame frame = frame_at(edges, X, D, px[p], py[p]),
                     bent = frame_at(free_edges, free.X, free.D, px[p], py[p]);
    const auto kappa = metric(bent.A1, bent.A2, bent.B1, bent.B2),
               rho = metric(bent.B1, bent.B2, bent.B1, bent.B2);
    for (int i = 0; i < 3; ++i) {
      put(at.reference(p) + i, kappa[i]);
      put(at.reference(p) + 3 + i, rho[i] / 2);
    }
    PointColumns columns(section, frame, warp);
    for (std::size_t k = 0; k < section.points.size(); ++k) {
      const auto column = columns(k, 1.0);
      for (int i = 0; i < 8; ++i) put(at.point(p, static_cast<int>(k)) + i, column[i]);
      for (int f = 0; f < 2 && k == 0; ++f) {
        const double by_xi = column[2 * f], by_eta = column[2 * f + 1];
        const double sine = 2 * by_xi * by_eta / (by_xi * by_xi + by_eta * by_eta);
        oblique[f] += sine * sine / gauss_points;
      }
    }
  }
  for (int f = 0; f < 2; ++f) put(Shell4Layout::easing + f, eased(oblique[f], section.yarns_over_shear[f]));
  const PointFrame middle = frame_at(edges, X, D, 0, 0);
  put_shears(section, middle, warp, free_edges, free.D, put);
  const int held = held_mode(section, edges, PointColumns(section, middle, warp)(0, 1.0));
  put_membrane(edges, weighing_tangent(section, middle, warp), held, put);
}

double shell3_rigidity(const section::Section& section, const std::array<Vec3, 3>& X,
                       const std::array<Vec3, 3>& D, const WarpAt& warp) {
  const Vec3 A1 = X[1] - X[0], A2 = X[2] - X[0];
  const PointFrame middle{
      (X[0] + X[1] + X[2]) / 3, (D[0] + D[1] + D[2]) / 3, A1, A2, D[1] - D[0], D[2] - D[0]};
  const Mat3 bending = virgin_stiffness(section, middle, warp).bending;
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& edge : {A1, A2, Vec3(A2 - A1)}) {
    const Vec3 kappa = bend_along(A1, A2, edge);
    least = std::min(least, kappa.dot(bending * kappa));
  }
  return std::max(0.0, least / A1.cross(A2).norm());  // that of the parallelogram
}

void shell3_geometry(const section::Section& section, const std::array<Vec3, 3>& X,
                     const std::array<Vec3, 3>& D, const WarpAt& warp, double* geometry, int lane,
                     int stride) {
  shell3_rest_geometry(section, {X, D}, {X, D}, warp, geometry, lane, stride);
}

void shell3_rest_geometry(const section::Section& section, const Placed<3>& reference, const Placed<3>& free,
                          const WarpAt& warp, double* geometry, int lane, int stride) {
  const auto& [X, D] = reference;
  const Shell3Layout at(static_cast<int>(section.points.size()));
  auto put = [&](int i, double v) { geometry[i * stride + lane] = v; };
  static constexpr int edge[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int e = 0; e < 3; ++e) {
    const auto [i, j] = std::pair(edge[e][0], edge[e][1]);
    put(e, section.thickness / 4 * (free.X[j] - free.X[i]).dot(free.D[i] + free.D[j]));
  }
  const Vec3 A1 = X[1] - X[0], A2 = X[2] - X[0], B1 = D[1] - D[0], B2 = D[2] - D[0];
  const Vec3 F1 = free.D[1] - free.D[0], F2 = free.D[2] - free.D[0];
  const auto membrane = metric(A1, A2, A1, A2), rho = metric(F1, F2, F1, F2);
  for (int i = 0; i < 3; ++i) put(3 + i, membrane[i] / 2);
  double bent[3];  // curvatures of the edges
  for (int e = 0; e < 3; ++e) {
    const auto [i, j] = std::pair(edge[e][0], edge[e][1]);
    bent[e] = 2 * (free.X[j] - free.X[i]).dot(lengthened((free.D[j] - free.D[i]) / 2));
  }
  const double kappa[3] = {bent[0], bent[1], bent[0] + bent[1] - bent[2]};
  const PointFrame middle{(X[0] + X[1] + X[2]) / 3, (D[0] + D[1] + D[2]) / 3, A1, A2, B1, B2};
  const VirginStiffness stiffness = virgin_stiffness(section, middle, warp);
  for (int e = 0; e < 3; ++e) {
    const Vec3 along = X[edge[e][1]] - X[edge[e][0]];
    const double p = bending_over_shear(stiffness, section, A1, A2, along);
    const double bend = -3 / ((1 + p) * section.thickness * along.squaredNorm());
    put(Shell3Layout::shares + e, share_of(p));
    put(Shell3Layout::bends + e, bend * A1.dot(along));
    put(Shell3Layout::bends + 3 + e, bend * A2.dot(along));
  }
  static constexpr double r[3] = {1.0 / 6, 2.0 / 3, 1.0 / 6}, s[3] = {1.0 / 6, 1.0 / 6, 2.0 / 3};
  for (int p = 0; p < shell3_points; ++p) {
    for (int i = 0; i < 3; ++i) {
      put(at.reference(p) + i, kappa[i]);
      put(at.reference(p) + 3 + i, rho[i] / 2);
    }
    const PointFrame frame{X[0] + r[p] * A1 + s[p] * A2, D[0] + r[p] * B1 + s[p] * B2, A1, A2, B1, B2};
    PointColumns columns(section, frame, warp);
    for (std::size_t k = 0; k < section.points.size(); ++k) {
      const auto column = columns(k, 1.0 / 6);
      for (int i = 0; i < 8; ++i) put(at.point(p, static_cast<int>(k)) + i, column[i]);
    }
  }
}

namespace {

constexpr double kAgree = 1e-11;

bool agree(double a, double b, double size) { return std::abs(a - b) <= kAgree * size; }

// The index in a lane's column at which its points begin, and the number of in-plane points.
struct PointColumn {
  const double* column;
  int first, in_plane;
};

// Compares two transforms without their weights.
bool same_transform(const double* a, const double* b) {
  const double size =
      std::max({std::abs(b[0]), std::abs(b[lanes]), std::abs(b[2 * lanes]), std::abs(b[3 * lanes])});
  for (int i = 0; i < 4; ++i)
    if (!agree(a[i * lanes], b[i * lanes], size)) return false;
  return agree(a[4 * lanes], 0, size) && agree(a[5 * lanes], 0, size) &&
         agree(a[6 * lanes], b[6 * lanes], std::abs(b[6 * lanes]));
}

bool same_through(const section::Section& section, const PointColumn& p, int strains) {
  const int points = static_cast<int>(section.points.size());
  constexpr int size = Shell4Layout::transform;
  for (int g = 0; g < p.in_plane; ++g) {
    const double* first = p.column + (p.first + size * points * g) * lanes;
    for (int k = 0; k < points; ++k) {
      const double* column = first + size * k * lanes;
      const double w = first[7 * lanes] * section.points[k].weight / section.points[0].weight;
      if (!same_transform(column, first) || !agree(column[7 * lanes], w, w)) return false;
    }
    // Converts the curvatures of the reference to strains with the thickness and the transform.
    const double T2 = first[0] * first[0] + first[lanes] * first[lanes] +
                      first[2 * lanes] * first[2 * lanes] + first[3 * lanes] * first[3 * lanes];
    for (int i = 0; i < 6; ++i)
      if (!agree(p.column[(strains + 6 * g + i) * lanes] * T2 * section.thickness *
                     (i < 3 ? 1 : section.thickness),
                 0, 1))
        return false;
  }
  return true;
}

bool same_in_plane(const PointColumn& p, int points) {
  constexpr int size = Shell4Layout::transform;
  for (int g = 1; g < p.in_plane; ++g) {
    const double *column = p.column + (p.first + size * points * g) * lanes,
                 *first = p.column + p.first * lanes;
    if (!same_transform(column, first) || !agree(column[7 * lanes], first[7 * lanes], first[7 * lanes]))
      return false;
  }
  return true;
}

bool is_parallelogram(const double* column) {
  const auto mode = [&](int i, int k) { return column[(Shell4Layout::modes + kSamples * i + k) * lanes]; };
  for (int i = 0; i < kEnhanced; ++i) {
    if (!agree(mode(i, 0), -mode(i, 1), 1) || !agree(mode(i, 2), -mode(i, 3), 1)) return false;
    for (int k = 4; k < kSamples; ++k)
      if (!agree(mode(i, k), 0, 1)) return false;
  }
  return agree(column[Shell4Layout::distortion * lanes], 0, 1) &&
         agree(column[(Shell4Layout::distortion + 1) * lanes], 0, 1);
}

}  // namespace

Sharing shell4_sharing(const section::Section& section, const double* geometry) {
  const int points = static_cast<int>(section.points.size());
  const Shell4Layout layout(points);
  Sharing sharing = Sharing::element;
  for (int l = 0; l < lanes; ++l) {
    const PointColumn p{geometry + l, layout.point(0, 0), gauss_points};
    if (!same_through(section, p, layout.reference(0))) return Sharing::none;
    if (!is_parallelogram(geometry + l) || !same_in_plane(p, points)) sharing = Sharing::through;
  }
  return sharing;
}

Sharing shell3_sharing(const section::Section& section, const double* geometry) {
  const Shell3Layout layout(static_cast<int>(section.points.size()));
  for (int l = 0; l < lanes; ++l)
    if (!same_through(section, {geometry + l, layout.point(0, 0), shell3_points}, layout.reference(0)))
      return Sharing::none;
  return Sharing::through;
}

}  // namespace fabricsh::element
