// Shared by the batch kernels of all shell elements: vectors of packs, the transformation between covariant
// and material strains, and the law through the thickness. Included only by the *_isa.cpp files of this room.
#pragma once
#include "element/shell4.hpp"
#include "law/branches.hpp"
#include "law/part.hpp"
#include "law/potential.hpp"
#include "simd/pack3.hpp"

namespace fabricsh::element {
inline namespace FABRICSH_ISA {
namespace {

constexpr int transform_size = 8;  // T11 T12 T21 T22 q1 q2 s w

using V3 = Pack3;
inline V3 load3(const double* p, int i) {
  return {load(p + i * lanes), load(p + (i + 1) * lanes), load(p + (i + 2) * lanes)};
}
inline void store3(double* p, int i, V3 v) {
  store(p + i * lanes, v.x);
  store(p + (i + 1) * lanes, v.y);
  store(p + (i + 2) * lanes, v.z);
}

// Changes of the covariant strains since the reference at an in-plane point: eps,
// kappa, rho in the order (11, 22, 2 12), and the assumed shears 2 c13, 2 c23.
struct Strains {
  Pack eps[3], kappa[3], rho[3];
  Pack g1, g2;
};

// L: from covariant (c11 c22 2c12 g1 g2) to material strains (E11 E22 2E23 2E13 2E12).
struct Transform {
  Pack L[5][5];
  Pack weight;
};

inline Transform transform(const double* column) {
  auto in = [&](int i) { return load(column + i * lanes); };
  const Pack T11 = in(0), T12 = in(1), T21 = in(2), T22 = in(3), q1 = in(4), q2 = in(5), s = in(6);
  const Pack two(2.0), zero(0.0);
  Transform t{{{T11 * T11, T12 * T12, T11 * T12, zero, zero},
               {T21 * T21, T22 * T22, T21 * T22, zero, zero},
               {two * T21 * q1, two * T22 * q2, T21 * q2 + T22 * q1, T21 * s, T22 * s},
               {two * T11 * q1, two * T12 * q2, T11 * q2 + T12 * q1, T11 * s, T12 * s},
               {two * T11 * T21, two * T12 * T22, T11 * T22 + T12 * T21, zero, zero}},
              in(7)};
  return t;
}

inline void material_strain(const Strains& p, const Transform& t, double z, double* E) {
  const Pack zz(z), z2(z * z);
  Pack c[5];
  for (int i = 0; i < 3; ++i) c[i] = p.eps[i] + zz * p.kappa[i] + z2 * p.rho[i];
  c[3] = p.g1;
  c[4] = p.g2;
  for (int i = 0; i < 5; ++i) {
    Pack e = t.L[i][0] * c[0] + t.L[i][1] * c[1] + t.L[i][2] * c[2];
    if (i == 2 || i == 3) e += t.L[i][3] * c[3] + t.L[i][4] * c[4];
    store(E + i * lanes, e);
  }
}

// Stress resultants at an in-plane point times the reference
// volume weights: work-conjugate to (eps kappa rho g).
struct Resultants {
  Pack N[3], M[3], K[3], Q[2];
};

// Tangent of the eleven resultants: Z[m] is sum w z^m L^T C L over in-plane rows and columns; the shear
// blocks are separate. For a symmetric section only the upper half of Z is used, and g_in stays zero.
struct ThicknessMoments {
  Pack Z[5][3][3];     // z^0 .. z^4
  Pack in_g[3][3][2];  // z^0 .. z^2: rows in-plane, columns shear
  Pack g_in[3][2][3];
  Pack g_g[2][2];
  Pack bending[3][3];  // separate bending: rows and columns of the curvatures only
};

inline void clear(Resultants& r) {
  for (Pack* p : {r.N, r.M, r.K})
    for (int i = 0; i < 3; ++i) p[i] = Pack(0.0);
  r.Q[0] = r.Q[1] = Pack(0.0);
}

inline void clear(ThicknessMoments& s) {
  Pack* p = &s.Z[0][0][0];
  for (unsigned i = 0; i < sizeof(ThicknessMoments) / sizeof(Pack); ++i) p[i] = Pack(0.0);
}

inline void add_stress(const Transform& t, const double* S, double z, Resultants& r) {
  Pack s[5];
  for (int i = 0; i < 5; ++i) s[i] = t.weight * load(S + i * lanes);
  const Pack zz(z), z2(z * z);
  for (int j = 0; j < 3; ++j) {
    Pack c(0.0);
    for (int i = 0; i < 5; ++i) c += t.L[i][j] * s[i];
    r.N[j] += c;
    r.M[j] += zz * c;
    r.K[j] += z2 * c;
  }
  for (int j = 0; j < 2; ++j) r.Q[j] += t.L[2][3 + j] * s[2] + t.L[3][3 + j] * s[3];
}

inline void add_powers(const Pack (&D)[5][5], double z, bool symmetric, ThicknessMoments& k,
                       bool coupled = true) {
  double power = 1;
  for (int m = 0; m < 5; ++m, power *= z)
    for (int i = 0; i < 3; ++i) {
      for (int j = symmetric ? i : 0; j < 3; ++j) k.Z[m][i][j] += Pack(power) * D[i][j];
      if (m < 3 && coupled)
        for (int j = 0; j < 2; ++j) {
          k.in_g[m][i][j] += Pack(power) * D[i][3 + j];
          if (!symmetric) k.g_in[m][j][i] += Pack(power) * D[3 + j][i];
        }
    }
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) k.g_g[i][j] += D[3 + i][3 + j];
}

// Whether the director is normal to the element in all lanes: no in-plane strain shears it.
inline bool is_level(const Transform& t) {
  unsigned tilted = 0;
  for (int i = 2; i < 4; ++i)
    for (int j = 0; j < 3; ++j) tilted |= bits(!(t.L[i][j] == Pack(0.0)));
  return tilted == 0;
}

inline void add_tangent(const Transform& t, const double* C, double z, ThicknessMoments& k) {
  Pack CL[5][5], D[5][5];
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      Pack c(0.0);
      for (int m = 0; m < 5; ++m)
        if (j < 3 || m == 2 || m == 3) c += load(C + (5 * i + m) * lanes) * t.L[m][j];
      CL[i][j] = t.weight * c;
    }
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      Pack c(0.0);
      for (int m = 0; m < 5; ++m)
        if (i < 3 || m == 2 || m == 3) c += t.L[m][i] * CL[m][j];
      D[i][j] = c;
    }
  add_powers(D, z, false, k);
}

