#include "element/shell3.hpp"

namespace fabricsh::element {

namespace baseline {
Shell4Kernels shell3_kernels_of_isa();
}
namespace avx2 {
Shell4Kernels shell3_kernels_of_isa();
}
namespace avx512 {
Shell4Kernels shell3_kernels_of_isa();
}

Shell4Kernels shell3_kernels(Isa isa) {
  switch (isa) {
    case Isa::avx512:
      return avx512::shell3_kernels_of_isa();
    case Isa::avx2:
      return avx2::shell3_kernels_of_isa();
    default:
      return baseline::shell3_kernels_of_isa();
  }
}

}  // namespace fabricsh::element
