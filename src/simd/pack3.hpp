// Vectors of packs: one vector in each lane.
#pragma once
#include "simd/pack.hpp"

namespace fabricsh {
inline namespace FABRICSH_ISA {

struct Pack3 {
  Pack x, y, z;
  friend Pack3 operator+(Pack3 a, Pack3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Pack3 operator-(Pack3 a, Pack3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Pack3 operator*(Pack s, Pack3 a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Pack3 operator/(Pack3 a, Pack s) { return {a.x / s, a.y / s, a.z / s}; }
  Pack3& operator+=(Pack3 b) { return *this = *this + b; }
  Pack3& operator-=(Pack3 b) { return *this = *this - b; }
};
inline Pack dot(Pack3 a, Pack3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Pack3 cross(Pack3 a, Pack3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Three rows of a structure of arrays, from its lane `first` on.
inline Pack3 load3(const double (*rows)[lanes], int first) {
  return {load(rows[0] + first), load(rows[1] + first), load(rows[2] + first)};
}
inline void store3(double (*rows)[lanes], int first, Pack3 a) {
  store(rows[0] + first, a.x);
  store(rows[1] + first, a.y);
  store(rows[2] + first, a.z);
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh
