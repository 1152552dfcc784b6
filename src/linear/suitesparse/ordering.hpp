// The choice behind Ordering::automatic.
#pragma once
#include "linear/linear_solver.hpp"

namespace fabricsh::linear {

// Number of unknowns from which METIS is faster on shell meshes.
inline constexpr Index metis_from = 80000;

inline bool use_metis(Ordering ordering, Index size) {
  return ordering == Ordering::metis || (ordering == Ordering::automatic && size > metis_from);
}

}  // namespace fabricsh::linear
