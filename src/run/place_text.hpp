// Positions and directions as text.
#pragma once
#include <string>

#include "geometry/vec.hpp"

namespace fabricsh::run {

// "(0, 0.1, 0) m": a position in m; with another unit a direction. Numbers below 1e-9 are rounding errors and
// shown as 0.
std::string place_text(const Vec3& v, const std::string& unit = " m");

}  // namespace fabricsh::run
