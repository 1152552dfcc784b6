// The element tangent in the unknowns of the strains: vectors of the position (two for a
// triangle, three for a quadrilateral) and two rotations per node. Rows of the strain
// operator that are zero for a kind of unknown are skipped, and only half of a symmetric
// law's tangent is computed. Included only by the *_isa.cpp files of this room.
#pragma once
#include <type_traits>

#include "element/shell_isa.hpp"

namespace fabricsh::element {
inline namespace FABRICSH_ISA {
namespace {

// The strains that depend on an unknown: six of the nine in the plane (eps kappa rho), eps and kappa for a
// position, kappa and rho for a director, and the two shears.
constexpr int kInPlane = 6, kReach = kInPlane + 2;
constexpr int kFirstOfX = 0, kFirstOfD = 3;      // the first of the six
constexpr int kEps = 0, kKappa = 3, kShear = 6;  // indices in a column of x
constexpr int kKappaOfD = 0, kRhoOfD = 3;        // and of d

// Columns of the strain operator: nx for the position (three per vector) and nd for the rotations.
template <int nx, int nd>
struct Columns {
  Pack x[nx][kReach], d[nd][kReach];
};

// Of a symmetric tangent dx is the transpose of xd and is left out.
template <int nx, int nd, bool symmetric>
struct Tangent {
  Pack xx[nx][nx], xd[nx][nd], dx[symmetric ? 1 : nd][nx], dd[nd][nd];
};

// Sets what add_material() adds to.
template <int nx, int nd, bool symmetric>
inline void clear(Tangent<nx, nd, symmetric>& K) {
  for (int r = 0; r < nx; ++r) {
    for (int c = symmetric ? r : 0; c < nx; ++c) K.xx[r][c] = Pack(0.0);
    for (int c = 0; c < nd; ++c) K.xd[r][c] = Pack(0.0);
  }
  for (int r = 0; r < nd; ++r) {
    for (int c = symmetric ? r : 0; c < nd; ++c) K.dd[r][c] = Pack(0.0);
    if constexpr (!symmetric)
      for (int c = 0; c < nx; ++c) K.dx[r][c] = Pack(0.0);
  }
}

// The 11x11 tangent of the resultants (N M K Q) by the strains (eps kappa rho g), whose entries are read
// where they are. Loops over it are unrolled, so that no index is computed at run time.
template <bool symmetric>
struct Resistance {
  explicit Resistance(const ThicknessMoments& stiffness) : k(stiffness) {
    for (int i = 0; i < 3; ++i)
      for (int j = symmetric ? i : 0; j < 3; ++j) M_by_kappa[i][j] = k.Z[2][i][j] + k.bending[i][j];
  }
  Pack operator()(int row, int column) const {
    const int a = row / 3, b = column / 3, i = row % 3, j = column % 3;  // 3, and 0 or 1: shears
    if (a == 3 && b == 3) return k.g_g[i][j];
    if (b == 3) return k.in_g[a][i][j];
    if (a == 3) return symmetric ? k.in_g[b][j][i] : k.g_in[b][i][j];
    const int r = symmetric && i > j ? j : i, c = symmetric && i > j ? i : j;
    return a == 1 && b == 1 ? M_by_kappa[r][c] : k.Z[a + b][r][c];
  }
  const ThicknessMoments& k;
  Pack M_by_kappa[3][3];
};

// Adds the change of the resultants by the tangent from strains p to strains `to`.
template <bool symmetric>
inline void add_change(const ThicknessMoments& k, const Strains& p, const Strains& to, Resultants& r) {
  const Resistance<symmetric> D(k);
  Pack by[11];
  for (int i = 0; i < 3; ++i) {
    by[i] = to.eps[i] - p.eps[i];
    by[3 + i] = to.kappa[i] - p.kappa[i];
    by[6 + i] = to.rho[i] - p.rho[i];
  }
  by[9] = to.g1 - p.g1;
  by[10] = to.g2 - p.g2;
  Pack* const of[4] = {r.N, r.M, r.K, r.Q};
  _Pragma("GCC unroll 11") for (int i = 0; i < 11; ++i) {
    Pack v = D(i, 0) * by[0];
    _Pragma("GCC unroll 11") for (int j = 1; j < 11; ++j) v += D(i, j) * by[j];
    of[i / 3][i % 3] += v;
  }
}

// Whether in-plane strains and transverse shears are coupled in some element. They are not where the
// directors are normal to the element.
template <bool symmetric>
inline bool coupled(const ThicknessMoments& k) {
  unsigned some = 0;
  for (int m = 0; m < 3; ++m)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 2; ++j) {
        some |= bits(!(k.in_g[m][i][j] == Pack(0.0)));
        if (!symmetric) some |= bits(!(k.g_in[m][j][i] == Pack(0.0)));
      }
  return some != 0;
}

// Whether a strain (0 to 7, as in a column) does not depend on position vector 0, 1 or 2: the curvature along
// the other base vector and, of a quadrilateral, its shear. Director: depends on all.
constexpr int kDirector = -1;
template <int nx>
constexpr bool absent(int vector, int strain) {
  return (vector == 0 || vector == 1) && (strain == 4 - vector || (nx == 9 && strain == 7 - vector));
}

// Calls visit(vector, unknown) for the first `count` position unknowns; the vector is a constant expression.
template <int nx, class Visit>
inline void each_position(int count, Visit visit) {
  for (int r = 0; r < (count < 3 ? count : 3); ++r) visit(std::integral_constant<int, 0>(), r);
  for (int r = 3; r < (count < 6 ? count : 6); ++r) visit(std::integral_constant<int, 1>(), r);
  if constexpr (nx == 9)
    for (int r = 6; r < count; ++r) visit(std::integral_constant<int, 2>(), r);
}

// D times a column b of the operator: `rows` in-plane rows, and the shears in the last two places.
template <bool coupled, int rows, int nx, int vector, class Resistance>
inline void times(const Resistance& D, const Pack (&b)[kReach], Pack (&out)[11]) {
  constexpr int first = vector == kDirector ? kFirstOfD : kFirstOfX;
  _Pragma("GCC unroll 11") for (int i = 0; i < 11; ++i) {
    if (i >= rows && i < 9) continue;
    const bool shear = i >= 9;
    Pack v = coupled || !shear ? D(i, first) * b[0] : Pack(0.0);
    _Pragma("GCC unroll 7") for (int j = 1; j < kReach; ++j) {
      const bool other = shear != (j >= kInPlane);
      if (!absent<nx>(vector, j) && (coupled || !other)) v += D(i, j < kInPlane ? first + j : 3 + j) * b[j];
    }
    out[i] = v;
  }
}

// The product of a column of the operator with a column that times() has written.
template <int nx, int vector>
inline Pack dot(const Pack (&a)[kReach], const Pack (&b)[11]) {
  constexpr int first = vector == kDirector ? kFirstOfD : kFirstOfX;
  Pack v = a[0] * b[first];
  _Pragma("GCC unroll 7") for (int j = 1; j < kReach; ++j) if (!absent<nx>(vector, j)) v +=
      a[j] * b[j < kInPlane ? first + j : 3 + j];
  return v;
}

template <bool coupled, int nx, int nd, bool symmetric>
inline void add_material_of(const Columns<nx, nd>& B, const Resistance<symmetric>& D,
                            Tangent<nx, nd, symmetric>& K) {
  Pack q[11];
  each_position<nx>(nx, [&](auto column, int c) {
    times<coupled, symmetric ? kInPlane : 9, nx, column.value>(D, B.x[c], q);
    each_position<nx>(symmetric ? c + 1 : nx,
                      [&](auto row, int r) { K.xx[r][c] += dot<nx, row.value>(B.x[r], q); });
    if constexpr (!symmetric)
      for (int r = 0; r < nd; ++r) K.dx[r][c] += dot<nx, kDirector>(B.d[r], q);
  });
  for (int c = 0; c < nd; ++c) {
    times<coupled, 9, nx, kDirector>(D, B.d[c], q);
    each_position<nx>(nx, [&](auto row, int r) { K.xd[r][c] += dot<nx, row.value>(B.x[r], q); });
    for (int r = 0; r < (symmetric ? c + 1 : nd); ++r) K.dd[r][c] += dot<nx, kDirector>(B.d[r], q);
  }
}

// K += B^T D B; for a symmetric D only the upper half of xx and dd, and xd.
template <int nx, int nd, bool symmetric>
inline void add_material(const Columns<nx, nd>& B, const ThicknessMoments& k, Tangent<nx, nd, symmetric>& K) {
  const Resistance<symmetric> D(k);
  coupled<symmetric>(k) ? add_material_of<true>(B, D, K) : add_material_of<false>(B, D, K);
}

// Completes a symmetric tangent.
template <int nx, int nd, bool symmetric>
inline void mirror(Tangent<nx, nd, symmetric>& K) {
  if constexpr (!symmetric) return;
  for (int c = 0; c < nx; ++c)
    for (int r = c + 1; r < nx; ++r) K.xx[r][c] = K.xx[c][r];
  for (int c = 0; c < nd; ++c)
    for (int r = c + 1; r < nd; ++r) K.dd[r][c] = K.dd[c][r];
}

// Adds a scalar times the unit matrix between two position vectors, or a vector between
// a position vector and a rotation. For symmetric terms; to be called after mirror().
template <int nx, int nd, bool symmetric>
inline void add_scalar(int p, int q, Pack s, Tangent<nx, nd, symmetric>& K) {
  for (int i = 0; i < 3; ++i) {
    K.xx[3 * p + i][3 * q + i] += s;
    if (p != q) K.xx[3 * q + i][3 * p + i] += s;
  }
}
template <int nx, int nd, bool symmetric>
inline void add_vector(int p, int column, V3 v, Tangent<nx, nd, symmetric>& K) {
  const Pack parts[3] = {v.x, v.y, v.z};
  for (int i = 0; i < 3; ++i) {
    K.xd[3 * p + i][column] += parts[i];
    if constexpr (!symmetric) K.dx[column][3 * p + i] += parts[i];
  }
}

// Writes the blocks of nodes in `wanted` (see ShellBatch) of K, COLUMN-major on (u, q) of each; node a has
// the weight coefficient[p][a] in vector p.
template <int vectors, int corners, bool symmetric>
inline void store_tangent(const Tangent<3 * vectors, 2 * corners, symmetric>& K,
                          const double (&coefficient)[vectors][corners], unsigned wanted, double* out) {
  constexpr int nx = 3 * vectors, nd = 2 * corners, dofs = 5 * corners;
  const auto at = [&](int r, int c) { return out + (dofs * c + r) * lanes; };
  const auto is_wanted = [&](int a, int b) { return (wanted >> (4 * a + b) & 1u) != 0; };
  for (int a = 0; a < corners; ++a)
    for (int i = 0; i < 3; ++i) {
      Pack row[nx];  // for node a, component i
      for (int c = 0; c < nx; ++c) {
        row[c] = Pack(coefficient[0][a]) * K.xx[i][c];
        for (int p = 1; p < vectors; ++p) row[c] += Pack(coefficient[p][a]) * K.xx[3 * p + i][c];
      }
      for (int b = 0; b < corners; ++b) {
        if (!is_wanted(a, b)) continue;
        for (int j = 0; j < 3; ++j) {
          Pack v = Pack(coefficient[0][b]) * row[j];
          for (int p = 1; p < vectors; ++p) v += Pack(coefficient[p][b]) * row[3 * p + j];
          store(at(5 * a + i, 5 * b + j), v);
        }
      }
      for (int c = 0; c < nd; ++c) {
        const int b = c / 2, of_director = 5 * b + 3 + c % 2;
        Pack right = Pack(coefficient[0][a]) * K.xd[i][c];
        for (int p = 1; p < vectors; ++p) right += Pack(coefficient[p][a]) * K.xd[3 * p + i][c];
        if (is_wanted(a, b)) store(at(5 * a + i, of_director), right);
        if (!is_wanted(b, a)) continue;
        Pack left = right;
        if constexpr (!symmetric) {
          left = Pack(coefficient[0][a]) * K.dx[c][i];
          for (int p = 1; p < vectors; ++p) left += Pack(coefficient[p][a]) * K.dx[c][3 * p + i];
        }
        store(at(of_director, 5 * a + i), left);
      }
    }
  for (int r = 0; r < nd; ++r)
    for (int c = 0; c < nd; ++c)
      if (is_wanted(r / 2, c / 2)) store(at(5 * (r / 2) + 3 + r % 2, 5 * (c / 2) + 3 + c % 2), K.dd[r][c]);
}

}  // namespace
}  // namespace FABRICSH_ISA
}  // namespace fabricsh::element
