// The batch kernels of the three-node shell; the mathematics is in shell3.hpp's head.
#include "element/shell3.hpp"
#include "element/shell_isa.hpp"

namespace fabricsh::element {
inline namespace FABRICSH_ISA {
namespace {

constexpr double kR[3] = {1.0 / 6, 2.0 / 3, 1.0 / 6}, kS[3] = {1.0 / 6, 1.0 / 6, 2.0 / 3};
constexpr int kEdge[3][2] = {{0, 1}, {0, 2}, {1, 2}};
constexpr double kN1[3] = {-1, 1, 0}, kN2[3] = {-1, 0, 1};
// Weights of the edge shears in g1 and g2 at in-plane point g.
constexpr double tie1(int g, int e) { return e == 0 ? 1 - kS[g] : e == 1 ? kS[g] : -kS[g]; }
constexpr double tie2(int g, int e) { return e == 1 ? 1 - kR[g] : kR[g]; }

// The element's nodes, base vectors and strains; the shears are set point by point.
struct Triangle {
  V3 x[3], d[3], a1, a2, b1, b2;
  Pack gamma[3];
  Strains strains;
};

inline Triangle load_triangle(const section::Section& section, const ShellBatch& batch) {
  Triangle t;
  for (int a = 0; a < 3; ++a) {
    t.x[a] = load3(batch.x, 3 * a);
    t.d[a] = load3(batch.d, 3 * a);
  }
  t.a1 = t.x[1] - t.x[0];
  t.a2 = t.x[2] - t.x[0];
  t.b1 = t.d[1] - t.d[0];
  t.b2 = t.d[2] - t.d[0];
  const auto ref = [&](int i) { return load(batch.geometry + i * lanes); };
  for (int e = 0; e < 3; ++e) {
    const int i = kEdge[e][0], j = kEdge[e][1];
    t.gamma[e] = Pack(section.thickness / 4) * dot(t.x[j] - t.x[i], t.d[i] + t.d[j]) - ref(e);
  }
  const Pack half(0.5);
  Strains& p = t.strains;
  p.eps[0] = half * dot(t.a1, t.a1) - ref(3);
  p.eps[1] = half * dot(t.a2, t.a2) - ref(4);
  p.eps[2] = dot(t.a1, t.a2) - ref(5);
  p.kappa[0] = dot(t.a1, t.b1) - ref(6);
  p.kappa[1] = dot(t.a2, t.b2) - ref(7);
  p.kappa[2] = dot(t.a1, t.b2) + dot(t.a2, t.b1) - ref(8);
  p.rho[0] = half * dot(t.b1, t.b1) - ref(9);
  p.rho[1] = half * dot(t.b2, t.b2) - ref(10);
  p.rho[2] = dot(t.b1, t.b2) - ref(11);
  return t;
}

inline Strains strains_at(const Triangle& t, int g) {
  Strains p = t.strains;
  p.g1 = p.g2 = Pack(0.0);
  for (int e = 0; e < 3; ++e) {
    p.g1 += Pack(tie1(g, e)) * t.gamma[e];
    p.g2 += Pack(tie2(g, e)) * t.gamma[e];
  }
  return p;
}

inline const double* columns_at(const section::Section& section, const ShellBatch& batch, int g) {
  return batch.geometry + Shell3Layout(static_cast<int>(section.points.size())).point(g, 0) * lanes;
}

// The resultants' sum over the points, and the edge shears' conjugates (times t / 4).
struct Totals {
  Resultants r;
  Pack edge[3];
};

inline void clear(Totals& s) {
  clear(s.r);
  for (Pack& e : s.edge) e = Pack(0.0);
}

inline void add(const Resultants& r, double thickness, int g, Totals& s) {
  for (int i = 0; i < 3; ++i) {
    s.r.N[i] += r.N[i];
    s.r.M[i] += r.M[i];
    s.r.K[i] += r.K[i];
    s.edge[i] += Pack(thickness / 4) * (Pack(tie1(g, i)) * r.Q[0] + Pack(tie2(g, i)) * r.Q[1]);
  }
}

struct Forces3 {
  V3 x[3], d[3];
};

inline Forces3 forces_of(const Triangle& t, const Totals& s) {
  const Resultants& r = s.r;
  const V3 x1 = r.N[0] * t.a1 + r.N[2] * t.a2 + r.M[0] * t.b1 + r.M[2] * t.b2;
  const V3 x2 = r.N[2] * t.a1 + r.N[1] * t.a2 + r.M[2] * t.b1 + r.M[1] * t.b2;
  const V3 d1 = r.M[0] * t.a1 + r.M[2] * t.a2 + r.K[0] * t.b1 + r.K[2] * t.b2;
  const V3 d2 = r.M[2] * t.a1 + r.M[1] * t.a2 + r.K[2] * t.b1 + r.K[1] * t.b2;
  Forces3 f;
  for (int a = 0; a < 3; ++a) {
    f.x[a] = Pack(kN1[a]) * x1 + Pack(kN2[a]) * x2;
    f.d[a] = Pack(kN1[a]) * d1 + Pack(kN2[a]) * d2;
  }
  for (int e = 0; e < 3; ++e) {
    const int i = kEdge[e][0], j = kEdge[e][1];
    const V3 on_x = s.edge[e] * (t.d[i] + t.d[j]), on_d = s.edge[e] * (t.x[j] - t.x[i]);
    f.x[j] += on_x;
    f.x[i] -= on_x;
    f.d[i] += on_d;
    f.d[j] += on_d;
  }
  return f;
}

inline void store_forces(const Forces3& f, double* out) {
  for (int a = 0; a < 3; ++a) {
    store3(out, 3 * a, f.x[a]);
    store3(out, 9 + 3 * a, f.d[a]);
  }
}

unsigned force(const section::Section& section, fabric::AtSwitch at, const ShellBatch& batch, double* f) {
  const Triangle t = load_triangle(section, batch);
  Totals s;
  clear(s);
  unsigned failed = 0;
  for (int g = 0; g < shell3_points; ++g) {
    Resultants r;
    failed |= integrate(section, at, batch, columns_at(section, batch, g), strains_at(t, g), g, r, nullptr);
    add(r, section.thickness, g, s);
  }
  store_forces(forces_of(t, s), f);
  return failed;
}

inline void put(Pack* row, int a, V3 on_x, V3 on_d, const V3 (&b)[3][2]) {
  row[5 * a] += on_x.x;
  row[5 * a + 1] += on_x.y;
  row[5 * a + 2] += on_x.z;
  for (int q = 0; q < 2; ++q) row[5 * a + 3 + q] += dot(on_d, b[a][q]);
}

// Rows of the strain operator: eps, kappa, rho (0-8) for all points, and those of the edge shears.
inline void fill(const Triangle& t, double thickness, const V3 (&b)[3][2], Pack (&B)[11][shell3_dofs],
                 Pack (&edge)[3][shell3_dofs]) {
  const Pack zero(0.0);
  const V3 none{zero, zero, zero};
  for (auto& row : B)
    for (Pack& v : row) v = zero;
  for (auto& row : edge)
    for (Pack& v : row) v = zero;
  for (int a = 0; a < 3; ++a) {
    const Pack n1(kN1[a]), n2(kN2[a]);
    const V3 a11 = n1 * t.a1, a22 = n2 * t.a2, a12 = n1 * t.a2 + n2 * t.a1;
    const V3 b11 = n1 * t.b1, b22 = n2 * t.b2, b12 = n1 * t.b2 + n2 * t.b1;
    const V3 on_x[9] = {a11, a22, a12, b11, b22, b12, none, none, none};
    const V3 on_d[9] = {none, none, none, a11, a22, a12, b11, b22, b12};
    for (int i = 0; i < 9; ++i) put(B[i], a, on_x[i], on_d[i], b);
  }
  const Pack h(thickness / 4), minus(-1.0);
  for (int e = 0; e < 3; ++e) {
    const int i = kEdge[e][0], j = kEdge[e][1];
    const V3 director = h * (t.d[i] + t.d[j]), chord = h * (t.x[j] - t.x[i]);
    put(edge[e], j, director, chord, b);
    put(edge[e], i, minus * director, chord, b);
  }
}

// Second variation at fixed resultants, node pair by node pair.
inline void add_geometric(const Totals& s, const Forces3& f, const Triangle& t, const V3 (&b)[3][2],
                          Pack (&K)[shell3_dofs][shell3_dofs]) {
  const Resultants& r = s.r;
  Pack xd[3][3];
  for (int a = 0; a < 3; ++a)
    for (int c = 0; c < 3; ++c) {
      const Pack n11(kN1[a] * kN1[c]), n22(kN2[a] * kN2[c]), n12(kN1[a] * kN2[c] + kN2[a] * kN1[c]);
      const Pack xx = n11 * r.N[0] + n22 * r.N[1] + n12 * r.N[2];
      const Pack dd = n11 * r.K[0] + n22 * r.K[1] + n12 * r.K[2];
      xd[a][c] = n11 * r.M[0] + n22 * r.M[1] + n12 * r.M[2];
      for (int i = 0; i < 3; ++i) K[5 * a + i][5 * c + i] += xx;
      for (int p = 0; p < 2; ++p)
        for (int q = 0; q < 2; ++q) K[5 * a + 3 + p][5 * c + 3 + q] += dd * dot(b[a][p], b[c][q]);
    }
  for (int e = 0; e < 3; ++e)
    for (const int m : kEdge[e]) {
      xd[kEdge[e][1]][m] += s.edge[e];
      xd[kEdge[e][0]][m] -= s.edge[e];
    }
  for (int a = 0; a < 3; ++a) {
    for (int c = 0; c < 3; ++c)
      for (int q = 0; q < 2; ++q) {
        const V3 v = xd[a][c] * b[c][q];
        const Pack parts[3] = {v.x, v.y, v.z};
        for (int i = 0; i < 3; ++i) {
          K[5 * a + i][5 * c + 3 + q] += parts[i];
          K[5 * c + 3 + q][5 * a + i] += parts[i];
        }
      }
    const Pack along = dot(f.d[a], t.d[a]);  // second variation of the director: delta2 d = -(q.q) d
    for (int q = 3; q < 5; ++q) K[5 * a + q][5 * a + q] -= along;
  }
}

unsigned tangent(const section::Section& section, fabric::AtSwitch at, const ShellBatch& batch, double* f,
                 double* out) {
  const Triangle t = load_triangle(section, batch);
  V3 b[3][2];
  for (int a = 0; a < 3; ++a)
    for (int q = 0; q < 2; ++q) b[a][q] = load3(batch.b, 6 * a + 3 * q);
  Pack B[11][shell3_dofs], edge[3][shell3_dofs], K[shell3_dofs][shell3_dofs];
  fill(t, section.thickness, b, B, edge);
  for (auto& row : K)
    for (Pack& v : row) v = Pack(0.0);
  Totals s;
  clear(s);
  unsigned failed = 0;
  for (int g = 0; g < shell3_points; ++g) {
    Resultants r;
    Stiffness k;
    failed |= integrate(section, at, batch, columns_at(section, batch, g), strains_at(t, g), g, r, &k);
    add(r, section.thickness, g, s);
    for (int c = 0; c < shell3_dofs; ++c) {
      B[9][c] = B[10][c] = Pack(0.0);
      for (int e = 0; e < 3; ++e) {
        B[9][c] += Pack(tie1(g, e)) * edge[e][c];
        B[10][c] += Pack(tie2(g, e)) * edge[e][c];
      }
    }
    add_material(B, k, K);
  }
  const Forces3 forces = forces_of(t, s);
  add_geometric(s, forces, t, b, K);
  store_forces(forces, f);
  for (int r = 0; r < shell3_dofs; ++r)
    for (int c = 0; c < shell3_dofs; ++c) store(out + (shell3_dofs * r + c) * lanes, K[r][c]);
  return failed;
}

void strain(const section::Section& section, const ShellBatch& batch, double* E) {
  const Triangle t = load_triangle(section, batch);
  const int points = static_cast<int>(section.points.size());
  for (int g = 0; g < shell3_points; ++g) {
    const Strains p = strains_at(t, g);
    const double* columns = columns_at(section, batch, g);
    for (int k = 0; k < points; ++k)
      material_strain(p, transform(columns + k * transform_size * lanes), height(section, k),
                      E + (g * points + k) * 5 * lanes);
  }
}

void curvature(const section::Section& section, const ShellBatch& batch, double* kappa) {
  const Triangle t = load_triangle(section, batch);
  constexpr int row[3] = {0, 1, 4};
  for (int g = 0; g < shell3_points; ++g) {
    const Transform to = transform(columns_at(section, batch, g));
    for (int i = 0; i < 3; ++i) {
      const Pack* L = to.L[row[i]];
      const Pack* k = t.strains.kappa;
      store(kappa + (3 * g + i) * lanes, L[0] * k[0] + L[1] * k[1] + L[2] * k[2]);
    }
  }
}

}  // namespace

Shell4Kernels shell3_kernels_of_isa() { return {&force, &tangent, &strain, &curvature}; }

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::element
