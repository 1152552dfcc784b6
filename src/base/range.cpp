#include "base/range.hpp"

#include <cmath>

#include "base/number.hpp"

namespace fabricsh {

std::string range_words(const Range& r) {
  const bool low = std::isfinite(r.low), high = std::isfinite(r.high);
  if (low && high)
    return std::string(r.low_open ? " above " : " from ") + number(r.low) +
           (r.high_open ? " to below " : " to ") + number(r.high);
  if (low) return std::string(r.low_open ? " above " : " of at least ") + number(r.low);
  if (high) return std::string(r.high_open ? " below " : " of at most ") + number(r.high);
  return "";
}

std::string number_words(const Range& range, const std::string& unit, const std::string& noun) {
  const char* article = noun.front() == 'i' ? "an " : "a ";
  const std::string words = range.is_positive() ? "a positive " + noun : article + noun + range_words(range);
  return unit.empty() ? words : words + " in " + unit;
}

}  // namespace fabricsh
