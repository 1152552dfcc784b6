#include "lab/photographs.hpp"

#include <dlfcn.h>

#include "base/error.hpp"
#include "base/version.hpp"
#include "system/paths.hpp"

namespace fabricsh::lab {

namespace {

// Stays loaded until the process ends, since it holds the classes of what it has made.
const Photographs& loaded() {
  const std::string file = module_file("photographs.so");
  if (file.empty())
    throw Error(
        "photographs are a part that is not installed (Debian package fabricsh-photographs, or build with "
        "-DFABRICSH_PHOTOGRAPHS=ON)");
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw Error(std::string("photographs: cannot load the part: ") + dlerror());
  using Of = const Photographs* (*)(const char* version);
  const auto of = reinterpret_cast<Of>(dlsym(library, "fabricsh_photographs"));
  const Photographs* const part = of == nullptr ? nullptr : of(version().c_str());
  if (part == nullptr) throw Error("photographs: '" + file + "' is not of version " + version());
  return *part;
}

}  // namespace

const Photographs& photographs() {
  static const Photographs& part = loaded();  // after an error the next call tries again
  return part;
}

}  // namespace fabricsh::lab
