#include "render/shades.hpp"

#include <algorithm>
#include <cmath>

#include "plot/colour_scale.hpp"

namespace fabricsh::render {

namespace {

// For values of both signs straight lines in CIE L*a*b* from dark blue over near white to dark red, which are
// perceptually uniform; for one sign viridis.
constexpr Colour blue = {32, 8, -42}, white = {97, 0, 0}, red = {32, 34, 26};  // L*, a*, b*

// Red, green and blue, from 0 to 255, of a colour in CIE L*a*b*.
Colour display(const Colour& lab) {
  const double fy = (lab[0] + 16) / 116, fx = fy + lab[1] / 500, fz = fy - lab[2] / 200;
  const auto back = [](double f) { return f > 6.0 / 29 ? f * f * f : (116 * f - 16) * 27 / 24389; };
  const double x = 0.95047 * back(fx), y = back(fy), z = 1.08883 * back(fz);
  const Colour linear = {3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
                         -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
                         0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
  Colour c{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double v = std::clamp(linear[k], 0.0, 1.0);
    c[k] = 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055);
  }
  return c;
}

// t: from -1 (blue) to 1 (red).
Colour with_sign(double t) {
  const Colour& end = t < 0 ? blue : red;
  const double s = std::min(std::abs(t), 1.0);
  Colour lab{};
  for (std::size_t k = 0; k < 3; ++k) lab[k] = white[k] + s * (end[k] - white[k]);
  Colour c = display(lab);
  for (double& v : c) v /= 255;
  return c;
}

}  // namespace

Colour shade(double low, double high, double value) {
  const double largest = std::max(std::abs(low), std::abs(high));
  const bool both = low < -0.02 * largest && high > 0.02 * largest;
  return both ? with_sign(value / largest) : plot::viridis((value - low) / (high - low));
}

}  // namespace fabricsh::render
