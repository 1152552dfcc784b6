// The range of values that the axes of a figure show.
#pragma once
#include "plot/figure.hpp"

namespace fabricsh::plot {

struct Span {
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;
};

// Range of the points, bands and error bars within the fixed ranges. Error: a figure that cannot be drawn.
Span visible_span(const Figure& figure);

}  // namespace fabricsh::plot
