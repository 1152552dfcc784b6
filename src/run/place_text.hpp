// Places and directions in words.
#pragma once
#include <string>

#include "geometry/vec.hpp"

namespace fabricsh::run {

// "(0, 0.1, 0) m": a place, m, or with another unit a direction; what is below 1e-9 is rounding and shown as
// 0.
std::string place_text(const Vec3& v, const std::string& unit = " m");

}  // namespace fabricsh::run
