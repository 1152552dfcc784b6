// Folds within a point: a bound on the compression that the cloth around it carries (share/doc/folds.md).
// An element cannot fold within itself, and so would carry compression that real cloth does not. Here the
// strain E of a point consists of that of the cloth, e, and of what is shortened by folds, F, a symmetric
// tensor without negative eigenvalues [pipkin1986, steigmann1990]:
//   e = E + F,   minimum over F of  W(e) + sigma : F + |F|^2 / 2
// W is the energy of the law in this step, sigma = diag(s1, s2) the stress at which folds begin along the two
// yarns, and |F|^2 = r1 F11^2 + r2 F22^2 + 2 sqrt(r1 r2) F12^2 their stiffness. So S + sigma has no negative
// eigenvalue but for that stiffness: no direction n is compressed by more than s1 n1^2 + s2 n2^2. The minimum
// is a convex function of E, its derivative, the stress, is continuous, and its tangent symmetric and
// positive definite. Where nothing folds F is zero, and everything is as without folds, to the bit.
//
// With a = r1^(1/2), b = r2^(1/2), c = (ab)^(1/2), tensors are scaled to F11 a, F22 b, F12 c and S11 / a,
// S22 / b, S12 / c, which keeps signs of eigenvalues and the product S : F. They are written as
// m = (11 + 22) / 2, d = (11 - 22) / 2, c = 12. With A = S + sigma, the minimum is one of these:
//   taut    F = 0, and A has no negative eigenvalue
//   folded  F = v v^T, (A + F) v = 0: folds in one direction
//   slack   A + F = 0: folds in all directions
// Since the function is convex, whichever is found is the only one.
#pragma once
#include "law/response.hpp"

