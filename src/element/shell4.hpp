// The four-node degenerated shell with assumed transverse shear (MITC4): total Lagrangian,
// finite rotations of the directors, 2x2 points in the plane, and the section's points
// through the thickness. [williams2010, ch. 5] with the corrections of share/doc/theory.md;
// MITC4: [dvorkin1984].
//
//   x(xi, eta, zeta) = sum_A N_A (x_A + z d_A),   z = (t/2)(zeta - zeta_bar)
//
// Generalised covariant strains at an in-plane point, where a_i = sum N_A,i x_A, and b_i are
// derivatives of the directors, with edge differences lengthened from the chord to the arc:
//   c(z) = eps + z kappa + z^2 rho in the order (c11, c22, 2 c12);
//   kappa ~ sym(a.b),  rho ~ b.b / 2;  shear g_i = 2 c_i3 from the four edge midpoints, eased as below; eps
//   from an assumed field: stretches on edge chords, tied so that a warped element does not lock (MITC4+
//   [ko2017]), and the four enhanced strains of [simo1990; andelfinger1993], eliminated with a constant
//   tangent: they are a fixed multiple of the deviation from a homogeneous strain. See
//   share/doc/verification.md.
//
// An edge bends as a circle, and sheets much more limp in bending than in shear would lock: between two held
// rotations sum (theta_i + theta_j) h / 2 = w_j - w_i along any line of edges. A part c of the residual
// flexibility in bending of [macneal1978] is in series with the shear S of two opposite edges,
//   1 / S -> 1 / S + c h^2 / (12 B),
// h: the mean of their lengths, B: of virgin cloth along them. c = 1 is right for a beam that bends by forces
// at its nodes; a plate, where part of the shear force is of the twist, would be too soft (7.5 % clamped on 8
// x 8). c = 1/8 for the mean of the two edges, 1/100 for their difference, which is the twist's: more of it
// would soften free edges in torsion. See share/doc/verification.md. Mean and difference of the shears are
// multiplied by sqrt(p / (c + p)), p = 12 B / (S h^2), as in shell3.hpp: S is that of the section.
//
// Yarns that cross an element obliquely would lock it: their strain eps_f = m_f.eps m_f (f: warp, weft)
// varies along them, and in cloth only shear, which is far softer, could hold such a change of tension along
// a yarn. Of the deviation of eps_f from its mean over the element only a share is kept,
//   share^2 = 1 / (1 + sin^2(2 phi) <E_f / (20 G) - 1>),
// where phi is the angle in (xi, eta) between the yarn and the element's sides: the modulus of the yarn in
// series with what shear can hold. It is one for yarns along the sides at all points and for isotropic sheets
// (E / G up to four). Curvatures keep their variation. The strain is a linear function of the assumed one, so
// that forces and tangents are derivatives of the same energy; shear keeps its variation and its points.
#pragma once
#include <array>
#include <functional>

#include "base/error.hpp"
#include "geometry/vec.hpp"
#include "section/section.hpp"
#include "simd/isa.hpp"

