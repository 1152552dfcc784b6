// Sums that are the same bit for bit for any number of threads: blocks of fixed size are added in order.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "base/shares.hpp"

namespace fabricsh {

inline constexpr std::size_t ordered_block = 1024;

// The sums of so many blocks from term `from` on, side by side, since each addition of a block has to wait
// for the one before. A few terms of each are computed beforehand, which needs no order.
template <std::size_t blocks, class Term>
void sum_side_by_side(std::size_t from, Term& term, double* part) {
  constexpr std::size_t few = 64;
  std::array<double, blocks> sum{};
  std::array<std::array<double, few>, blocks> terms;
  for (std::size_t i = from; i < from + ordered_block; i += few) {
    for (std::size_t k = 0; k < blocks; ++k)
      for (std::size_t j = 0; j < few; ++j) terms[k][j] = term(i + j + k * ordered_block);
    for (std::size_t j = 0; j < few; ++j)
      for (std::size_t k = 0; k < blocks; ++k) sum[k] += terms[k][j];
  }
  std::copy(sum.begin(), sum.end(), part);
}

// term(i): of the i-th term, in any order.
template <class Term>
double ordered_sum(std::size_t n, Term term) {
  constexpr std::size_t side_by_side = 4, group = ordered_block * side_by_side;
  const std::size_t blocks = (n + ordered_block - 1) / ordered_block, groups = n / group;
  std::vector<double> part(blocks, 0);
  for_each_index(groups, blocks >= 16, [&](std::size_t g) {
    sum_side_by_side<side_by_side>(g * group, term, part.data() + g * side_by_side);
  });
  double* const rest = part.data() + groups * side_by_side;
  const std::size_t whole = (n - groups * group) / ordered_block;
  if (whole == 3) sum_side_by_side<3>(groups * group, term, rest);
  if (whole == 2) sum_side_by_side<2>(groups * group, term, rest);
  if (whole == 1) sum_side_by_side<1>(groups * group, term, rest);
  double last = 0;
  for (std::size_t i = groups * group + whole * ordered_block; i < n; ++i) last += term(i);
  if (groups * side_by_side + whole < blocks) part.back() = last;
  double sum = 0;
  for (const double p : part) sum += p;
  return sum;
}

}  // namespace fabricsh
