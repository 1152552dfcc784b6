#include "card/compression.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"

namespace fabricsh::card {

namespace {

using Points = std::vector<std::pair<double, double>>;

std::string words(const std::pair<double, double>& point) {
  return "{" + number(point.first) + ", " + number(point.second) + "}";
}

}  // namespace

std::string compression_fault(const Points& given) {
  if (given.size() < 2)
    return "expected at least two points {gap, pressure}, got " + std::to_string(given.size());
  Points points = given;
  std::sort(points.begin(), points.end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [gap, pressure] = points[i];
    if (!(gap > 0) || !std::isfinite(gap) || !(pressure > 0) || !std::isfinite(pressure))
      return "expected positive gaps in m and pressures in Pa, got " + words(points[i]);
    if (i > 0 && (!(gap > points[i - 1].first) || !(pressure < points[i - 1].second)))
      return "expected a pressure that falls as the gap grows, got " + words(points[i - 1]) + " and " +
             words(points[i]);
  }
  return {};
}

}  // namespace fabricsh::card
