// Finding dots on photographs, and making photographs of dots for tests. Positions in pixels: x to the right
// and y downwards from the centre of the first pixel.
#pragma once
#include <optional>
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

// --- The centre of a dot, from fitting a blurred ellipse to all pixels around it.

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

// --- Photographs of speckled cloth under a known map, for trying the correlation.

using lab::Speckles;

// Every blot lets 1 - exp(-r^2 / (2 size^2)) of the light through, so the brightness is a smooth function
// that is known at every place, and a map of the cloth is exact: no picture is interpolated. 8 bits.
Image draw(const Speckles& speckles);

}  // namespace fabricsh::photograph
