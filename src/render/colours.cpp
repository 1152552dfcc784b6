#include "render/colours.hpp"

#include "plot/colour_scale.hpp"

namespace fabricsh::render {

vtkSmartPointer<vtkLookupTable> colours(double low, double high) {
  constexpr int count = 256;
  const auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(count);
  table->SetTableRange(low, high);
  table->SetNanColor(0.72, 0.72, 0.72, 1);  // rigid bodies have no field
  for (int i = 0; i < count; ++i) {
    const double v = low + (i + 0.5) / count * (high - low);
    const auto c = plot::colour(v, low, high);
    table->SetTableValue(i, c[0], c[1], c[2], 1);
  }
  return table;
}

}  // namespace fabricsh::render
