// Positions of a sheet and its axis labels within a part of a picture, in pixels from its lower left
// corner. Nothing is drawn here, so that tests can check that no label overlaps another or is cut off.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace fabricsh::render {

using Point = std::array<double, 2>;  // pixels, to the right and up
using Vector = std::array<double, 3>;
using Bounds = std::array<double, 6>;  // x, x, y, y, z, z: lower and upper bound

struct Word {
  std::string text;
  Point centre{}, size{};
};
struct Segment {
  Point from{}, to{};
};
// Viewing direction, as the unit vectors in space that point right and up in the picture.
struct View {
  Vector right, up;
};
// Degrees: 0, 90 is from above; 0, 0 is along +y.
View view_from(double azimuth, double elevation);

struct ViewLayout {
  double scale = 1;  // pixels per unit of length
  Point centre{};    // position of the centre of the bounds
  std::vector<Word> words;
  std::vector<Segment> lines;
};

struct Space {
  double width = 0, height = 0;  // pixels
  double letter = 10;            // font size
  // Width and height of a text in this font size.
  std::function<Point(const std::string&)> measure;
  double most = 1e300;  // largest scale allowed, pixels per unit of length
};

// The largest picture of the bounds and the axis labels that fits into the
// space. Axes run along edges of the bounds; one that is seen end-on or is not
// longer than a letter has no labels. unit: unit of length; empty: no axes.
ViewLayout layout(const Bounds& bounds, const View& view, const std::string& unit, const Space& space);

// A colour bar: its ends and its labels.
struct Bar {
  double low = 0, high = 1;
  std::vector<std::pair<double, std::string>> numbers = {};
};
// A bar with about `count` labels in steps of 1, 2 or 5 times a power of ten, with enough digits to
// distinguish neighbours. Ends that are not fixed are moved outwards to the next label.
Bar round_bar(double low, double high, bool fixed, int count);

}  // namespace fabricsh::render
