// Finding dots on photographs, and making photographs of dots for tests. Positions in pixels: x to the right
// and y downwards from the centre of the first pixel.
#pragma once
#include <vector>

#include "lab/photographs.hpp"
#include "photograph/image.hpp"

namespace fabricsh::photograph {

struct Dot {
  double x, y;      // centre, with sub-pixel accuracy
  double area;      // pixels
  double contrast;  // difference of brightness between dot and background
};

using lab::DotGrid;
using lab::DotOptions;

// Finds connected spots beyond the threshold between background and dots (Otsu's, for the image smoothed over
// three pixels [otsu1979]) that do not touch the border. The position is the centre of a blurred ellipse
// fitted to the pixels; for a spot that is no ellipse, the centroid of its darkness.
std::vector<Dot> find_dots(const Image& image, const DotOptions& options);

Image draw(const DotGrid& scene);
// The exact positions of the dots in the scene, row by row: x0, y0, x1, y1, ...
std::vector<double> true_positions(const DotGrid& scene);

}  // namespace fabricsh::photograph
