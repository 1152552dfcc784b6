// The middle of a dot by the picture of a blurred ellipse, fitted to all pixels around it.
#pragma once
#include <optional>

#include "format/image.hpp"

namespace fabricsh::lab {

struct Window {
  int left, right, top, bottom;  // columns and rows, inclusive, within the image
};

struct Ellipse {
  double x = 0, y = 0;            // middle, pixels
  double xx = 0, xy = 0, yy = 0;  // rim: xx dx^2 + 2 xy dx dy + yy dy^2 = 1
  double ground = 0, ink = 0;     // brightness
  double blur = 1;                // standard deviation of the point spread, pixels
};

// Least squares (Levenberg and Marquardt) over the pixels of the window: ground + (ink - ground) times the
// part of a Gaussian point spread that a straight rim at the pixel's distance covers. Every pixel of the rim
// has its say, so noise weighs no more than it must. Nothing: it does not settle near `start`, or what
// remains is more than `largest_rest` of the contrast (root mean square): no ellipse.
std::optional<Ellipse> fit_ellipse(const format::Image& image, const Window& window, const Ellipse& start,
                                   double largest_rest);

}  // namespace fabricsh::lab
