// Curves in coordinate systems as SVG, PNG, PDF or letters, drawn by gnuplot.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace fabricsh::plot {

enum class CurveStyle { line, dashed, points, line_points };

// Lower and upper ends, one pair for each point of a curve; empty: none.
struct Ends {
  std::vector<double> low = {}, high = {};
  bool empty() const { return low.empty(); }
};

struct Curve {
  std::string label;  // in the key; empty: not in the key
  std::vector<double> x,
      y;  // of one length; a value that is not finite interrupts the line. y empty: only a band
  CurveStyle style = CurveStyle::line;
  Ends band = {}, error = {};
  std::string colour = {};  // "#0072b2"; empty: by its place among the curves
};

struct Axis {
  std::string label = {};
  std::optional<double> low = {}, high = {};  // empty: chosen from the curves
  bool logarithmic = false;
};

enum class Key { best, none, top_left, top_right, bottom_left, bottom_right, below, right };

struct Figure {
  std::string title = {};
  Axis x = {}, y = {};
  std::vector<Curve> curves = {};
  Key key = Key::best;
};

// What it is printed on.
struct Paper {
  double width = 0, height = 0;  // m; 0: 85 mm for one column of panels, 170 mm for more, 60 mm a row
  std::string font = {};         // a family; empty: Helvetica, or what stands for it
  double font_size = 8;          // points
  double dpi = 300;              // pixels of a PNG per inch
};

// Figures in rows and columns on one page.
struct Page {
  std::vector<Figure> panels = {};
  int rows = 0, columns = 0;  // 0: two columns, and the rows that it takes
  bool letters = true;        // (a), (b), ... where there are several panels
  Paper paper = {};
};

// Replaces the file; the ending of its name says the format. Text is taken as it is, no mark-up. Returns what
// is to be told of words that have no room. Error: another ending, no curve, x and y of different length, a
// curve without a point that can be drawn, no point inside the range, a page too small for its axes, gnuplot
// failing; NoGnuplot: it is not installed.
std::vector<std::string> draw(const std::string& path, const Page& page);
std::vector<std::string> draw(const std::string& path, const Figure& figure);

// The same in letters, for a terminal; columns x lines characters a panel.
std::string drawn_in_letters(const Page& page, int columns, int lines);
std::string drawn_in_letters(const Figure& figure, int columns, int lines);

}  // namespace fabricsh::plot
