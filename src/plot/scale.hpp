// The scale of an axis: its ends, its ticks, and the position of a value.
#pragma once
#include <string>
#include <vector>

#include "plot/figure.hpp"

namespace fabricsh::plot {

struct Tick {
  double value = 0;
  std::string text;  // empty: a minor tick
};

struct Scale {
  double low = 0, high = 1;
  bool logarithmic = false;
  std::vector<Tick> ticks = {};

  double part(double value) const;  // position: 0 at the lower end, 1 at the upper end
  double at(double part) const;     // the value at a position
  double held(double value) const;  // the value; on a logarithmic scale its lower end for zero and below
};

// A scale for values from low to high with steps of 1, 2 or 5 times a power of ten. Ends that the
// axis does not fix are moved outwards to the next tick. length: of the axis, points; letter: font size
// of the tick labels; upright: the axis is vertical.
Scale scale_of(const Axis& axis, double low, double high, double length, double letter, bool upright);

}  // namespace fabricsh::plot
