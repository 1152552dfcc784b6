#include "contact/batch.hpp"

#include "simd/copies.hpp"

namespace fabricsh::contact {

FABRICSH_DECLARE_COPIES(BatchKernels batch_kernels_of_isa();)

BatchKernels batch_kernels(Isa isa) { return FABRICSH_COPY_FOR(isa, batch_kernels_of_isa)(); }

}  // namespace fabricsh::contact
