#include "contact/batch.hpp"

#include "simd/copies.hpp"

namespace fabricsh::contact {

FABRICSH_DECLARE_COPIES(BatchPress batch_press_of_isa();)

BatchPress batch_press(Isa isa) { return FABRICSH_COPY_FOR(isa, batch_press_of_isa)(); }

}  // namespace fabricsh::contact
