#include "simd/isa.hpp"

#include <cstdlib>
#include <cstring>

namespace fabricsh {

namespace {

Isa machine_isa() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
    return Isa::avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return Isa::avx2;
#endif
  return Isa::baseline;
}

}  // namespace

Isa best_isa() {
  static const Isa chosen = [] {
    const Isa machine = machine_isa();
    const char* wish = std::getenv("FABRICSH_ISA");
    if (wish == nullptr) return machine;
    for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512})
      if (std::strcmp(wish, name(isa)) == 0 && isa < machine) return isa;
    return machine;
  }();
  return chosen;
}

const char* name(Isa isa) {
  switch (isa) {
    case Isa::avx512:
      return "avx512";
    case Isa::avx2:
      return "avx2";
    default:
#if defined(__aarch64__)
      return "neon";  // what every such processor has; checkpoints of other processors are refused by this
                      // name
#else
      return "baseline";
#endif
  }
}

}  // namespace fabricsh