// The same for a symmetric law with elastic uncoupled
// transverse shear, C13 = C23 = ... = 0. Fills the upper half.
inline void add_symmetric_tangent(const Transform& t, const double* C, double z, ThicknessMoments& k) {
  constexpr int in[3] = {0, 1, 4};
  const auto at = [&](int i, int j) { return t.weight * load(C + (5 * i + j) * lanes); };
  Pack D[5][5], CL[3][3], shear[2] = {at(2, 2), at(3, 3)};
  const bool level = is_level(t);
  for (int i = 0; i < 3; ++i) {
    const Pack c[3] = {at(in[i], 0), at(in[i], 1), at(in[i], 4)};
    for (int j = 0; j < 3; ++j) CL[i][j] = c[0] * t.L[0][j] + c[1] * t.L[1][j] + c[2] * t.L[4][j];
  }
  for (int i = 0; i < 5; ++i) {
    if (level && i < 3) continue;
    const Pack s2 = shear[0] * t.L[2][i], s3 = shear[1] * t.L[3][i];
    for (int j = i; j < 5; ++j) D[i][j] = s2 * t.L[2][j] + s3 * t.L[3][j];
  }
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      const Pack in_plane = t.L[0][i] * CL[0][j] + t.L[1][i] * CL[1][j] + t.L[4][i] * CL[2][j];
      D[i][j] = level ? in_plane : D[i][j] + in_plane;
    }
  D[4][3] = D[3][4];
  add_powers(D, z, true, k, !level);
}

