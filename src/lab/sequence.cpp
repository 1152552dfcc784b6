#include "lab/sequence.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <random>
#include <string>

#include "base/error.hpp"

namespace fabricsh::lab {

std::vector<double> sobol_points(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  if (dimensions == 0 || dimensions > most_dimensions)
    throw Error("sobol: expected 1 to " + std::to_string(most_dimensions) + " names, got " +
                std::to_string(dimensions));
  boost::random::sobol_engine<std::uint64_t, 53> sequence(dimensions);
  std::mt19937_64 random(seed);
  std::vector<double> shift(dimensions, 0.0), points;
  if (seed != 0)
    for (double& s : shift) s = std::ldexp(static_cast<double>(random() >> 11), -53);
  points.reserve(count * dimensions);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < dimensions; ++k) {
      const bool origin = i == 0 && seed != 0;
      const double p = std::ldexp((origin ? 0.0 : static_cast<double>(sequence())) + 0.5, -53) + shift[k];
      points.push_back(p < 1 ? p : p - 1);
    }
  return points;
}

double normal_quantile(double p) { return boost::math::quantile(boost::math::normal(), p); }

}  // namespace fabricsh::lab
