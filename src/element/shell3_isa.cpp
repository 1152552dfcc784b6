// The batch kernels of the three-node shell; the mathematics is described at the top of shell3.hpp. The
// curvature of the nodes' directors is that of the three edges, (x_j - x_i).(d_j - d_i), each lengthened to
// the arc as in shell4.hpp: kappa11 of 1-2, kappa22 of 1-3, and 2 kappa12 both less that of 2-3.
#include "element/shell3.hpp"
#include "element/shell_stiffness_isa.hpp"

namespace fabricsh::element {
inline namespace FABRICSH_ISA {
namespace {

constexpr double kR[3] = {1.0 / 6, 2.0 / 3, 1.0 / 6}, kS[3] = {1.0 / 6, 1.0 / 6, 2.0 / 3};
constexpr int kEdge[3][2] = {{0, 1}, {0, 2}, {1, 2}};
constexpr double kN1[3] = {-1, 1, 0}, kN2[3] = {-1, 0, 1};
// Weights of the edge shears in g1 and g2 at in-plane point g.
constexpr double tie1(int g, int e) { return e == 0 ? 1 - kS[g] : e == 1 ? kS[g] : -kS[g]; }
constexpr double tie2(int g, int e) { return e == 1 ? 1 - kR[g] : kR[g]; }

// Derivatives by r and by s of the parabola 4 N_i N_j of edge e at in-plane point g, with the part that
// varies within the element times kVarying.
constexpr double slope(int g, int e, const double (&n)[3]) {
  const double N[3] = {1 - kR[g] - kS[g], kR[g], kS[g]};
  const int i = kEdge[e][0], j = kEdge[e][1];
  const double Ni = 1.0 / 3 + kVarying * (N[i] - 1.0 / 3), Nj = 1.0 / 3 + kVarying * (N[j] - 1.0 / 3);
  return 4 * (Ni * n[j] + Nj * n[i]);
}
constexpr double slope1(int g, int e) { return slope(g, e, kN1); }
constexpr double slope2(int g, int e) { return slope(g, e, kN2); }

// Nodes, base vectors and strains of the element; curvatures and shears are completed for each point.
struct Triangle {
  V3 x[3], d[3], a1, a2, b1, b2;
  ArcEdge edge[3];
  Pack gamma[3], share[3], bend1[3], bend2[3];  // of the edges
  Strains strains;
};

// Strains that a unit of g_e adds at in-plane point g: curvatures 11, 22, 2 12 and shears 13, 23.
struct OfEdge {
  Pack kappa[3], shear[2];
};
inline OfEdge of_edge(const Triangle& t, int g, int e) {
  const Pack by_r(slope1(g, e)), by_s(slope2(g, e));
  return {{by_r * t.bend1[e], by_s * t.bend2[e], by_s * t.bend1[e] + by_r * t.bend2[e]},
          {Pack(tie1(g, e)) * t.share[e], Pack(tie2(g, e)) * t.share[e]}};
}

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
    ArcEdge& edge = t.edge[e];
    edge.chord = Pack(0.5) * (t.x[j] - t.x[i]);
    edge.mean = Pack(0.5) * (t.d[i] + t.d[j]);
    edge.delta = Pack(0.5) * (t.d[j] - t.d[i]);
    lengthen(edge);
    t.gamma[e] = Pack(section.thickness) * dot(edge.chord, edge.mean) - ref(e);
    t.share[e] = ref(Shell3Layout::shares + e);
    t.bend1[e] = ref(Shell3Layout::bends + e);
    t.bend2[e] = ref(Shell3Layout::bends + 3 + e);
  }
  const Pack half(0.5);
  constexpr int bent = Shell3Layout::head;
  Strains& p = t.strains;
  p.eps[0] = half * dot(t.a1, t.a1) - ref(3);
  p.eps[1] = half * dot(t.a2, t.a2) - ref(4);
  p.eps[2] = dot(t.a1, t.a2) - ref(5);
  Pack k[3];
  for (int e = 0; e < 3; ++e) k[e] = Pack(4.0) * dot(t.edge[e].chord, t.edge[e].beta);
  p.kappa[0] = k[0] - ref(bent);
  p.kappa[1] = k[1] - ref(bent + 1);
  p.kappa[2] = k[0] + k[1] - k[2] - ref(bent + 2);
  p.rho[0] = half * dot(t.b1, t.b1) - ref(bent + 3);
  p.rho[1] = half * dot(t.b2, t.b2) - ref(bent + 4);
  p.rho[2] = dot(t.b1, t.b2) - ref(bent + 5);
  return t;
}

inline Strains strains_at(const Triangle& t, int g) {
  Strains p = t.strains;
  p.g1 = p.g2 = Pack(0.0);
  for (int e = 0; e < 3; ++e) {
    const OfEdge of = of_edge(t, g, e);
    for (int i = 0; i < 3; ++i) p.kappa[i] += of.kappa[i] * t.gamma[e];
    p.g1 += of.shear[0] * t.gamma[e];
    p.g2 += of.shear[1] * t.gamma[e];
  }
  return p;
}

inline const double* columns_at(const section::Section& section, const ShellBatch& batch, int g) {
  return batch.geometry + Shell3Layout(static_cast<int>(section.points.size())).point(g, 0) * lanes;
}

// The sum of the resultants over the points, and the conjugates of the edge shears (times t / 4).
struct ResultantSums {
  Resultants r;
  Pack edge[3];
};

inline void clear(ResultantSums& s) {
  clear(s.r);
  for (Pack& e : s.edge) e = Pack(0.0);
}

inline void add(const Triangle& t, const Resultants& r, double thickness, int g, ResultantSums& s) {
  for (int i = 0; i < 3; ++i) {
    s.r.N[i] += r.N[i];
    s.r.M[i] += r.M[i];
    s.r.K[i] += r.K[i];
    const OfEdge of = of_edge(t, g, i);
    s.edge[i] += Pack(thickness / 4) * (of.kappa[0] * r.M[0] + of.kappa[1] * r.M[1] + of.kappa[2] * r.M[2] +
                                        of.shear[0] * r.Q[0] + of.shear[1] * r.Q[1]);
  }
}

struct Forces3 {
  V3 x[3], d[3];
};

// Conjugate to the curvature of an edge, 4 chord.beta: the curvatures are those of the edges 1-2 and 1-3, and
// both less that of 2-3.
inline Pack edge_moment(const Resultants& r, int e) { return e == 2 ? Pack(0.0) - r.M[2] : r.M[e] + r.M[2]; }

inline Forces3 forces_of(const Triangle& t, const ResultantSums& s) {
  const Resultants& r = s.r;
  const V3 x1 = r.N[0] * t.a1 + r.N[2] * t.a2, x2 = r.N[2] * t.a1 + r.N[1] * t.a2;
  const V3 d1 = r.K[0] * t.b1 + r.K[2] * t.b2, d2 = r.K[2] * t.b1 + r.K[1] * t.b2;
  Forces3 f;
  for (int a = 0; a < 3; ++a) {
    f.x[a] = Pack(kN1[a]) * x1 + Pack(kN2[a]) * x2;
    f.d[a] = Pack(kN1[a]) * d1 + Pack(kN2[a]) * d2;
  }
  for (int e = 0; e < 3; ++e) {
    const int i = kEdge[e][0], j = kEdge[e][1];
    const ArcEdge& edge = t.edge[e];
    const Pack two(2.0), moment = two * edge_moment(r, e), shear = two * s.edge[e];
    const V3 on_x = moment * edge.beta + shear * edge.mean, on_mean = shear * edge.chord,
             on_delta = through_arc(edge, moment * edge.chord);
    f.x[j] += on_x;
    f.x[i] -= on_x;
    f.d[i] += on_mean - on_delta;
    f.d[j] += on_mean + on_delta;
  }
  return f;
}

inline void store_forces(const Forces3& f, double* out) {
  for (int a = 0; a < 3; ++a) {
    store3(out, 3 * a, f.x[a]);
    store3(out, 9 + 3 * a, f.d[a]);
  }
}

unsigned force(const section::Section& section, const law::Step& step, const ShellBatch& batch, double* f) {
  const Triangle t = load_triangle(section, batch);
  ResultantSums s;
  clear(s);
  unsigned failed = 0;
  for (int g = 0; g < shell3_points; ++g) {
    Resultants r;
    failed |= integrate(section, step, batch, columns_at(section, batch, g), strains_at(t, g), g, r, nullptr);
    add(t, r, section.thickness, g, s);
  }
  store_forces(forces_of(t, s), f);
  return failed;
}

constexpr int kX = 6, kD = 6;  // base vectors a1 a2; two rotations per node
template <bool symmetric>
using Tangent3 = Tangent<kX, kD, symmetric>;

// The strains of the whole element, to which those of its points are proportional: eps, kappa of the nodes'
// directors and rho, 11 22 2 12 each, and the edges' g_e.
constexpr int kStrains = 12, kKappas = 3, kEdges = 9;

// Columns of the strain operator: three for each base vector, and the rotations.
struct Columns3 {
  Pack x[kX][kStrains], d[kD][kStrains];
};

inline void put(Pack (&column)[kX][kStrains], int vector, int place, V3 v) {
  column[3 * vector][place] = v.x;
  column[3 * vector + 1][place] = v.y;
  column[3 * vector + 2][place] = v.z;
}

// The coefficients of edge e along a1 and along a2.
constexpr double edge_coefficient(int e, int vector) {
  return e == 2 ? (vector == 0 ? -1 : 1) : e == vector ? 1 : 0;
}

// -1 and 1 at the ends of edge e, 0 at the corner opposite.
constexpr int end_of(int e, int corner) { return corner == kEdge[e][0] ? -1 : corner == kEdge[e][1] ? 1 : 0; }

inline void fill(const Triangle& t, double thickness, const V3 (&b)[3][2], Columns3& B) {
  const Pack zero(0.0);
  const V3 none{zero, zero, zero};
  const V3 b12 = Pack(2.0) * t.edge[0].beta, b13 = Pack(2.0) * t.edge[1].beta,
           b23 = Pack(2.0) * t.edge[2].beta;
  const V3 on_a[2][9] = {{t.a1, none, t.a2, b12, none, b12 + b23, none, none, none},
                         {none, t.a2, t.a1, none, b13, b13 - b23, none, none, none}};
  for (int v = 0; v < 2; ++v)
    for (int i = 0; i < 9; ++i) put(B.x, v, i, on_a[v][i]);
  for (int a = 0; a < 3; ++a) {
    const Pack n1(kN1[a]), n2(kN2[a]);
    V3 bent[3];
    for (int e = 0; e < 3; ++e) bent[e] = Pack(2.0 * end_of(e, a)) * through_arc(t.edge[e], t.edge[e].chord);
    const V3 rows[9] = {none,      none,      none,
                        bent[0],   bent[1],   bent[0] + bent[1] - bent[2],
                        n1 * t.b1, n2 * t.b2, n1 * t.b2 + n2 * t.b1};
    for (int q = 0; q < 2; ++q)
      for (int i = 0; i < 9; ++i) B.d[2 * a + q][i] = dot(rows[i], b[a][q]);
  }
  for (int e = 0; e < 3; ++e) {
    const int i = kEdge[e][0], j = kEdge[e][1];
    const V3 director = Pack(thickness / 2) * t.edge[e].mean, chord = Pack(thickness / 2) * t.edge[e].chord;
    for (int v = 0; v < 2; ++v) put(B.x, v, kEdges + e, Pack(edge_coefficient(e, v)) * director);
    for (int a = 0; a < 3; ++a)
      for (int q = 0; q < 2; ++q) B.d[2 * a + q][kEdges + e] = a == i || a == j ? dot(chord, b[a][q]) : zero;
  }
}

// The resistance of the whole element to its strains. For a symmetric section the upper half is used.
struct Resistance3 {
  Pack D[kStrains][kStrains];
};

// Adds A^T D A of an in-plane point, where A takes the element's strains to those of the point.
template <bool symmetric>
inline void add(const Triangle& t, const ThicknessMoments& k, int g, Resistance3& sum) {
  const Resistance<symmetric> D(k);
  const OfEdge of[3] = {of_edge(t, g, 0), of_edge(t, g, 1), of_edge(t, g, 2)};
  Pack right[11][3], left[3][11];  // columns and rows of the edges
  for (int i = 0; i < 11; ++i)
    for (int e = 0; e < 3; ++e) {
      Pack v = D(i, 9) * of[e].shear[0] + D(i, 10) * of[e].shear[1];
      for (int j = 0; j < 3; ++j) v += D(i, kKappas + j) * of[e].kappa[j];
      right[i][e] = v;
      if constexpr (!symmetric) {
        v = D(9, i) * of[e].shear[0] + D(10, i) * of[e].shear[1];
        for (int j = 0; j < 3; ++j) v += D(kKappas + j, i) * of[e].kappa[j];
        left[e][i] = v;
      }
    }
  for (int i = 0; i < 9; ++i) {
    for (int j = symmetric ? i : 0; j < 9; ++j) sum.D[i][j] += D(i, j);
    for (int e = 0; e < 3; ++e) {
      sum.D[i][kEdges + e] += right[i][e];
      if constexpr (!symmetric) sum.D[kEdges + e][i] += left[e][i];
    }
  }
  for (int e = 0; e < 3; ++e)
    for (int c = symmetric ? e : 0; c < 3; ++c) {
      Pack v = of[e].shear[0] * right[9][c] + of[e].shear[1] * right[10][c];
      for (int j = 0; j < 3; ++j) v += of[e].kappa[j] * right[kKappas + j][c];
      sum.D[kEdges + e][kEdges + c] += v;
    }
}

// The first strain that a column depends on: positions on eps and kappa, directors on kappa and rho; both on
// the edges.
constexpr int kFirst[2] = {0, kKappas}, kEnd[2] = {6, 9};

inline void times(const Resistance3& D, const Pack (&b)[kStrains], int kind, Pack (&out)[kStrains]) {
  for (int i = 0; i < kStrains; ++i) {
    Pack v = D.D[i][kFirst[kind]] * b[kFirst[kind]];
    for (int j = kFirst[kind] + 1; j < kEnd[kind]; ++j) v += D.D[i][j] * b[j];
    for (int j = kEdges; j < kStrains; ++j) v += D.D[i][j] * b[j];
    out[i] = v;
  }
}

inline Pack product(const Pack (&a)[kStrains], int kind, const Pack (&b)[kStrains]) {
  Pack v = a[kFirst[kind]] * b[kFirst[kind]];
  for (int j = kFirst[kind] + 1; j < kEnd[kind]; ++j) v += a[j] * b[j];
  for (int j = kEdges; j < kStrains; ++j) v += a[j] * b[j];
  return v;
}

// K += B^T D B; for a symmetric D only the upper half of xx and dd, and xd.
template <bool symmetric>
inline void add_material(const Columns3& B, Resistance3& D, Tangent3<symmetric>& K) {
  if constexpr (symmetric)
    for (int i = 0; i < kStrains; ++i)
      for (int j = 0; j < i; ++j) D.D[i][j] = D.D[j][i];
  Pack q[kStrains];
  for (int c = 0; c < kX; ++c) {
    times(D, B.x[c], 0, q);
    for (int r = 0; r < (symmetric ? c + 1 : kX); ++r) K.xx[r][c] += product(B.x[r], 0, q);
    if constexpr (!symmetric)
      for (int r = 0; r < kD; ++r) K.dx[r][c] += product(B.d[r], 1, q);
  }
  for (int c = 0; c < kD; ++c) {
    times(D, B.d[c], 1, q);
    for (int r = 0; r < kX; ++r) K.xd[r][c] += product(B.x[r], 0, q);
    for (int r = 0; r < (symmetric ? c + 1 : kD); ++r) K.dd[r][c] += product(B.d[r], 1, q);
  }
}

// Adds the second variation of the strains at fixed resultants.
template <bool symmetric>
inline void add_geometric(const ResultantSums& s, const Forces3& f, const Triangle& t, const V3 (&b)[3][2],
                          Tangent3<symmetric>& K) {
  const Resultants& r = s.r;
  add_scalar(0, 0, r.N[0], K);
  add_scalar(1, 1, r.N[1], K);
  add_scalar(0, 1, r.N[2], K);
  for (int a = 0; a < 3; ++a)
    for (int q = 0; q < 2; ++q) {
      const int at = 2 * a + q;
      for (int c = 0; c < 3; ++c) {
        const Pack k = Pack(kN1[a] * kN1[c]) * r.K[0] + Pack(kN2[a] * kN2[c]) * r.K[1] +
                       Pack(kN1[a] * kN2[c] + kN2[a] * kN1[c]) * r.K[2];
        for (int p = 0; p < 2; ++p) K.dd[2 * c + p][at] += k * dot(b[c][p], b[a][q]);
      }
      K.dd[at][at] -= dot(f.d[a], t.d[a]);  // second variation of the director: delta2 d = -(q.q) d
    }
  for (int e = 0; e < 3; ++e) {
    const ArcEdge& edge = t.edge[e];
    const Pack two(2.0), four(4.0), moment = edge_moment(r, e);
    const V3 force = four * moment * edge.chord;  // on beta
    const Pack work = dot(force, edge.delta);
    for (const int a : kEdge[e])
      for (int q = 0; q < 2; ++q) {
        const V3 delta = Pack(0.5 * end_of(e, a)) * b[a][q];
        const V3 on_a = s.edge[e] * b[a][q] + two * moment * through_arc(edge, delta);
        for (int v = 0; v < 2; ++v) add_vector(v, 2 * a + q, Pack(edge_coefficient(e, v)) * on_a, K);
        // As in shell4_isa.cpp: the second variation of beta.
        const Pack along = dot(edge.delta, delta);
        const V3 bent = two * edge.slope * (dot(force, delta) * edge.delta + along * force + work * delta) +
                        (four * edge.bend * work * along) * edge.delta;
        for (const int c : kEdge[e])
          for (int p = 0; p < 2; ++p)
            K.dd[2 * c + p][2 * a + q] += Pack(0.5 * end_of(e, c)) * dot(b[c][p], bent);
      }
  }
}

// Takes from the strains what is quadratic in the step from the nodes before.
inline void linearise(const Triangle& before, double thickness, Triangle& t) {
  const V3 a1 = t.a1 - before.a1, a2 = t.a2 - before.a2;
  const Pack half(0.5);
  Strains& p = t.strains;
  p.eps[0] -= half * dot(a1, a1);
  p.eps[1] -= half * dot(a2, a2);
  p.eps[2] -= dot(a1, a2);
  Pack k[3];
  for (int e = 0; e < 3; ++e) {
    const V3 chord = t.edge[e].chord - before.edge[e].chord;
    k[e] = Pack(4.0) * dot(chord, t.edge[e].beta - before.edge[e].beta);
    t.gamma[e] -= Pack(thickness) * dot(chord, t.edge[e].mean - before.edge[e].mean);
  }
  p.kappa[0] -= k[0];
  p.kappa[1] -= k[1];
  p.kappa[2] -= k[0] + k[1] - k[2];
}

// Adds the change of the resultants by the whole of the resistance from the strains of t to those of `to`.
inline void add_change(const Resistance3& D, const Triangle& t, const Triangle& to, double thickness,
                       ResultantSums& s) {
  Pack by[kStrains], change[kStrains];
  for (int i = 0; i < 3; ++i) {
    by[i] = to.strains.eps[i] - t.strains.eps[i];
    by[kKappas + i] = to.strains.kappa[i] - t.strains.kappa[i];
    by[6 + i] = to.strains.rho[i] - t.strains.rho[i];
    by[kEdges + i] = to.gamma[i] - t.gamma[i];
  }
  for (int i = 0; i < kStrains; ++i) {
    change[i] = D.D[i][0] * by[0];
    for (int j = 1; j < kStrains; ++j) change[i] += D.D[i][j] * by[j];
  }
  for (int i = 0; i < 3; ++i) {
    s.r.N[i] += change[i];
    s.r.M[i] += change[kKappas + i];
    s.r.K[i] += change[6 + i];
    s.edge[i] += Pack(thickness / 4) * change[kEdges + i];
  }
}

[[gnu::noinline]] void own_resultants(const section::Section& section, const law::Step& step,
                                      const ShellBatch& batch, const Triangle& t, int g, Resultants& r) {
  integrate(section, step, batch, columns_at(section, batch, g), strains_at(t, g), g, r, nullptr);
}

template <bool symmetric>
unsigned tangent_of(const section::Section& section, const law::Step& step, const ShellBatch& batch,
                    double* f, double* out) {
  const bool linear = batch.before_x != nullptr && branches_of(batch) != nullptr;
  const Triangle whole = load_triangle(section, batch);
  Triangle t = whole;
  if (batch.before_x != nullptr) linearise(load_triangle(section, before_step(batch)), section.thickness, t);
  V3 b[3][2];
  for (int a = 0; a < 3; ++a)
    for (int q = 0; q < 2; ++q) b[a][q] = load3(batch.b, 6 * a + 3 * q);
  Columns3 B;
  fill(t, section.thickness, b, B);
  Tangent3<symmetric> K;
  clear(K);
  Resistance3 D;
  for (auto& row : D.D)
    for (Pack& entry : row) entry = Pack(0.0);
  ResultantSums s, on_line;
  clear(s);
  clear(on_line);
  unsigned failed = 0;
  for (int g = 0; g < shell3_points; ++g) {
    Resultants r;
    ThicknessMoments k;
    failed |= integrate(section, step, batch, columns_at(section, batch, g), strains_at(t, g), g, r, &k);
    if (linear) {
      add(t, r, section.thickness, g, on_line);
      // As in shell4_isa.cpp: the stiffness of the law's own stresses.
      own_resultants(section, step, batch, t, g, r);
    }
    add(t, r, section.thickness, g, s);
    add<symmetric>(t, k, g, D);
  }
  add_material(B, D, K);
  mirror(K);
  const Forces3 forces = forces_of(t, s);
  if (!batch.law_only) add_geometric(s, forces, t, b, K);
  if (linear) {
    add_change(D, t, whole, section.thickness, on_line);
    store_forces(forces_of(t, on_line), f);
  } else {
    store_forces(forces, f);
  }
  constexpr double coefficient[2][3] = {{-1, 1, 0}, {-1, 0, 1}};
  store_tangent(K, coefficient, batch.wanted, out);
  return failed;
}

unsigned tangent(const section::Section& section, const law::Step& step, const ShellBatch& batch, double* f,
                 double* out) {
  return section.symmetric ? tangent_of<true>(section, step, batch, f, out)
                           : tangent_of<false>(section, step, batch, f, out);
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
    const Strains p = strains_at(t, g);
    for (int i = 0; i < 3; ++i) {
      const Pack* L = to.L[row[i]];
      const Pack* k = p.kappa;
      store(kappa + (3 * g + i) * lanes, L[0] * k[0] + L[1] * k[1] + L[2] * k[2]);
    }
  }
}

// Mask of the lanes whose element is inverted: its mean director points against the normal.
unsigned inverted(const ShellBatch& batch) {
  V3 x[3], d{Pack(0.0), Pack(0.0), Pack(0.0)};
  for (int a = 0; a < 3; ++a) {
    x[a] = load3(batch.x, 3 * a);
    d += load3(batch.d, 3 * a);
  }
  return bits(dot(cross(x[1] - x[0], x[2] - x[0]), d) <= Pack(0.0));
}

unsigned astray(const ShellBatch& batch, double cosine, double bent) {
  return astray(batch, kEdge, {1, 0, 2, 0}, cosine, bent);
}

}  // namespace

Shell4Kernels shell3_kernels_of_isa() {
  return kernels_of_parts<force, tangent, strain, curvature, inverted, astray>();
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::element
