// The element tangent in the unknowns of the strains: vectors of the position (two for a
// triangle, three for a quadrilateral) and two rotations per node. Rows of the strain
// operator that are zero for a kind of unknown are skipped, and only half of a symmetric
// law's tangent is computed. Included only by the *_isa.cpp files of this room.
#pragma once
#include "element/shell_isa.hpp"

namespace fabricsh::element {
inline namespace FABRICSH_ISA {
namespace {

constexpr int kReach = 8;                                // number of strains that depend on an unknown
constexpr int kOfX[kReach] = {0, 1, 2, 3, 4, 5, 9, 10};  // position: eps kappa g
constexpr int kOfD[kReach] = {3, 4, 5, 6, 7, 8, 9, 10};  // director: kappa rho g
constexpr int kEps = 0, kKappa = 3, kShear = 6;          // indices in a column of x
constexpr int kKappaOfD = 0, kRhoOfD = 3;                // and of d

// Columns of the strain operator: nx for the position (three per vector) and nd for the rotations.
template <int nx, int nd>
struct Columns {
  Pack x[nx][kReach], d[nd][kReach];
};

template <int nx, int nd>
struct Tangent {
  Pack xx[nx][nx], xd[nx][nd], dx[nd][nx], dd[nd][nd];
};

template <int nx, int nd>
inline void clear(Tangent<nx, nd>& K) {
  Pack* p = &K.xx[0][0];
  for (unsigned i = 0; i < sizeof(K) / sizeof(Pack); ++i) p[i] = Pack(0.0);
}

inline Pack dot8(const Pack* a, const Pack* b) {
  Pack v = a[0] * b[0];
  for (int j = 1; j < kReach; ++j) v += a[j] * b[j];
  return v;
}

// The 11x11 tangent of the resultants. The loops are unrolled, so that no index is computed at run time.
template <bool symmetric>
inline void put_stiffness(const Stiffness& k, Pack (&D)[11][11]) {
  _Pragma("GCC unroll 3") for (int a = 0; a < 3; ++a) _Pragma("GCC unroll 3") for (int i = 0; i < 3; ++i) {
    _Pragma("GCC unroll 3") for (int b = 0; b < 3; ++b) _Pragma("GCC unroll 3") for (int j = 0; j < 3; ++j) {
      const int r = symmetric && i > j ? j : i, c = symmetric && i > j ? i : j;
      D[3 * a + i][3 * b + j] = a == 1 && b == 1 ? k.Z[2][r][c] + k.bending[r][c] : k.Z[a + b][r][c];
    }
    _Pragma("GCC unroll 2") for (int j = 0; j < 2; ++j) {
      D[3 * a + i][9 + j] = k.in_g[a][i][j];
      D[9 + j][3 * a + i] = symmetric ? k.in_g[a][i][j] : k.g_in[a][j][i];
    }
  }
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) D[9 + i][9 + j] = k.g_g[i][j];
}

// The rows `rows` of D times a column of the operator whose nonzero strains are `reach`.
template <int n>
inline void times(const Pack (&D)[11][11], const int (&rows)[n], const int (&reach)[kReach],
                  const Pack (&b)[kReach], Pack (&out)[n]) {
  for (int i = 0; i < n; ++i) {
    Pack v = D[rows[i]][reach[0]] * b[0];
    for (int j = 1; j < kReach; ++j) v += D[rows[i]][reach[j]] * b[j];
    out[i] = v;
  }
}

// K += B^T D B; for a symmetric D only the upper half of xx and dd, and xd.
template <bool symmetric, int nx, int nd>
inline void add_material(const Columns<nx, nd>& B, const Stiffness& k, Tangent<nx, nd>& K) {
  Pack D[11][11], on_x[kReach], on_d[kReach];
  put_stiffness<symmetric>(k, D);
  for (int c = 0; c < nx; ++c) {
    times(D, kOfX, kOfX, B.x[c], on_x);
    for (int r = 0; r < (symmetric ? c + 1 : nx); ++r) K.xx[r][c] += dot8(B.x[r], on_x);
    if (symmetric) continue;
    times(D, kOfD, kOfX, B.x[c], on_d);
    for (int r = 0; r < nd; ++r) K.dx[r][c] += dot8(B.d[r], on_d);
  }
  for (int c = 0; c < nd; ++c) {
    times(D, kOfX, kOfD, B.d[c], on_x);
    times(D, kOfD, kOfD, B.d[c], on_d);
    for (int r = 0; r < nx; ++r) K.xd[r][c] += dot8(B.x[r], on_x);
    for (int r = 0; r < (symmetric ? c + 1 : nd); ++r) K.dd[r][c] += dot8(B.d[r], on_d);
  }
}

template <int nx, int nd>
inline void mirror(Tangent<nx, nd>& K) {
  for (int c = 0; c < nx; ++c) {
    for (int r = c + 1; r < nx; ++r) K.xx[r][c] = K.xx[c][r];
    for (int r = 0; r < nd; ++r) K.dx[r][c] = K.xd[c][r];
  }
  for (int c = 0; c < nd; ++c)
    for (int r = c + 1; r < nd; ++r) K.dd[r][c] = K.dd[c][r];
}

// Adds a scalar times the unit matrix between two position vectors, or a vector between
// a position vector and a rotation. For symmetric terms; to be called after mirror().
template <int nx, int nd>
inline void add_scalar(int p, int q, Pack s, Tangent<nx, nd>& K) {
  for (int i = 0; i < 3; ++i) {
    K.xx[3 * p + i][3 * q + i] += s;
    if (p != q) K.xx[3 * q + i][3 * p + i] += s;
  }
}
template <int nx, int nd>
inline void add_vector(int p, int column, V3 v, Tangent<nx, nd>& K) {
  const Pack parts[3] = {v.x, v.y, v.z};
  for (int i = 0; i < 3; ++i) {
    K.xd[3 * p + i][column] += parts[i];
    K.dx[column][3 * p + i] += parts[i];
  }
}

// Writes K to the nodes, COLUMN-major on (u, q) of each; node a has the weight share[p][a] in vector p.
template <int vectors, int corners>
inline void store_tangent(const Tangent<3 * vectors, 2 * corners>& K, const double (&share)[vectors][corners],
                          double* out) {
  constexpr int nx = 3 * vectors, nd = 2 * corners, dofs = 5 * corners;
  const auto at = [&](int r, int c) { return out + (dofs * c + r) * lanes; };
  for (int a = 0; a < corners; ++a)
    for (int i = 0; i < 3; ++i) {
      Pack row[nx];  // for node a, component i
      for (int c = 0; c < nx; ++c) {
        row[c] = Pack(share[0][a]) * K.xx[i][c];
        for (int p = 1; p < vectors; ++p) row[c] += Pack(share[p][a]) * K.xx[3 * p + i][c];
      }
      for (int b = 0; b < corners; ++b)
        for (int j = 0; j < 3; ++j) {
          Pack v = Pack(share[0][b]) * row[j];
          for (int p = 1; p < vectors; ++p) v += Pack(share[p][b]) * row[3 * p + j];
          store(at(5 * a + i, 5 * b + j), v);
        }
      for (int c = 0; c < nd; ++c) {
        Pack right = Pack(share[0][a]) * K.xd[i][c], left = Pack(share[0][a]) * K.dx[c][i];
        for (int p = 1; p < vectors; ++p) {
          right += Pack(share[p][a]) * K.xd[3 * p + i][c];
          left += Pack(share[p][a]) * K.dx[c][3 * p + i];
        }
        store(at(5 * a + i, 5 * (c / 2) + 3 + c % 2), right);
        store(at(5 * (c / 2) + 3 + c % 2, 5 * a + i), left);
      }
    }
  for (int r = 0; r < nd; ++r)
    for (int c = 0; c < nd; ++c) store(at(5 * (r / 2) + 3 + r % 2, 5 * (c / 2) + 3 + c % 2), K.dd[r][c]);
}

}  // namespace
}  // namespace FABRICSH_ISA
}  // namespace fabricsh::element
