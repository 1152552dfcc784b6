#include "mechanics/turning_batch.hpp"

#include "simd/copies.hpp"

namespace fabricsh::mechanics {

// The copies compiled by turning_batch_isa.cpp.
FABRICSH_DECLARE_COPIES(void turn_batch(TurningBatch&);)

void turn(TurningBatch& batch) {
  static const auto of_isa = FABRICSH_COPY_FOR(best_isa(), turn_batch);
  of_isa(batch);
}

}  // namespace fabricsh::mechanics
