#include "element/shell4.hpp"

namespace fabricsh::element {

namespace baseline {
Shell4Kernels shell4_kernels_of_isa();
}
namespace avx2 {
Shell4Kernels shell4_kernels_of_isa();
}
namespace avx512 {
Shell4Kernels shell4_kernels_of_isa();
}

Shell4Kernels shell4_kernels(Isa isa) {
  switch (isa) {
    case Isa::avx512:
      return avx512::shell4_kernels_of_isa();
    case Isa::avx2:
      return avx2::shell4_kernels_of_isa();
    default:
      return baseline::shell4_kernels_of_isa();
  }
}

}  // namespace fabricsh::element
