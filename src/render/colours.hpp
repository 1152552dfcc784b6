// Colour scales that remain distinguishable in grey print and for most colour-blind readers.
#pragma once
#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

namespace fabricsh::render {

// Dark violet to yellow; or blue, white at zero, and red if the range includes both signs.
vtkSmartPointer<vtkLookupTable> colours(double low, double high);

}  // namespace fabricsh::render