namespace fabricsh::element {

inline constexpr int gauss_points = 4;  // in the plane, in the order (-,-) (+,-) (+,+) (-,+)
inline constexpr int shell4_dofs = 20;  // per node: u1 u2 u3, q1 q2 with delta d = q1 b1 + q2 b2

inline constexpr int kSamples = 8, kEnhanced = 4;  // of the assumed membrane strain field

// Reference geometry of one element, as the kernels read it; entry i of lane l at [i * lanes + l].
// - edge shears (t/8)(X_j - X_i).(D_i + D_j), eased: edges 4-3, 1-2, 2-3, 1-4
// - levers: the shear of an edge over its product of chord and director (t/2, eased), for the first two edges
//   and the others; then over that of the edge opposite, likewise
// - membrane samples: c11 on the first two edges, c22 on the others; c11, c22, 2 c12 in the middle; q
// - distortion: components of X_d = sum xi eta X / 4 on the middle's base vectors
// - modes: the enhanced strains from the samples, 4 x 8, row-major
// - easing: for warp and weft, the share of the variation of their strain within the element that is left,
//   less one: 0 leaves the strain as it is, -1 takes its mean everywhere
// - then per in-plane point: kappa (3), rho (3) of the reference
// - then per in-plane point and thickness point: T11 T12 T21 T22 q1 q2 s w
//
// where T_ij takes covariant to material components (T_ij = G^j . m_i), q_j = G^j . m_3, s = G^3 . m_3, w =
// weight J, m^3.
struct Shell4Layout {
  explicit Shell4Layout(int thickness_points) : points(thickness_points) {}
  int points;
  static constexpr int levers = 4, samples = 8, distortion = samples + kSamples, modes = distortion + 2,
                       easing = modes + kEnhanced * kSamples, head = easing + 2, strains = 6, transform = 8;
  int reference(int g) const { return head + strains * g; }
  int point(int g, int k) const { return head + strains * gauss_points + transform * (points * g + k); }
  int size() const { return point(gauss_points, 0); }
};

// How far the transforms of an element's points are equal, which lets a force kernel read and compute less.
//   through: one transform for all points through the thickness, because the directors are parallel; kappa,
//   rho, q1, q2 are zero. element: the same, and one transform for all in-plane points, as in a
//   parallelogram; its enhanced modes depend only on differences of opposite chords.
enum class Sharing { none, through, element };

// The sharing that holds for all lanes, to a relative tolerance of 1e-11, since coordinates have rounding.
Sharing shell4_sharing(const section::Section& section, const double* geometry);

// Warp direction at a point with the given unit normal, global, not yet projected on the surface.
using WarpAt = std::function<Vec3(const Vec3& X, const Vec3& normal)>;

// The element is degenerate or inverted at an in-plane point (J <= 0). The text continues the element's name.
class DegenerateElement : public Error {
 public:
  explicit DegenerateElement(double jacobian);
};

// Nodes (m) and unit directors of an element.
template <std::size_t corners>
struct Placed {
  std::array<Vec3, corners> X, D;
};

// Fills the geometry column of one lane. X, D: reference nodes (m) and unit directors.
// Errors: DegenerateElement; those of `warp`.
void shell4_geometry(const section::Section& section, const std::array<Vec3, 4>& X,
                     const std::array<Vec3, 4>& D, const WarpAt& warp, double* geometry, int lane,
                     int stride);
// The same for an element that is free of moments and transverse shear elsewhere; of `unbent` only the
// curvature and the shear strain count.
void shell4_rest_geometry(const section::Section& section, const Placed<4>& reference,
                          const Placed<4>& unbent, const WarpAt& warp, double* geometry, int lane,
                          int stride);

// Current state of a batch of elements, structure of arrays: entry i of lane l at [i * lanes + l].
struct ShellBatch {
  const double* geometry;
  const double* x;   // 12 (triangle: 9): component i of node A at 3 A + i, m
  const double* d;   // directors, in the same order
  const double* b;   // 24 (18): b1 then b2 per node, at 6 A + 3 (alpha) + i; tangent only
  const double* s0;  // committed law states, [gauss][section state]
  double* s1;        // trial law states; null in place
  Sharing sharing = Sharing::none;
  bool law_only = false;  // tangent: B^T C B only, without the parts of stress and rotating directors
  // If `changed` is null, s0 is read and all of s1 is written. Otherwise the states are updated in place:
  // `now` is s0, and `changed` has one byte per number of the states, in which bit l is set if the number of
  // lane l has changed. The old numbers of a pack with such a lane are appended to `log`, part after part of
  // the batch; it must have room for all of them.
  unsigned char* changed = nullptr;
  double* now = nullptr;  // two copies: in a tangent the branches (law/branches.hpp), if any; then the forces
                          // are linear about the strains predicted, as the tangent is
  double** log = nullptr;  // the end of the log
  int first_lane = 0;      // of the part of the batch that a kernel works on
  // The tangent's blocks of nodes a and b that are written: bit 4 a + b.
  unsigned wanted = 0xffff;
  // tangent: the nodes before the last step, 12 numbers of x and 12 of d (triangle: 9 each). The strains are
  // then those that the step predicted linearly, without the parts that are quadratic in its displacements.
  // Null: the strains of x and d.
  const double* before_x = nullptr;
  const double* before_d = nullptr;
};
using Shell4Batch = ShellBatch;

// All return the mask of the lanes whose law failed.
// f   24 per lane: internal force on x (12, N) and on d (12, N m), the derivative of the internal energy.
// K   20x20 per lane, column-major, as far as wanted: tangent on (u, q), with the second variation -(f_d . d)
// I2 of the directors for the INTERNAL force. E   [gauss][point][5] material strains, doubled shears.
using Shell4Force = unsigned (*)(const section::Section&, const law::Step&, const Shell4Batch&, double* f);
using Shell4Tangent = unsigned (*)(const section::Section&, const law::Step&, const Shell4Batch&, double* f,
                                   double* K);
using Shell4Strain = void (*)(const section::Section&, const Shell4Batch&, double* E);
// kappa  [gauss][3] material curvatures k11 k22 2k12 at the section's first thickness point, 1/m.
using Shell4Curvature = Shell4Strain;
// Mask of the inverted lanes: (a1 x a2).d is not positive at some in-plane point.
using Shell4Inverted = unsigned (*)(const Shell4Batch&);
// Mask of the lanes in which a director's cosine with the element's normal is below the given one, or in
// which (chord . delta)^2 of an edge is above `bent`, with half the chord (m) and half the directors'
// difference.
using Shell4Astray = unsigned (*)(const Shell4Batch&, double cosine, double bent);
struct Shell4Kernels {
  Shell4Force force;
  Shell4Tangent tangent;
  Shell4Strain strain;
  Shell4Curvature curvature;
  Shell4Inverted inverted;
  Shell4Astray astray;
  int width = lanes;  // of the parts of a batch
};
Shell4Kernels shell4_kernels(Isa isa);

}  // namespace fabricsh::element
