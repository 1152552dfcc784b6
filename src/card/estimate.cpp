#include "card/estimate.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/number.hpp"
#include "card/fields.hpp"

namespace fabricsh::card {

namespace {

// kg/m2, of the cloths measured.
constexpr double kLightest = 0.015, kHeaviest = 0.87;
constexpr double kMiddle = 0.2;

}  // namespace

BendingEstimate bending_of_areal_mass(const Card& card) {
  const double mass = card.density * card.thickness;
  if (!(mass >= kLightest && mass <= kHeaviest))
    throw Error(at_field(card, "bending") + "expected an areal mass (density times thickness) of " +
                fabricsh::number(kLightest) + " to " + fabricsh::number(kHeaviest) +
                " kg/m2, as the cloths have from which bending is estimated, got " + fabricsh::number(mass));
  // Least squares of the logarithms; two thirds of the cloths lie within a factor of 2.7.
  const auto power = [mass](double at_middle, double exponent) {
    return at_middle * std::pow(mass / kMiddle, exponent);
  };
  BendingEstimate out;
  out.bending.warp = power(15.1e-6, 1.29);
  out.bending.weft = power(9.75e-6, 1.12);
  const double oblique = power(11.9e-6, 1.22);
  out.bending.twist = oblique - (out.bending.warp + out.bending.weft) / 4;
  out.source = "X. Feng et al., ACM TOG 41 (2022): powers of the areal mass, here " +
               fabricsh::number(1e3 * mass) +
               " g/m^2, through 309 cloths, two thirds of them within a factor of 2.7";
  return out;
}

}  // namespace fabricsh::card
