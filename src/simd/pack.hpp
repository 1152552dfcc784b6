// Pack: the doubles of one vector register, one element or material point per lane. Kernels are
// written once over a number type T and compiled for T = double (one point) and T = Pack (a
// batch); branches are written as select(), which both types support. A batch of `lanes` consists
// of pack_parts packs; a kernel works on one such part, and at_parts() runs it on all of them.
#pragma once
// The headers of later instruction sets take a second to parse, and nearly every source includes this one.
#if defined(__AVX2__) || defined(__AVX512F__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "simd/isa.hpp"

namespace fabricsh {
inline namespace FABRICSH_ISA {

#if defined(__AVX512F__)
inline constexpr int pack_width = 8;
#elif defined(__AVX2__)
inline constexpr int pack_width = 4;
#else
inline constexpr int pack_width = 2;
#endif
inline constexpr int pack_parts = lanes / pack_width;

// Calls kernel(first lane) for each part of a batch. The kernel returns the mask
// of the lanes in its part that failed; the result is the mask of the whole batch.
template <class Kernel>
unsigned at_parts(Kernel kernel) {
  unsigned failed = 0;
  for (int first = 0; first < lanes; first += pack_width) failed |= kernel(first) << first;
  return failed;
}

typedef double PackBits __attribute__((vector_size(pack_width * sizeof(double))));
typedef long long PackInts __attribute__((vector_size(pack_width * sizeof(long long))));

#if defined(__AVX512F__)
struct PackMask {
  __mmask8 m;  // bit i: lane i
  friend PackMask operator&(PackMask a, PackMask b) { return {static_cast<__mmask8>(a.m & b.m)}; }
  friend PackMask operator|(PackMask a, PackMask b) { return {static_cast<__mmask8>(a.m | b.m)}; }
  friend PackMask operator!(PackMask a) { return {static_cast<__mmask8>(~a.m)}; }
};
#else
struct PackMask {
  PackInts m;  // all bits of a lane set, or none
  friend PackMask operator&(PackMask a, PackMask b) { return {a.m & b.m}; }
  friend PackMask operator|(PackMask a, PackMask b) { return {a.m | b.m}; }
  friend PackMask operator!(PackMask a) { return {~a.m}; }
};
#endif

struct Pack {
  PackBits v;
  Pack() = default;
  explicit Pack(PackBits bits) : v(bits) {}
  Pack(double x) : v(x - PackBits{}) {}
  double operator[](int lane) const { return v[lane]; }
  void set(int lane, double x) { v[lane] = x; }
  Pack& operator+=(Pack b) { return v += b.v, *this; }
  Pack& operator-=(Pack b) { return v -= b.v, *this; }
  Pack& operator*=(Pack b) { return v *= b.v, *this; }
  Pack& operator/=(Pack b) { return v /= b.v, *this; }
  friend Pack operator+(Pack a, Pack b) { return Pack(a.v + b.v); }
  friend Pack operator-(Pack a, Pack b) { return Pack(a.v - b.v); }
  friend Pack operator*(Pack a, Pack b) { return Pack(a.v * b.v); }
  friend Pack operator/(Pack a, Pack b) { return Pack(a.v / b.v); }
  friend Pack operator-(Pack a) { return Pack(-a.v); }
#if defined(__AVX512F__)
  friend PackMask operator<(Pack a, Pack b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)}; }
  friend PackMask operator<=(Pack a, Pack b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ)}; }
  friend PackMask operator==(Pack a, Pack b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ)}; }
#else
  friend PackMask operator<(Pack a, Pack b) { return {a.v < b.v}; }
  friend PackMask operator<=(Pack a, Pack b) { return {a.v <= b.v}; }
  friend PackMask operator==(Pack a, Pack b) { return {a.v == b.v}; }
#endif
  friend PackMask operator>(Pack a, Pack b) { return b < a; }
  friend PackMask operator>=(Pack a, Pack b) { return b <= a; }
};

