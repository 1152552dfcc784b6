// Cloth that is pressed flat: measured points of thickness (m, ascending) and pressure (Pa).
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace fabricsh::card {

// The fault of points in either order: "expected ..., got ..."; empty: none.
std::string compression_fault(const std::vector<std::pair<double, double>>& points);

}  // namespace fabricsh::card
