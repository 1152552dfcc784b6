#include "law/text.hpp"

#include <cmath>

#include "base/number.hpp"

namespace fabricsh::law {

std::string number(double x) { return fabricsh::number(x, 4); }

std::string pressure(double pa) {
  const double size = std::fabs(pa);
  if (size >= 1e9) return number(pa / 1e9) + " GPa";
  if (size >= 1e4) return number(pa / 1e6) + " MPa";
  return number(pa) + " Pa";
}

std::string percent(double ratio) { return fabricsh::number(100 * ratio, 3) + " %"; }

}  // namespace fabricsh::law
