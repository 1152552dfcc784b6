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
  CHECK(colour(0, -1, 4) == Colour{247 / 255.0, 247 / 255.0, 247 / 255.0});
  CHECK(colour(4, -1, 4) == Colour{103 / 255.0, 0, 31 / 255.0});
  CHECK(colour(-4, -4, 1) == Colour{5 / 255.0, 48 / 255.0, 97 / 255.0});
  CHECK(colour(0.0 / 0.0, 0, 1) == Colour{0.72, 0.72, 0.72});
}

TEST_CASE("colours as light: the curve of sRGB", "[plot]") {
  CHECK(light({0, 1, 0.04}) == Colour{0, 1, 0.04 / 12.92});
  CHECK(std::abs(light({0.5, 0, 0})[0] - 0.21404114048223255) < 1e-15);
}
