// The batch kernels of the four-node shell; compiled once per instruction set. The mathematics is in
// shell4.hpp's head.
#include "element/shell_isa.hpp"

namespace fabricsh::element {
inline namespace FABRICSH_ISA {
namespace {

constexpr double kGauss = 0.57735026918962576451;  // 1 / sqrt(3)
constexpr double kXi[4] = {-kGauss, kGauss, kGauss, -kGauss};
constexpr double kEta[4] = {-kGauss, -kGauss, kGauss, kGauss};
constexpr double kSx[4] = {-1, 1, 1, -1};
constexpr double kSy[4] = {-1, -1, 1, 1};
constexpr int kEdge[4][2] = {{0, 1}, {3, 2}, {0, 3}, {1, 2}};  // two along xi, two along eta

constexpr double shape1(int g, int a) { return kSx[a] * (1 + kSy[a] * kEta[g]) / 4; }
constexpr double shape2(int g, int a) { return kSy[a] * (1 + kSx[a] * kXi[g]) / 4; }
// Weight of edge e in the assumed shear at in-plane point g: edges 0, 1 give g1, edges 2, 3 give g2.
constexpr double tie(int g, int e) {
  switch (e) {
    case 0:
      return (1 - kEta[g]) / 2;
    case 1:
      return (1 + kEta[g]) / 2;
    case 2:
      return (1 - kXi[g]) / 2;
    default:
      return (1 + kXi[g]) / 2;
  }
}

struct Nodes {
  V3 x[4], d[4];
};

// Assumed-shear samples 2 c_i3 at the four edge midpoints.
inline void edge_shears(const Nodes& n, const double* geometry, double thickness, Pack gamma[4]) {
  for (int e = 0; e < 4; ++e) {
    const int i = kEdge[e][0], j = kEdge[e][1];
    gamma[e] = Pack(thickness / 8) * dot(n.x[j] - n.x[i], n.d[i] + n.d[j]) - load(geometry + e * lanes);
  }
}

// The assumed membrane field: strains sampled on edge chords and in the middle, and what ties them to an
// in-plane point. Samples, in this order: c11 on the edges 4-3 (A) and 1-2 (B), c22 on 2-3 (C) and 1-4 (D);
// c11, c22, 2 c12 in the middle; and q = |in-plane part of x_d|^2 / 2 with x_d = sum xi eta x / 4. Then
//   c11 = (1 + eta)/2 A + (1 - eta)/2 B + (eta^2 - 1) q: the bilinear field, less the out-of-plane part of
//   x_d, which makes a warped element lock; c22 likewise; 2 c12 is the middle's constant strain carried to
//   the point.
constexpr int kSamples = 8;
constexpr int kChord[4][2] = {{3, 2}, {0, 1}, {1, 2}, {0, 3}};  // A B along xi, C D along eta

struct Membrane {
  V3 chord[4];    // half chords: a1 at A and B, a2 at C and D
  V3 mid1, mid2;  // a1 and a2 in the middle
  Pack strain[kSamples];
  Pack slope[7];       // dq / d(other samples)
  Pack w1, w2;         // x_d's in-plane components: w = G^-1 v, v = (x_d.a1, x_d.a2), G the middle's metric
  Pack G11, G12, G22;  // inverse of G
  Pack c1, c2;         // the same components in the reference
};

// q = v.G^-1 v / 2 from the other samples, which carry v and G; its slopes there.
inline Pack in_plane_distortion(const Pack s[7], Membrane& m) {
  const Pack half(0.5), two(2.0), one(1.0);
  const Pack v1 = half * (s[0] - s[1]), v2 = half * (s[2] - s[3]);
  const Pack g11 = two * s[4], g22 = two * s[5], g12 = s[6], over = one / (g11 * g22 - g12 * g12);
  m.G11 = g22 * over;
  m.G22 = g11 * over;
  m.G12 = -g12 * over;
  m.w1 = m.G11 * v1 + m.G12 * v2;
  m.w2 = m.G12 * v1 + m.G22 * v2;
  m.slope[0] = half * m.w1;
  m.slope[1] = -m.slope[0];
  m.slope[2] = half * m.w2;
  m.slope[3] = -m.slope[2];
  m.slope[4] = -m.w1 * m.w1;
  m.slope[5] = -m.w2 * m.w2;
  m.slope[6] = -m.w1 * m.w2;
  return half * (v1 * m.w1 + v2 * m.w2);
}

inline Membrane membrane(const Nodes& n, const double* geometry) {
  Membrane m;
  const Pack half(0.5);
  for (int e = 0; e < 4; ++e) m.chord[e] = half * (n.x[kChord[e][1]] - n.x[kChord[e][0]]);
  m.mid1 = half * (m.chord[0] + m.chord[1]);
  m.mid2 = half * (m.chord[2] + m.chord[3]);
  for (int e = 0; e < 4; ++e) m.strain[e] = half * dot(m.chord[e], m.chord[e]);
  m.strain[4] = half * dot(m.mid1, m.mid1);
  m.strain[5] = half * dot(m.mid2, m.mid2);
  m.strain[6] = dot(m.mid1, m.mid2);
  m.strain[7] = in_plane_distortion(m.strain, m);
  for (int i = 0; i < kSamples; ++i) m.strain[i] -= load(geometry + (4 + i) * lanes);
  m.c1 = load(geometry + 12 * lanes);
  m.c2 = load(geometry + 13 * lanes);
  return m;
}

// Weights of the samples in (c11, c22, 2 c12) at in-plane point g. The compatible shear s6 + r v1 + s v2 + 2
// r s q differs from the middle's strain carried to the point by D(r, s), which in-plane bending makes and
// which vanishes in a homogeneous strain. It is taken away as an enhanced strain: D in the middle's axes,
// times j0 / j, so that its mean over the element is zero and the patch test is passed [simo1990, section 3].
struct TieWeights {
  Pack w[3][kSamples];
};

inline TieWeights tie_weights(const Membrane& m, int g) {
  const double r = kXi[g], s = kEta[g];
  const Pack zero(0.0), one(1.0), two(2.0), rs(r * s);
  TieWeights t{{{Pack((1 + s) / 2), Pack((1 - s) / 2), zero, zero, zero, zero, zero, Pack(s * s - 1)},
                {zero, zero, Pack((1 + r) / 2), Pack((1 - r) / 2), zero, zero, zero, Pack(r * r - 1)},
                {Pack(r / 2), Pack(-r / 2), Pack(s / 2), Pack(-s / 2), zero, zero, one, two * rs}}};
  // A_i at the point = F_ij times A_j in the middle; j / j0 = det F = 1 + s c1 + r c2.
  const Pack F11 = one + Pack(s) * m.c1, F12 = Pack(s) * m.c2, F21 = Pack(r) * m.c1,
             F22 = one + Pack(r) * m.c2, over = one / (one + Pack(s) * m.c1 + Pack(r) * m.c2);
  Pack D[kSamples];
  for (int k = 0; k < kSamples; ++k) D[k] = t.w[2][k];
  D[4] = -two * m.c1 * (Pack(r) + m.c1 * rs);
  D[5] = -two * m.c2 * (Pack(s) + m.c2 * rs);
  D[6] = -(m.c2 * Pack(r) + m.c1 * Pack(s) + two * m.c1 * m.c2 * rs);
  const Pack carry[3] = {over * F11 * F12, over * F21 * F22, over * (F11 * F22 + F12 * F21)};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < kSamples; ++k) t.w[i][k] -= carry[i] * D[k];
  return t;
}

// Everything at one in-plane point that does not depend on the thickness coordinate.
struct InPlane : Strains {
  V3 a1, a2, b1, b2;
  TieWeights tie;
};

inline InPlane in_plane(const Nodes& n, const double* reference, const Membrane& m, const Pack gamma[4],
                        int g) {
  InPlane p;
  const Pack zero(0.0);
  p.a1 = p.a2 = p.b1 = p.b2 = {zero, zero, zero};
  for (int a = 0; a < 4; ++a) {
    p.a1 += Pack(shape1(g, a)) * n.x[a];
    p.a2 += Pack(shape2(g, a)) * n.x[a];
    p.b1 += Pack(shape1(g, a)) * n.d[a];
    p.b2 += Pack(shape2(g, a)) * n.d[a];
  }
  const Pack half(0.5);
  auto ref = [&](int i) { return load(reference + i * lanes); };
  p.tie = tie_weights(m, g);
  for (int i = 0; i < 3; ++i) {
    p.eps[i] = p.tie.w[i][0] * m.strain[0];
    for (int k = 1; k < kSamples; ++k) p.eps[i] += p.tie.w[i][k] * m.strain[k];
  }
  p.kappa[0] = dot(p.a1, p.b1) - ref(0);
  p.kappa[1] = dot(p.a2, p.b2) - ref(1);
  p.kappa[2] = dot(p.a1, p.b2) + dot(p.a2, p.b1) - ref(2);
  p.rho[0] = half * dot(p.b1, p.b1) - ref(3);
  p.rho[1] = half * dot(p.b2, p.b2) - ref(4);
  p.rho[2] = dot(p.b1, p.b2) - ref(5);
  p.g1 = Pack(tie(g, 0)) * gamma[0] + Pack(tie(g, 1)) * gamma[1];
  p.g2 = Pack(tie(g, 2)) * gamma[2] + Pack(tie(g, 3)) * gamma[3];
  return p;
}

struct Forces {
  V3 x[4], d[4];
  Pack edge[4];           // sum over points of Q times the tie weight, times t / 8
  Pack sample[kSamples];  // work-conjugate to the membrane samples
};

inline void add_force(const InPlane& p, const Resultants& r, double thickness, int g, Forces& f) {
  const V3 nx1 = r.M[0] * p.b1 + r.M[2] * p.b2;
  const V3 nx2 = r.M[2] * p.b1 + r.M[1] * p.b2;
  for (int k = 0; k < kSamples; ++k)
    f.sample[k] += p.tie.w[0][k] * r.N[0] + p.tie.w[1][k] * r.N[1] + p.tie.w[2][k] * r.N[2];
  const V3 nd1 = r.M[0] * p.a1 + r.M[2] * p.a2 + r.K[0] * p.b1 + r.K[2] * p.b2;
  const V3 nd2 = r.M[2] * p.a1 + r.M[1] * p.a2 + r.K[2] * p.b1 + r.K[1] * p.b2;
  for (int a = 0; a < 4; ++a) {
    f.x[a] += Pack(shape1(g, a)) * nx1 + Pack(shape2(g, a)) * nx2;
    f.d[a] += Pack(shape1(g, a)) * nd1 + Pack(shape2(g, a)) * nd2;
  }
  for (int e = 0; e < 4; ++e) f.edge[e] += Pack(tie(g, e) * thickness / 8) * r.Q[e / 2];
}

// Membrane forces: each sample's stretch works along its chord.
inline void add_membrane_forces(const Membrane& m, Forces& f) {
  for (int k = 0; k < 7; ++k) f.sample[k] += f.sample[7] * m.slope[k];
  const V3 mid1 = f.sample[4] * m.mid1 + f.sample[6] * m.mid2,
           mid2 = f.sample[5] * m.mid2 + f.sample[6] * m.mid1;
  const Pack half(0.5);
  for (int e = 0; e < 4; ++e) {
    const V3 along = half * (f.sample[e] * m.chord[e] + half * (e < 2 ? mid1 : mid2));
    f.x[kChord[e][1]] += along;
    f.x[kChord[e][0]] -= along;
  }
}

inline void add_edge_forces(const Nodes& n, Forces& f) {
  for (int e = 0; e < 4; ++e) {
    const int i = kEdge[e][0], j = kEdge[e][1];
    const V3 on_x = f.edge[e] * (n.d[i] + n.d[j]), on_d = f.edge[e] * (n.x[j] - n.x[i]);
    f.x[j] += on_x;
    f.x[i] -= on_x;
    f.d[i] += on_d;
    f.d[j] += on_d;
  }
}

inline Nodes load_nodes(const Shell4Batch& batch) {
  Nodes n;
  for (int a = 0; a < 4; ++a) {
    n.x[a] = load3(batch.x, 3 * a);
    n.d[a] = load3(batch.d, 3 * a);
  }
  return n;
}

inline void clear(Forces& f) {
  const V3 zero{Pack(0.0), Pack(0.0), Pack(0.0)};
  for (int a = 0; a < 4; ++a) f.x[a] = f.d[a] = zero, f.edge[a] = Pack(0.0);
  for (Pack& n : f.sample) n = Pack(0.0);
}

inline void store_forces(const Forces& f, double* out) {
  for (int a = 0; a < 4; ++a) {
    store3(out, 3 * a, f.x[a]);
    store3(out, 12 + 3 * a, f.d[a]);
  }
}

unsigned force(const section::Section& section, fabric::AtSwitch at, const Shell4Batch& batch, double* f) {
  const Nodes n = load_nodes(batch);
  const Shell4Layout layout(static_cast<int>(section.points.size()));
  Pack gamma[4];
  edge_shears(n, batch.geometry, section.thickness, gamma);
  const Membrane m = membrane(n, batch.geometry);
  Forces forces;
  clear(forces);
  unsigned failed = 0;
  for (int g = 0; g < gauss_points; ++g) {
    const InPlane p = in_plane(n, batch.geometry + layout.reference(g) * lanes, m, gamma, g);
    Resultants r;
    failed |= integrate(section, at, batch, batch.geometry + layout.point(g, 0) * lanes, p, g, r, nullptr);
    add_force(p, r, section.thickness, g, forces);
  }
  add_membrane_forces(m, forces);
  add_edge_forces(n, forces);
  store_forces(forces, f);
  return failed;
}

// Rows of the strain operator on (u, q): eps (0-2), kappa (3-5), rho (6-8), g (9, 10); column 5 A + dof.
struct Operator {
  Pack B[11][shell4_dofs];
};

inline void set3(Pack* row, int a, V3 v) {
  row[5 * a] = v.x;
  row[5 * a + 1] = v.y;
  row[5 * a + 2] = v.z;
}
inline void set2(Pack* row, int a, V3 v, const V3 (&b)[4][2]) {
  row[5 * a + 3] = dot(v, b[a][0]);
  row[5 * a + 4] = dot(v, b[a][1]);
}

// Rows of the membrane samples on (u, q): 7 x 20, the rotations' columns zero.
inline void fill_samples(const Membrane& m, Pack (&rows)[kSamples][shell4_dofs]) {
  const Pack half(0.5), quarter(0.25);
  for (auto& row : rows)
    for (Pack& v : row) v = Pack(0.0);
  const auto add = [](Pack* row, int node, V3 v) {
    row[5 * node] += v.x;
    row[5 * node + 1] += v.y;
    row[5 * node + 2] += v.z;
  };
  for (int e = 0; e < 4; ++e) {
    const int i = kChord[e][0], j = kChord[e][1];
    const V3 own = half * m.chord[e], mid = quarter * (e < 2 ? m.mid1 : m.mid2),
             other = quarter * (e < 2 ? m.mid2 : m.mid1);
    const Pack minus(-1.0);
    add(rows[e], j, own);
    add(rows[e], i, minus * own);
    add(rows[e < 2 ? 4 : 5], j, mid);
    add(rows[e < 2 ? 4 : 5], i, minus * mid);
    add(rows[6], j, other);
    add(rows[6], i, minus * other);
  }
  for (int c = 0; c < shell4_dofs; ++c) {
    Pack v = m.slope[0] * rows[0][c];
    for (int k = 1; k < 7; ++k) v += m.slope[k] * rows[k][c];
    rows[7][c] = v;
  }
}

inline void fill_in_plane(const InPlane& p, int g, const V3 (&b)[4][2],
                          const Pack (&samples)[kSamples][shell4_dofs], Operator& o) {
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < shell4_dofs; ++c) {
      Pack v = p.tie.w[i][0] * samples[0][c];
      for (int k = 1; k < kSamples; ++k) v += p.tie.w[i][k] * samples[k][c];
      o.B[i][c] = v;
    }
  const Pack zero(0.0);
  const V3 none{zero, zero, zero};
  for (int a = 0; a < 4; ++a) {
    const Pack N1(shape1(g, a)), N2(shape2(g, a));
    const V3 a11 = N1 * p.a1, a22 = N2 * p.a2, a12 = N1 * p.a2 + N2 * p.a1;
    const V3 b11 = N1 * p.b1, b22 = N2 * p.b2, b12 = N1 * p.b2 + N2 * p.b1;
    const V3 onx[9] = {none, none, none, b11, b22, b12, none, none, none};
    const V3 ond[9] = {none, none, none, a11, a22, a12, b11, b22, b12};
    for (int i = 3; i < 9; ++i) {
      set3(o.B[i], a, onx[i]);
      set2(o.B[i], a, ond[i], b);
    }
  }
}

inline void fill_edges(const Nodes& n, double thickness, const V3 (&b)[4][2], Pack (&edge)[4][shell4_dofs]) {
  const Pack h(thickness / 8), zero(0.0);
  for (int e = 0; e < 4; ++e) {
    for (Pack& v : edge[e]) v = zero;
    const int i = kEdge[e][0], j = kEdge[e][1];
    const V3 director = h * (n.d[i] + n.d[j]), chord = h * (n.x[j] - n.x[i]);
    set3(edge[e], j, director);
    set3(edge[e], i, Pack(-1.0) * director);
    set2(edge[e], i, chord, b);
    set2(edge[e], j, chord, b);
  }
}

// Scalar factors of the geometric stiffness between node pairs: displacement-displacement,
// displacement-director, director-director.
struct Geometric {
  Pack xx[4][4], xd[4][4], dd[4][4];
};

inline void add_geometric(const Resultants& r, int g, Geometric& k) {
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) {
      const Pack n11(shape1(g, a) * shape1(g, b)), n22(shape2(g, a) * shape2(g, b));
      const Pack n12(shape1(g, a) * shape2(g, b) + shape2(g, a) * shape1(g, b));
      k.xd[a][b] += n11 * r.M[0] + n22 * r.M[1] + n12 * r.M[2];
      k.dd[a][b] += n11 * r.K[0] + n22 * r.K[1] + n12 * r.K[2];
    }
}

