#include "rheology/viscous/viscous.hpp"

#include <cmath>

namespace fabricsh::rheology::viscous {

namespace {

// x int_0^1 ((1 - exp(-x s)) / x)^2 ds, by a series where x is small and the closed form loses digits.
double pulled_fraction(double x, double left, double left_twice) {
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

std::vector<ParameterRow<Parameters>> Element::rows() {
  const ParameterRow<Parameters> shear("shear", "a spring and a dashpot in series beside in-plane shear"),
      modulus("shear.modulus", &Parameters::modulus, "Pa", positive,
              "of the part that relaxes, in shear's measure"),
      time("shear.time", &Parameters::time, "s", positive,
           "relaxation time: at constant strain its stress falls to 1/e");
  return {shear,
          modulus.ask(1e3, 1e12, "is the modulus in Pa? (write 8*MPa; N/m divided by the thickness)")
              .printed("shear # MPa", 1e-6),
          time.printed("over # s")};
}

StepEffect effect_of_step(double x) {
  if (!(x > 0)) return {};
  const double left = -std::expm1(-x), left_twice = -std::expm1(-2 * x);
  return {std::exp(-x), left / x, left_twice / 2, left * left / (2 * x),
          pulled_fraction(x, left, left_twice)};
}

}  // namespace fabricsh::rheology::viscous
