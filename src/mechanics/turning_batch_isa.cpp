// Rotation of a batch of directors: compiled once per instruction set, selected at run time by turn().
#include "mechanics/turning_batch.hpp"
#include "simd/pack.hpp"

namespace fabricsh::mechanics {
inline namespace FABRICSH_ISA {

namespace {

struct Vector {
  Pack x, y, z;
  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(Pack s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
};
Pack dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// cos, sin / angle and (cos - 1) / x of the angle whose square is x. Below x = 0.01, the usual case in
// dynamics, by series truncated below rounding error.
struct TurnFunctions {
  Pack cosine, sine, versed;
};
TurnFunctions turn_by(Pack x) {
  const auto term = [x](double divisor, Pack rest) { return Pack(1.0) - Pack(1 / divisor) * x * rest; };
  const Pack tail = term(30, term(56, term(90, Pack(1.0))));
  TurnFunctions by;
  by.versed = Pack(-0.5) * term(12, tail);
  by.cosine = Pack(1.0) + x * by.versed;
  by.sine = term(6, term(20, term(42, term(72, Pack(1.0)))));
  for (unsigned far = bits(x >= Pack(0.01)); far != 0; far &= far - 1) {
    const int lane = __builtin_ctz(far);
    const double angle = __builtin_sqrt(x[lane]), cosine = __builtin_cos(angle);
    by.cosine.set(lane, cosine);
    by.sine.set(lane, __builtin_sin(angle) / angle);
    by.versed.set(lane, (cosine - 1) / x[lane]);
  }
  return by;
}

// Normalises v, whose length is almost 1: one Newton step, whose error is quadratic in that of the length.
Vector renewed(const Vector& v) { return (Pack(1.5) - Pack(0.5) * dot(v, v)) * v; }

}  // namespace

void turn_batch(TurningBatch& batch) {
  const auto read = [](const double(&v)[3][lanes], int first) {
    return Vector{load(v[0] + first), load(v[1] + first), load(v[2] + first)};
  };
  const auto write = [](double(&v)[3][lanes], int first, const Vector& a) {
    store(v[0] + first, a.x);
    store(v[1] + first, a.y);
    store(v[2] + first, a.z);
  };
  for (int first = 0; first < lanes; first += pack_width) {
    const Vector d0 = read(batch.d, first), b0 = read(batch.b1, first);
    const Vector q = load(batch.q[0] + first) * b0 + load(batch.q[1] + first) * cross(d0, b0);
    const TurnFunctions by = turn_by(dot(q, q));
    const Vector d = renewed(by.cosine * d0 + by.sine * q);
    Vector b1 = b0 + dot(b0, q) * (by.versed * q - by.sine * d0);
    b1 = b1 - dot(b1, d) * d;
    write(batch.d, first, d);
    write(batch.b1, first, renewed(b1));
  }
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::mechanics
