// How the curves of a figure are told apart, also by colour-blind readers and in grey print.
#pragma once
#include <cstddef>
#include <string>

#include "plot/figure.hpp"

namespace fabricsh::plot {

inline constexpr std::size_t kColours = 7, kPatterns = 4, kMarkers = 6;

struct Look {
  std::string colour;  // "#0072b2"
  std::string dashes;  // lengths of dashes and gaps in widths of the line, "8,3"; empty: solid
  int marker = 0;      // gnuplot's number; 0: none
  bool line = true;
};

// Of curve number `place`, from 0: the colours in turn; lines take the next pattern, and marks the next
// shape, when the colours begin anew. Marks differ from one curve to the next besides.
Look look(std::size_t place, CurveStyle style);

}  // namespace fabricsh::plot
