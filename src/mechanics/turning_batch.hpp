// Rotation of directors on the unit sphere, a batch at a time.
#pragma once
#include "simd/isa.hpp"

namespace fabricsh::mechanics {

// In each lane a director, its first axis b1 and the increment of its two rotations, rad.
struct TurningBatch {
  alignas(64) double d[3][lanes] = {}, b1[3][lanes] = {}, q[2][lanes] = {};
};

// Rotates each director d by the increment q0 b1 + q1 d x b1, tangent to the sphere, along a great circle,
// and parallel-transports its first axis b1.
void turn(TurningBatch& batch);

}  // namespace fabricsh::mechanics
