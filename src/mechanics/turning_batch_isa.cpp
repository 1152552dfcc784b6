// Rotation of a batch of directors: compiled once per instruction set, selected at run time by turn().
#include "mechanics/turning_batch.hpp"
#include "simd/pack3.hpp"

namespace fabricsh::mechanics {
inline namespace FABRICSH_ISA {

namespace {

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
Pack3 renewed(const Pack3& v) { return (Pack(1.5) - Pack(0.5) * dot(v, v)) * v; }

}  // namespace

void turn_batch(TurningBatch& batch) {
  for (int first = 0; first < lanes; first += pack_width) {
    const Pack3 d0 = load3(batch.d, first), b0 = load3(batch.b1, first);
    const Pack3 q = load(batch.q[0] + first) * b0 + load(batch.q[1] + first) * cross(d0, b0);
    const TurnFunctions by = turn_by(dot(q, q));
    const Pack3 d = renewed(by.cosine * d0 + by.sine * q);
    Pack3 b1 = b0 + dot(b0, q) * (by.versed * q - by.sine * d0);
    b1 = b1 - dot(b1, d) * d;
    store3(batch.d, first, d);
    store3(batch.b1, first, renewed(b1));
  }
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::mechanics
