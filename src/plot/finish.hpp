// What gnuplot leaves undone in a file that it drew.
#pragma once
#include <string>

namespace fabricsh::plot {

// Width and height in mm, the page's own part of the canvas, letters that every viewer has, one number for
// each curve of all panels, and characters that XML wants escaped. Sizes in points.
std::string finished_svg(std::string svg, double width, double height, double canvas_height, bool own_font);

// A PNG that says how many pixels an inch has.
std::string finished_png(const std::string& png, double dpi);

}  // namespace fabricsh::plot