// Second derivatives of the samples: quarters of the products of the nodes' signs on the chords.
inline void add_membrane_geometric(const Forces& f, Geometric& k) {
  // Signs of a1 (from chords A and B) and a2 (C and D) at the nodes, twice the derivative: mid1 = sum s1 x
  // / 4.
  for (int e = 0; e < 4; ++e) {
    const Pack n = Pack(0.25) * f.sample[e];
    const int i = kChord[e][0], j = kChord[e][1];
    k.xx[i][i] += n;
    k.xx[j][j] += n;
    k.xx[i][j] -= n;
    k.xx[j][i] -= n;
  }
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      k.xx[a][b] += Pack(kSx[a] * kSx[b] / 16) * f.sample[4] + Pack(kSy[a] * kSy[b] / 16) * f.sample[5] +
                    Pack((kSx[a] * kSy[b] + kSy[a] * kSx[b]) / 16) * f.sample[6];
}

// The second derivative of q beyond its slopes: y.G^-1 y with y = dv - dG w, two rows.
inline void add_distortion_geometric(const Membrane& m, const Forces& f,
                                     const Pack (&rows)[kSamples][shell4_dofs],
                                     Pack (&K)[shell4_dofs][shell4_dofs]) {
  const Pack half(0.5), two(2.0), n = f.sample[7];
  Pack y1[shell4_dofs], y2[shell4_dofs];
  for (int c = 0; c < shell4_dofs; ++c) {
    y1[c] = half * (rows[0][c] - rows[1][c]) - two * m.w1 * rows[4][c] - m.w2 * rows[6][c];
    y2[c] = half * (rows[2][c] - rows[3][c]) - m.w1 * rows[6][c] - two * m.w2 * rows[5][c];
  }
  for (int c = 0; c < shell4_dofs; ++c) {
    const Pack z1 = n * (m.G11 * y1[c] + m.G12 * y2[c]), z2 = n * (m.G12 * y1[c] + m.G22 * y2[c]);
    for (int r = 0; r < shell4_dofs; ++r) K[r][c] += y1[r] * z1 + y2[r] * z2;
  }
}

