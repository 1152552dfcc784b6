// Batches of pairs of one kind and interaction, side by side: pairs of an explicit step that touch above
// their guard. The kernels do what pair_force() and the memory of friction do, operation by operation and
// without fused products, so that a pair has the same bits in both.
#pragma once
#include <cstdint>

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

using ByLane = double[lanes];

// A point in a step: where it is and was at the beginning (m), its inverse mass (1/kg) and crowd, see Slip.
struct alignas(64) BatchPoint {
  double x[3], inverse_mass, start[3], crowd;
};

// Each lane a pair: its corners as numbers of points, its slot, and numbers of Pair. Lanes that are not in
// use repeat the first.
struct alignas(64) BatchPairs {
  std::uint32_t corner[4][lanes], slot[lanes];
  std::int8_t at_edge[3][lanes], at_corner[3][lanes];  // of facets: Pair::edge, Pair::corner
  ByLane scale, zone[2], area;
};

// The memory of friction by lane; slides: 0 to 1; gap: m.
struct alignas(64) BatchMemory {
  ByLane slip[3], pull[3], damped, slides, gap;
};

// Of a pair: the force on each corner (N) with Force::resists, and numbers of Force.
struct alignas(64) PairForce {
  double on[4][4];
  double contact, stick, work, impact;
  double gap, torque[3];
};

struct BatchStep {
  const BatchPoint* points;
  unsigned used;  // lanes with a slip in `held`
  const BatchMemory* held;
  BatchMemory* tried;
  PairForce* forces;  // by slot
  // Of lanes that touch and are not among them: puts their slips into `held`.
  void (*find)(void* who, unsigned lanes);
  void* who;
};

struct BatchTouch {
  unsigned touching = 0;  // bit i: the pair in lane i does, and its forces are there
  unsigned special = 0;   // these come into their guards
};

using BatchPress = BatchTouch (*)(const BatchLaw& law, const BatchPairs& pairs, const BatchStep& step);
BatchPress batch_press(Isa isa);

}  // namespace fabricsh::contact
