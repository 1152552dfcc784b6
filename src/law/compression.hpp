// Sheets that are pressed flat one on the other: measured points of thickness (m, ascending) and pressure
// (Pa).
#pragma once
#include <utility>
#include <vector>

namespace fabricsh::law {

using Points = std::vector<std::pair<double, double>>;

// A part of what is pressed: `fraction` of a sheet, which is `thickness` at any pressure if that was not
// measured.
struct CompressionCurve {
  Points compression;
  double thickness = 0;  // m
  double fraction = 1;
};
// All of them one on the other: at every pressure that was measured the sum of their thicknesses. Between
// points thickness is straight over the pressure's logarithm; beyond them it stays. Empty: none was measured.
Points pressed_together(const std::vector<CompressionCurve>& parts);

}  // namespace fabricsh::law
