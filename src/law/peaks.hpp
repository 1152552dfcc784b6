// The largest strains that a law's state remembers, as shares of the strains up to which its card was
// measured: 1.2 is 20 % beyond what was tested.
#pragma once
#include <array>

#include "law/law.hpp"

namespace fabricsh::law {

// E11, E22 and E12 (tensor) up to which the curves of a card were measured: what it states, else the last
// points of curves given by points. 0: not known.
std::array<double, 3> tested_strains(const card::Card& card);

// Largest E11 and E22 so far, and the largest |E12| of the present branch of shear (laws "incremental" and
// "thesis": the strains themselves); no law state, no strain: zeros. Entry i of the state is s[i * stride].
std::array<double, 3> peak_strains(const Law& law, const double* s, int stride);

// For a batch of `lanes` elements: share[lane] becomes at least the largest share of all three at `count`
// points of one law, whose states begin `stride` numbers apart; inverse: 1 over the tested strains, 0 where
// they are not known.
using SharesFunction = void (*)(const Law& law, const double inverse[3], const double* s, long stride,
                                int count, double* share);
SharesFunction shares_function(Isa isa);

}  // namespace fabricsh::law
