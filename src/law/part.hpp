// The law on one part of a batch (see simd/pack.hpp), for the batch kernels of other rooms.
#pragma once
#include "law/law.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

// As BatchFunction, for the pack_width lanes that the pointers begin at; bit i of the answer: lane i of them.
BatchFunction part_for(const Law& law);

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
