#include "app/environment.hpp"

#include <dlfcn.h>
#include <malloc.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

#include "simd/isa.hpp"

namespace fabricsh::app {

namespace {

// Better kernels for OpenBLAS than those it would choose; null: its own choice is good, or the BLAS is
// another one.
const char* better_kernels() {
  using CoreName = char* (*)();
  const auto name = reinterpret_cast<CoreName>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  if (name == nullptr || std::strcmp(name(), "Prescott") != 0) return nullptr;
  const Isa isa = best_isa();
  return isa == Isa::avx512 ? "SkylakeX" : isa == Isa::avx2 ? "Haswell" : nullptr;
}

}  // namespace

std::string environment_error() {
  const char* wish = std::getenv("FABRICSH_ISA");
  if (wish == nullptr || *wish == 0 || std::strcmp(wish, name(best_isa())) == 0) return {};
  std::string known;
  for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512})
    if (isa <= best_isa()) known += (known.empty() ? "" : ", ") + std::string(name(isa));
  return "FABRICSH_ISA: expected one that this machine has (" + known + "), got '" + wish + "'";
}

// Factorisations allocate and free megabytes in each iteration. By default the C library returns them to the
// system each time, and the pages come back one by one, a quarter of the time of a small implicit run.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int mapped_apart = 4 << 20, kept = 16 << 20;  // bytes
  mallopt(M_MMAP_THRESHOLD, mapped_apart);
  mallopt(M_TRIM_THRESHOLD, kept);
#endif
}

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
