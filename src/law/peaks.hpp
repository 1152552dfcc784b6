// The largest strains in the state of a law, relative to the strains up
// to which its card was measured: 1.2 means 20 % beyond the tested range.
#pragma once
#include <array>

#include "law/law.hpp"

namespace fabricsh::law {

// E11, E22 and E12 (tensor) up to which the curves of a card were measured: as the
// card states, otherwise the last point of a curve given by points. 0: not known.
std::array<double, 3> tested_strains(const card::Card& card);

// The largest E11 and E22 so far, and the largest |E12| on the present shear branch (for laws that keep no
// such strains the strains themselves). Zeros for a law without state. Entry i of the state is s[i * stride].
std::array<double, 3> peak_strains(const Law& law, const double* s, int stride);

// For a batch of `lanes` elements: the largest ratio, of all lanes, of the three strains to the tested ones
// at `count` points of one law, whose states are `stride` numbers apart. inverse: 1 over the tested strains,
// 0 where they are not known.
using StrainRatioFunction = double (*)(const Law& law, const double inverse[3], const double* s, long stride,
                                       int count);
StrainRatioFunction strain_ratio_function(Isa isa);

}  // namespace fabricsh::law
