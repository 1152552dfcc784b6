// Where a sheet and the words of its axes stand in a part of a picture: in pixels from its lower left corner.
// Nothing here draws, so that it can be tried that no word lies on another or is cut off.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace fabricsh::render {

using Point = std::array<double, 2>;  // pixels, to the right and up
using Vector = std::array<double, 3>;
using Bounds = std::array<double, 6>;  // x, x, y, y, z, z: lower and upper end

struct Word {
  std::string text;
  Point centre{}, size{};
};
struct Line {
  Point from{}, to{};
};
// From where it is seen: unit vectors of space that point to the right and up in the picture.
struct View {
  Vector right, up;
};
// Degrees: 0, 90 from above, 0, 0 along +y.
View view_from(double azimuth, double elevation);

struct Layout {
  double scale = 1;  // pixels per unit of length
  Point centre{};    // of the bounds
  std::vector<Word> words;
  std::vector<Line> lines;
};

struct Space {
  double width = 0, height = 0;  // pixels
  double letter = 10;            // size of the letters
  // Width and height of a text in these letters.
  std::function<Point(const std::string&)> measure;
  double most = 1e300;  // pixels per unit of length, at most
};

// The largest picture of the bounds, with the words of the axes, that lies within the space. Axes run along
// edges of the bounds; one that is seen from its end, or is no longer than a letter, has no words. unit: of
// lengths; empty: no axes at all.
Layout layout(const Bounds& bounds, const View& view, const std::string& unit, const Space& space);

// A colour bar: its ends, and round numbers on it.
struct Bar {
  double low = 0, high = 1;
  std::vector<std::pair<double, std::string>> numbers = {};
};
// Steps of 1, 2 or 5, about `count` numbers, with digits enough that neighbours differ. Ends that are not
// fixed move out to the next number.
Bar round_bar(double low, double high, bool fixed, int count);

}  // namespace fabricsh::render