inline void add_edge_geometric(const Forces& f, Geometric& k) {
  for (int e = 0; e < 4; ++e) {
    const int i = kEdge[e][0], j = kEdge[e][1];
    for (int m : {i, j}) {
      k.xd[j][m] += f.edge[e];
      k.xd[i][m] -= f.edge[e];
    }
  }
}

inline void put_geometric(const Geometric& k, const Forces& f, const Nodes& n, const V3 (&b)[4][2],
                          Pack (&K)[shell4_dofs][shell4_dofs]) {
  for (int a = 0; a < 4; ++a)
    for (int c = 0; c < 4; ++c) {
      for (int i = 0; i < 3; ++i) K[5 * a + i][5 * c + i] += k.xx[a][c];
      for (int q = 0; q < 2; ++q) {
        const V3 v = k.xd[a][c] * b[c][q];
        const Pack parts[3] = {v.x, v.y, v.z};
        for (int i = 0; i < 3; ++i) {
          K[5 * a + i][5 * c + 3 + q] += parts[i];
          K[5 * c + 3 + q][5 * a + i] += parts[i];
        }
        for (int p = 0; p < 2; ++p) K[5 * a + 3 + p][5 * c + 3 + q] += k.dd[a][c] * dot(b[a][p], b[c][q]);
      }
    }
  for (int a = 0; a < 4; ++a) {
    const Pack along = dot(f.d[a], n.d[a]);  // second variation of the director: delta2 d = -(q.q) d
    K[5 * a + 3][5 * a + 3] -= along;
    K[5 * a + 4][5 * a + 4] -= along;
  }
}

