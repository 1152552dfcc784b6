// Kinematics of the four-node shell in packs: edges, samples of the assumed fields,
// strains at the in-plane points, and forces from stress resultants. Included by
// shell4_isa.cpp only; the mathematics is described at the top of shell4.hpp.
#pragma once
#include "element/shell_isa.hpp"

namespace fabricsh::element {
inline namespace FABRICSH_ISA {
namespace {

constexpr double kGauss = 0.57735026918962576451;  // 1 / sqrt(3)
constexpr double kXi[4] = {-kGauss, kGauss, kGauss, -kGauss};
constexpr double kEta[4] = {-kGauss, -kGauss, kGauss, kGauss};
// x = centre + xi mid1 + eta mid2 + xi eta twist; four times the nodes' weights in mid1, mid2, twist.
constexpr double kNodeSign[3][4] = {{-1, 1, 1, -1}, {-1, -1, 1, 1}, {1, -1, 1, -1}};
// First and second node of the edges: A (eta = 1) and B (eta
// = -1) along xi, C (xi = 1) and D (xi = -1) along eta.
constexpr int kEdge[4][2] = {{3, 2}, {0, 1}, {1, 2}, {0, 3}};
// The sign of the twist in half an edge: A = mid1 + twist, B = mid1 - twist, C and D likewise from mid2.
constexpr double kTwist[4] = {1, -1, 1, -1};

// Weight of an edge at in-plane point g: edges A and B are interpolated along eta, C and D along xi.
constexpr double tie(int g, int e) { return (1 + kTwist[e] * (e < 2 ? kEta[g] : kXi[g])) / 2; }

struct Kinematics {
  ArcEdge edge[4];
  V3 mid1, mid2, twist;
  V3 d[4];
};

inline Kinematics kinematics(const Shell4Batch& batch) {
  Kinematics k;
  V3 x[4];
  for (int a = 0; a < 4; ++a) {
    x[a] = load3(batch.x, 3 * a);
    k.d[a] = load3(batch.d, 3 * a);
  }
  const Pack half(0.5);
  for (int e = 0; e < 4; ++e) {
    const int i = kEdge[e][0], j = kEdge[e][1];
    ArcEdge& edge = k.edge[e];
    edge.chord = half * (x[j] - x[i]);
    edge.mean = half * (k.d[i] + k.d[j]);
    edge.delta = half * (k.d[j] - k.d[i]);
    lengthen(edge);
  }
  k.mid1 = half * (k.edge[0].chord + k.edge[1].chord);
  k.mid2 = half * (k.edge[2].chord + k.edge[3].chord);
  k.twist = half * (k.edge[0].chord - k.edge[1].chord);
  return k;
}

// The assumed membrane field, from stretches of edge chords and in the middle. Samples in this order: c11 on
// A and B, c22 on C and D; c11, c22, 2 c12 in the middle; and q = |in-plane part of the twist|^2 / 2. Then
//   c11 = (1 + eta)/2 A + (1 - eta)/2 B + (eta^2 - 1) q
// is the bilinear field without the out-of-plane part of the twist, which makes a warped element lock
// [ko2017]; c22 likewise; 2 c12 = middle + xi (A - B)/2 + eta (C - D)/2 + 2 xi eta q. An enhanced strain of
// zero mean [simo1990; andelfinger1993] in the middle's axes, times j0 / j, is added:
//   c11 += xi alpha1,  c22 += eta alpha2,  2 c12 += xi alpha3 + eta alpha4,  alpha = A samples,
// where A is a constant matrix of the element (see shell4_geometry).
struct Membrane {
  Pack strain[kSamples];
  Pack alpha[kEnhanced];
  Pack slope[7];       // dq / d(other samples)
  Pack w1, w2;         // in-plane components of the twist: w = G^-1 v, v = twist.(mid1, mid2), metric G
  Pack G11, G12, G22;  // inverse of G
  Pack c1, c2;         // w in the reference configuration
  PackMask collapsed;  // lanes whose base vectors in the middle are nearly parallel
};

// An element may fold until its base vectors in the middle are parallel. The plane of the twist then turns
// over any way, and q = v.adj(G) v / (2 det G), which is at most |twist|^2 / 2, would turn with it by forces
// without bound. Below kCollapse times its reference value, det G is therefore replaced: 1 / det G by its
// quadratic Taylor polynomial about that value, whose value and first two derivatives agree there. Then q is
// a smooth function of the positions, goes to zero with det G, and lies between zero and its unchanged value.
// The force on a base vector is at most 1.43 |twist|^2 |other base vector| / sqrt(kCollapse det G0), times
// the resultant that q works on. Cloth is sheared by 80 degrees where this begins.
constexpr double kCollapse = 0.03;

// The metric of the middle and the products of the twist with its base vectors; and 1 / det G as replaced,
// with its derivatives by det G.
struct CollapsedMetric {
  Pack v1, v2, g11, g22, g12;
  Pack over, slope, bend;
};

struct Twist {
  Pack q, slope[7], w1, w2, G11, G12, G22;
};

inline Pack det_where_collapse_begins(const double* geometry) {
  const auto r = [&](int i) { return load(geometry + (Shell4Layout::samples + i) * lanes); };
  return Pack(kCollapse) * (Pack(4.0) * r(4) * r(5) - r(6) * r(6));
}

inline CollapsedMetric collapsed_metric(const Pack s[7], Pack begin) {
  const Pack half(0.5), one(1.0), two(2.0), three(3.0);
  CollapsedMetric g{half * (s[0] - s[1]), half * (s[2] - s[3]), two * s[4], two * s[5], s[6], one, one, one};
  const Pack unit = one / begin, y = (g.g11 * g.g22 - g.g12 * g.g12) * unit;
  g.over = (three - three * y + y * y) * unit;
  g.slope = (two * y - three) * unit * unit;
  g.bend = two * unit * unit * unit;
  return g;
}

// v.adj(G) v
inline Pack adjugate_form(const CollapsedMetric& g) {
  return g.g22 * g.v1 * g.v1 - Pack(2.0) * g.g12 * g.v1 * g.v2 + g.g11 * g.v2 * g.v2;
}

// q and its derivatives as replaced for collapsed lanes, and as given for the others.
[[gnu::noinline]] Twist collapsed_twist(const Pack s[7], Pack begin, PackMask collapsed,
                                        const Twist& regular) {
  const Pack half(0.5);
  const CollapsedMetric g = collapsed_metric(s, begin);
  Twist t;
  t.G11 = g.g22 * g.over;
  t.G22 = g.g11 * g.over;
  t.G12 = -g.g12 * g.over;
  t.w1 = t.G11 * g.v1 + t.G12 * g.v2;
  t.w2 = t.G12 * g.v1 + t.G22 * g.v2;
  t.q = half * (g.v1 * t.w1 + g.v2 * t.w2);
  const Pack by_det = g.slope * adjugate_form(g);
  t.slope[0] = half * t.w1;
  t.slope[1] = -t.slope[0];
  t.slope[2] = half * t.w2;
  t.slope[3] = -t.slope[2];
  t.slope[4] = g.over * g.v2 * g.v2 + by_det * g.g22;
  t.slope[5] = g.over * g.v1 * g.v1 + by_det * g.g11;
  t.slope[6] = -g.over * g.v1 * g.v2 - by_det * g.g12;
  const Pack* const from = &regular.q;
  Pack* const to = &t.q;
  for (unsigned i = 0; i < sizeof(Twist) / sizeof(Pack); ++i) to[i] = select(collapsed, to[i], from[i]);
  return t;
}

// q = v.G^-1 v / 2 from the other samples s, which contain v and G; and its derivatives by them.
inline Pack in_plane_twist(const Pack s[7], const double* geometry, Membrane& m) {
  const Pack half(0.5), two(2.0), one(1.0);
  const Pack v1 = half * (s[0] - s[1]), v2 = half * (s[2] - s[3]);
  const Pack g11 = two * s[4], g22 = two * s[5], g12 = s[6], det = g11 * g22 - g12 * g12, over = one / det;
  Twist t;
  t.G11 = g22 * over;
  t.G22 = g11 * over;
  t.G12 = -g12 * over;
  t.w1 = t.G11 * v1 + t.G12 * v2;
  t.w2 = t.G12 * v1 + t.G22 * v2;
  t.slope[0] = half * t.w1;
  t.slope[1] = -t.slope[0];
  t.slope[2] = half * t.w2;
  t.slope[3] = -t.slope[2];
  t.slope[4] = -t.w1 * t.w1;
  t.slope[5] = -t.w2 * t.w2;
  t.slope[6] = -t.w1 * t.w2;
  t.q = half * (v1 * t.w1 + v2 * t.w2);
  const Pack begin = det_where_collapse_begins(geometry);
  m.collapsed = det < begin;
  if (any(m.collapsed)) [[unlikely]]
    t = collapsed_twist(s, begin, m.collapsed, t);
  m.G11 = t.G11;
  m.G22 = t.G22;
  m.G12 = t.G12;
  m.w1 = t.w1;
  m.w2 = t.w2;
  for (int i = 0; i < 7; ++i) m.slope[i] = t.slope[i];
  return t.q;
}

// Entry (i, k) of the matrix A of the enhanced modes.
inline Pack mode(const double* geometry, int i, int k) {
  return load(geometry + (Shell4Layout::modes + kSamples * i + k) * lanes);
}

// Amplitudes of the enhanced modes for the samples v.
template <Sharing sharing = Sharing::none>
inline void modes_of(const double* geometry, const Pack v[kSamples], Pack alpha[kEnhanced]) {
  for (int i = 0; i < kEnhanced; ++i) {
    if constexpr (sharing == Sharing::element) {
      alpha[i] = mode(geometry, i, 0) * (v[0] - v[1]) + mode(geometry, i, 2) * (v[2] - v[3]);
    } else {
      alpha[i] = mode(geometry, i, 0) * v[0];
      for (int j = 1; j < kSamples; ++j) alpha[i] += mode(geometry, i, j) * v[j];
    }
  }
}

// All samples but q, in the present configuration.
inline void metric_samples(const Kinematics& k, Pack s[7]) {
  const Pack half(0.5);
  for (int e = 0; e < 4; ++e) s[e] = half * dot(k.edge[e].chord, k.edge[e].chord);
  s[4] = half * dot(k.mid1, k.mid1);
  s[5] = half * dot(k.mid2, k.mid2);
  s[6] = dot(k.mid1, k.mid2);
}

template <Sharing sharing = Sharing::none>
inline Membrane membrane(const Kinematics& k, const double* geometry) {
  Membrane m;
  metric_samples(k, m.strain);
  m.strain[7] = in_plane_twist(m.strain, geometry, m);
  for (int i = 0; i < kSamples; ++i) m.strain[i] -= load(geometry + (Shell4Layout::samples + i) * lanes);
  modes_of<sharing>(geometry, m.strain, m.alpha);
  if constexpr (sharing == Sharing::element) return m;
  m.c1 = load(geometry + Shell4Layout::distortion * lanes);
  m.c2 = load(geometry + (Shell4Layout::distortion + 1) * lanes);
  return m;
}

// Transforms enhanced strains from the middle's axes to point g: the base
// vectors there are F times those in the middle, and j / j0 = det F.
struct AxisTransform {
  Pack c[3][3];
};

inline AxisTransform axis_transform(const Membrane& m, int g) {
  const Pack r(kXi[g]), s(kEta[g]), one(1.0), two(2.0);
  const Pack F11 = one + s * m.c1, F12 = s * m.c2, F21 = r * m.c1, F22 = one + r * m.c2;
  const Pack over = one / (one + s * m.c1 + r * m.c2);
  return {{{over * F11 * F11, over * F12 * F12, over * F11 * F12},
           {over * F21 * F21, over * F22 * F22, over * F21 * F22},
           {two * over * F11 * F21, two * over * F12 * F22, over * (F11 * F22 + F12 * F21)}}};
}

// (c11, c22, 2 c12) at point g from samples v and modes alpha: strains, or a column of their operator.
template <Sharing sharing = Sharing::none>
inline void membrane_at(const AxisTransform& to, int g, const Pack v[kSamples], const Pack alpha[kEnhanced],
                        Pack out[3]) {
  const double r = kXi[g], s = kEta[g];
  const Pack e[3] = {Pack(r) * alpha[0], Pack(s) * alpha[1], Pack(r) * alpha[2] + Pack(s) * alpha[3]};
  out[0] = Pack((1 + s) / 2) * v[0] + Pack((1 - s) / 2) * v[1] + Pack(s * s - 1) * v[7];
  out[1] = Pack((1 + r) / 2) * v[2] + Pack((1 - r) / 2) * v[3] + Pack(r * r - 1) * v[7];
  out[2] = v[6] + Pack(r / 2) * (v[0] - v[1]) + Pack(s / 2) * (v[2] - v[3]) + Pack(2 * r * s) * v[7];
  for (int i = 0; i < 3; ++i)
    out[i] += sharing == Sharing::element ? e[i] : to.c[i][0] * e[0] + to.c[i][1] * e[1] + to.c[i][2] * e[2];
}

// All quantities at an in-plane point that do not depend on the thickness coordinate.
struct InPlane : Strains {
  V3 a1, a2, b1, b2;
  AxisTransform axis_transform;
};

// The shears of the edges over chord.mean: own times that of the edge, and other times that of the edge
// opposite.
struct Levers {
  Pack own[2], other[2];
  explicit Levers(const double* geometry) {
    for (int d = 0; d < 2; ++d) {
      own[d] = load(geometry + (Shell4Layout::levers + d) * lanes);
      other[d] = load(geometry + (Shell4Layout::levers + 2 + d) * lanes);
    }
  }
  Pack of(const Pack v[4], int e) const { return own[e / 2] * v[e] + other[e / 2] * v[e ^ 1]; }
  // The weight of chord.mean of an edge in the shear at in-plane point g.
  Pack weight(int g, int e) const {
    return Pack(tie(g, e)) * own[e / 2] + Pack(tie(g, e ^ 1)) * other[e / 2];
  }
};

// Shears 2 c_i3 at the midpoints of the edges, eased.
inline void edge_shears(const Kinematics& k, const double* geometry, const Levers& levers, Pack gamma[4]) {
  Pack products[4];
  for (int e = 0; e < 4; ++e) products[e] = dot(k.edge[e].chord, k.edge[e].mean);
  for (int e = 0; e < 4; ++e) gamma[e] = levers.of(products, e) - load(geometry + e * lanes);
}

// Written in place: two kilobytes that a copy would move through memory.
template <Sharing sharing = Sharing::none>
inline void in_plane(const Kinematics& k, const double* reference, const Membrane& m, const Pack gamma[4],
                     int g, InPlane& p) {
  const ArcEdge* e = k.edge;
  p.a1 = k.mid1 + Pack(kEta[g]) * k.twist;
  p.a2 = k.mid2 + Pack(kXi[g]) * k.twist;
  p.b1 = Pack(tie(g, 0)) * e[0].beta + Pack(tie(g, 1)) * e[1].beta;
  p.b2 = Pack(tie(g, 2)) * e[2].beta + Pack(tie(g, 3)) * e[3].beta;
  if constexpr (sharing != Sharing::element) p.axis_transform = axis_transform(m, g);
  membrane_at<sharing>(p.axis_transform, g, m.strain, m.alpha, p.eps);
  const Pack half(0.5);
  p.kappa[0] = dot(p.a1, p.b1);
  p.kappa[1] = dot(p.a2, p.b2);
  p.kappa[2] = dot(p.a1, p.b2) + dot(p.a2, p.b1);
  p.rho[0] = half * dot(p.b1, p.b1);
  p.rho[1] = half * dot(p.b2, p.b2);
  p.rho[2] = dot(p.b1, p.b2);
  for (int i = 0; i < 3 && sharing == Sharing::none; ++i) {
    p.kappa[i] -= load(reference + i * lanes);
    p.rho[i] -= load(reference + (3 + i) * lanes);
  }
  p.g1 = Pack(tie(g, 0)) * gamma[0] + Pack(tie(g, 1)) * gamma[1];
  p.g2 = Pack(tie(g, 2)) * gamma[2] + Pack(tie(g, 3)) * gamma[3];
}

// The shares by which the strains of warp and weft are eased (see shell4.hpp), and what is needed of the
// in-plane points: rows that take c11, c22, 2 c12 to the strain along a yarn, columns that take it back at
// unchanged other material components, and the points' shares of the volume.
struct Easing {
  Pack of[2];
  bool any;
  struct Point {
    Pack row[2][3], column[2][3], share;
  } point[gauss_points];
};

inline void load_easing_at(const double* columns, Easing::Point& p) {
  const auto in = [&](int i) { return load(columns + i * lanes); };
  const Pack T11 = in(0), T12 = in(1), T21 = in(2), T22 = in(3), two(2.0);
  const Pack over = Pack(1.0) / (T11 * T22 - T12 * T21);
  const Pack U11 = over * T22, U12 = -over * T12, U21 = -over * T21, U22 = over * T11;
  const Pack values[2][2][3] = {
      {{T11 * T11, T12 * T12, T11 * T12}, {T21 * T21, T22 * T22, T21 * T22}},
      {{U11 * U11, U21 * U21, two * U11 * U21}, {U12 * U12, U22 * U22, two * U12 * U22}}};
  for (int f = 0; f < 2; ++f)
    for (int i = 0; i < 3; ++i) {
      p.row[f][i] = values[0][f][i];
      p.column[f][i] = values[1][f][i];
    }
  p.share = in(7);
}

inline bool load_easing(const double* geometry, const Shell4Layout& layout, Easing& e) {
  const Pack zero(0.0);
  for (int f = 0; f < 2; ++f) e.of[f] = load(geometry + (Shell4Layout::easing + f) * lanes);
  e.any = bits((e.of[0] < zero) | (e.of[1] < zero)) != 0;
  if (!e.any) [[likely]]
    return false;
  Pack volume(0.0);
  for (int g = 0; g < gauss_points; ++g) {
    load_easing_at(geometry + layout.point(g, 0) * lanes, e.point[g]);
    volume += e.point[g].share;
  }
  const Pack over = Pack(1.0) / volume;
  for (auto& p : e.point) p.share = over * p.share;
  return true;
}

// Eases covariant strains of the points, or columns of their operator.
inline void ease(const Easing& e, Pack* const (&eps)[gauss_points]) {
  Pack along[2][gauss_points], mean[2] = {Pack(0.0), Pack(0.0)};
  for (int g = 0; g < gauss_points; ++g)
    for (int f = 0; f < 2; ++f) {
      const Pack* row = e.point[g].row[f];
      along[f][g] = row[0] * eps[g][0] + row[1] * eps[g][1] + row[2] * eps[g][2];
      mean[f] += e.point[g].share * along[f][g];
    }
  for (int g = 0; g < gauss_points; ++g)
    for (int f = 0; f < 2; ++f) {
      const Pack change = e.of[f] * (along[f][g] - mean[f]);
      for (int i = 0; i < 3; ++i) eps[g][i] += change * e.point[g].column[f][i];
    }
}

// The transpose of ease(), for the resultants N of the points.
inline void ease_forces(const Easing& e, Pack* const (&N)[gauss_points]) {
  Pack along[2][gauss_points], sum[2] = {Pack(0.0), Pack(0.0)};
  for (int g = 0; g < gauss_points; ++g)
    for (int f = 0; f < 2; ++f) {
      const Pack* column = e.point[g].column[f];
      along[f][g] = column[0] * N[g][0] + column[1] * N[g][1] + column[2] * N[g][2];
      sum[f] += along[f][g];
    }
  for (int g = 0; g < gauss_points; ++g)
    for (int f = 0; f < 2; ++f) {
      const Pack change = e.of[f] * (along[f][g] - e.point[g].share * sum[f]);
      for (int i = 0; i < 3; ++i) N[g][i] += change * e.point[g].row[f][i];
    }
}

[[gnu::noinline]] void ease_strains(const Easing& e, InPlane* p) {
  ease(e, {p[0].eps, p[1].eps, p[2].eps, p[3].eps});
}
[[gnu::noinline]] void ease_resultants(const Easing& e, Resultants* r) {
  ease_forces(e, {r[0].N, r[1].N, r[2].N, r[3].N});
}

// The same where all points share a transform and a volume: one matrix takes the deviation of a point from
// the mean to its change.
struct SharedEasing {
  Pack of[3][3];
  bool any;
};

inline void load_shared_easing(const double* geometry, const Shell4Layout& layout, SharedEasing& e) {
  const Pack zero(0.0), share[2] = {load(geometry + Shell4Layout::easing * lanes),
                                    load(geometry + (Shell4Layout::easing + 1) * lanes)};
  e.any = bits((share[0] < zero) | (share[1] < zero)) != 0;
  if (!e.any) [[likely]]
    return;
  Easing::Point p;
  load_easing_at(geometry + layout.point(0, 0) * lanes, p);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      e.of[i][j] = share[0] * p.column[0][i] * p.row[0][j] + share[1] * p.column[1][i] * p.row[1][j];
}

template <bool transposed>
inline void ease_alike(const SharedEasing& e, Pack* const (&v)[gauss_points]) {
  Pack mean[3];
  for (int i = 0; i < 3; ++i) mean[i] = Pack(0.25) * ((v[0][i] + v[1][i]) + (v[2][i] + v[3][i]));
  for (Pack* const at : v) {
    const Pack d[3] = {at[0] - mean[0], at[1] - mean[1], at[2] - mean[2]};
    for (int i = 0; i < 3; ++i) {
      const auto of = [&](int j) { return transposed ? e.of[j][i] : e.of[i][j]; };
      at[i] += of(0) * d[0] + of(1) * d[1] + of(2) * d[2];
    }
  }
}

[[gnu::noinline]] void ease_strains(const SharedEasing& e, InPlane* p) {
  ease_alike<false>(e, {p[0].eps, p[1].eps, p[2].eps, p[3].eps});
}
[[gnu::noinline]] void ease_resultants(const SharedEasing& e, Resultants* r) {
  ease_alike<true>(e, {r[0].N, r[1].N, r[2].N, r[3].N});
}

// Sums of the resultants over all points, work-conjugate to the samples and enhanced modes, to mid1 mid2
// twist (without the membrane part), to beta of the edges, and to chord.mean of the edges.
struct ConjugateForces {
  Pack sample[kSamples], mode[kEnhanced];
  V3 x[3], beta[4];
  Pack shear[4];
};

inline void clear(ConjugateForces& f) {
  const Pack zero(0.0);
  for (Pack& n : f.sample) n = zero;
  for (Pack& n : f.mode) n = zero;
  for (V3& v : f.x) v = {zero, zero, zero};
  for (int e = 0; e < 4; ++e) f.beta[e] = {zero, zero, zero}, f.shear[e] = zero;
}

// The transpose of membrane_at.
template <Sharing sharing = Sharing::none>
inline void add_membrane(const InPlane& p, const Resultants& q, int g, ConjugateForces& f) {
  const double r = kXi[g], s = kEta[g];
  const Pack* N = q.N;
  f.sample[0] += Pack((1 + s) / 2) * N[0] + Pack(r / 2) * N[2];
  f.sample[1] += Pack((1 - s) / 2) * N[0] - Pack(r / 2) * N[2];
  f.sample[2] += Pack((1 + r) / 2) * N[1] + Pack(s / 2) * N[2];
  f.sample[3] += Pack((1 - r) / 2) * N[1] - Pack(s / 2) * N[2];
  f.sample[6] += N[2];
  f.sample[7] += Pack(s * s - 1) * N[0] + Pack(r * r - 1) * N[1] + Pack(2 * r * s) * N[2];
  Pack e[3];
  for (int j = 0; j < 3; ++j)
    e[j] = sharing == Sharing::element ? N[j]
                                       : p.axis_transform.c[0][j] * N[0] + p.axis_transform.c[1][j] * N[1] +
                                             p.axis_transform.c[2][j] * N[2];
  f.mode[0] += Pack(r) * e[0];
  f.mode[1] += Pack(s) * e[1];
  f.mode[2] += Pack(r) * e[2];
  f.mode[3] += Pack(s) * e[2];
}

template <Sharing sharing = Sharing::none>
inline void add_force(const InPlane& p, const Resultants& r, int g, ConjugateForces& f) {
  add_membrane<sharing>(p, r, g, f);
  const V3 on_a1 = r.M[0] * p.b1 + r.M[2] * p.b2, on_a2 = r.M[2] * p.b1 + r.M[1] * p.b2;
  f.x[0] += on_a1;
  f.x[1] += on_a2;
  f.x[2] += Pack(kEta[g]) * on_a1 + Pack(kXi[g]) * on_a2;
  const V3 on_b1 = r.M[0] * p.a1 + r.M[2] * p.a2 + r.K[0] * p.b1 + r.K[2] * p.b2;
  const V3 on_b2 = r.M[2] * p.a1 + r.M[1] * p.a2 + r.K[2] * p.b1 + r.K[1] * p.b2;
  for (int e = 0; e < 4; ++e) {
    f.beta[e] += Pack(tie(g, e)) * (e < 2 ? on_b1 : on_b2);
    f.shear[e] += Pack(tie(g, e)) * r.Q[e / 2];
  }
}

// After all points: adds the forces of the modes to the samples, and those of q to the others; takes those of
// the shears to chord.mean.
template <Sharing sharing = Sharing::none>
inline void close(const Membrane& m, const double* geometry, const Levers& levers, ConjugateForces& f) {
  for (int i = 0; i < kEnhanced; ++i)
    for (int k = 0; k < (sharing == Sharing::element ? 4 : kSamples); ++k) {
      const int chord =
          sharing == Sharing::element ? k / 2 * 2 : k;  // the second of two chords has the opposite sign
      const Pack n = mode(geometry, i, chord) * f.mode[i];
      f.sample[k] += chord == k ? n : -n;
    }
  for (int k = 0; k < 7; ++k) f.sample[k] += f.sample[7] * m.slope[k];
  const Pack shear[4] = {f.shear[0], f.shear[1], f.shear[2], f.shear[3]};
  for (int e = 0; e < 4; ++e) f.shear[e] = levers.of(shear, e);
}

struct NodeForces {
  V3 x[4], d[4];
};

inline NodeForces on_nodes(const Kinematics& k, const ConjugateForces& f) {
  V3 x[3] = {f.x[0] + f.sample[4] * k.mid1 + f.sample[6] * k.mid2,
             f.x[1] + f.sample[5] * k.mid2 + f.sample[6] * k.mid1, f.x[2]};
  NodeForces n;
  const Pack zero(0.0), half(0.5), quarter(0.25);
  for (V3& v : n.d) v = {zero, zero, zero};
  for (int e = 0; e < 4; ++e) {
    const ArcEdge& edge = k.edge[e];
    const V3 on_chord = f.sample[e] * edge.chord + f.shear[e] * edge.mean;
    x[e / 2] += on_chord;
    x[2] += Pack(kTwist[e]) * on_chord;
    const V3 on_delta = half * through_arc(edge, f.beta[e]), on_mean = half * (f.shear[e] * edge.chord);
    n.d[kEdge[e][0]] += on_mean - on_delta;
    n.d[kEdge[e][1]] += on_mean + on_delta;
  }
  for (V3& v : x) v = quarter * v;
  for (int a = 0; a < 4; ++a)
    n.x[a] = Pack(kNodeSign[0][a]) * x[0] + Pack(kNodeSign[1][a]) * x[1] + Pack(kNodeSign[2][a]) * x[2];
  return n;
}

inline void store_forces(const NodeForces& f, double* out) {
  for (int a = 0; a < 4; ++a) {
    store3(out, 3 * a, f.x[a]);
    store3(out, 12 + 3 * a, f.d[a]);
  }
}

}  // namespace
}  // namespace FABRICSH_ISA
}  // namespace fabricsh::element
