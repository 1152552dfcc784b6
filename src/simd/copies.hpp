// Choosing among the copies of a function that a file *_isa.cpp defines, one per instruction set.
// FABRICSH_DECLARE_COPIES(declaration;) declares them in their namespaces, FABRICSH_COPY_FOR(isa, function)
// is the address of one. Other processors than x86-64 have the baseline alone.
#pragma once

#include "simd/isa.hpp"

#define FABRICSH_DECLARE_COPIES(...) \
  namespace avx2 {                   \
  __VA_ARGS__                        \
  }                                  \
  namespace avx512 {                 \
  __VA_ARGS__                        \
  }                                  \
  inline namespace baseline {        \
  __VA_ARGS__                        \
  }
#if defined(__x86_64__)
#define FABRICSH_COPY_FOR(isa, function) \
  ((isa) == Isa::avx512 ? &avx512::function : (isa) == Isa::avx2 ? &avx2::function : &baseline::function)
#else
#define FABRICSH_COPY_FOR(isa, function) (static_cast<void>(isa), &baseline::function)
#endif