// Stores the trial states of a law; `place` is the offset of the first of them in the batch's states. In
// place only changed packs are written: most states change in few steps, and memory traffic limits the speed.
// A batch's states must be put in their order.
inline void put_states(const ShellBatch& batch, long place, int count, const Pack* old, const Pack* trial) {
  if (batch.changed == nullptr) {
    for (int i = 0; i < count; ++i) store(batch.s1 + place + i * lanes, trial[i]);
    return;
  }
  unsigned char* changed = batch.changed + place / lanes;
  double* log = *batch.log;
  for (int i = 0; i < count; ++i) {
    const unsigned bits = differing(old[i], trial[i]);
    const unsigned before = batch.first_lane == 0 ? 0 : changed[i];
    changed[i] = static_cast<unsigned char>(before | bits << batch.first_lane);
    if (bits == 0) continue;
    store(log, old[i]);
    log += pack_width;
    store(batch.now + place + i * lanes, trial[i]);
  }
  *batch.log = log;
}

// The same for trial states in memory.
inline void put_states(const ShellBatch& batch, long place, int count, const double* trial) {
  for (int i = 0; i < count; ++i) {
    const Pack old = load(batch.s0 + place + i * lanes), now = load(trial + i * lanes);
    put_states(batch, place + i * lanes, 1, &old, &now);
  }
}

// The branches of the yarns in a tangent; null: they keep to none.
inline double* branches_of(const ShellBatch& batch) { return batch.changed == nullptr ? batch.now : nullptr; }

// Separate bending: springs on the material curvatures (11, 22, 2 12) at the middle thickness point. Friction
// states s0, s1: slip, lost and with fading also last, of warp, then of weft; null without friction.
inline void add_bending(const section::Section& section, const law::Step& step, const Strains& p,
                        const Transform& t, const double* s0, double* s1, Resultants& r,
                        ThicknessMoments* k) {
  const Pack area = t.weight / Pack(section.thickness);
  constexpr int row[3] = {0, 1, 4};
  for (int m = 0; m < 3; ++m) {
    const Pack* L = t.L[row[m]];
    const Pack kappa = L[0] * p.kappa[0] + L[1] * p.kappa[1] + L[2] * p.kappa[2];
    law::BendingState<Pack> state;
    const bool rubs = s0 != nullptr && m < 2;
    const int first = section.bending_states * m * lanes;
    if (rubs) state = {load(s0 + first), load(s0 + first + lanes)};
    if (rubs && section.bending_states == 3) state.last = load(s0 + first + 2 * lanes);
    const auto bent = law::bending_moment(section.bending[m], step.at, kappa, state);
    if (rubs) {
      store(s1 + first, state.slip);
      store(s1 + first + lanes, state.lost);
      if (section.bending_states == 3) store(s1 + first + 2 * lanes, state.last);
    }
    for (int i = 0; i < 3; ++i) {
      r.M[i] += L[i] * area * bent.M;
      if (k != nullptr)
        for (int j = 0; j < 3; ++j) k->bending[i][j] += area * bent.C * L[i] * L[j];
    }
  }
}

inline double height(const section::Section& section, int k) {
  return section.thickness / 2 * (section.points[k].zeta - section.offset);
}

// Bending at in-plane point g, with the transform of the section's only thickness point.
inline void add_bending_at(const section::Section& section, const law::Step& step, const ShellBatch& batch,
                           const Strains& p, const Transform& t, int g, Resultants& r, ThicknessMoments* k) {
  if (section.bending_state < 0) return add_bending(section, step, p, t, nullptr, nullptr, r, k);
  const long offset = static_cast<long>(g * section.state_size + section.bending_state) * lanes;
  if (batch.changed == nullptr)
    return add_bending(section, step, p, t, batch.s0 + offset, batch.s1 + offset, r, k);
  alignas(64) double trial[6 * lanes];
  add_bending(section, step, p, t, batch.s0 + offset, trial, r, k);
  put_states(batch, offset, 2 * section.bending_states, trial);
}