unsigned tangent(const section::Section& section, fabric::AtSwitch at, const Shell4Batch& batch, double* f,
                 double* out) {
  const Nodes n = load_nodes(batch);
  V3 b[4][2];
  for (int a = 0; a < 4; ++a)
    for (int q = 0; q < 2; ++q) b[a][q] = load3(batch.b, 6 * a + 3 * q);
  const Shell4Layout layout(static_cast<int>(section.points.size()));
  Pack gamma[4], edge[4][shell4_dofs], samples[kSamples][shell4_dofs], K[shell4_dofs][shell4_dofs];
  edge_shears(n, batch.geometry, section.thickness, gamma);
  const Membrane m = membrane(n, batch.geometry);
  fill_edges(n, section.thickness, b, edge);
  fill_samples(m, samples);
  Forces forces;
  clear(forces);
  Geometric geometric;
  for (auto* block : {geometric.xx, geometric.xd, geometric.dd})
    for (int a = 0; a < 4; ++a)
      for (int c = 0; c < 4; ++c) block[a][c] = Pack(0.0);
  for (auto& row : K)
    for (Pack& v : row) v = Pack(0.0);
  unsigned failed = 0;
  Operator o;
  for (int g = 0; g < gauss_points; ++g) {
    const InPlane p = in_plane(n, batch.geometry + layout.reference(g) * lanes, m, gamma, g);
    Resultants r;
    Stiffness k;
    failed |= integrate(section, at, batch, batch.geometry + layout.point(g, 0) * lanes, p, g, r, &k);
    add_force(p, r, section.thickness, g, forces);
    fill_in_plane(p, g, b, samples, o);
    for (int c = 0; c < shell4_dofs; ++c) {
      o.B[9][c] = Pack(tie(g, 0)) * edge[0][c] + Pack(tie(g, 1)) * edge[1][c];
      o.B[10][c] = Pack(tie(g, 2)) * edge[2][c] + Pack(tie(g, 3)) * edge[3][c];
    }
    add_material(o.B, k, K);
    add_geometric(r, g, geometric);
  }
  add_membrane_forces(m, forces);
  add_edge_forces(n, forces);
  add_membrane_geometric(forces, geometric);
  add_distortion_geometric(m, forces, samples, K);
  add_edge_geometric(forces, geometric);
  put_geometric(geometric, forces, n, b, K);
  store_forces(forces, f);
  for (int r = 0; r < shell4_dofs; ++r)
    for (int c = 0; c < shell4_dofs; ++c) store(out + (shell4_dofs * r + c) * lanes, K[r][c]);
  return failed;
}

