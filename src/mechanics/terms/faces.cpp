#include "mechanics/terms/faces.hpp"

#include <cmath>

#include "base/ordered_sum.hpp"
#include "geometry/node_view.hpp"
#include "geometry/turning.hpp"
#include "mechanics/mesh_tools.hpp"

namespace fabricsh::mechanics {

namespace {

// Shape functions of a face at a Gauss point: 2x2 points for a quadrilateral; one for a triangle, with its
// weight 1/2 included in N.
struct FacePoint {
  double N[4], N1[4], N2[4];
};

std::array<FacePoint, 4> quadrilateral_points() {
  constexpr double sx[4] = {-1, 1, 1, -1}, sy[4] = {-1, -1, 1, 1};
  std::array<FacePoint, 4> points;
  for (int g = 0; g < 4; ++g) {
    const double r = sx[g] / std::sqrt(3.0), s = sy[g] / std::sqrt(3.0);
    for (int a = 0; a < 4; ++a) {
      points[g].N[a] = (1 + sx[a] * r) * (1 + sy[a] * s) / 4;
      points[g].N1[a] = sx[a] * (1 + sy[a] * s) / 4;
      points[g].N2[a] = sy[a] * (1 + sx[a] * r) / 4;
    }
  }
  return points;
}

// Computed once: for each face anew they would take a third of an explicit step under pressure.
std::span<const FacePoint> points(const std::array<Index, 4>& face) {
  static const std::array<FacePoint, 4> four = quadrilateral_points();
  static const std::array<FacePoint, 1> one{{{{1.0 / 6, 1.0 / 6, 1.0 / 6, 0}, {-1, 1, 0, 0}, {-1, 0, 1, 0}}}};
  return corners(face) == 3 ? std::span<const FacePoint>(one) : std::span<const FacePoint>(four);
}

template <int n>
Vec3 tangent(const double (&derivative)[4], const Vec3* x) {
  Vec3 t = Vec3::Zero();
  for (int a = 0; a < n; ++a) t += derivative[a] * x[a];
  return t;
}

struct Tangents {
  Vec3 a1, a2;
};

Tangents tangents(const FacePoint& p, const std::array<Index, 4>& nodes, std::span<const double> x) {
  Vec3 corner[4];
  for (int a = 0; a < corners(nodes); ++a) corner[a] = at(x, nodes[a]);
  if (corners(nodes) == 3) return {tangent<3>(p.N1, corner), tangent<3>(p.N2, corner)};
  return {tangent<4>(p.N1, corner), tangent<4>(p.N2, corner)};
}

// Adds the forces of the pressure on one face, in the order of its points. Of a quadrilateral, two points
// each share a tangent: that along one side does not change along it.
template <int n>
void add_face(const std::array<Index, 4>& nodes, double pressure, std::span<const double> x,
              std::span<double> on_x) {
  constexpr int count = n == 3 ? 1 : 4, along_1[4] = {0, 0, 1, 1}, along_2[4] = {0, 1, 1, 0};
  const FacePoint* const face = points(nodes).data();
  Vec3 corner[n], force[n];
  for (int a = 0; a < n; ++a) {
    corner[a] = at(x, nodes[a]);
    force[a] = at(on_x, nodes[a]);
  }
  const Vec3 a1[2] = {tangent<n>(face[0].N1, corner), tangent<n>(face[count / 2].N1, corner)};
  const Vec3 a2[2] = {tangent<n>(face[0].N2, corner), tangent<n>(face[count / 4].N2, corner)};
  for (int g = 0; g < count; ++g) {
    const Vec3 f = pressure * a1[along_1[g]].cross(a2[along_2[g]]);
    for (int a = 0; a < n; ++a) force[a] += face[g].N[a] * f;
  }
  for (int a = 0; a < n; ++a) at(on_x, nodes[a]) = force[a];
}

}  // namespace

void add_pressure(std::span<const FaceNodes> faces, double pressure, std::span<const double> x,
                  std::span<double> on_x) {
  for (const auto& nodes : faces)
    if (corners(nodes) == 3)
      add_face<3>(nodes, pressure, x, on_x);
    else
      add_face<4>(nodes, pressure, x, on_x);
}

void add_pressure_tangent(std::span<const FaceNodes> faces, double pressure, std::span<const double> x,
                          TangentSink& sink) {
  for (const auto& nodes : faces) {
    Mat3 block[4][4];
    for (auto& row : block)
      for (auto& b : row) b.setZero();
    const int n = corners(nodes);
    for (const FacePoint& p : points(nodes)) {
      const Tangents t = tangents(p, nodes, x);
      const Mat3 C1 = cross_matrix(t.a1), C2 = cross_matrix(t.a2);
      // delta (a1 x a2) = -a2 x delta a1 + a1 x delta a2.
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) block[a][b] -= pressure * p.N[a] * (p.N2[b] * C1 - p.N1[b] * C2);
    }
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) sink.on_positions(nodes[a], nodes[b], block[a][b]);
  }
}

double volume_behind(std::span<const FaceNodes> faces, std::span<const double> x, const Vec3& from) {
  return ordered_sum(faces.size(), [&](std::size_t i) {
    double sum = 0;
    for (const FacePoint& p : points(faces[i])) {
      Vec3 place = Vec3::Zero();
      for (int a = 0; a < corners(faces[i]); ++a) place += p.N[a] * (at(x, faces[i][a]) - from);
      const Tangents t = tangents(p, faces[i], x);
      sum += place.dot(t.a1.cross(t.a2)) / 3;
    }
    return sum;
  });
}

double area_of(std::span<const FaceNodes> faces, std::span<const double> x) {
  return ordered_sum(faces.size(), [&](std::size_t i) {
    double sum = 0;
    const auto all = points(faces[i]);
    for (const FacePoint& p : all) {
      const Tangents t = tangents(p, faces[i], x);
      sum += t.a1.cross(t.a2).norm() / (all.size() == 1 ? 2 : 1);
    }
    return sum;
  });
}

}  // namespace fabricsh::mechanics
