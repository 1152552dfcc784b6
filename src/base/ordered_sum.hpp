// Sums that are the same bit for bit for any number of threads: blocks of fixed size are added in order.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace fabricsh {

// term(i): of the i-th term, in any order. Four blocks are summed side by side, since each addition of a
// block has to wait for the one before.
template <class Term>
double ordered_sum(std::size_t n, Term term) {
  constexpr std::size_t block = 1024, side_by_side = 4, group = block * side_by_side;
  const std::size_t blocks = (n + block - 1) / block, groups = n / group;
  std::vector<double> part(blocks, 0);
#pragma omp parallel for schedule(static) if (blocks >= 16)
  for (std::size_t g = 0; g < groups; ++g) {
    std::array<double, side_by_side> sum{};
    for (std::size_t i = g * group; i < g * group + block; ++i)
      for (std::size_t k = 0; k < side_by_side; ++k) sum[k] += term(i + k * block);
    std::copy(sum.begin(), sum.end(), part.begin() + static_cast<std::ptrdiff_t>(g * side_by_side));
  }
  for (std::size_t i = groups * group; i < n; ++i) part[i / block] += term(i);
  double sum = 0;
  for (const double p : part) sum += p;
  return sum;
}

}  // namespace fabricsh
