// Kernels on the columns of supernodes: arrays column by column, whose leading dimensions are multiples of
// kRows and whose first entries are aligned.
#pragma once
#include "simd/isa.hpp"

namespace fabricsh::linear {

inline constexpr long kRows = 8, kColumns = 5;

struct DenseKernels {
  // c = a S b^T with m rows (up to kRows - 1 more are read and written), n columns (to a multiple of
  // kColumns) and k columns of a and b; sign: S. packed: n times k numbers, with n such a multiple.
  void (*product)(const double* a, long lda, const double* b, long ldb, const double* sign, long m, long n,
                  long k, double* c, long ldc, double* packed);
  // a = L S L^T for the first n rows of n columns, and the rows of L below them. False: a pivot is not larger
  // than `least` or not finite.
  bool (*factorise)(double* a, long lda, long rows, long n, double least, double* sign, double* packed);
  // x of n unknowns becomes L^-1 x, and below takes L x of the rows below them.
  void (*forward)(const double* a, long lda, long rows, long n, double* x, double* below);
  // x becomes L^-T (x - what `below` has through the rows below).
  void (*backward)(const double* a, long lda, long rows, long n, double* x, const double* below);
};

}  // namespace fabricsh::linear
