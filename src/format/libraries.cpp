#include "format/libraries.hpp"

#include <vtkVersion.h>

namespace fabricsh::format {

std::vector<Library> libraries() { return {{"VTK", vtkVersion::GetVTKVersion()}}; }

}  // namespace fabricsh::format
