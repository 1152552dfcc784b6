#include <cmath>

#include "base/ordered_sum.hpp"
#include "catch.hpp"

using namespace fabricsh;

// Whatever is summed side by side: each block of 1,024 terms in order, and then the blocks.
TEST_CASE("an ordered sum is that of its blocks in order, to the bit") {
  const auto term = [](std::size_t i) { return std::sin(double(i)) / (1 + double(i % 7)); };
  for (const std::size_t n :
       {0u, 1u, 1023u, 1024u, 1025u, 2600u, 3072u, 4095u, 4096u, 7300u, 12288u, 70000u}) {
    double whole = 0;
    for (std::size_t from = 0; from < n; from += 1024) {
      double block = 0;
      for (std::size_t i = from; i < std::min(n, from + 1024); ++i) block += term(i);
      whole += block;
    }
    INFO(n << " terms");
    CHECK(ordered_sum(n, term) == whole);
  }
}
