// Sums whose bits do not depend on the number of threads: blocks of fixed size are added in order.
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace fabricsh {

template <class Term>
double ordered_sum(std::size_t n, Term term) {
  constexpr std::size_t block = 1024;
  const std::size_t blocks = (n + block - 1) / block;
  std::vector<double> part(blocks, 0);
#pragma omp parallel for schedule(static) if (blocks >= 16)
  for (std::size_t b = 0; b < blocks; ++b) {
    double sum = 0;
    for (std::size_t i = b * block; i < std::min(n, (b + 1) * block); ++i) sum += term(i);
    part[b] = sum;
  }
  double sum = 0;
  for (const double p : part) sum += p;
  return sum;
}

}  // namespace fabricsh
