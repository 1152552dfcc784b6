#include "app/environment.hpp"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

#include "base/isa.hpp"

namespace fabricsh::app {

namespace {

// Name of the kernels that OpenBLAS should rather take; null: its own choice is good, or another BLAS is
// there.
const char* better_kernels() {
  using CoreName = char* (*)();
  const auto name = reinterpret_cast<CoreName>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  if (name == nullptr || std::strcmp(name(), "Prescott") != 0) return nullptr;
  const Isa isa = best_isa();
  return isa == Isa::avx512 ? "SkylakeX" : isa == Isa::avx2 ? "Haswell" : nullptr;
}

}  // namespace

void settle_environment(char** words) {
  bool anew = false;
  const auto set = [&](const char* name, const char* value) {
    if (value == nullptr || std::getenv(name) != nullptr) return;
    anew = setenv(name, value, 0) == 0 || anew;
  };
  if (std::getenv("OMP_WAIT_POLICY") == nullptr) set("GOMP_SPINCOUNT", "5000");
  set("OPENBLAS_CORETYPE", better_kernels());
  if (anew) execv("/proc/self/exe", words);
}

}  // namespace fabricsh::app
