// Confidence bands from a few specimens.
#pragma once
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace fabricsh::lab {

// The median of at least one value; of an even number the upper of the two in the middle.
double median(std::vector<double> values);

// Quantile of Student's t: P(t <= x) = p, p in (0, 1), degrees of freedom > 0.
double student_quantile(double p, double freedom);

struct MeanWithBand {
  std::vector<double> value;       // mean over the specimens
  std::vector<double> low, high;   // limits of the band; empty for one specimen
  std::vector<double> covariance;  // of value, n x n, row by row; empty for one specimen
};

struct BandOptions {
  double level = 0.95;
  int draws = 2000;
  std::uint64_t seed = 1;
  // Standard uncertainties common to all specimens, relative to the value: load cell, thickness, width.
  std::vector<double> common;
};

// The mean of one parameter vector per specimen, and its confidence band by the bootstrap over specimens. The
// mean of n specimens drawn with replacement has a variance that is too small by (n-1)/n, and for few
// specimens the normal quantile is too small. So the covariance of the draws is multiplied by n/(n-1),
// common^2 value^2 is added, and the band is t(level, n-1) standard deviations wide on each side
// [hesterberg2015, section 4.3; gum2008, section 5].
MeanWithBand band_of(const std::vector<std::vector<double>>& specimens, const BandOptions& options);

// Draws parameters from a joint distribution about value with the correlation of `covariance` (n x n). Each
// lies between low and high with the probability `level`: normal where both are as far from the value, else
// of two halves of a normal distribution, whose shares and deviations are as those distances; where the value
// is an end of its band, on the side of the band alone. A value outside of its band is drawn about as if it
// were its middle.
std::vector<double> draw_around(const std::vector<double>& value, const std::vector<double>& low,
                                const std::vector<double>& high, const std::vector<double>& covariance,
                                double level, std::mt19937_64& random);

// --- Points that fill a cube evenly, for studies with far fewer cases than random numbers would need.

inline constexpr std::size_t most_dimensions = 3667;  // for which direction numbers are tabulated

// Sobol's sequence with the direction numbers of [joe2008]: `count` points of `dimensions` numbers in (0, 1),
// point after point. All numbers of a dimension are shifted modulo 1 by one that is drawn from the seed
// [cranley1976], so that repetitions with other seeds show the error. Seed 0: not shifted, and without the
// first point, the origin. Error: more than most_dimensions dimensions.
std::vector<double> sobol_points(std::size_t count, std::size_t dimensions, std::uint64_t seed);

// The quantile of the normal distribution with mean 0 and deviation 1, p in (0, 1).
double normal_quantile(double p);

}  // namespace fabricsh::lab
