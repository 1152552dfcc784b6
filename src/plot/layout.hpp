// Positions of the axes, legends and texts of a page, in points from its lower left corner. Separate from
// the drawing, so that tests can check that no text overlaps another one or is cut off.
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

struct PageBox {
  double left = 0, bottom = 0, right = 0, top = 0;  // points
  double width() const { return right - left; }
  double height() const { return top - bottom; }
};

enum class Align { left, centre, right };

struct PlacedWord {
  std::string text;
  double x = 0, y = 0;  // position of its left end, centre or right end, at mid-height
  Align align = Align::centre;
  double size = 8;
  bool upright = false;  // rotated by 90 degrees
};

struct LegendLine {
  std::size_t curve = 0;              // index in the panel
  double left = 0, right = 0, y = 0;  // of the line sample
};

struct PlacedPanel {
  PageBox frame;  // area within the axes
  Scale x, y;
  std::vector<PlacedWord> words;
  std::vector<LegendLine> samples;  // of the legend
  PageBox key;                      // of the legend; empty: none
};

struct PageLayout {
  double width = 0, height = 0;
  std::vector<PlacedPanel> panels;
  std::vector<std::string> warnings;  // about texts that do not fit
};

// Area that a text occupies on the page.
PageBox box_of(const PlacedWord& word);

// Error: data that cannot be shown, or a page that is too small.
PageLayout layout_of(const Page& page);

}  // namespace fabricsh::plot
