// Colour scales that grey print and most colour-blind readers keep apart.
#pragma once
#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

namespace fabricsh::render {

// From low to high: from dark violet to yellow, or blue, white at zero, red where the range has both signs.
vtkSmartPointer<vtkLookupTable> colours(double low, double high);

}  // namespace fabricsh::render
