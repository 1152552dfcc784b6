#include "run/place_text.hpp"

#include <cmath>

#include "base/number.hpp"

namespace fabricsh::run {

std::string place_text(const Vec3& v, const std::string& unit) {
  const auto digits = [](double x) { return number(std::abs(x) < 1e-9 ? 0.0 : x); };
  return "(" + digits(v.x()) + ", " + digits(v.y()) + ", " + digits(v.z()) + ")" + unit;
}

}  // namespace fabricsh::run
