// Pack: eight doubles side by side, one element or material point per lane. Kernels are written once over a
// number type T, and compiled for T = double (one point) and T = Pack (a batch); select() is the branch that
// both understand.
#pragma once
#include <cmath>

#include "base/isa.hpp"

namespace fabricsh {
inline namespace FABRICSH_ISA {

// A pack is held as vectors of the machine's own width: wider ones the compiler would take apart badly.
#if defined(__AVX512F__)
inline constexpr int pack_width = 8;
#elif defined(__AVX2__)
inline constexpr int pack_width = 4;
#else
inline constexpr int pack_width = 2;
#endif
inline constexpr int pack_parts = lanes / pack_width;

typedef double PackBits __attribute__((vector_size(pack_width * sizeof(double))));
typedef long long MaskBits __attribute__((vector_size(pack_width * sizeof(long long))));

// for (each part i) statement
#define FABRICSH_PARTS(statement) \
  _Pragma("GCC unroll 8") for (int i = 0; i < pack_parts; ++i) { statement; }

struct PackMask {
  MaskBits m[pack_parts];
  friend PackMask operator&(PackMask a, PackMask b) {
    FABRICSH_PARTS(a.m[i] &= b.m[i])
    return a;
  }
  friend PackMask operator|(PackMask a, PackMask b) {
    FABRICSH_PARTS(a.m[i] |= b.m[i])
    return a;
  }
  friend PackMask operator!(PackMask a) {
    FABRICSH_PARTS(a.m[i] = ~a.m[i])
    return a;
  }
};

struct Pack {
  PackBits v[pack_parts];
  Pack() = default;
  Pack(double x) { FABRICSH_PARTS(v[i] = x - PackBits{}) }
  double operator[](int lane) const { return v[lane / pack_width][lane % pack_width]; }
  void set(int lane, double x) { v[lane / pack_width][lane % pack_width] = x; }
  Pack& operator+=(const Pack& b) {
    FABRICSH_PARTS(v[i] += b.v[i])
    return *this;
  }
  Pack& operator-=(const Pack& b) {
    FABRICSH_PARTS(v[i] -= b.v[i])
    return *this;
  }
  Pack& operator*=(const Pack& b) {
    FABRICSH_PARTS(v[i] *= b.v[i])
    return *this;
  }
  Pack& operator/=(const Pack& b) {
    FABRICSH_PARTS(v[i] /= b.v[i])
    return *this;
  }
  friend Pack operator+(Pack a, const Pack& b) { return a += b; }
  friend Pack operator-(Pack a, const Pack& b) { return a -= b; }
  friend Pack operator*(Pack a, const Pack& b) { return a *= b; }
  friend Pack operator/(Pack a, const Pack& b) { return a /= b; }
  friend Pack operator-(Pack a) {
    FABRICSH_PARTS(a.v[i] = -a.v[i])
    return a;
  }
  friend PackMask operator<(const Pack& a, const Pack& b) {
    PackMask c;
    FABRICSH_PARTS(c.m[i] = a.v[i] < b.v[i])
    return c;
  }
  friend PackMask operator<=(const Pack& a, const Pack& b) {
    PackMask c;
    FABRICSH_PARTS(c.m[i] = a.v[i] <= b.v[i])
    return c;
  }
  friend PackMask operator>(const Pack& a, const Pack& b) { return b < a; }
  friend PackMask operator>=(const Pack& a, const Pack& b) { return b <= a; }
  friend PackMask operator==(const Pack& a, const Pack& b) {
    PackMask c;
    FABRICSH_PARTS(c.m[i] = a.v[i] == b.v[i])
    return c;
  }
};

inline Pack select(const PackMask& c, Pack a, const Pack& b) {
  FABRICSH_PARTS(a.v[i] = c.m[i] ? a.v[i] : b.v[i])
  return a;
}
inline double select(bool c, double a, double b) { return c ? a : b; }
inline Pack max(const Pack& a, const Pack& b) { return select(a > b, a, b); }
inline double max(double a, double b) { return a > b ? a : b; }
inline Pack min(const Pack& a, const Pack& b) { return select(a < b, a, b); }
inline double min(double a, double b) { return a < b ? a : b; }
inline Pack sqrt(Pack a) {
  for (int i = 0; i < lanes; ++i) a.set(i, __builtin_sqrt(a[i]));
  return a;
}
inline double sqrt(double a) { return __builtin_sqrt(a); }
inline Pack abs(const Pack& a) { return select(a < Pack(0.0), -a, a); }
inline double abs(double a) { return __builtin_fabs(a); }
// Bit i set: lane i of the mask is true.
inline unsigned bits(const PackMask& c) {
  unsigned r = 0;
  for (int i = 0; i < lanes; ++i) r |= c.m[i / pack_width][i % pack_width] ? 1u << i : 0u;
  return r;
}
inline bool any(const PackMask& c) { return bits(c) != 0; }
inline bool any(bool c) { return c; }
inline unsigned bits(bool c) { return c ? 1u : 0u; }
// False for NaN and infinity, in both number types; needs no <cmath>, and no -ffast-math to break it.
template <class T>
auto finite(T a) {
  return a - a == T(0.0);
}

// A column of numbers in a structure-of-arrays batch: entry i, all lanes, at p[i * lanes].
inline Pack load(const double* p) {
  Pack a;
  __builtin_memcpy(a.v, p, sizeof(a.v));
  return a;
}
inline void store(double* p, const Pack& a) { __builtin_memcpy(p, a.v, sizeof(a.v)); }

#undef FABRICSH_PARTS

}  // namespace FABRICSH_ISA
}  // namespace fabricsh
