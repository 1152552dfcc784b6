#include <cmath>

#include "catch.hpp"
#include "plot/colour_scale.hpp"

using namespace fabricsh::plot;
using Colour = std::array<double, 3>;

TEST_CASE("colours: the ends of viridis, and both sides of zero", "[plot]") {
  CHECK(colour(2, 2, 5) == Colour{68 / 255.0, 1 / 255.0, 84 / 255.0});
  CHECK(colour(5, 2, 5) == Colour{253 / 255.0, 231 / 255.0, 37 / 255.0});
  CHECK(colour(99, 2, 5) == colour(5, 2, 5));
  CHECK(colour(3, 3, 3) == colour(2, 2, 5));
  // -1 to 4: white at zero, the same distance on both sides, although one end is not reached.
  // L* = 97 without a hue is Y = ((97 + 16) / 116)^3 of white; its red, green and blue agree but for the
  // rounding of the matrix.
  const double grey = 1.055 * std::pow(std::pow(113 / 116.0, 3), 1 / 2.4) - 0.055;
  for (const double c : colour(0, -1, 4)) CHECK(std::abs(c - grey) < 2e-4);
  const Colour red = colour(4, -1, 4), blue = colour(-4, -4, 1);
  CHECK((red[0] > 0.4 && red[1] < 0.2 && red[2] < 0.2));
  CHECK((blue[2] > 0.4 && blue[0] < 0.2 && blue[1] < 0.35));
  CHECK(colour(0.0 / 0.0, 0, 1) == Colour{0.72, 0.72, 0.72});
}

TEST_CASE("colours as light: the curve of sRGB", "[plot]") {
  CHECK(light({0, 1, 0.04}) == Colour{0, 1, 0.04 / 12.92});
  CHECK(std::abs(light({0.5, 0, 0})[0] - 0.21404114048223255) < 1e-15);
}
