// The libraries by which files are read and written.
#pragma once
#include <vector>

#include "base/version.hpp"

namespace fabricsh::format {

std::vector<Library> libraries();  // VTK

}  // namespace fabricsh::format
