// Pack: eight doubles side by side, one element or material point per lane. Kernels are written once over a
// number type T, and compiled for T = double (one point) and T = Pack (a batch); select() is the branch that
// both understand.
#pragma once
#include <cmath>

#include "base/isa.hpp"

namespace fabricsh {
inline namespace FABRICSH_ISA {

typedef double PackBits __attribute__((vector_size(lanes * sizeof(double))));
typedef long long MaskBits __attribute__((vector_size(lanes * sizeof(long long))));

struct PackMask {
  MaskBits m;
  friend PackMask operator&(PackMask a, PackMask b) { return {a.m & b.m}; }
  friend PackMask operator|(PackMask a, PackMask b) { return {a.m | b.m}; }
  friend PackMask operator!(PackMask a) { return {~a.m}; }
};

struct Pack {
  PackBits v;
  Pack() = default;
  Pack(double x) : v(PackBits{} + x) {}
  Pack(PackBits x) : v(x) {}
  double operator[](int lane) const { return v[lane]; }
  void set(int lane, double x) { v[lane] = x; }
  Pack& operator+=(Pack b) {
    v += b.v;
    return *this;
  }
  Pack& operator-=(Pack b) {
    v -= b.v;
    return *this;
  }
  Pack& operator*=(Pack b) {
    v *= b.v;
    return *this;
  }
  friend Pack operator+(Pack a, Pack b) { return a.v + b.v; }
  friend Pack operator-(Pack a, Pack b) { return a.v - b.v; }
  friend Pack operator*(Pack a, Pack b) { return a.v * b.v; }
  friend Pack operator/(Pack a, Pack b) { return a.v / b.v; }
  friend Pack operator-(Pack a) { return -a.v; }
  friend PackMask operator<(Pack a, Pack b) { return {a.v < b.v}; }
  friend PackMask operator<=(Pack a, Pack b) { return {a.v <= b.v}; }
  friend PackMask operator>(Pack a, Pack b) { return {a.v > b.v}; }
  friend PackMask operator>=(Pack a, Pack b) { return {a.v >= b.v}; }
  friend PackMask operator==(Pack a, Pack b) { return {a.v == b.v}; }
};

inline Pack select(PackMask c, Pack a, Pack b) { return Pack(c.m ? a.v : b.v); }
inline double select(bool c, double a, double b) { return c ? a : b; }
inline Pack max(Pack a, Pack b) { return select(a > b, a, b); }
inline double max(double a, double b) { return a > b ? a : b; }
inline Pack min(Pack a, Pack b) { return select(a < b, a, b); }
inline double min(double a, double b) { return a < b ? a : b; }
inline Pack sqrt(Pack a) {
  for (int i = 0; i < lanes; ++i) a.v[i] = __builtin_sqrt(a.v[i]);
  return a;
}
inline double sqrt(double a) { return __builtin_sqrt(a); }
inline Pack abs(Pack a) { return select(a < Pack(0.0), -a, a); }
inline double abs(double a) { return __builtin_fabs(a); }
inline bool any(PackMask c) {
  long long r = 0;
  for (int i = 0; i < lanes; ++i) r |= c.m[i];
  return r != 0;
}
inline bool any(bool c) { return c; }
// Bit i set: lane i of the mask is true.
inline unsigned bits(PackMask c) {
  unsigned r = 0;
  for (int i = 0; i < lanes; ++i) r |= c.m[i] ? 1u << i : 0u;
  return r;
}
inline unsigned bits(bool c) { return c ? 1u : 0u; }
// False for NaN and infinity, in both number types; needs no <cmath>, and no -ffast-math to break it.
template <class T>
auto finite(T a) {
  return a - a == T(0.0);
}

// A column of numbers in a structure-of-arrays batch: entry i, all lanes, at p[i * lanes].
inline Pack load(const double* p) {
  Pack a;
  __builtin_memcpy(&a.v, p, sizeof(a.v));
  return a;
}
inline void store(double* p, Pack a) { __builtin_memcpy(p, &a.v, sizeof(a.v)); }

}  // namespace FABRICSH_ISA
}  // namespace fabricsh
