// The range of values that the axes of a figure show, and the points that they cannot show.
#pragma once
#include <string>
#include <vector>

#include "plot/figure.hpp"

namespace fabricsh::plot {

struct Span {
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;
};

// Whether an axis has a place for this value: it is finite, and above zero on a logarithmic axis.
bool shows(const Axis& axis, double value);

// Range of the points, bands and error bars within the fixed ranges. Error: a figure that cannot be drawn.
Span visible_span(const Figure& figure);

// A sentence for each curve with points, band ends or error bars at zero or below on a logarithmic axis.
std::vector<std::string> left_out(const Page& page);

}  // namespace fabricsh::plot
