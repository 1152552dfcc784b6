// Batches of pairs of one kind and interaction, side by side: the plain case of a pair in an explicit step,
// that touches at one place above its guard. The kernels do what pair_force() and the memory of friction do,
// operation by operation and without fused products, so that a pair has the same bits in both.
#pragma once
#include "simd/isa.hpp"

namespace fabricsh::contact {

enum class BatchKind { facet, edges, plane };

// Shared by all pairs of a batch.
struct BatchLaw {
  BatchKind kind = BatchKind::facet;
  // Of the law: rows of gap, stiffness, pressure and energy; see ContactLaw.
  const double* knots = nullptr;
  int count = 0;
  double gap = 0, floor = 0, guard = 0, stiffest = 0;  // m, m, m, Pa/m
  double offset = 0;                                   // m
  bool rubs = false;                                   // friction or the damping of approach acts
  bool coulomb = false;                                // friction acts
  double friction = 0, holding = 0;                    // mu of what slides, and of what sticks
  double spring = 0, loss = 0;                         // see Slip
  double dt = 0;                                       // s
  double turn[3] = {};                                 // rad, of the rigid side
};

// Corner, component, lane. Unused lanes repeat others.
using ByCorner = double[4][3][lanes];
using ByLane = double[lanes];

struct BatchPairs {
  alignas(64) ByCorner x, start;     // m, now and at the beginning of the step
  ByLane inverse_mass[4], crowd[4];  // see Slip
  ByLane area, scale, zone[2];
  ByLane held[3], pull[3], damped, slides;  // the memory of friction; slides: 0 or 1
};

struct BatchForces {
  alignas(64) ByCorner on;
  ByLane contact, gap, torque[3];
  ByLane slip[3], pull[3], stick, damped, work, impact, slides, resists[4];
  unsigned touching;  // bit i: the pair in lane i does, and its numbers are here
  unsigned special;   // these may touch in another way
};

// Of pairs of facets and edges: bit i is set unless they are clearly farther apart than allowed.
// far: m2, the square of the distance.
struct BatchKernels {
  unsigned (*near)(BatchKind kind, const ByCorner& x, const ByLane& far);
  void (*press)(const BatchLaw& law, const BatchPairs& pairs, BatchForces& out);
};
BatchKernels batch_kernels(Isa isa);

}  // namespace fabricsh::contact
