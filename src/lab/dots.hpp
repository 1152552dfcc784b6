// Finding dots on photographs, and making photographs of dots for tests. Positions in pixels: x to the right
// and y downwards from the centre of the first pixel.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "format/image.hpp"

namespace fabricsh::lab {

struct Dot {
  double x, y;      // centre, with sub-pixel accuracy
  double area;      // pixels
  double contrast;  // difference of brightness between dot and background
};

struct DotOptions {
  bool dark = true;      // dark dots on a lighter background
  double smallest = 12;  // area, pixels
  double largest = 1e5;
  double contrast = 0.1;  // least
};

// Finds connected spots beyond the threshold between background and dots (Otsu's, for the image smoothed over
// three pixels [otsu1979]) that do not touch the border. The position is the centre of a blurred ellipse
// fitted to the pixels; for a spot that is no ellipse, the centroid of its darkness.
std::vector<Dot> find_dots(const format::Image& image, const DotOptions& options);

// A grid of dots under an affine map, as seen by a camera.
struct DotGrid {
  int width = 0, height = 0;            // pixels
  std::size_t rows = 2, columns = 2;    // of dots
  double pitch = 0, radius = 0;         // of the undeformed grid, pixels
  std::array<double, 4> F{1, 0, 0, 1};  // about the centre of image and grid; y downwards
  double ground = 0.85, ink = 0.15;     // brightness of background and dots
  double blur = 1;                      // standard deviation of the point spread, pixels
  double noise = 0.01;                  // standard deviation per pixel, brightness
  std::uint64_t seed = 1;
};
format::Image photograph(const DotGrid& scene);
// The exact positions of the dots in the scene, row by row: x0, y0, x1, y1, ...
std::vector<double> true_positions(const DotGrid& scene);

}  // namespace fabricsh::lab
