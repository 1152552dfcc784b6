// Where the axes, the keys and the words of a page stand: in points from its lower left corner. Nothing here
// draws, so that it can be tried that no word lies on another or is cut off.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "plot/figure.hpp"
#include "plot/scale.hpp"

namespace fabricsh::plot {

struct Box {
  double left = 0, bottom = 0, right = 0, top = 0;  // points
  double width() const { return right - left; }
  double height() const { return top - bottom; }
};

enum class Align { left, centre, right };

struct PlacedWord {
  std::string text;
  double x = 0, y = 0;  // of its left end, centre or right end; in the middle of its height
  Align align = Align::centre;
  double size = 8;
  bool upright = false;  // runs upwards
};

struct Sample {
  std::size_t curve = 0;              // its number in the panel
  double left = 0, right = 0, y = 0;  // of the piece of line
};

struct PlacedPanel {
  Box frame;  // of the axes
  Scale x, y;
  std::vector<PlacedWord> words;
  std::vector<Sample> samples;  // of the key
  Box key;                      // empty: none
};

struct Layout {
  double width = 0, height = 0;
  std::vector<PlacedPanel> panels;
  std::vector<std::string> warnings;  // of words without room
};

// Room that a word takes on the page.
Box box_of(const PlacedWord& word);

// Error: what can't be shown, or a page too small.
Layout layout_of(const Page& page);

}  // namespace fabricsh::plot
