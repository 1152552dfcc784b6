// Colours of numbers: even to the eye, in grey print, and for most colour-blind readers.
#pragma once
#include <array>

namespace fabricsh::render {

using Colour = std::array<double, 3>;  // red, green, blue, from 0 to 1

// On a bar from low to high: from dark violet to yellow, or blue, white at zero, red where the range has both
// signs.
Colour shade(double low, double high, double value);

}  // namespace fabricsh::render
