// Curves in a coordinate system as SVG, PNG, PDF or letters, drawn by gnuplot.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace fabricsh::plot {

enum class CurveStyle { line, dashed, points, line_points };

struct Curve {
  std::string label;         // in the key; empty: not in the key
  std::vector<double> x, y;  // of one length; a value that is not finite interrupts the line
  CurveStyle style = CurveStyle::line;
};

struct Axis {
  std::string label = {};
  std::optional<double> low = {}, high = {};  // none: from the curves
  bool logarithmic = false;
};

struct Figure {
  std::string title = {};
  Axis x = {}, y = {};
  std::vector<Curve> curves = {};
};

// Replaces the file; the ending of its name says the format. Text is taken as it is, no mark-up.
// Error: another ending, no curve, x and y of different length, a curve without a point that can be drawn, no
// point inside the range, gnuplot failing; NoGnuplot: it is not installed.
void draw(const std::string& path, const Figure& figure);

// The same in letters, for a terminal; columns x lines characters.
std::string drawn_in_letters(const Figure& figure, int columns, int lines);

}  // namespace fabricsh::plot
