// Directions of the deformed yarns. At each in-plane point the material direction m_i = T_i1 G_1 + T_i2 G_2
// of the reference has become T_i1 a_1 + T_i2 a_2. Transform and base vectors belong to the same point: in
// quadrilaterals that are no parallelograms both change from point to point.
#include <cmath>

#include "geometry/node_view.hpp"
#include "mechanics/terms/cloth.hpp"

namespace fabricsh::mechanics {

namespace {

// The thickness point at which the yarns are read: the middle one of the ply, or of all plies. The two that
// count folds, the second of which has a negative weight, are at the end of each ply (section.cpp).
int middle_point(const section::Section& section, int ply) {
  std::vector<int> found;
  const int points = static_cast<int>(section.points.size());
  for (int k = 0; k < points; ++k) {
    const bool folds = section.points[k].weight < 0 || (k + 1 < points && section.points[k + 1].weight < 0);
    if (!folds && (ply == Cloth::all_plies || section.points[k].ply == ply)) found.push_back(k);
  }
  return found[found.size() / 2];
}

// The base vectors a_1 + eta d and a_2 + xi d, in a triangle without d.
struct Bases {
  Vec3 a1, a2, d = Vec3::Zero();
};

Bases bases(const std::array<Vec3, 4>& p, int corners) {
  if (corners == 3) return {p[1] - p[0], p[2] - p[0]};
  return {(p[1] + p[2] - p[0] - p[3]) / 4, (p[2] + p[3] - p[0] - p[1]) / 4, (p[0] + p[2] - p[1] - p[3]) / 4};
}

}  // namespace

std::pair<Vec3, Vec3> Cloth::yarns(Index element, int ply) const {
  const BatchLane place = place_[element];
  const Batch& batch = batches_[place.batch];
  const BatchKind& kind = *batch.kind;
  const auto& section = *batch.section;
  const int k = middle_point(section, ply), points = static_cast<int>(section.points.size());
  const auto& point = section.points[k];
  const double z = section.thickness / 2 * (point.zeta - section.offset);
  std::array<Vec3, 4> p;
  for (int a = 0; a < kind.corners; ++a) {
    const Index node = batch.nodes[place.lane][a];
    p[a] = at(configuration_.x(), node) + z * at(configuration_.d(), node);
  }
  const Bases base = bases(p, kind.corners);
  // Sums over the in-plane points of T_i1 and T_i2, and of T_i1 eta + T_i2 xi.
  constexpr int xi[] = {-1, 1, 1, -1}, eta[] = {-1, -1, 1, 1};
  double T[4] = {}, by[2] = {};
  for (int g = 0; g < kind.in_plane; ++g) {
    const double* t = batch.geometry + kind.point(g, k, points) * lanes + place.lane;
    for (int i = 0; i < 4; ++i) T[i] += t[i * lanes];
    for (int i = 0; i < 2; ++i) by[i] += t[2 * i * lanes] * eta[g] + t[(2 * i + 1) * lanes] * xi[g];
  }
  const double away = 1 / std::sqrt(3.0);  // of the points from the middle
  const Vec3 warp = T[0] * base.a1 + T[1] * base.a2 + away * by[0] * base.d,
             weft = T[2] * base.a1 + T[3] * base.a2 + away * by[1] * base.d;
  const double angle = ply == all_plies ? point.angle - section.common_angle() : 0;
  if (angle == 0) return {warp.normalized(), weft.normalized()};
  const double c = std::cos(angle), s = std::sin(angle);
  return {(c * warp - s * weft).normalized(), (s * warp + c * weft).normalized()};
}

}  // namespace fabricsh::mechanics
