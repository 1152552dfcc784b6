// The centre of a dot, from fitting a blurred ellipse to all pixels around it.
#pragma once
#include <optional>

#include "photograph/image.hpp"

namespace fabricsh::photograph {

struct Window {
  int left, right, top, bottom;  // columns and rows, inclusive, within the image
};

struct Ellipse {
  double x = 0, y = 0;            // centre, pixels
  double xx = 0, xy = 0, yy = 0;  // rim: xx dx^2 + 2 xy dx dy + yy dy^2 = 1
  double ground = 0, ink = 0;     // brightness
  double blur = 1;                // standard deviation of the point spread, pixels
};

// Least squares (Levenberg-Marquardt) over the pixels of the window. Model: ground + (ink - ground) times the
// fraction of a Gaussian point spread that a straight rim at the pixel's distance covers. All pixels of the
// rim contribute, which minimises the effect of noise. Empty: the fit does not converge near `start`, or its
// root mean square residual exceeds `largest_rest` of the contrast, so that the spot is no ellipse.
std::optional<Ellipse> fit_ellipse(const Image& image, const Window& window, const Ellipse& start,
                                   double largest_residual);

}  // namespace fabricsh::photograph
