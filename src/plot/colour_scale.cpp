#include "plot/colour_scale.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fabricsh::plot {

namespace {

using Colour = std::array<double, 3>;
// viridis (S. van der Walt, N. Smith, public domain) and the red-blue scale of ColorBrewer, at even
// distances.
const std::vector<Colour> rising = {{68, 1, 84},    {72, 40, 120},  {62, 74, 137},  {49, 104, 142},
                                    {38, 130, 142}, {31, 158, 137}, {53, 183, 121}, {109, 205, 89},
                                    {180, 222, 44}, {253, 231, 37}};
const std::vector<Colour> two_sided = {{5, 48, 97},     {33, 102, 172},  {67, 147, 195},  {146, 197, 222},
                                       {209, 229, 240}, {247, 247, 247}, {253, 219, 199}, {244, 165, 130},
                                       {214, 96, 77},   {178, 24, 43},   {103, 0, 31}};

Colour at(const std::vector<Colour>& scale, double t) {
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(scale.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), scale.size() - 2);
  const double s = place - static_cast<double>(i);
  Colour c{};
  for (std::size_t k = 0; k < 3; ++k) c[k] = ((1 - s) * scale[i][k] + s * scale[i + 1][k]) / 255;
  return c;
}

}  // namespace

Colour viridis(double t) { return at(rising, t); }

Colour colour(double value, double low, double high) {
  if (!std::isfinite(value)) return {0.72, 0.72, 0.72};
  const double largest = std::max(std::abs(low), std::abs(high));
  if (low < -0.02 * largest && high > 0.02 * largest) return at(two_sided, (value / largest + 1) / 2);
  return viridis(high > low ? (value - low) / (high - low) : 0);
}

// IEC 61966-2-1.
Colour light(const Colour& colour) {
  Colour out{};
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = colour[k] <= 0.04045 ? colour[k] / 12.92 : std::pow((colour[k] + 0.055) / 1.055, 2.4);
  return out;
}

}  // namespace fabricsh::plot
