// Instruction sets of the batch kernels. Every header with code that a *_isa.cpp file compiles puts it into
// namespace FABRICSH_ISA, so that the copies made with different compiler flags never meet at link time.
#pragma once

#ifndef FABRICSH_ISA
#define FABRICSH_ISA baseline
#endif

namespace fabricsh {

enum class Isa { baseline, avx2, avx512 };

// The widest set that this machine and build can run; FABRICSH_ISA=baseline|avx2|avx512 in the environment
// lowers it (never raises it).
Isa best_isa();
const char* name(Isa isa);

// Lanes of one batch: elements or material points that are evaluated side by side, on every machine alike.
inline constexpr int lanes = 8;

}  // namespace fabricsh
