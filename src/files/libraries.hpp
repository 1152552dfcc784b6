// What files are read and written with.
#pragma once
#include <vector>

#include "base/version.hpp"

namespace fabricsh::files {

std::vector<Library> libraries();  // VTK

}  // namespace fabricsh::files
