#include "plot/colour_scale.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fabricsh::plot {

namespace {

using Colour = std::array<double, 3>;
// viridis (S. van der Walt, N. Smith, public domain), at even distances.
const std::vector<Colour> rising = {{68, 1, 84},    {72, 40, 120},  {62, 74, 137},  {49, 104, 142},
                                    {38, 130, 142}, {31, 158, 137}, {53, 183, 121}, {109, 205, 89},
                                    {180, 222, 44}, {253, 231, 37}};
// For values of both signs straight lines in CIE L*a*b* from dark blue over near white to dark red, which are
// perceptually uniform.
constexpr Colour blue = {32, 8, -42}, white = {97, 0, 0}, red = {32, 34, 26};  // L*, a*, b*

Colour at(const std::vector<Colour>& scale, double t) {
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(scale.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), scale.size() - 2);
  const double s = place - static_cast<double>(i);
  Colour c{};
  for (std::size_t k = 0; k < 3; ++k) c[k] = ((1 - s) * scale[i][k] + s * scale[i + 1][k]) / 255;
  return c;
}

// IEC 61966-2-1.
double from_light(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

// Red, green and blue of a colour in CIE L*a*b*, under daylight.
Colour display(const Colour& lab) {
  const double fy = (lab[0] + 16) / 116, fx = fy + lab[1] / 500, fz = fy - lab[2] / 200;
  const auto back = [](double f) { return f > 6.0 / 29 ? f * f * f : (116 * f - 16) * 27 / 24389; };
  const double x = 0.95047 * back(fx), y = back(fy), z = 1.08883 * back(fz);
  const Colour light = {3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
                        -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
                        0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
  Colour c{};
  for (std::size_t k = 0; k < 3; ++k) c[k] = from_light(std::clamp(light[k], 0.0, 1.0));
  return c;
}

// t: from -1 (blue) to 1 (red).
Colour two_sided(double t) {
  const Colour& end = t < 0 ? blue : red;
  const double s = std::min(std::abs(t), 1.0);
  Colour lab{};
  for (std::size_t k = 0; k < 3; ++k) lab[k] = white[k] + s * (end[k] - white[k]);
  return display(lab);
}

}  // namespace

Colour colour(double value, double low, double high) {
  if (!std::isfinite(value)) return {0.72, 0.72, 0.72};
  const double largest = std::max(std::abs(low), std::abs(high));
  if (low < -0.02 * largest && high > 0.02 * largest) return two_sided(value / largest);
  return at(rising, high > low ? (value - low) / (high - low) : 0);
}

// IEC 61966-2-1.
Colour light(const Colour& colour) {
  Colour out{};
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = colour[k] <= 0.04045 ? colour[k] / 12.92 : std::pow((colour[k] + 0.055) / 1.055, 2.4);
  return out;
}

}  // namespace fabricsh::plot