namespace fabricsh::law {

inline namespace FABRICSH_ISA {

template <class T>
struct Plane {
  T m, d, c;
};

template <class T>
T squared(const Plane<T>& x) {
  return x.m * x.m + x.d * x.d + x.c * x.c;
}

template <class T>
Plane<T> either(decltype(T() < T()) which, const Plane<T>& x, const Plane<T>& y) {
  return {select(which, x.m, y.m), select(which, x.d, y.d), select(which, x.c, y.c)};
}

// Eigenvalues of a tensor, the larger first, and the unit vector of the first.
template <class T>
struct Eigen {
  T first, second, x, y;
};

template <class T>
Eigen<T> eigen(const Plane<T>& M) {
  const T zero(0.0), one(1.0), half(0.5), tiny(1e-150);
  const T radius = sqrt(M.d * M.d + M.c * M.c), safe = max(radius, tiny);
  const T x = sqrt(max(half * (one + M.d / safe), zero)), y = sqrt(max(half * (one - M.d / safe), zero));
  return {M.m + radius, M.m - radius, x, select(M.c < zero, -y, y)};
}

// A symmetric matrix on m, d, c whose entries mc and dc are zero.
template <class T>
struct Blocks {
  T mm, md, dd, cc;
};

template <class T>
Plane<T> operator*(const Blocks<T>& K, const Plane<T>& x) {
  return {K.mm * x.m + K.md * x.d, K.md * x.m + K.dd * x.d, K.cc * x.c};
}

// The scales of a point and its limits, as they are in its state.
template <class T>
struct FoldSite {
  T a, b, c, s1, s2;
  decltype(T() < T()) off;
};

template <class T>
FoldSite<T> fold_site(const T* s) {
  const T one(1.0);
  const auto off = s[fold_state::a] <= T(0.0);
  return {select(off, one, s[fold_state::a]),
          select(off, one, s[fold_state::b]),
          select(off, one, s[fold_state::c]),
          s[fold_state::s1],
          s[fold_state::s2],
          off};
}

template <class T>
Plane<T> scaled_excess(const FoldSite<T>& site, const Response<T>& at) {  // A
  const T half(0.5), x = (at.S[0] + site.s1) / site.a, y = (at.S[1] + site.s2) / site.b;
  return {half * (x + y), half * (x - y), at.S[4] / site.c};
}

template <class T>
Blocks<T> scaled_tangent(const FoldSite<T>& site, const Response<T>& at) {  // K = dA / dF
  const T half(0.5), x = at.C11 / (site.a * site.a), y = at.C22 / (site.b * site.b);
  const T xy = at.C12 / (site.a * site.b);
  return {half * (x + y) + xy, half * (x - y), half * (x + y) - xy, T(2.0) * at.C55 / (site.c * site.c)};
}

// The strain of the cloth: that of the point and what folds have taken.
template <class T>
void add_folds(const FoldSite<T>& site, const Plane<T>& F, const T E[5], T e[5]) {
  e[0] = E[0] + (F.m + F.d) / site.a;
  e[1] = E[1] + (F.m - F.d) / site.b;
  e[2] = E[2];
  e[3] = E[3];
  e[4] = E[4] + T(2.0) * F.c / site.c;
}

// The sum of energies at a trial F = v v^T to second order in the step of v: slope g and matrix H, which is
// positive definite also where A + F is not, since of that only the part with positive eigenvalues counts.
template <class T>
struct Folding {
  T b[3][2];  // dF / dv
  T g[2], xx, xy, yy;

  Folding(const Plane<T>& rest, const Blocks<T>& K, T p, T q) : b{{p, q}, {p, -q}, {q, p}} {
    const T two(2.0), one(1.0), zero(0.0), half(0.5);
    const Eigen<T> e = eigen(rest);
    const T l1 = max(e.first, zero), l2 = max(e.second, zero), mean = half * (l1 + l2),
            radial = half * (l1 - l2);
    const T cosine = e.x * e.x - e.y * e.y, sine = two * e.x * e.y;
    const auto slope = [&](int i) { return two * (rest.m * b[0][i] + rest.d * b[1][i] + rest.c * b[2][i]); };
    const auto bend = [&](int i, int j) {
      const Plane<T> x = K * Plane<T>{b[0][j], b[1][j], b[2][j]};
      return two * (b[0][i] * (x.m + b[0][j]) + b[1][i] * (x.d + b[1][j]) + b[2][i] * (x.c + b[2][j]));
    };
    g[0] = slope(0);
    g[1] = slope(1);
    xx = bend(0, 0) + two * (mean + radial * cosine);
    yy = bend(1, 1) + two * (mean - radial * cosine);
    xy = bend(0, 1) + two * radial * sine;
    const auto flat = xx * yy - xy * xy <= zero;
    xx = select(flat, one + xx, xx);
    yy = select(flat, one + yy, yy);
  }
  // H^-1 times a vector.
  void solve(T x, T y, T& p, T& q) const {
    const T scale = T(1.0) / (xx * yy - xy * xy);
    p = scale * (yy * x - xy * y);
    q = scale * (xx * y - xy * x);
  }
};

// (I + K)^-1 x.
template <class T>
Plane<T> softened(const Blocks<T>& K, const Plane<T>& x) {
  const T one(1.0), mm = one + K.mm, dd = one + K.dd, scale = one / (mm * dd - K.md * K.md);
  return {scale * (dd * x.m - K.md * x.d), scale * (mm * x.d - K.md * x.m), x.c / (one + K.cc)};
}

// The tangent of a point with folds, from that of its cloth: K - 2 K B H^-1 B^T K with folds in one
// direction, (I + K)^-1 K in all.
template <class T>
void fold_tangent(const FoldSite<T>& site, const Blocks<T>& K, const Folding<T>& folding,
                  decltype(T() < T()) taut, decltype(T() < T()) slack, Response<T>& out) {
  const T zero(0.0), one(1.0), half(0.5), two(2.0);
  T t[3][3];
  for (int j = 0; j < 3; ++j) {
    const Plane<T> unit{j == 0 ? one : zero, j == 1 ? one : zero, j == 2 ? one : zero};
    const Plane<T> k = K * unit, all = softened(K, k);
    const auto along = [&](int i) {
      return two * (folding.b[0][i] * k.m + folding.b[1][i] * k.d + folding.b[2][i] * k.c);
    };
    T p, q;
    folding.solve(along(0), along(1), p, q);
    const Plane<T> turned =
        K * Plane<T>{folding.b[0][0] * p + folding.b[0][1] * q, folding.b[1][0] * p + folding.b[1][1] * q,
                     folding.b[2][0] * p + folding.b[2][1] * q};
    t[0][j] = select(slack, all.m, k.m - turned.m);
    t[1][j] = select(slack, all.d, k.d - turned.d);
    t[2][j] = select(slack, all.c, k.c - turned.c);
  }
  const T md = half * (t[0][1] + t[1][0]), mc = half * (t[0][2] + t[2][0]), dc = half * (t[1][2] + t[2][1]);
  const T a = half * site.a, b = half * site.b;
  const auto put = [&](T& entry, T value) { entry = select(taut, entry, value); };
  put(out.C11, a * site.a * (t[0][0] + t[1][1] + two * md));
  put(out.C12, a * site.b * (t[0][0] - t[1][1]));
  put(out.C22, b * site.b * (t[0][0] + t[1][1] - two * md));
  out.C21 = out.C12;
  out.C15 = select(taut, zero, a * site.c * (mc + dc));
  out.C25 = select(taut, zero, b * site.c * (mc - dc));
  put(out.C55, half * site.c * site.c * t[2][2]);
}

// The search for the minimum: folds in one direction, v = (p, q), or in all, by Newton's method of either
// kind with a search along each step, since the law has switches. Lanes that have arrived stay where they
// are, so that no lane depends on others.
template <class T>
struct FoldSearch {
  using Mask = decltype(T() < T());
  static constexpr int most_passes = 100, most_turns = 6, first_passes = 8;
  static constexpr double exact = 1e-11, rounding = 1e-15, enough = 1e-3;  // of the stress

  struct Place {
    T p, q;
    Plane<T> F;  // of either kind
  };
  Mask folds, slack;  // lanes that are searched; folds in all directions
  Place at, from, step;
  // From the last place along its step: the share of it that is tried, the slope at its beginning, and
  // between which shares it changes its sign; high 0: not known.
  T way, slope, low, low_slope, high, high_slope, turned;
  T error, size, limit;  // of the condition of the minimum; of the stress; what counts as met

  static Plane<T> one_way(T p, T q) {
    const T half(0.5);
    return {half * (p * p + q * q), half * (p * p - q * q), p * q};
  }

  // At folds that were all of F, or only its largest. other: their direction if F has none.
  static Place place(const Plane<T>& F, const Plane<T>& other, Mask& in_all) {
    const Eigen<T> e = eigen(F), o = eigen(other);
    in_all = e.second > T(1e-9) * abs(e.first);
    const auto some = e.first > T(0.0);
    const T root = sqrt(select(some, e.first, T(1e-3) * abs(e.second) + T(1e-300)));
    const T p = root * select(some, e.x, o.x), q = root * select(some, e.y, o.y);
    return {p, q, either(in_all, F, one_way(p, q))};
  }

  // At the committed folds, or at those of cloth with the present tangent.
  FoldSearch(Mask searched, const Plane<T>& A, const Blocks<T>& K, const Plane<T>& committed)
      : folds(searched) {
    const T zero(0.0), one(1.0);
    const Plane<T> minus{-A.m, -A.d, -A.c}, nothing{zero, zero, zero};
    Mask in_all;
    const Place known = place(committed, committed, in_all),
                guessed = place(softened(K, minus), minus, slack);
    // Folds of a direction that is stretched now would only shrink to nothing.
    const auto is_known =
        (squared(committed) > zero) & (A.m * known.F.m + A.d * known.F.d + A.c * known.F.c < zero);
    slack = (is_known & in_all) | ((!is_known) & slack);
    at = {select(is_known, known.p, guessed.p), select(is_known, known.q, guessed.q),
          either(folds, either(is_known, known.F, guessed.F), nothing)};
    from = at;
    step = {zero, zero, nothing};
    way = one;
    slope = T(-1e300);
    low = high = turned = zero;
    low_slope = slope;
    high_slope = one;
    error = size = limit = zero;
  }

  T along_step(const Plane<T>& rest, const Folding<T>& folding) const {
    return select(slack, T(2.0) * (rest.m * step.F.m + rest.d * step.F.d + rest.c * step.F.c),
                  folding.g[0] * step.p + folding.g[1] * step.q);
  }

  void measure(const Plane<T>& A, const Plane<T>& rest, const Folding<T>& folding, T stiff, T strain) {
    const T square = at.p * at.p + at.q * at.q, shrunk(1e-200);
    const T of_v =
        T(0.5) * sqrt((folding.g[0] * folding.g[0] + folding.g[1] * folding.g[1]) / max(square, shrunk));
    error = select(slack, sqrt(squared(rest)), select(square > shrunk, of_v, T(1e300)));
    size = sqrt(squared(A) + squared(at.F));
    limit = T(exact) * size + T(rounding) * stiff * (strain + sqrt(squared(at.F)));
  }

  // Goes on to the next place; false: all have arrived. strain: the size of the scaled strain.
  bool advance(int pass, const Plane<T>& A, const Blocks<T>& K, const Plane<T>& rest,
               const Folding<T>& folding, T strain) {
    measure(A, rest, folding, K.mm + K.dd + K.cc, strain);
    const Eigen<T> of_F = eigen(at.F);
    const auto met = error <= limit;
    // A minimum of one kind that is none of the other is left.
    const auto turns = folds & (turned < T(most_turns)) &
                       ((met & slack & (of_F.second < T(-1e-9) * abs(of_F.first))) |
                        ((!slack) & (rest.m < T(-10.0) * max(error, limit))));
    const auto open = folds & ((!met) | turns);
    if (!any(open & (error == error)) || pass == most_passes) return false;
    search(pass, turns, K, rest, folding);
    const auto moves = open & (!turns), in_one = moves & (!slack);
    at.p = select(in_one, from.p + way * step.p, at.p);
    at.q = select(in_one, from.q + way * step.q, at.q);
    const Plane<T> F{from.F.m + way * step.F.m, from.F.d + way * step.F.d, from.F.c + way * step.F.c};
    at.F = either(moves & slack, F, at.F);
    turn(turns, of_F);
    at.F = either(open & (!slack), one_way(at.p, at.q), at.F);
    return true;
  }

  // Along a step the slope is to become small; where it has changed its sign, a place between is tried.
  void search(int pass, Mask turns, const Blocks<T>& K, const Plane<T>& rest, const Folding<T>& folding) {
    const T zero(0.0), one(1.0);
    const T here = along_step(rest, folding), small = T(pass < first_passes ? 0.5 : 0.05) * abs(slope);
    const auto above = here > small, below = (here < -small) & (high > zero);
    const auto good = (!(above | below)) | ((high > zero) & (high - low < T(1e-6))) | turns;
    const Plane<T> all = softened(K, rest);
    T x, y;
    folding.solve(folding.g[0], folding.g[1], x, y);
    from = {select(good, at.p, from.p), select(good, at.q, from.q), either(good, at.F, from.F)};
    step = {select(good, -x, step.p), select(good, -y, step.q),
            either(good, {-all.m, -all.d, -all.c}, step.F)};
    slope = select(good, along_step(rest, folding), slope);
    high_slope = select(above, here, high_slope);
    high = select(good, zero, select(above, way, high));
    low_slope = select(good, slope, select(below, here, low_slope));
    low = select(good, zero, select(below, way, low));
    const T share = max(min(-low_slope / (high_slope - low_slope), T(0.9)), T(0.1));
    way = select(good, one, low + share * (high - low));
  }

  // To the other kind, which begins with its own first step.
  void turn(Mask turns, const Eigen<T>& of_F) {
    const T zero(0.0), root = sqrt(max(of_F.first, T(1e-300)));
    const auto to_one = turns & slack, to_all = turns & (!slack);
    at.p = select(to_one, root * of_F.x, at.p);
    at.q = select(to_one, root * of_F.y, at.q);
    slack = (slack & (!to_one)) | to_all;
    slope = select(turns, T(-1e300), slope);
    step = {select(turns, zero, step.p), select(turns, zero, step.q),
            either(turns, {zero, zero, zero}, step.F)};
    turned = select(turns, turned + T(1.0), turned);
  }
};

// The response of a point with folds. cloth(e, s0, s1): that of its cloth. slot: where the numbers of the
// folds begin in the state.
template <class T, class Cloth>
Response<T> folded_update(const Cloth& cloth, int slot, const T E[5], const T* s0, T* s1) {
  using namespace fold_state;
  const FoldSite<T> site = fold_site(s0 + slot);
  const T zero(0.0), half(0.5);
  for (int i = a; i <= s2; ++i) s1[slot + i] = s0[slot + i];
  for (int i = m; i <= m12; ++i) s1[slot + i] = zero;
  Response<T> out = cloth(E, s0, s1);
  Plane<T> A = scaled_excess(site, out);
  const auto taut = site.off | ((A.m >= zero) & (A.m * A.m >= A.d * A.d + A.c * A.c)) | (!(A.m == A.m));
  const auto folds = !taut;
  if (!any(folds)) return out;

  FoldSearch<T> search(folds, A, scaled_tangent(site, out), {s0[slot + m], s0[slot + d], s0[slot + m12]});
  const T x = E[0] * site.a, y = E[1] * site.b;
  const T strain = sqrt(squared(Plane<T>{half * (x + y), half * (x - y), half * E[4] * site.c}));
  for (int pass = 0;; ++pass) {
    T e[5];
    add_folds(site, search.at.F, E, e);
    out = cloth(e, s0, s1);
    A = scaled_excess(site, out);
    const Blocks<T> K = scaled_tangent(site, out);
    const Plane<T>& F = search.at.F;
    const Plane<T> rest{A.m + F.m, A.d + F.d, A.c + F.c};
    const Folding<T> folding(rest, K, search.at.p, search.at.q);
    if (search.advance(pass, A, K, rest, folding, strain)) continue;
    fold_tangent(site, K, folding, taut, search.slack, out);
    break;
  }
  s1[slot + m] = select(taut, zero, search.at.F.m);
  s1[slot + d] = select(taut, zero, search.at.F.d);
  s1[slot + m12] = select(taut, zero, search.at.F.c);
  const auto failed = folds & (!(search.error <= T(FoldSearch<T>::enough) * search.size));
  out.S[0] = select(failed, T(__builtin_nan("")), out.S[0]);
  return out;
}

// The strain of the cloth in a state, and the energy of its folds, J/m^3.
template <class T>
T fold_energy(int slot, const T* s, const T E[5], T e[5]) {
  using namespace fold_state;
  const FoldSite<T> site = fold_site(s + slot);
  const Plane<T> F{s[slot + m], s[slot + d], s[slot + m12]};
  add_folds(site, F, E, e);
  return site.s1 * (F.m + F.d) / site.a + site.s2 * (F.m - F.d) / site.b + squared(F);
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