// Sums over the thickness of weight times z^m times the tangent of a plain law, m = 0 to 4, in material axes.
struct PlainTangents {
  Pack C11[5], C12[5], C22[5], C55[5];
};

inline void clear(PlainTangents& c) {
  for (Pack* p : {c.C11, c.C12, c.C22, c.C55})
    for (int m = 0; m < 5; ++m) p[m] = Pack(0.0);
}

template <class Response>
inline void add_tangent(const Response& at_point, Pack weight, Pack z, PlainTangents& c) {
  Pack power = weight;
  for (int m = 0; m < 5; ++m) {
    c.C11[m] += power * at_point.C11;
    c.C12[m] += power * at_point.C12;
    c.C22[m] += power * at_point.C22;
    c.C55[m] += power * at_point.C55;
    power = power * z;
  }
}

// Clears what put_tangent() does not write and a symmetric section uses.
inline void clear_rest(ThicknessMoments& k) {
  Pack* in_g = &k.in_g[0][0][0];
  for (unsigned i = 0; i < sizeof k.in_g / sizeof(Pack); ++i) in_g[i] = Pack(0.0);
  Pack* bending = &k.bending[0][0];
  for (unsigned i = 0; i < sizeof k.bending / sizeof(Pack); ++i) bending[i] = Pack(0.0);
}

// The upper half of the tangent of the resultants. shear: the sum of weight times the modulus of transverse
// shear; volume: the reference volume of a weight of one.
inline void put_tangent(const PlainTangents& c, Pack shear, Pack volume, const Transform& t,
                        ThicknessMoments& k) {
  clear_rest(k);
  for (int j = 0; j < 3; ++j) {
    const Pack L[3] = {volume * t.L[0][j], volume * t.L[1][j], volume * t.L[4][j]};
    for (int m = 0; m < 5; ++m) {
      const Pack S[3] = {c.C11[m] * L[0] + c.C12[m] * L[1], c.C12[m] * L[0] + c.C22[m] * L[1],
                         c.C55[m] * L[2]};
      for (int i = 0; i <= j; ++i) k.Z[m][i][j] = t.L[0][i] * S[0] + t.L[1][i] * S[1] + t.L[4][i] * S[2];
    }
  }
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      k.g_g[i][j] = volume * shear * (t.L[2][3 + i] * t.L[2][3 + j] + t.L[3][3 + i] * t.L[3][3 + j]);
}

