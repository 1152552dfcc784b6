// Colour scales that are perceptually uniform and suitable for grey print and most colour-blind readers.
#pragma once
#include <array>

namespace fabricsh::render {

using Colour = std::array<double, 3>;  // red, green, blue, from 0 to 1

// Colour of a value on a bar from low to high: dark violet to yellow, or, if the range has both signs,
// blue over white at zero to red.
Colour shade(double low, double high, double value);

}  // namespace fabricsh::render
