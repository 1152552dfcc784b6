#include "linear/supernodal/dense.hpp"
#include "simd/pack.hpp"

namespace fabricsh::linear {
inline namespace FABRICSH_ISA {
namespace {

constexpr long w = pack_width;
constexpr long kPacks = pack_width == 8 ? 4 : 2;  // of rows at once; with the columns they fill the registers
constexpr long kPanel = 2 * kColumns;

// Rows of c, over w: a S b^T, or c less it.
template <long packs, bool subtract>
void strip(const double* a, long lda, const double* packed, long k, double* c, long ldc, long columns) {
  Pack sum[packs][kColumns];
  for (long p = 0; p < packs; ++p)
    for (long j = 0; j < kColumns; ++j) sum[p][j] = Pack(0.0);
  for (long l = 0; l < k; ++l, a += lda, packed += kColumns) {
    Pack column[packs];
    for (long p = 0; p < packs; ++p) column[p] = load(a + p * w);
    for (long j = 0; j < kColumns; ++j) {
      const Pack b(packed[j]);
      for (long p = 0; p < packs; ++p) sum[p][j] += column[p] * b;
    }
  }
  for (long j = 0; j < kColumns; ++j) {
    if (subtract && j >= columns) break;
    for (long p = 0; p < packs; ++p) {
      double* const to = c + j * ldc + p * w;
      store(to, subtract ? load(to) - sum[p][j] : sum[p][j]);
    }
  }
}

template <bool subtract>
void multiply(const double* a, long lda, const double* b, long ldb, const double* sign, long m, long n,
              long k, double* c, long ldc, double* packed) {
  for (long j = 0; j < n; j += kColumns) {
    const long columns = n - j < kColumns ? n - j : kColumns;
    for (long l = 0; l < k; ++l)  // what is stored beyond five numbers is overwritten by the next
      for (long i = 0; i < kColumns; i += w)
        store(packed + l * kColumns + i, load(b + l * ldb + j + i) * Pack(sign[l]));
    double* const to = c + j * ldc;
    long i = 0;
    for (; i + kPacks * w <= m; i += kPacks * w)
      strip<kPacks, subtract>(a + i, lda, packed, k, to + i, ldc, columns);
    for (; i + 2 * w <= m; i += 2 * w) strip<2, subtract>(a + i, lda, packed, k, to + i, ldc, columns);
    for (; i < m; i += w) strip<1, subtract>(a + i, lda, packed, k, to + i, ldc, columns);
  }
}

void product(const double* a, long lda, const double* b, long ldb, const double* sign, long m, long n, long k,
             double* c, long ldc, double* packed) {
  multiply<false>(a, lda, b, ldb, sign, m, n, k, c, ldc, packed);
}

// y -= x s from the pack with row `from` on.
inline void subtract_from(long from, long rows, const double* x, double s, double* y) {
  const Pack factor(s);
  for (long i = from / w * w; i < rows; i += w) store(y + i, load(y + i) - load(x + i) * factor);
}

// Columns j to end of the rows from `from` on, once column j of them and row j to end of it are known.
inline void finish_column(double* a, long lda, long j, long end, long from, long rows, Pack over,
                          const double* sign) {
  double* const x = a + j * lda;
  for (long i = from / w * w; i < rows; i += w) store(x + i, load(x + i) * over);
  for (long l = j + 1; l < end; ++l) subtract_from(from > l ? from : l, rows, x, sign[j] * x[l], a + l * lda);
}

bool factorise(double* a, long lda, long rows, long first, long n, const double* least, double* sign,
               double* packed) {
  for (long p = first; p < n; p += kPanel) {
    const long end = p + kPanel < n ? p + kPanel : n, from = p / kRows * kRows;
    if (p > 0)
      multiply<true>(a + from, lda, a + p, lda, sign, rows - from, end - p, p, a + p * lda + from, lda,
                     packed);
    for (long j = p; j < end; ++j) {
      const double pivot = a[j * lda + j];
      if (!(abs(pivot) > least[j]) || !(abs(pivot) < 1e300)) return false;
      sign[j] = pivot < 0 ? -1 : 1;
      finish_column(a, lda, j, end, j, rows, Pack(sign[j] / sqrt(abs(pivot))), sign);
    }
  }
  return true;
}

void extend(double* a, long lda, long from, long rows, long first, long n, const double* sign,
            double* packed) {
  for (long p = first; p < n; p += kPanel) {
    const long end = p + kPanel < n ? p + kPanel : n;
    if (p > 0)
      multiply<true>(a + from, lda, a + p, lda, sign, rows - from, end - p, p, a + p * lda + from, lda,
                     packed);
    for (long j = p; j < end; ++j)
      finish_column(a, lda, j, end, from, rows, Pack(sign[j] / a[j * lda + j]), sign);
  }
}

void forward(const double* a, long lda, long rows, long n, double* x, double* below) {
  for (long j = 0; j < n; ++j) {
    const double* const column = a + j * lda;
    x[j] /= column[j];
    for (long i = j + 1; i < n; ++i) x[i] -= column[i] * x[j];
  }
  for (long i = n; i < rows; i += w) {
    Pack sum(0.0);
    for (long j = 0; j < n; ++j) sum += load(a + j * lda + i) * Pack(x[j]);
    store(below + i - n, sum);
  }
}

// x less the products of so many columns of a with `below`.
template <long columns>
void take_below(const double* a, long lda, long rows, const double* below, double* x) {
  Pack sum[columns];
  for (long j = 0; j < columns; ++j) sum[j] = Pack(0.0);
  long i = 0;
  for (; i + w <= rows; i += w) {
    const Pack b = load(below + i);
    for (long j = 0; j < columns; ++j) sum[j] += load(a + j * lda + i) * b;
  }
  for (long j = 0; j < columns; ++j) {
    for (int l = 0; l < pack_width; ++l) x[j] -= sum[j][l];
    for (long r = i; r < rows; ++r) x[j] -= a[j * lda + r] * below[r];
  }
}

void backward(const double* a, long lda, long rows, long n, double* x, const double* below) {
  long j = 0;
  for (; j + kColumns <= n; j += kColumns) take_below<kColumns>(a + j * lda + n, lda, rows - n, below, x + j);
  for (; j < n; ++j) take_below<1>(a + j * lda + n, lda, rows - n, below, x + j);
  for (j = n - 1; j >= 0; --j) {
    const double* const column = a + j * lda;
    take_below<1>(column + j + 1, lda, n - j - 1, x + j + 1, x + j);
    x[j] /= column[j];
  }
}

}  // namespace

DenseKernels dense_kernels_of_isa() { return {product, factorise, extend, forward, backward}; }

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::linear
