// Curves in coordinate systems, drawn by gnuplot as SVG, PNG, PDF, EPS or text.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace fabricsh::plot {

enum class CurveStyle { line, dashed, points, line_points };

// Lower and upper ends for each point of a curve; empty: none.
struct Ends {
  std::vector<double> low = {}, high = {};
  bool empty() const { return low.empty(); }
};

struct PlottedCurve {
  std::string label;  // for the legend; empty: no entry
  std::vector<double> x,
      y;  // of one length; a value that is not finite interrupts the line. y empty: only a band
  CurveStyle style = CurveStyle::line;
  Ends band = {}, error = {};  // along y
  Ends x_error = {};           // error bars along x; only with y
  std::string colour = {};     // "#0072b2"; empty: by its place among the curves
};

struct Axis {
  std::string label = {};
  std::optional<double> low = {}, high = {};  // empty: chosen from the curves
  bool logarithmic = false;
  std::vector<std::string> names = {};  // of the values 1, 2, ..., in the place of numbers
};

enum class Key { best, none, top_left, top_right, bottom_left, bottom_right, below, right };

struct Figure {
  std::string title = {};
  Axis x = {}, y = {};
  std::vector<PlottedCurve> curves = {};
  Key key = Key::best;
};

// Size of a page and its font.
struct Paper {
  double width = 0,
         height = 0;  // m; 0: 85 mm wide for one column of panels, 170 mm for more, 60 mm high for each row
  std::string font = {};  // family; empty: Helvetica or its substitute
  double font_size = 8;   // points
  double dpi = 300;       // of a PNG
};

// Figures in rows and columns on one page.
struct Page {
  std::vector<Figure> panels = {};
  int rows = 0, columns = 0;  // 0: two columns, and as many rows as needed
  bool letters = true;        // (a), (b), ... if there are several panels
  Paper paper = {};
};

// Replaces the file; its extension determines the format. Texts are not interpreted as markup. Returns
// warnings about texts that do not fit and points that a logarithmic axis cannot show. Error: another
// extension, no curve, x and y of different lengths, a curve without a drawable point, no point within the
// range, a page too small for its axes, or a failure of gnuplot. NoGnuplot if it is not installed.
std::vector<std::string> draw(const std::string& path, const Page& page);
std::vector<std::string> draw(const std::string& path, const Figure& figure);

// The figure as text for a terminal, columns x lines characters for each panel.
std::string drawn_in_letters(const Page& page, int columns, int lines);
std::string drawn_in_letters(const Figure& figure, int columns, int lines);

}  // namespace fabricsh::plot
