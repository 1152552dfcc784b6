// The batch kernels of the four-node shell; compiled once per instruction set.
#include "element/shell4_isa.hpp"

#include "element/shell_stiffness_isa.hpp"

namespace fabricsh::element {
inline namespace FABRICSH_ISA {
namespace {

constexpr int kVectors = 3, kX = 3 * kVectors, kD = 8;  // mid1 mid2 twist; two rotations per node
using Columns4 = Columns<kX, kD>;
template <bool symmetric>
using Tangent4 = Tangent<kX, kD, symmetric>;

// The loops over the points are separate, so that the law is compiled once and the others are unrolled.
template <Sharing sharing>
unsigned force_of(const section::Section& section, const law::Step& step, const Shell4Batch& batch,
                  double* f) {
  const Kinematics k = kinematics(batch);
  const Shell4Layout layout(static_cast<int>(section.points.size()));
  const Levers levers(batch.geometry);
  Pack gamma[4];
  edge_shears(k, batch.geometry, levers, gamma);
  const Membrane m = membrane<sharing>(k, batch.geometry);
  InPlane p[gauss_points];
  Resultants r[gauss_points];
  _Pragma("GCC unroll 4") for (int g = 0; g < gauss_points; ++g)
      in_plane<sharing>(k, batch.geometry + layout.reference(g) * lanes, m, gamma, g, p[g]);
  std::conditional_t<sharing == Sharing::element, SharedEasing, Easing> easing;
  if constexpr (sharing == Sharing::element)
    load_shared_easing(batch.geometry, layout, easing);
  else
    load_easing(batch.geometry, layout, easing);
  if (easing.any) ease_strains(easing, p);
  unsigned failed = 0;
  for (int g = 0; g < gauss_points; ++g) {
    const int first = layout.point(sharing == Sharing::element ? 0 : g, 0);
    failed |= integrate(section, step, batch, batch.geometry + first * lanes, p[g], g, r[g], nullptr);
  }
  if (easing.any) ease_resultants(easing, r);
  ConjugateForces forces;
  clear(forces);
  _Pragma("GCC unroll 4") for (int g = 0; g < gauss_points; ++g) add_force<sharing>(p[g], r[g], g, forces);
  close<sharing>(m, batch.geometry, levers, forces);
  store_forces(on_nodes(k, forces), f);
  return failed;
}

unsigned force(const section::Section& section, const law::Step& step, const Shell4Batch& batch, double* f) {
  if (batch.sharing == Sharing::element && section.plain != nullptr)
    return force_of<Sharing::element>(section, step, batch, f);
  if (batch.sharing != Sharing::none) return force_of<Sharing::through>(section, step, batch, f);
  return force_of<Sharing::none>(section, step, batch, f);
}

// Derivatives of the edges' directors by the rotations: each edge
// has four columns, two of its first node and two of its second.
struct EdgeColumns {
  V3 mean, delta, beta;  // derivatives
};
struct Rotations {
  EdgeColumns column[4][4];
};
inline int rotation(int edge, int column) { return 2 * kEdge[edge][column / 2] + column % 2; }

inline Rotations rotations(const Kinematics& k, const double* basis) {
  Rotations r;
  const Pack half(0.5), minus(-0.5);
  for (int e = 0; e < 4; ++e)
    for (int c = 0; c < 4; ++c) {
      const V3 b = load3(basis, 3 * rotation(e, c));
      EdgeColumns& column = r.column[e][c];
      column.mean = half * b;
      column.delta = (c < 2 ? minus : half) * b;
      column.beta = through_arc(k.edge[e], column.delta);
    }
  return r;
}

// Columns of the membrane samples and enhanced modes for mid1, mid2 and twist.
struct SampleColumns {
  Pack sample[kX][kSamples], mode[kX][kEnhanced];
};

inline void put(SampleColumns& s, int vector, int sample, V3 v) {
  s.sample[3 * vector][sample] = v.x;
  s.sample[3 * vector + 1][sample] = v.y;
  s.sample[3 * vector + 2][sample] = v.z;
}

inline SampleColumns sample_columns(const Kinematics& k, const Membrane& m, const double* geometry) {
  SampleColumns s;
  for (auto& column : s.sample)
    for (Pack& v : column) v = Pack(0.0);
  for (int e = 0; e < 4; ++e) {
    put(s, e / 2, e, k.edge[e].chord);
    put(s, 2, e, Pack(kTwist[e]) * k.edge[e].chord);
  }
  put(s, 0, 4, k.mid1);
  put(s, 1, 5, k.mid2);
  put(s, 0, 6, k.mid2);
  put(s, 1, 6, k.mid1);
  for (int c = 0; c < kX; ++c) {
    Pack v = m.slope[0] * s.sample[c][0];
    for (int j = 1; j < 7; ++j) v += m.slope[j] * s.sample[c][j];
    s.sample[c][7] = v;
    for (int i = 0; i < kEnhanced; ++i) {
      Pack w = mode(geometry, i, 0) * s.sample[c][0];
      for (int j = 1; j < kSamples; ++j) w += mode(geometry, i, j) * s.sample[c][j];
      s.mode[c][i] = w;
    }
  }
  return s;
}

// Columns of the eased membrane strains of all in-plane points.
struct EasedColumns {
  Pack eps[kX][gauss_points][3];
};

[[gnu::noinline]] void eased_columns(const Easing& easing, const Membrane& m, const SampleColumns& s,
                                     EasedColumns& out) {
  for (int g = 0; g < gauss_points; ++g) {
    const AxisTransform to = axis_transform(m, g);
    for (int c = 0; c < kX; ++c) membrane_at(to, g, s.sample[c], s.mode[c], out.eps[c][g]);
  }
  for (auto& eps : out.eps) ease(easing, {eps[0], eps[1], eps[2], eps[3]});
}

// eased: the columns of the membrane strains, null where they are not eased.
inline void position_columns(const Kinematics& k, const InPlane& p, const SampleColumns& s,
                             const EasedColumns* eased, const Levers& levers, int g, Columns4& B) {
  for (int c = 0; c < kX; ++c) {
    if (eased == nullptr)
      membrane_at(p.axis_transform, g, s.sample[c], s.mode[c], B.x[c] + kEps);
    else
      for (int i = 0; i < 3; ++i) B.x[c][kEps + i] = eased->eps[c][g][i];
  }
  const Pack zero(0.0), r(kXi[g]), e(kEta[g]);
  const V3 none{zero, zero, zero};
  V3 shear[2][2] = {{none, none}, {none, none}};  // derivatives of g1, g2 by middle and twist
  for (int i = 0; i < 4; ++i) {
    const V3 v = levers.weight(g, i) * k.edge[i].mean;
    shear[i / 2][0] += v;
    shear[i / 2][1] += Pack(kTwist[i]) * v;
  }
  const V3 rows[kVectors][5] = {{p.b1, none, p.b2, shear[0][0], none},
                                {none, p.b2, p.b1, none, shear[1][0]},
                                {e * p.b1, r * p.b2, e * p.b2 + r * p.b1, shear[0][1], shear[1][1]}};
  for (int v = 0; v < kVectors; ++v)
    for (int i = 0; i < 5; ++i) {
      B.x[3 * v][kKappa + i] = rows[v][i].x;
      B.x[3 * v + 1][kKappa + i] = rows[v][i].y;
      B.x[3 * v + 2][kKappa + i] = rows[v][i].z;
    }
}

inline void rotation_columns(const Kinematics& k, const InPlane& p, const Rotations& q, const Levers& levers,
                             int g, Columns4& B) {
  for (int e = 0; e < 4; ++e) {
    const Pack w(tie(g, e)), h = levers.weight(g, e);
    const int along = e / 2;  // for b1 or b2
    const V3 a[2] = {w * p.a1, w * p.a2}, b[2] = {w * p.b1, w * p.b2}, chord = h * k.edge[e].chord;
    for (int c = 0; c < 4; ++c) {
      const EdgeColumns& column = q.column[e][c];
      Pack* out = B.d[rotation(e, c)];
      out[kKappaOfD + along] = dot(a[along], column.beta);
      out[kRhoOfD + along] = dot(b[along], column.beta);
      out[kShear + along] = dot(chord, column.mean);
      // Each node has one edge of either direction; those along b1 come first.
      const Pack kappa = dot(a[1 - along], column.beta), rho = dot(b[1 - along], column.beta);
      out[kKappaOfD + 2] = along == 0 ? kappa : out[kKappaOfD + 2] + kappa;
      out[kRhoOfD + 2] = along == 0 ? rho : out[kRhoOfD + 2] + rho;
    }
  }
}

// Second variations at fixed resultants between position vectors and edges, summed over the points.
struct Geometric {
  Pack x_beta[kVectors][4], beta_beta[4][4];
};

inline void clear(Geometric& s) {
  for (auto& row : s.x_beta)
    for (Pack& v : row) v = Pack(0.0);
  for (auto& row : s.beta_beta)
    for (Pack& v : row) v = Pack(0.0);
}

inline void add_geometric(const Resultants& r, int g, Geometric& s) {
  const Pack xi(kXi[g]), eta(kEta[g]);
  for (int e = 0; e < 4; ++e) {
    const int along = e / 2;
    const Pack w(tie(g, e)), on1 = w * r.M[along == 0 ? 0 : 2], on2 = w * r.M[along == 0 ? 2 : 1];
    s.x_beta[0][e] += on1;
    s.x_beta[1][e] += on2;
    s.x_beta[2][e] += eta * on1 + xi * on2;
    for (int f = 0; f < 4; ++f)
      s.beta_beta[e][f] += Pack(tie(g, e) * tie(g, f)) * r.K[along != f / 2 ? 2 : along];
  }
}

template <bool symmetric>
inline void add_membrane_geometric(const Membrane& m, const ConjugateForces& f, const SampleColumns& s,
                                   Tangent4<symmetric>& K) {
  const Pack* N = f.sample;
  add_scalar(0, 0, N[0] + N[1] + N[4], K);
  add_scalar(1, 1, N[2] + N[3] + N[5], K);
  add_scalar(2, 2, N[0] + N[1] + N[2] + N[3], K);
  add_scalar(0, 2, N[0] - N[1], K);
  add_scalar(1, 2, N[2] - N[3], K);
  add_scalar(0, 1, N[6], K);
  // The part of the second derivative of q that is not in its slopes: y.G^-1 y with y = dv - dG w.
  const Pack half(0.5), two(2.0), N7 = select(m.collapsed, Pack(0.0), N[7]);
  Pack y1[kX], y2[kX];
  for (int c = 0; c < kX; ++c) {
    const Pack* v = s.sample[c];
    y1[c] = half * (v[0] - v[1]) - two * m.w1 * v[4] - m.w2 * v[6];
    y2[c] = half * (v[2] - v[3]) - m.w1 * v[6] - two * m.w2 * v[5];
  }
  for (int c = 0; c < kX; ++c) {
    const Pack z1 = N7 * (m.G11 * y1[c] + m.G12 * y2[c]), z2 = N7 * (m.G12 * y1[c] + m.G22 * y2[c]);
    for (int r = 0; r < kX; ++r) K.xx[r][c] += y1[r] * z1 + y2[r] * z2;
  }
}

// The same part for collapsed lanes, from q = over(det G) v.adj(G) v / 2 in the five variables v1 v2 g11 g22
// g12.
template <bool symmetric>
[[gnu::noinline]] void add_collapsed_geometric(const Kinematics& k, const double* geometry,
                                               PackMask collapsed, Pack N7, const SampleColumns& samples,
                                               Tangent4<symmetric>& K) {
  constexpr int kVariables = 5;
  const Pack zero(0.0), half(0.5), two(2.0);
  Pack s[7];
  metric_samples(k, s);
  const CollapsedMetric g = collapsed_metric(s, det_where_collapse_begins(geometry));
  const Pack a = adjugate_form(g), d_det[kVariables] = {zero, zero, g.g22, g.g11, -two * g.g12},
             da[kVariables] = {two * (g.g22 * g.v1 - g.g12 * g.v2), two * (g.g11 * g.v2 - g.g12 * g.v1),
                               g.v2 * g.v2, g.v1 * g.v1, -two * g.v1 * g.v2};
  Pack H[kVariables][kVariables];
  for (int i = 0; i < kVariables; ++i)
    for (int j = 0; j < kVariables; ++j)
      H[i][j] = g.bend * a * d_det[i] * d_det[j] + g.slope * (d_det[i] * da[j] + da[i] * d_det[j]);
  const auto add = [&](int i, int j, Pack v) {
    H[i][j] += v;
    if (i != j) H[j][i] += v;
  };
  add(2, 3, g.slope * a);
  add(4, 4, -two * g.slope * a);
  add(0, 0, two * g.over * g.g22);
  add(1, 1, two * g.over * g.g11);
  add(0, 1, -two * g.over * g.g12);
  add(0, 3, two * g.over * g.v1);
  add(0, 4, -two * g.over * g.v2);
  add(1, 2, two * g.over * g.v2);
  add(1, 4, -two * g.over * g.v1);
  const Pack weight = select(collapsed, half * N7, zero);
  Pack variable[kX][kVariables];
  for (int c = 0; c < kX; ++c) {
    const Pack* d = samples.sample[c];
    const Pack of[kVariables] = {half * (d[0] - d[1]), half * (d[2] - d[3]), two * d[4], two * d[5], d[6]};
    for (int i = 0; i < kVariables; ++i) variable[c][i] = of[i];
  }
  for (int c = 0; c < kX; ++c)
    for (int i = 0; i < kVariables; ++i) {
      Pack row(0.0);
      for (int j = 0; j < kVariables; ++j) row += H[i][j] * variable[c][j];
      row = weight * row;
      for (int r = 0; r < kX; ++r) K.xx[r][c] += row * variable[r][i];
    }
}

// Products of the columns of two edges, with position vectors on one side, and the second variation of beta,
//   F.d2 beta(u, v) = u.H v,
//   H = 2 f' (delta F^T + F delta^T + (F.delta) 1) + 4 f'' (F.delta) delta delta^T.
template <bool symmetric>
inline void add_edge_geometric(const Kinematics& k, const Geometric& s, const ConjugateForces& f,
                               const Rotations& q, Tangent4<symmetric>& K) {
  const Pack two(2.0), four(4.0);
  for (int e = 0; e < 4; ++e) {
    const ArcEdge& edge = k.edge[e];
    const Pack work = dot(f.beta[e], edge.delta);
    for (int c = 0; c < 4; ++c) {
      const EdgeColumns& column = q.column[e][c];
      const int at = rotation(e, c);
      for (int p = 0; p < kVectors; ++p) add_vector(p, at, s.x_beta[p][e] * column.beta, K);
      const V3 shear = f.shear[e] * column.mean;
      add_vector(e / 2, at, shear, K);
      add_vector(2, at, Pack(kTwist[e]) * shear, K);
      const Pack along = dot(edge.delta, column.delta);
      const V3 bent =
          two * edge.slope *
              (dot(f.beta[e], column.delta) * edge.delta + along * f.beta[e] + work * column.delta) +
          (four * edge.bend * work * along) * edge.delta;
      for (int i = 0; i < 4; ++i) K.dd[rotation(e, i)][at] += dot(q.column[e][i].delta, bent);
      for (int o = 0; o < 4; ++o) {
        const V3 pulled = s.beta_beta[o][e] * column.beta;
        for (int i = 0; i < 4; ++i) K.dd[rotation(o, i)][at] += dot(q.column[o][i].beta, pulled);
      }
    }
  }
}

// Takes from the samples and edge shears what is quadratic in the step from the nodes before.
inline void linearise(const Kinematics& before, const Kinematics& k, const double* geometry,
                      const Levers& levers, Membrane& m, Pack gamma[4]) {
  const Pack half(0.5);
  Pack products[4];
  for (int e = 0; e < 4; ++e) {
    const V3 chord = k.edge[e].chord - before.edge[e].chord;
    m.strain[e] -= half * dot(chord, chord);
    products[e] = dot(chord, k.edge[e].mean - before.edge[e].mean);
  }
  for (int e = 0; e < 4; ++e) gamma[e] -= levers.of(products, e);
  const V3 mid1 = k.mid1 - before.mid1, mid2 = k.mid2 - before.mid2;
  m.strain[4] -= half * dot(mid1, mid1);
  m.strain[5] -= half * dot(mid2, mid2);
  m.strain[6] -= dot(mid1, mid2);
  modes_of(geometry, m.strain, m.alpha);
}

// The same of the curvatures at in-plane point g.
inline void linearise(const Kinematics& before, const Kinematics& k, int g, InPlane& p) {
  const V3 twist = k.twist - before.twist;
  const V3 a1 = k.mid1 - before.mid1 + Pack(kEta[g]) * twist,
           a2 = k.mid2 - before.mid2 + Pack(kXi[g]) * twist;
  const auto beta = [&](int e) { return Pack(tie(g, e)) * (k.edge[e].beta - before.edge[e].beta); };
  const V3 b1 = beta(0) + beta(1), b2 = beta(2) + beta(3);
  p.kappa[0] -= dot(a1, b1);
  p.kappa[1] -= dot(a2, b2);
  p.kappa[2] -= dot(a1, b2) + dot(a2, b1);
}

// Moves the membrane's resultants aside, which can only be eased together with those of the other points.
inline void take_membrane(Resultants& r, Resultants& aside) {
  for (int i = 0; i < 3; ++i) {
    aside.N[i] = r.N[i];
    r.N[i] = Pack(0.0);
  }
}

template <bool symmetric>
unsigned tangent_of(const section::Section& section, const law::Step& step, const Shell4Batch& batch,
                    double* f, double* out) {
  const Kinematics k = kinematics(batch);
  const Rotations q = rotations(k, batch.b);
  const Shell4Layout layout(static_cast<int>(section.points.size()));
  const Levers levers(batch.geometry);
  Pack gamma[4];
  edge_shears(k, batch.geometry, levers, gamma);
  Membrane m = membrane(k, batch.geometry);
  const bool extrapolated = batch.before_x != nullptr, linear = extrapolated && branches_of(batch) != nullptr;
  const Kinematics before = extrapolated ? kinematics(before_step(batch)) : k;
  InPlane whole[gauss_points];
  for (int g = 0; g < gauss_points && linear; ++g)
    in_plane(k, batch.geometry + layout.reference(g) * lanes, m, gamma, g, whole[g]);
  if (extrapolated) linearise(before, k, batch.geometry, levers, m, gamma);
  const SampleColumns samples = sample_columns(k, m, batch.geometry);
  ConjugateForces forces, on_line;
  clear(forces);
  clear(on_line);
  Geometric geometric;
  clear(geometric);
  Tangent4<symmetric> K;
  clear(K);
  unsigned failed = 0;
  Columns4 B;
  Easing easing;
  InPlane eased[gauss_points];
  Resultants eased_away[gauss_points], eased_on_line[gauss_points];
  EasedColumns columns;
  if (load_easing(batch.geometry, layout, easing)) {
    for (int g = 0; g < gauss_points; ++g)
      in_plane(k, batch.geometry + layout.reference(g) * lanes, m, gamma, g, eased[g]);
    ease_strains(easing, eased);
    if (linear) ease_strains(easing, whole);
    eased_columns(easing, m, samples, columns);
  }
  for (int g = 0; g < gauss_points; ++g) {
    InPlane p;
    if (easing.any)
      p = eased[g];
    else
      in_plane(k, batch.geometry + layout.reference(g) * lanes, m, gamma, g, p);
    if (extrapolated) linearise(before, k, g, p);
    Resultants r;
    ThicknessMoments stiffness;
    failed |=
        integrate(section, step, batch, batch.geometry + layout.point(g, 0) * lanes, p, g, r, &stiffness);
    if (linear) {
      Resultants moved = r;
      add_change<symmetric>(stiffness, p, whole[g], moved);
      if (easing.any) take_membrane(moved, eased_on_line[g]);
      add_force(p, moved, g, on_line);
      // The stiffness of the stresses is that of the law's own: beyond its branch a line may press hard.
      failed |=
          integrate(section, step, batch, batch.geometry + layout.point(g, 0) * lanes, p, g, r, nullptr);
    }
    if (easing.any) take_membrane(r, eased_away[g]);
    add_force(p, r, g, forces);
    add_geometric(r, g, geometric);
    position_columns(k, p, samples, easing.any ? &columns : nullptr, levers, g, B);
    rotation_columns(k, p, q, levers, g, B);
    add_material(B, stiffness, K);
  }
  if (easing.any) {
    ease_resultants(easing, eased_away);
    for (int g = 0; g < gauss_points; ++g) add_membrane(eased[g], eased_away[g], g, forces);
    if (linear) {
      ease_resultants(easing, eased_on_line);
      for (int g = 0; g < gauss_points; ++g) add_membrane(eased[g], eased_on_line[g], g, on_line);
    }
  }
  close(m, batch.geometry, levers, forces);
  if (linear) close(m, batch.geometry, levers, on_line);
  mirror(K);
  if (!batch.law_only) {
    add_membrane_geometric(m, forces, samples, K);
    if (any(m.collapsed)) [[unlikely]]
      add_collapsed_geometric(k, batch.geometry, m.collapsed, forces.sample[7], samples, K);
    add_edge_geometric(k, geometric, forces, q, K);
  }
  const NodeForces nodes = on_nodes(k, forces);
  for (int a = 0; a < 4 && !batch.law_only; ++a) {
    const Pack along = dot(nodes.d[a], k.d[a]);  // second variation of the director: delta2 d = -(q.q) d
    K.dd[2 * a][2 * a] -= along;
    K.dd[2 * a + 1][2 * a + 1] -= along;
  }
  store_forces(linear ? on_nodes(k, on_line) : nodes, f);
  constexpr double coefficient[kVectors][4] = {
      {-.25, .25, .25, -.25}, {-.25, -.25, .25, .25}, {.25, -.25, .25, -.25}};
  store_tangent(K, coefficient, batch.wanted, out);
  return failed;
}

unsigned tangent(const section::Section& section, const law::Step& step, const Shell4Batch& batch, double* f,
                 double* out) {
  return section.symmetric ? tangent_of<true>(section, step, batch, f, out)
                           : tangent_of<false>(section, step, batch, f, out);
}

// Calls visit(g, strains, first transform) for the in-plane points in their order.
template <class Visit>
inline void at_points(const section::Section& section, const Shell4Batch& batch, Visit visit) {
  const Kinematics k = kinematics(batch);
  const Shell4Layout layout(static_cast<int>(section.points.size()));
  const Levers levers(batch.geometry);
  Pack gamma[4];
  edge_shears(k, batch.geometry, levers, gamma);
  const Membrane m = membrane(k, batch.geometry);
  InPlane p[gauss_points];
  for (int g = 0; g < gauss_points; ++g)
    in_plane(k, batch.geometry + layout.reference(g) * lanes, m, gamma, g, p[g]);
  Easing easing;
  if (load_easing(batch.geometry, layout, easing)) ease_strains(easing, p);
  for (int g = 0; g < gauss_points; ++g) visit(g, p[g], batch.geometry + layout.point(g, 0) * lanes);
}

void strain(const section::Section& section, const Shell4Batch& batch, double* E) {
  const int points = static_cast<int>(section.points.size());
  at_points(section, batch, [&](int g, const InPlane& p, const double* columns) {
    for (int k = 0; k < points; ++k)
      material_strain(p, transform(columns + k * transform_size * lanes), height(section, k),
                      E + (g * points + k) * 5 * lanes);
  });
}

void curvature(const section::Section& section, const Shell4Batch& batch, double* kappa) {
  constexpr int row[3] = {0, 1, 4};
  at_points(section, batch, [&](int g, const InPlane& p, const double* columns) {
    const Transform t = transform(columns);
    for (int i = 0; i < 3; ++i) {
      const Pack* L = t.L[row[i]];
      store(kappa + (3 * g + i) * lanes, L[0] * p.kappa[0] + L[1] * p.kappa[1] + L[2] * p.kappa[2]);
    }
  });
}

// Mask of the inverted lanes: (a1 x a2).d is not positive at some in-plane point.
unsigned inverted(const Shell4Batch& batch) {
  const Kinematics k = kinematics(batch);
  unsigned lost = 0;
  for (int g = 0; g < gauss_points; ++g) {
    const V3 a1 = k.mid1 + Pack(kEta[g]) * k.twist, a2 = k.mid2 + Pack(kXi[g]) * k.twist;
    const V3 d = Pack(tie(g, 0)) * (Pack(tie(g, 3)) * k.d[3] + Pack(tie(g, 2)) * k.d[2]) +
                 Pack(tie(g, 1)) * (Pack(tie(g, 3)) * k.d[0] + Pack(tie(g, 2)) * k.d[1]);
    lost |= bits(dot(cross(a1, a2), d) <= Pack(0.0));
  }
  return lost;
}

unsigned astray(const Shell4Batch& batch, double cosine, double bent) {
  return astray(batch, kEdge, {2, 0, 3, 1}, cosine, bent);
}

}  // namespace

Shell4Kernels shell4_kernels_of_isa() {
  return kernels_of_parts<force, tangent, strain, curvature, inverted, astray>();
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::element
