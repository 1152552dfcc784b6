#include "fabric/text.hpp"

#include <cmath>
#include <cstdio>

namespace fabricsh::fabric {

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

std::string pressure(double pa) {
  const double size = std::fabs(pa);
  if (size >= 1e9) return number(pa / 1e9) + " GPa";
  if (size >= 1e4) return number(pa / 1e6) + " MPa";
  return number(pa) + " Pa";
}

std::string percent(double ratio) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100 * ratio);
  return text;
}

}  // namespace fabricsh::fabric
