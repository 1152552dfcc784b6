// Corrections of the files that gnuplot draws.
#pragma once
#include <string>

namespace fabricsh::plot {

// Sets width and height in mm, clips the canvas to the page, names fonts that every viewer has,
// numbers the curves of all panels consecutively, and escapes what XML requires. Sizes in points.
std::string finished_svg(std::string svg, double width, double height, double canvas_height, bool own_font);

// Takes the date out, so that the same figure is the same file.
std::string finished_eps(std::string eps);

// Adds the resolution to a PNG.
std::string finished_png(const std::string& png, double dpi);

}  // namespace fabricsh::plot
