// A page as commands for gnuplot.
#pragma once
#include <string>

#include "plot/layout.hpp"

namespace fabricsh::plot {

// All but the terminal. canvas: points of the whole drawing, of which the page takes the lower left part.
std::string script_of(const Page& page, const Layout& layout, double canvas_width, double canvas_height);

// One panel for a terminal of letters.
std::string letters_script(const Figure& figure);

}  // namespace fabricsh::plot
