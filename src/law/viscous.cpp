#include "law/viscous.hpp"

#include <cmath>

namespace fabricsh::law {

namespace {

// x int_0^1 ((1 - exp(-x s)) / x)^2 ds, by a series where x is small and the closed form loses digits.
double pulled_share(double x, double left, double left_twice) {
  if (x > 0.5) return (1 - 2 * left / x + left_twice / (2 * x)) / x;
  double sum = 0, power = x, two = 4, factorial = 2;
  for (int n = 2; n < 20; ++n) {
    sum += power * (two - 2) / (factorial * (n + 1));
    power *= -x;
    two *= 2;
    factorial *= n + 1;
  }
  return sum;
}

}  // namespace

ViscousStep viscous_step(double x) {
  if (!(x > 0)) return {};
  const double left = -std::expm1(-x), left_twice = -std::expm1(-2 * x);
  return {std::exp(-x), left / x, left_twice / 2, left * left / (2 * x), pulled_share(x, left, left_twice)};
}

}  // namespace fabricsh::law
