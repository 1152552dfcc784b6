#include "files/libraries.hpp"

#include <vtkVersion.h>

namespace fabricsh::files {

std::vector<Library> libraries() { return {{"VTK", vtkVersion::GetVTKVersion()}}; }

}  // namespace fabricsh::files
