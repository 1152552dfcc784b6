// Numbers beside each other at a place for each lane, as packs: transposed loads and stores.
#pragma once
#include "simd/pack.hpp"

namespace fabricsh {
inline namespace FABRICSH_ISA {

// Four numbers beside each other at a place for each lane: column i has number i of each.
#if defined(__AVX512F__)
inline void load_rows(const double* const* from, Pack* column) {
  const auto two = [&](int i) {
    return _mm512_maskz_insertf64x4(0xff, _mm512_castpd256_pd512(_mm256_loadu_pd(from[i])),
                                    _mm256_loadu_pd(from[i + 4]), 1);
  };
  const __m512d a = two(0), b = two(1), c = two(2), d = two(3);
  const __m512i near = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13),
                far = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  const __m512d even = _mm512_maskz_unpacklo_pd(0xff, a, b), odd = _mm512_maskz_unpackhi_pd(0xff, a, b),
                even2 = _mm512_maskz_unpacklo_pd(0xff, c, d), odd2 = _mm512_maskz_unpackhi_pd(0xff, c, d);
  column[0] = Pack(_mm512_permutex2var_pd(even, near, even2));
  column[1] = Pack(_mm512_permutex2var_pd(odd, near, odd2));
  column[2] = Pack(_mm512_permutex2var_pd(even, far, even2));
  column[3] = Pack(_mm512_permutex2var_pd(odd, far, odd2));
}
inline void store_rows(double* const* to, const Pack* column) {
  const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11),
                high = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
  const auto two = [&](int i, __m512d rows) {
    _mm256_storeu_pd(to[i], _mm512_maskz_extractf64x4_pd(0xf, rows, 0));
    _mm256_storeu_pd(to[i + 2], _mm512_maskz_extractf64x4_pd(0xf, rows, 1));
  };
  const __m512d even = _mm512_maskz_unpacklo_pd(0xff, column[0].v, column[1].v),
                even2 = _mm512_maskz_unpacklo_pd(0xff, column[2].v, column[3].v),
                odd = _mm512_maskz_unpackhi_pd(0xff, column[0].v, column[1].v),
                odd2 = _mm512_maskz_unpackhi_pd(0xff, column[2].v, column[3].v);
  two(0, _mm512_permutex2var_pd(even, low, even2));
  two(1, _mm512_permutex2var_pd(odd, low, odd2));
  two(4, _mm512_permutex2var_pd(even, high, even2));
  two(5, _mm512_permutex2var_pd(odd, high, odd2));
}
#elif defined(__AVX2__)
inline void turn_rows(const __m256d* from, __m256d* to) {
  const __m256d a = _mm256_unpacklo_pd(from[0], from[1]), b = _mm256_unpackhi_pd(from[0], from[1]),
                c = _mm256_unpacklo_pd(from[2], from[3]), d = _mm256_unpackhi_pd(from[2], from[3]);
  to[0] = _mm256_permute2f128_pd(a, c, 0x20);
  to[1] = _mm256_permute2f128_pd(b, d, 0x20);
  to[2] = _mm256_permute2f128_pd(a, c, 0x31);
  to[3] = _mm256_permute2f128_pd(b, d, 0x31);
}
inline void load_rows(const double* const* from, Pack* column) {
  __m256d rows[4], turned[4];
  for (int i = 0; i < 4; ++i) rows[i] = _mm256_loadu_pd(from[i]);
  turn_rows(rows, turned);
  for (int i = 0; i < 4; ++i) column[i] = Pack(turned[i]);
}
inline void store_rows(double* const* to, const Pack* column) {
  __m256d rows[4], turned[4];
  for (int i = 0; i < 4; ++i) rows[i] = column[i].v;
  turn_rows(rows, turned);
  for (int i = 0; i < 4; ++i) _mm256_storeu_pd(to[i], turned[i]);
}
#else
inline void load_rows(const double* const* from, Pack* column) {
  for (int i = 0; i < 4; ++i)
    for (int lane = 0; lane < pack_width; ++lane) column[i].set(lane, from[lane][i]);
}
inline void store_rows(double* const* to, const Pack* column) {
  for (int i = 0; i < 4; ++i)
    for (int lane = 0; lane < pack_width; ++lane) to[lane][i] = column[i][lane];
}
#endif

}  // namespace FABRICSH_ISA
}  // namespace fabricsh
