// Colours as an eye sees them, so that tests can tell how far apart two are.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace fabricsh::plot {

// Three numbers: red, green and blue, or L*, a*, b*.
using Seen = std::array<double, 3>;

// Linear red, green and blue as seen without one kind of cones (G. Machado, M. Oliveira, L.
// Fernandes, IEEE Transactions on Visualization and Computer Graphics 15, 2009; severity 1).
inline constexpr std::array<std::array<Seen, 3>, 4> eyes = {
    {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
     {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}}};
constexpr std::size_t all_cones = 0, no_green_cones = 2;

// CIE L*a*b* under daylight of an sRGB colour (each 0 to 1) as this eye sees it.
inline Seen seen(const Seen& rgb, std::size_t eye) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  Seen c{};
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += eyes[eye][i][k] * linear(rgb[k]);
    c[i] = std::clamp(sum, 0.0, 1.0);
  }
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const double x = f((0.4124564 * c[0] + 0.3575761 * c[1] + 0.1804375 * c[2]) / 0.95047),
               y = f(0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2]),
               z = f((0.0193339 * c[0] + 0.1191920 * c[1] + 0.9503041 * c[2]) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

inline double distance(const Seen& p, const Seen& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace fabricsh::plot
