#include "render/colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fabricsh::render {

namespace {

using Colour = std::array<double, 3>;
// viridis (S. van der Walt, N. Smith, public domain) and
// the red-blue scale of ColorBrewer, at equal intervals.
const std::vector<Colour> rising = {{68, 1, 84},    {72, 40, 120},  {62, 74, 137},  {49, 104, 142},
                                    {38, 130, 142}, {31, 158, 137}, {53, 183, 121}, {109, 205, 89},
                                    {180, 222, 44}, {253, 231, 37}};
const std::vector<Colour> signed_scale = {{5, 48, 97},     {33, 102, 172},  {67, 147, 195},  {146, 197, 222},
                                          {209, 229, 240}, {247, 247, 247}, {253, 219, 199}, {244, 165, 130},
                                          {214, 96, 77},   {178, 24, 43},   {103, 0, 31}};

Colour at(const std::vector<Colour>& scale, double t) {
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(scale.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), scale.size() - 2);
  const double s = place - static_cast<double>(i);
  Colour c{};
  for (std::size_t k = 0; k < 3; ++k) c[k] = ((1 - s) * scale[i][k] + s * scale[i + 1][k]) / 255;
  return c;
}

}  // namespace

vtkSmartPointer<vtkLookupTable> colours(double low, double high) {
  constexpr int count = 256;
  const auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(count);
  table->SetTableRange(low, high);
  table->SetNanColor(0.72, 0.72, 0.72, 1);  // rigid bodies have no field
  const double largest = std::max(std::abs(low), std::abs(high));
  const bool both = low < -0.02 * largest && high > 0.02 * largest;
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count, v = low + t * (high - low);
    const Colour c = both ? at(signed_scale, (v / largest + 1) / 2) : at(rising, t);
    table->SetTableValue(i, c[0], c[1], c[2], 1);
  }
  return table;
}

}  // namespace fabricsh::render
