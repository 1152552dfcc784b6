// Instruction sets of the batch kernels. Every header with code that is compiled in a *_isa.cpp file puts it
// into the namespace FABRICSH_ISA, so that the linker never merges copies made with different compiler flags.
#pragma once

#ifndef FABRICSH_ISA
#define FABRICSH_ISA baseline
#endif

namespace fabricsh {

enum class Isa { baseline, avx2, avx512 };

// The widest instruction set that this machine and this build support. The environment
// variable FABRICSH_ISA=baseline|avx2|avx512 can lower it, never raise it.
Isa best_isa();
const char* name(Isa isa);

// Size of one batch: the elements or material points evaluated side by side, the same on every machine.
inline constexpr int lanes = 8;

}  // namespace fabricsh
