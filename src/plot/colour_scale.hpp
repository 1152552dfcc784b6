// Colours of numbers, for pictures and for files of the web: scales that are even to the eye, and that grey
// print and most colour-blind readers keep apart.
#pragma once
#include <array>

namespace fabricsh::plot {

// Red, green and blue of a value between low and high, 0 to 1, as screens take them (sRGB): from blue over
// white to red, the same on both sides of 0, where low and high are on both sides of it; else from dark blue
// to yellow. Values that are not finite are grey.
std::array<double, 3> colour(double value, double low, double high);
// The same as the amounts of light that these are (linear).
std::array<double, 3> light(const std::array<double, 3>& colour);

}  // namespace fabricsh::plot