void strain(const section::Section& section, const Shell4Batch& batch, double* E) {
  const Nodes n = load_nodes(batch);
  const int points = static_cast<int>(section.points.size());
  const Shell4Layout layout(points);
  Pack gamma[4];
  edge_shears(n, batch.geometry, section.thickness, gamma);
  const Membrane m = membrane(n, batch.geometry);
  for (int g = 0; g < gauss_points; ++g) {
    const InPlane p = in_plane(n, batch.geometry + layout.reference(g) * lanes, m, gamma, g);
    for (int k = 0; k < points; ++k)
      material_strain(p, transform(batch.geometry + layout.point(g, k) * lanes), height(section, k),
                      E + (g * points + k) * 5 * lanes);
  }
}

void curvature(const section::Section& section, const Shell4Batch& batch, double* kappa) {
  const Nodes n = load_nodes(batch);
  const Shell4Layout layout(static_cast<int>(section.points.size()));
  Pack gamma[4];
  edge_shears(n, batch.geometry, section.thickness, gamma);
  const Membrane m = membrane(n, batch.geometry);
  constexpr int row[3] = {0, 1, 4};
  for (int g = 0; g < gauss_points; ++g) {
    const InPlane p = in_plane(n, batch.geometry + layout.reference(g) * lanes, m, gamma, g);
    const Transform t = transform(batch.geometry + layout.point(g, 0) * lanes);
    for (int i = 0; i < 3; ++i) {
      const Pack* L = t.L[row[i]];
      store(kappa + (3 * g + i) * lanes, L[0] * p.kappa[0] + L[1] * p.kappa[1] + L[2] * p.kappa[2]);
    }
  }
}

}  // namespace

Shell4Kernels shell4_kernels_of_isa() { return {&force, &tangent, &strain, &curvature}; }

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::element
