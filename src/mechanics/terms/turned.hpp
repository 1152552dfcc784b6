// Stiffness that is turned with the elements of a batch.
#pragma once
#include <Eigen/Cholesky>
#include <array>

#include "geometry/turning.hpp"
#include "mechanics/batch.hpp"

namespace fabricsh::mechanics {

// Positions (m) and axes of the directors of a batch's corners, as ShellBatch has them.
struct Placement {
  const double *x, *b;
  Vec3 position(int corner, int lane) const { return three(x, 3 * corner, lane); }
  Vec3 axis(int corner, int which, int lane) const { return three(b, 6 * corner + 3 * which, lane); }

 private:
  static Vec3 three(const double* all, int i, int lane) {
    return {all[i * lanes + lane], all[(i + 1) * lanes + lane], all[(i + 2) * lanes + lane]};
  }
};

// The rotation of an element by its mean spin w on the way, by Cayley's formula. Where Newmark's method turns
// a body in a circle, its velocities times the step have w = 2 tan(angle / 2): the angle is that of the step.
inline Mat3 rotation(const Placement& from, const Placement& to, int corners, int lane) {
  std::array<Vec3, 4> r, u;
  Vec3 centre = Vec3::Zero(), way = Vec3::Zero();
  for (int a = 0; a < corners; ++a) {
    r[a] = from.position(a, lane);
    u[a] = to.position(a, lane) - r[a];
    centre += r[a] / corners;
    way += u[a] / corners;
  }
  Mat3 inertia = Mat3::Zero();
  Vec3 momentum = Vec3::Zero();
  for (int a = 0; a < corners; ++a) {
    r[a] -= centre;
    inertia += r[a].squaredNorm() * Mat3::Identity() - r[a] * r[a].transpose();
    momentum += r[a].cross(u[a] - way);
  }
  inertia += 1e-12 * inertia.trace() * Mat3::Identity();  // corners on a line have no spin about it
  const Vec3 w = inertia.ldlt().solve(momentum);
  const Mat3 W = cross_matrix(w);
  return Mat3::Identity() + (W + W * W / 2) / (1 + w.squaredNorm() / 4);
}

// Turns the blocks `wanted` (see ShellBatch) of a batch's tangent K at `from` with its elements.
inline void turn_tangent(int corners, const Placement& from, const Placement& to, unsigned wanted,
                         double* K) {
  using Block = Eigen::Matrix<double, 5, 5>;
  const int dofs = 5 * corners;
  for (int l = 0; l < lanes; ++l) {
    const Mat3 R = rotation(from, to, corners, l);
    std::array<Block, 4> turn;
    for (int a = 0; a < corners; ++a) {
      turn[a].setZero();
      turn[a].topLeftCorner<3, 3>() = R;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) turn[a](3 + i, 3 + j) = to.axis(a, i, l).dot(R * from.axis(a, j, l));
    }
    for (int a = 0; a < corners; ++a)
      for (int b = 0; b < corners; ++b) {
        if ((wanted >> (4 * a + b) & 1u) == 0) continue;
        const auto entry = [&](int i, int j) -> double& {
          return K[(dofs * (5 * b + j) + 5 * a + i) * lanes + l];
        };
        Block k;
        for (int j = 0; j < 5; ++j)
          for (int i = 0; i < 5; ++i) k(i, j) = entry(i, j);
        const Block turned = turn[a] * k * turn[b].transpose();
        for (int j = 0; j < 5; ++j)
          for (int i = 0; i < 5; ++i) entry(i, j) = turned(i, j);
      }
  }
}

}  // namespace fabricsh::mechanics
