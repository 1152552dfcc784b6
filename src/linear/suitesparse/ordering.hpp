// The choice behind Ordering::automatic.
#pragma once
#include "linear/linear_solver.hpp"

namespace fabricsh::linear {

// Unknowns from which METIS is the faster one on shell meshes.
inline constexpr Index metis_from = 80000;

inline bool use_metis(Ordering ordering, Index size) {
  return ordering == Ordering::metis || (ordering == Ordering::automatic && size > metis_from);
}

}  // namespace fabricsh::linear
