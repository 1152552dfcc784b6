// Dots on a photograph, and photographs of dots for trying it. Positions in pixels: x to the right and y
// downwards from the middle of the first pixel.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "format/image.hpp"

namespace fabricsh::lab {

struct Dot {
  double x, y;      // middle, sub-pixel
  double area;      // pixels
  double contrast;  // of the dot against what is around it, brightness
};

struct DotOptions {
  bool dark = true;      // on a lighter ground
  double smallest = 12;  // area, pixels
  double largest = 1e5;
  double contrast = 0.1;  // least
};

// Connected spots beyond the threshold between ground and dots (Otsu's, of the picture smoothed over three
// pixels [otsu1979]), not touching the rim. The middle is that of a blurred ellipse fitted to the pixels; of
// a blot that is no ellipse, the centroid of its darkness.
std::vector<Dot> find_dots(const format::Image& image, const DotOptions& options);

// A dot grid under an affine map, as a camera would take it.
struct Scene {
  int width = 0, height = 0;            // pixels
  std::size_t rows = 2, columns = 2;    // of dots
  double pitch = 0, radius = 0;         // of the undeformed grid, pixels
  std::array<double, 4> F{1, 0, 0, 1};  // about the middle of picture and grid; y downwards
  double ground = 0.85, ink = 0.15;     // brightness
  double blur = 1;                      // standard deviation of the point spread, pixels
  double noise = 0.01;                  // of a pixel, brightness
  std::uint64_t seed = 1;
};
format::Image photograph(const Scene& scene);
// Where the dots of the scene truly are, row by row: x0, y0, x1, y1, ...
std::vector<double> true_positions(const Scene& scene);

}  // namespace fabricsh::lab