// Evaluates the law through the thickness where all points have one plain law and one transform: strains E =
// e + z k + z^2 q and resultants in material axes. The sum of the stresses shows whether any is not finite.
// at_point(response, weight, height) and at_end(volume) let a caller sum the tangent, too; bending: null
// without it.
template <class OnBranches, class AtPoint, class AtEnd>
inline unsigned through_thickness(const section::Section& section, const law::Step& step,
                                  const ShellBatch& batch, const Transform& t, const Strains& p, int g,
                                  Resultants& r, ThicknessMoments* bending, OnBranches on_branches,
                                  AtPoint at_point, AtEnd at_end) {
  constexpr int row[3] = {0, 1, 4}, states = law::potential_state::count;
  Pack e[3], k[3], q[3], E[5], old[states], trial[states];
  for (int i = 0; i < 3; ++i) {
    const Pack* L = t.L[row[i]];
    e[i] = L[0] * p.eps[0] + L[1] * p.eps[1] + L[2] * p.eps[2];
    k[i] = L[0] * p.kappa[0] + L[1] * p.kappa[1] + L[2] * p.kappa[2];
    q[i] = L[0] * p.rho[0] + L[1] * p.rho[1] + L[2] * p.rho[2];
  }
  for (int i = 2; i < 4; ++i) E[i] = t.L[i][3] * p.g1 + t.L[i][4] * p.g2;
  Resultants m;  // in material axes
  clear(m);
  for (const auto& point : section.points) {
    const double height = section.thickness / 2 * (point.zeta - section.offset);
    const Pack z(height), weight(point.weight);
    for (int i = 0; i < 3; ++i) E[row[i]] = e[i] + z * (k[i] + z * q[i]);
    const long offset = static_cast<long>(g * section.state_size + point.state) * lanes;
    for (int i = 0; i < states; ++i) old[i] = load(batch.s0 + offset + i * lanes);
    auto out = law::potential_update(*section.plain, step.at, E, old, trial);
    put_states(batch, offset, states, old, trial);
    on_branches(*section.plain, offset, E, old, out);
    for (int i = 0; i < 3; ++i) {
      const Pack S = weight * out.S[row[i]], zS = z * S;
      m.N[i] += S;
      m.M[i] += zS;
      m.K[i] += z * zS;
    }
    for (int i = 0; i < 2; ++i) m.Q[i] += weight * out.S[2 + i];
    at_point(out, weight, z);
  }
  const Pack volume = t.weight * Pack(1 / section.points[0].weight);
  for (int j = 0; j < 3; ++j) {
    const Pack L[3] = {volume * t.L[0][j], volume * t.L[1][j], volume * t.L[4][j]};
    r.N[j] = L[0] * m.N[0] + L[1] * m.N[1] + L[2] * m.N[2];
    r.M[j] = L[0] * m.M[0] + L[1] * m.M[1] + L[2] * m.M[2];
    r.K[j] = L[0] * m.K[0] + L[1] * m.K[1] + L[2] * m.K[2];
  }
  for (int j = 0; j < 2; ++j) r.Q[j] = volume * (t.L[2][3 + j] * m.Q[0] + t.L[3][3 + j] * m.Q[1]);
  at_end(volume);
  if (section.bends_apart) add_bending_at(section, step, batch, p, t, g, r, bending);
  const Pack sum = (m.N[0] + m.N[1]) + (m.N[2] + m.Q[0]) + m.Q[1];
  return bits(!(sum - sum == Pack(0.0)));
}

// The forces alone, and the forces with the tangent of a symmetric section. They are compiled apart, so that
// how the compiler fuses the products of one does not change the rounding of the other.
[[gnu::flatten, gnu::noinline]] unsigned integrate_plain(const section::Section& section,
                                                         const law::Step& step, const ShellBatch& batch,
                                                         const Transform& t, const Strains& p, int g,
                                                         Resultants& r) {
  const auto nothing = [](auto&&...) {};
  return through_thickness(section, step, batch, t, p, g, r, nullptr, nothing, nothing, nothing);
}

[[gnu::flatten, gnu::noinline]] unsigned integrate_plain_tangent(const section::Section& section,
                                                                 const law::Step& step,
                                                                 const ShellBatch& batch, const Transform& t,
                                                                 const Strains& p, int g, Resultants& r,
                                                                 ThicknessMoments& tangent) {
  PlainTangents c;
  clear(c);
  Pack weights(0.0);
  return through_thickness(
      section, step, batch, t, p, g, r, &tangent,
      [&](const auto& law, long place, const Pack* E, const Pack* old, auto& out) {
        double* const at = branches_of(batch);
        if (at == nullptr) return;
        Pack branches[3];
        for (int i = 0; i < 3; ++i) branches[i] = load(at + place + i * lanes);
        const Pack strain[3] = {E[0], E[1], E[4]};
        law::put_on_branches(law, step.at, strain, old, branches, {&out.S[0], &out.S[1], &out.S[4]},
                             {&out.C11, &out.C22, &out.C55});
        for (int i = 0; i < 3; ++i) store(at + place + i * lanes, branches[i]);
      },
      [&](const auto& response, Pack weight, Pack z) {
        add_tangent(response, weight, z, c);
        weights += weight;
      },
      [&](Pack volume) { put_tangent(c, weights * Pack(section.plain->transverse), volume, t, tangent); });
}

