// gnuplot commands for a page.
#pragma once
#include <string>

#include "plot/layout.hpp"

namespace fabricsh::plot {

// All commands of a page but `set terminal` and `set output`. canvas: size of the drawing in points; the page
// is its lower left part. Bands are transparent, or opaque in the same shade, the wider behind the narrower
// (EPS has no transparency).
std::string script_of(const Page& page, const PageLayout& layout, double canvas_width, double canvas_height,
                      bool opaque = false);

// The commands that draw one panel with characters, for a terminal (gnuplot's `dumb`).
std::string letters_script(const Figure& figure);

}  // namespace fabricsh::plot
