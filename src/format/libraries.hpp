// What files are read and written with.
#pragma once
#include <vector>

#include "base/version.hpp"

namespace fabricsh::format {

std::vector<Library> libraries();  // VTK

}  // namespace fabricsh::format
