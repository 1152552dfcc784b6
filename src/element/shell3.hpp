// The three-node companion of shell4.hpp: the same sections, directors and degrees of freedom. Membrane
// strains are constant. The directors vary linearly and, in addition, by a parabola along each edge, which is
// eliminated in advance [katili1993]: a thin triangle bends as Kirchhoff's plate along its edges.
//
//   r, s in the triangle, N = (1 - r - s, r, s);   g_e = (t/4) (x_j - x_i).(d_i + d_j) of edge e = i - j
//   parabola of an edge:  4 N_i N_j D_e A_e,   A_e = X_j - X_i,   D_e = -(1 - f_e) 3 g_e / (t A_e.A_e)
//   f_e = p / (1 + p),  p = 12 B / (S A_e.A_e):  the share of g_e that remains shear, as in Timoshenko's beam
//       along the edge; B, S are the stiffness of virgin cloth in bending and of its shear in that direction
//   kappa: that of the nodes' directors and that of the parabolas; of this the part that varies within the
//       element counts kVarying times, since triangles with only it bend too easily where edges are clamped
//   shear from the edges' f_e g_e, interpolated as in [lee2004]:
//       g1 = g12 + c s,   g2 = g13 - c r,   c = g13 - g12 - g23
//
// Both parts are functions of the three g_e, which are zero in rigid motions and in constant curvature;
// forces are the derivative of an energy with any law. Nothing depends on the numbering of the corners.
#pragma once
#include "element/shell4.hpp"

namespace fabricsh::element {

inline constexpr int shell3_points = 3;  // in the plane: (1/6, 1/6) (2/3, 1/6) (1/6, 2/3)
inline constexpr int shell3_dofs = 15;
inline constexpr double kVarying = 1.2247448713915890;  // sqrt(3/2), see share/doc/verification.md

// Reference geometry of one element, entry i of lane l at [i * lanes + l].
//   0..2  reference edge shears: edges 1-2, 1-3, 2-3;   3..5  membrane (A11/2, A22/2, A12)
//   6..8  f_e of these edges;   9..11, 12..14  A_1.A_e and A_2.A_e times D_e / g_e
//   then per in-plane point kappa (3), rho (3), and per in-plane and thickness point as Shell4Layout
struct Shell3Layout {
  explicit Shell3Layout(int thickness_points) : points(thickness_points) {}
  int points;
  static constexpr int shares = 6, bends = 9, head = 15, strains = 6, transform = 8;
  int reference(int g) const { return head + strains * g; }
  int point(int g, int k) const { return head + strains * shell3_points + transform * (points * g + k); }
  int size() const { return point(shell3_points, 0); }
};

// Like shell4_geometry and shell4_rest_geometry.
void shell3_geometry(const section::Section& section, const std::array<Vec3, 3>& X,
                     const std::array<Vec3, 3>& D, const WarpAt& warp, double* geometry, int lane,
                     int stride);
void shell3_rest_geometry(const section::Section& section, const Placed<3>& reference,
                          const Placed<3>& unbent, const WarpAt& warp, double* geometry, int lane,
                          int stride);

// N m: the least rigidity of virgin cloth in bending along an edge, zero where nothing bends.
double shell3_rigidity(const section::Section& section, const std::array<Vec3, 3>& X,
                       const std::array<Vec3, 3>& D, const WarpAt& warp);

// Like shell4_sharing; the result is at most `through`.
Sharing shell3_sharing(const section::Section& section, const double* geometry);

// Like Shell4Kernels, with 9 + 9 forces, 15x15 tangents and three in-plane points.
Shell4Kernels shell3_kernels(Isa isa);

}  // namespace fabricsh::element
