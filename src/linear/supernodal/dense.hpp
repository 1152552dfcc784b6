// Kernels on the columns of supernodes: arrays column by column, whose leading dimensions are multiples of
// kRows and whose first entries are aligned.
#pragma once
#include "simd/isa.hpp"

namespace fabricsh::linear {

inline constexpr long kRows = 8, kColumns = 5;

struct DenseKernels {
  // c = a S b^T with m rows (up to kRows - 1 more are read and written), n columns (to a multiple of
  // kColumns) and k columns of a and b, of which kRows more rows are read; sign: S. packed: kColumns times k
  // numbers and kRows more.
  void (*product)(const double* a, long lda, const double* b, long ldb, const double* sign, long m, long n,
                  long k, double* c, long ldc, double* packed);
  // a = L S L^T in columns `first` to n of the first `rows` rows, given the columns before. False: a pivot is
  // not larger than `least` of its column, or not finite.
  bool (*factorise)(double* a, long lda, long rows, long first, long n, const double* least, double* sign,
                    double* packed);
  // The same columns of L in rows `from` (a multiple of kRows, at least n) to `rows`, after factorise().
  void (*extend)(double* a, long lda, long from, long rows, long first, long n, const double* sign,
                 double* packed);
  // x of n unknowns becomes L^-1 x, and below takes L x of the rows below them.
  void (*forward)(const double* a, long lda, long rows, long n, double* x, double* below);
  // x becomes L^-T (x - what `below` has through the rows below).
  void (*backward)(const double* a, long lda, long rows, long n, double* x, const double* below);
};

}  // namespace fabricsh::linear
