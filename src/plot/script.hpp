// gnuplot commands for a page.
#pragma once
#include <cstddef>
#include <string>

#include "plot/figure.hpp"
#include "plot/layout.hpp"

namespace fabricsh::plot {

// All commands of a page but `set terminal` and `set output`. canvas: size of the drawing in points; the page
// is its lower left part. Bands are transparent, or opaque in the same shade, the wider behind the narrower
// (EPS has no transparency).
std::string script_of(const Page& page, const PageLayout& layout, double canvas_width, double canvas_height,
                      bool opaque = false);

// The commands that draw one panel with characters, for a terminal (gnuplot's `dumb`).
std::string letters_script(const Figure& figure);

// --- Colours, line patterns and marks, distinguishable for colour-blind readers and in grey print.

inline constexpr std::size_t kColours = 7, kPatterns = 4, kMarkers = 6;

struct CurveAppearance {
  std::string colour;  // "#0072b2"
  std::string dashes;  // dash and gap lengths in line widths, "8,3"; empty: solid
  int marker = 0;      // gnuplot's number; 0: none
  bool line = true;
};

// The look of curve number `place`, counted from 0. Colours and marks change from curve to curve;
// the line pattern changes each time the colours are repeated.
CurveAppearance look(std::size_t place, CurveStyle style);

}  // namespace fabricsh::plot