// The yarns of a law in memory on their branches.
[[gnu::noinline]] void put_on_branches(const law::Law& law, law::AtSwitch at, const double* E,
                                       const double* s0, double* branches, double* S, double* C) {
  constexpr int of_E[3] = {0, 1, 4}, of_C[3] = {0, 6, 24};
  Pack strain[3], branch[3], stress[3], slope[3], old[law::potential_state::count];
  for (int i = 0; i < law::potential_state::count; ++i) old[i] = load(s0 + i * lanes);
  for (int i = 0; i < 3; ++i) {
    strain[i] = load(E + of_E[i] * lanes);
    branch[i] = load(branches + i * lanes);
    stress[i] = load(S + of_E[i] * lanes);
    slope[i] = load(C + of_C[i] * lanes);
  }
  law::put_on_branches(law.woven, at, strain, old, branch, {&stress[0], &stress[1], &stress[2]},
                       {&slope[0], &slope[1], &slope[2]});
  for (int i = 0; i < 3; ++i) {
    store(branches + i * lanes, branch[i]);
    store(S + of_E[i] * lanes, stress[i]);
    store(C + of_C[i] * lanes, slope[i]);
  }
}

// Evaluates the law through the thickness at in-plane point g; columns: its first transform.
inline unsigned integrate(const section::Section& section, const law::Step& step, const ShellBatch& batch,
                          const double* columns, const Strains& p, int g, Resultants& r,
                          ThicknessMoments* k) {
  if (batch.sharing != Sharing::none && section.plain != nullptr) {
    const Transform t = transform(columns);
    if (k == nullptr) return integrate_plain(section, step, batch, t, p, g, r);
    if (section.symmetric) return integrate_plain_tangent(section, step, batch, t, p, g, r, *k);
  }
  const int n = static_cast<int>(section.points.size());
  alignas(64) double E[5 * lanes], S[5 * lanes], C[25 * lanes], trial[law::most_states * lanes];
  unsigned failed = 0;
  clear(r);
  if (k != nullptr) clear(*k);
  for (int i = 0; i < n; ++i) {
    const auto& point = section.points[i];
    const Transform t = transform(columns + i * transform_size * lanes);
    const double z = height(section, i);
    material_strain(p, t, z, E);
    const long offset = static_cast<long>(g * section.state_size + point.state) * lanes;
    double* const s1 = batch.changed == nullptr ? batch.s1 + offset : trial;
    failed |=
        law::part_for(*point.law)(*point.law, step, E, batch.s0 + offset, s1, S, k != nullptr ? C : nullptr);
    if (batch.changed != nullptr) put_states(batch, offset, point.law->state_size, trial);
    if (k != nullptr && branches_of(batch) != nullptr && law::has_branches(*point.law))
      put_on_branches(*point.law, step.at, E, batch.s0 + offset, branches_of(batch) + offset, S, C);
    add_stress(t, S, z, r);
    if (k != nullptr) section.symmetric ? add_symmetric_tangent(t, C, z, *k) : add_tangent(t, C, z, *k);
    if (section.bends_apart) add_bending_at(section, step, batch, p, t, g, r, k);
  }
  return failed;
}

// For Shell4Astray. along: the least product of a director with the normal, of any length; bend:
// the largest of an edge's chord with its directors' difference, both whole.
inline PackMask leans(Pack along, V3 normal, double cosine) {
  return along * abs(along) < Pack(cosine * cosine) * dot(normal, normal);
}
inline PackMask bends(Pack bend, double bent) { return bend * bend > Pack(16 * bent); }

// Half an edge: its chord, half the sum of its directors, and beta, half
// their difference lengthened from the chord to the arc between them.
struct ArcEdge {
  V3 chord, mean, delta, beta;
  Pack f, slope, bend;  // beta = f(q) delta with q = delta.delta; f' and f''
};

