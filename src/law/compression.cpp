#include "law/compression.hpp"

#include <algorithm>
#include <cmath>

namespace fabricsh::law {

namespace {

double thickness_at(const CompressionCurve& part, double pressure) {
  const Points& c = part.compression;
  if (c.empty()) return part.fraction * part.thickness;
  if (pressure >= c.front().second) return part.fraction * c.front().first;
  if (pressure <= c.back().second) return part.fraction * c.back().first;
  std::size_t i = 1;
  while (c[i].second > pressure) ++i;
  const double along = std::log(c[i - 1].second / pressure) / std::log(c[i - 1].second / c[i].second);
  return part.fraction * (c[i - 1].first + along * (c[i].first - c[i - 1].first));
}

}  // namespace

Points pressed_together(const std::vector<CompressionCurve>& parts) {
  std::vector<double> pressures;
  for (const CompressionCurve& part : parts)
    for (const auto& point : part.compression) pressures.push_back(point.second);
  std::sort(pressures.rbegin(), pressures.rend());
  Points out;
  for (const double pressure : pressures) {
    double gap = 0;
    for (const CompressionCurve& part : parts) gap += thickness_at(part, pressure);
    if (out.empty() || (gap > out.back().first && pressure < out.back().second))
      out.emplace_back(gap, pressure);
  }
  return out.size() < 2 ? Points() : out;
}

}  // namespace fabricsh::law
