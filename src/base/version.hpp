// What this program is: the version that CMakeLists.txt states.
#pragma once
#include <string>

namespace fabricsh {

// A library as it was found at run time, or where it cannot be asked, when compiled.
struct Library {
  std::string name, version;
};

std::string version();     // "0.1.0"
std::string build_kind();  // "Release", "Debug", ...: how it was compiled
std::string compiler();    // "GNU 12.2.0"

}  // namespace fabricsh
