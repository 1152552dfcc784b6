// The three-node companion of shell4.hpp (MITC3): the same sections, directors and degrees of freedom,
// linear in the plane; transverse shear from three edge midpoints, so that it does not lock [lee2004].
//
//   r, s in the triangle, N = (1 - r - s, r, s): membrane and curvature strains are constant;
//   g1 = g12 + c s,   g2 = g13 - c r,   c = g13 - g12 - g23,   g_ij = (t/4) (x_j - x_i).(d_i + d_j)
//
// This interpolation does not depend on the numbering of the corners [lee2004].
#pragma once
#include "element/shell4.hpp"

namespace fabricsh::element {

inline constexpr int shell3_points = 3;  // in the plane: (1/6, 1/6) (2/3, 1/6) (1/6, 2/3)
inline constexpr int shell3_dofs = 15;

// Reference geometry of one element, entry i of lane l at [i * lanes + l].
//   0..2  reference edge shears: edges 1-2, 1-3, 2-3;   3..5  membrane (A11/2, A22/2, A12)
//   then per in-plane point kappa (3), rho (3), and per in-plane and thickness point as Shell4Layout
struct Shell3Layout {
  explicit Shell3Layout(int thickness_points) : points(thickness_points) {}
  int points;
  static constexpr int head = 6, strains = 6, transform = 8;
  int reference(int g) const { return head + strains * g; }
  int point(int g, int k) const { return head + strains * shell3_points + transform * (points * g + k); }
  int size() const { return point(shell3_points, 0); }
};

// Like shell4_geometry.
void shell3_geometry(const section::Section& section, const std::array<Vec3, 3>& X,
                     const std::array<Vec3, 3>& D, const WarpAt& warp, double* geometry, int lane,
                     int stride);

// Like shell4_sharing; the result is at most `through`.
Sharing shell3_sharing(const section::Section& section, const double* geometry);

// Like Shell4Kernels, with 9 + 9 forces, 15x15 tangents and three in-plane points.
Shell4Kernels shell3_kernels(Isa isa);

}  // namespace fabricsh::element
