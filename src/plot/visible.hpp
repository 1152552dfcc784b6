// What of a figure's curves its axes show.
#pragma once
#include "plot/figure.hpp"

namespace fabricsh::plot {

struct Span {
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;
};

// Points, bands and error bars inside the ranges that are fixed. Error: a figure that can't be drawn.
Span visible_span(const Figure& figure);

}  // namespace fabricsh::plot
