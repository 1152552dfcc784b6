// The colours of a bar are even to the eye, and keep their order without one kind of cones.
#include <array>
#include <cmath>

#include "catch.hpp"
#include "plot/colour_scale.hpp"

using Colour = std::array<double, 3>;

namespace {

double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

struct Range {
  double low, high;
};

// CIE L*a*b* of colour i of 256 under daylight; as it is, or as seen without green cones (G.
// Machado, M. Oliveira, L. Fernandes, 2009).
Colour lab(const Range& bar, int i, bool without_green) {
  const Colour rgba =
      fabricsh::plot::colour(bar.low + (i + 0.5) / 256 * (bar.high - bar.low), bar.low, bar.high);
  Colour c = {linear(rgba[0]), linear(rgba[1]), linear(rgba[2])};
  if (without_green)
    c = {std::max(0.0, 0.367322 * c[0] + 0.860646 * c[1] - 0.227968 * c[2]),
         std::max(0.0, 0.280085 * c[0] + 0.672501 * c[1] + 0.047413 * c[2]),
         std::max(0.0, -0.011820 * c[0] + 0.042940 * c[1] + 0.968881 * c[2])};
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const double x = f((0.4124564 * c[0] + 0.3575761 * c[1] + 0.1804375 * c[2]) / 0.95047),
               y = f(0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2]),
               z = f((0.0193339 * c[0] + 0.1191920 * c[1] + 0.9503041 * c[2]) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double distance(const Colour& p, const Colour& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace

TEST_CASE("one sign: lighter all the way, also without green cones", "[plot]") {
  const Range table{0, 1};
  for (const bool without : {false, true})
    for (int i = 16; i < 256; i += 16) {
      CAPTURE(without, i);
      CHECK(lab(table, i, without)[0] > lab(table, i - 16, without)[0] + 1);
    }
  // Lightness rises as a straight line would, within 7 of its 75 units; equal steps are equal to the eye
  // within a factor of 2.2, as in viridis itself.
  double least = 1e9, most = 0;
  for (int i = 0; i < 256; i += 15) {
    const double low = lab(table, 0, false)[0], high = lab(table, 255, false)[0];
    CHECK(std::abs(lab(table, i, false)[0] - (low + (high - low) * i / 255)) < 7);
    if (i == 0) continue;
    const double step = distance(lab(table, i, false), lab(table, i - 15, false));
    least = std::min(least, step), most = std::max(most, step);
  }
  CAPTURE(least, most);
  CHECK(most < 2.2 * least);
}

TEST_CASE("two signs: white at zero, even steps to either end, the ends apart without green cones",
          "[plot]") {
  const Range table{-1, 1};
  CHECK(lab(table, 127, false)[0] > 96);
  double least = 1e9, most = 0;
  for (int i = 15; i < 256; i += 15) {
    if (i > 113 && i < 143) continue;  // around the turn at zero
    const double step = distance(lab(table, i, false), lab(table, i - 15, false));
    least = std::min(least, step), most = std::max(most, step);
  }
  CAPTURE(least, most);
  CHECK(most < 1.05 * least);
  for (int i = 0; i < 90; i += 10) CHECK(distance(lab(table, i, true), lab(table, 255 - i, true)) > 20);
  // As much above zero as below it is equally strong.
  for (int i = 0; i < 128; i += 8)
    CHECK(std::abs(lab(table, i, false)[0] - lab(table, 255 - i, false)[0]) < 0.5);
}

TEST_CASE("a range of one sign with a trace of the other stays of one sign", "[plot]") {
  CHECK(lab({-0.01, 1}, 0, false)[0] < 20);
  CHECK(lab({-0.5, 1}, 85, false)[0] > 95);  // zero, at a third
}
