// Colours, line patterns and marks, distinguishable for colour-blind readers and in grey print.
#pragma once
#include <cstddef>
#include <string>

#include "plot/figure.hpp"

namespace fabricsh::plot {

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
