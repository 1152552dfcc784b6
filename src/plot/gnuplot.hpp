// Runs gnuplot on a script, and corrects the files that it draws.
#pragma once
#include <string>

#include "base/error.hpp"

namespace fabricsh::plot {

// gnuplot is not installed; callers may then continue without the figure.
class NoGnuplot : public Error {
 public:
  using Error::Error;
};

// Returns the drawing that gnuplot writes to its standard output. Throws
// NoGnuplot, or Error with gnuplot's reason if it failed or drew nothing.
std::string run_gnuplot(const std::string& script);

// Sets width and height in mm, clips the canvas to the page, names fonts that every viewer has,
// numbers the curves of all panels consecutively, and escapes what XML requires. Sizes in points.
std::string finished_svg(std::string svg, double width, double height, double canvas_height, bool own_font);

// Takes the date out, so that the same figure is the same file.
std::string finished_eps(std::string eps);

// Adds the resolution to a PNG.
std::string finished_png(const std::string& png, double dpi);

}  // namespace fabricsh::plot
