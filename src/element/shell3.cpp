#include "element/shell3.hpp"

#include "simd/copies.hpp"

namespace fabricsh::element {

FABRICSH_DECLARE_COPIES(Shell4Kernels shell3_kernels_of_isa();)

Shell4Kernels shell3_kernels(Isa isa) { return FABRICSH_COPY_FOR(isa, shell3_kernels_of_isa)(); }

}  // namespace fabricsh::element
