// The law for one part of a batch (see simd/pack.hpp), for the batch kernels of other rooms.
#pragma once
#include "law/law.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

// Like BatchFunction, for the pack_width lanes at which the pointers start; bit i of the result: lane i.
BatchFunction part_for(const Law& law);

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
