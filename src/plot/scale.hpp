// Round numbers along an axis, and where a value stands on it.
#pragma once
#include <string>
#include <vector>

#include "plot/figure.hpp"

namespace fabricsh::plot {

struct Tick {
  double value = 0;
  std::string text;  // empty: a small tick between two numbers
};

struct Scale {
  double low = 0, high = 1;
  bool logarithmic = false;
  std::vector<Tick> ticks = {};

  double part(double value) const;  // 0 at the lower end, 1 at the upper one
  double at(double part) const;     // the value there
};

// A scale with steps of 1, 2 or 5 that holds what lies from low to high; an end that the axis does not fix is
// moved out to the next tick. length: of the axis, in points; letter: size of its numbers; upright: they
// stand above one another.
Scale scale_of(const Axis& axis, double low, double high, double length, double letter, bool upright);

}  // namespace fabricsh::plot