// max and min are a > b ? a : b and a < b ? a : b, as the machine does. bits: bit i is set for a true lane i.
#if defined(__AVX512F__)
inline Pack select(PackMask c, Pack a, Pack b) { return Pack(_mm512_mask_blend_pd(c.m, b.v, a.v)); }
inline Pack max(Pack a, Pack b) { return Pack(_mm512_mask_max_pd(a.v, 0xff, a.v, b.v)); }
inline Pack min(Pack a, Pack b) { return Pack(_mm512_mask_min_pd(a.v, 0xff, a.v, b.v)); }
inline unsigned bits(PackMask c) { return c.m; }
#elif defined(__AVX2__)
inline Pack select(PackMask c, Pack a, Pack b) {
  return Pack(_mm256_blendv_pd(b.v, a.v, reinterpret_cast<PackBits>(c.m)));
}
inline Pack max(Pack a, Pack b) { return Pack(_mm256_max_pd(a.v, b.v)); }
inline Pack min(Pack a, Pack b) { return Pack(_mm256_min_pd(a.v, b.v)); }
inline unsigned bits(PackMask c) { return _mm256_movemask_pd(reinterpret_cast<PackBits>(c.m)); }
#else
inline Pack select(PackMask c, Pack a, Pack b) { return Pack(c.m ? a.v : b.v); }
inline Pack max(Pack a, Pack b) { return select(a > b, a, b); }
inline Pack min(Pack a, Pack b) { return select(a < b, a, b); }
#if defined(__SSE2__)
inline unsigned bits(PackMask c) { return _mm_movemask_pd(reinterpret_cast<PackBits>(c.m)); }
#else
inline unsigned bits(PackMask c) {
  unsigned r = 0;
  for (int i = 0; i < pack_width; ++i) r |= c.m[i] ? 1u << i : 0u;
  return r;
}
#endif
#endif
inline double select(bool c, double a, double b) { return c ? a : b; }
inline double max(double a, double b) { return a > b ? a : b; }
inline double min(double a, double b) { return a < b ? a : b; }
inline Pack sqrt(Pack a) {
  for (int i = 0; i < pack_width; ++i) a.set(i, __builtin_sqrt(a[i]));
  return a;
}
inline double sqrt(double a) { return __builtin_sqrt(a); }
// Applies the C library's function to each lane: slow, for features that are rarely used.
inline Pack exp(Pack a) {
  for (int i = 0; i < pack_width; ++i) a.set(i, __builtin_exp(a[i]));
  return a;
}
inline double exp(double a) { return __builtin_exp(a); }
inline Pack abs(Pack a) {
  const PackInts sign = reinterpret_cast<PackInts>(-PackBits{});
  return Pack(reinterpret_cast<PackBits>(reinterpret_cast<PackInts>(a.v) & ~sign));
}
inline double abs(double a) { return __builtin_fabs(a); }
// Bit i set: the numbers of lane i are not the same bits.
#if defined(__AVX512F__)
inline unsigned differing(Pack a, Pack b) {
  return _mm512_cmpneq_epi64_mask(reinterpret_cast<__m512i>(a.v), reinterpret_cast<__m512i>(b.v));
}
#else
inline unsigned differing(Pack a, Pack b) {
  return bits(PackMask{reinterpret_cast<PackInts>(a.v) != reinterpret_cast<PackInts>(b.v)});
}
#endif
inline bool any(PackMask c) { return bits(c) != 0; }
inline bool any(bool c) { return c; }
inline unsigned bits(bool c) { return c ? 1u : 0u; }

// A column of numbers in a structure-of-arrays batch: p is at the part's first lane, entry i at p[i * lanes].
inline Pack load(const double* p) {
  Pack a;
  __builtin_memcpy(&a.v, p, sizeof(a.v));
  return a;
}
inline void store(double* p, Pack a) { __builtin_memcpy(p, &a.v, sizeof(a.v)); }

}  // namespace FABRICSH_ISA
}  // namespace fabricsh
