// Curves in a coordinate system, drawn by gnuplot as SVG, PNG, PDF or text.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace fabricsh::plot {

enum class CurveStyle { line, dashed, points, line_points };

struct Curve {
  std::string label;         // for the legend; empty: no entry
  std::vector<double> x, y;  // of equal length; a value that is not finite interrupts the line
  CurveStyle style = CurveStyle::line;
};

struct Axis {
  std::string label = {};
  std::optional<double> low = {}, high = {};  // empty: chosen from the curves
  bool logarithmic = false;
};

struct Figure {
  std::string title = {};
  Axis x = {}, y = {};
  std::vector<Curve> curves = {};
};

// Replaces the file; its extension determines the format. Texts are not interpreted as markup.
// Error: another extension, no curve, x and y of different lengths, a curve without a drawable
// point, no point within the range, or a failure of gnuplot. NoGnuplot if it is not installed.
void draw(const std::string& path, const Figure& figure);

// The figure as text for a terminal, columns x lines characters.
std::string drawn_in_letters(const Figure& figure, int columns, int lines);

}  // namespace fabricsh::plot
