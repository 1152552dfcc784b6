#include "plot/look.hpp"

#include <array>

namespace fabricsh::plot {

namespace {

// The colours of M. Okabe and K. Ito without the yellow, which is too pale on white paper. In this
// order successive colours are well separated for each kind of colour blindness.
constexpr std::array<const char*, kColours> colours = {"#0072b2", "#d55e00", "#cc79a7", "#000000",
                                                       "#009e73", "#e69f00", "#56b4e9"};
// The style "dashed" has its own pattern.
constexpr const char* asked_dashes = "7,3.5";
constexpr std::array<const char*, kPatterns> patterns = {"", "12,3,2,3", "2,3", "18,4"};
// Circle, square, triangle, diamond, triangle on its tip, pentagon: open, and filled.
constexpr std::array<int, kMarkers> open = {6, 4, 8, 12, 10, 14}, filled = {7, 5, 9, 13, 11, 15};

}  // namespace

CurveAppearance look(std::size_t place, CurveStyle style) {
  const std::size_t round = place / kColours, shape = place % kMarkers;
  CurveAppearance result{colours[place % kColours], patterns[round % kPatterns]};
  if (style == CurveStyle::dashed) result.dashes = asked_dashes;
  if (style == CurveStyle::line_points) result.marker = filled[shape];
  if (style == CurveStyle::points) result.marker = open[shape], result.line = false;
  return result;
}

}  // namespace fabricsh::plot