// Directors at an angle a differ by 2 sin(a / 2), hence f = asin(s) / s with s = |delta|, to its third term
// (error 5e-8 at 20 degrees per edge). Without it the bending resistance would fall off as sin(a) / a.
inline void lengthen(ArcEdge& e) {
  const Pack q = dot(e.delta, e.delta), c1(1.0 / 6), c2(3.0 / 40), two(2.0);
  e.f = Pack(1.0) + q * (c1 + q * c2);
  e.slope = c1 + two * c2 * q;
  e.bend = two * c2;
  e.beta = e.f * e.delta;
}

// The force on delta from a force on beta: J^T F with d beta = J d delta; J is symmetric.
inline V3 through_arc(const ArcEdge& e, V3 F) {
  return e.f * F + (Pack(2.0) * e.slope * dot(e.delta, F)) * e.delta;
}

// Shell4Astray of an element whose normal, of any length, is the product of its diagonals: a - b and c - d.
template <int corners>
unsigned astray(const ShellBatch& batch, const int (&edges)[corners][2], const int (&diagonals)[4],
                double cosine, double bent) {
  V3 x[corners], d[corners];
  for (int a = 0; a < corners; ++a) {
    x[a] = load3(batch.x, 3 * a);
    d[a] = load3(batch.d, 3 * a);
  }
  const V3 normal = cross(x[diagonals[0]] - x[diagonals[1]], x[diagonals[2]] - x[diagonals[3]]);
  Pack along = dot(d[0], normal), bend(0.0);
  for (int a = 1; a < corners; ++a) along = min(along, dot(d[a], normal));
  for (const auto& [i, j] : edges) bend = max(bend, abs(dot(x[j] - x[i], d[j] - d[i])));
  return bits(leans(along, normal, cosine) | bends(bend, bent));
}

// The batch before the last step, for the linear prediction of strains.
inline ShellBatch before_step(const ShellBatch& batch) {
  ShellBatch before = batch;
  before.x = batch.before_x;
  before.d = batch.before_d;
  return before;
}

// Makes kernels for one part of a batch work on a whole batch.
inline ShellBatch part(const ShellBatch& batch, int first) {
  const auto from = [first](auto* p) { return p == nullptr ? p : p + first; };
  return {from(batch.geometry), from(batch.x),        from(batch.d),       from(batch.b),
          from(batch.s0),       from(batch.s1),       batch.sharing,       batch.law_only,
          batch.changed,        from(batch.now),      batch.log,           first,
          batch.wanted,         from(batch.before_x), from(batch.before_d)};
}

template <Shell4Force force, Shell4Tangent tangent, Shell4Strain strain, Shell4Curvature curvature,
          Shell4Inverted inverted, Shell4Astray astray>
Shell4Kernels kernels_of_parts() {
  using section::Section;
  return {[](const Section& section, const law::Step& step, const ShellBatch& batch, double* f) {
            return at_parts([&](int i) { return force(section, step, part(batch, i), f + i); });
          },
          [](const Section& section, const law::Step& step, const ShellBatch& batch, double* f, double* K) {
            return at_parts([&](int i) { return tangent(section, step, part(batch, i), f + i, K + i); });
          },
          [](const Section& section, const ShellBatch& batch, double* E) {
            for (int i = 0; i < lanes; i += pack_width) strain(section, part(batch, i), E + i);
          },
          [](const Section& section, const ShellBatch& batch, double* kappa) {
            for (int i = 0; i < lanes; i += pack_width) curvature(section, part(batch, i), kappa + i);
          },
          [](const ShellBatch& batch) { return at_parts([&](int i) { return inverted(part(batch, i)); }); },
          [](const ShellBatch& batch, double cosine, double bent) {
            return at_parts([&](int i) { return astray(part(batch, i), cosine, bent); });
          },
          pack_width};
}

}  // namespace
}  // namespace FABRICSH_ISA
}  // namespace fabricsh::element
