// Curves in a coordinate system as SVG, PNG or PDF, drawn by gnuplot.
#pragma once
#include <string>
#include <vector>

namespace fabricsh::files {

enum class CurveStyle { line, dashed, points, line_points };

struct Curve {
  std::string label;         // in the key; empty: not in the key
  std::vector<double> x, y;  // of one length; a value that is not finite interrupts the line
  CurveStyle style = CurveStyle::line;
};

// Replaces the file; the ending of its name says the format. Text is taken as it is, no mark-up.
// Error: another ending, no curve, x and y of different length, gnuplot missing or failing (with its words).
void figure(const std::string& path, const std::string& title, const std::string& xlabel,
            const std::string& ylabel, const std::vector<Curve>& curves);

}  // namespace fabricsh::files
