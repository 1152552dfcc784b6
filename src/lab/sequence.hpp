// Points that fill a cube evenly, for studies with far fewer cases than random numbers would need.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fabricsh::lab {

inline constexpr std::size_t most_dimensions = 3667;  // for which direction numbers are tabulated

// Sobol's sequence with the direction numbers of [joe2008]: `count` points of `dimensions` numbers in (0, 1),
// point after point. All numbers of a dimension are shifted modulo 1 by one that is drawn from the seed
// [cranley1976], so that repetitions with other seeds show the error. Seed 0: not shifted, and without the
// first point, the origin. Error: more than most_dimensions dimensions.
std::vector<double> sobol_points(std::size_t count, std::size_t dimensions, std::uint64_t seed);

// The quantile of the normal distribution with mean 0 and deviation 1, p in (0, 1).
double normal_quantile(double p);

}  // namespace fabricsh::lab
