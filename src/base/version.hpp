// The version of this program, as stated in CMakeLists.txt, and how it was built.
#pragma once
#include <string>

namespace fabricsh {

// A library and its version: that found at run time if the library provides it, else that compiled against.
struct Library {
  std::string name, version;
};

std::string version();     // "0.2.0"
std::string build_kind();  // "Release", "Debug", ...: how it was compiled
std::string compiler();    // "GNU 12.2.0"

}  // namespace fabricsh
