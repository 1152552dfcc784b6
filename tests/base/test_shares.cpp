// Loops in shares of threads, and without: all indices once, the same largest term, and no parallel region
// where there is nothing to share.
#include <omp.h>

#include <vector>

#include "base/shares.hpp"
#include "catch.hpp"

using namespace fabricsh;

TEST_CASE("a loop has all of its indices once, with and without shares") {
  const int before = omp_get_max_threads();
  for (const int threads : {1, 3}) {
    omp_set_num_threads(threads);
    for (const bool worth : {false, true}) {
      std::vector<int> seen(1000, 0), level(1000, 0);
      for_each_index(seen.size(), worth, [&](std::size_t i) {
        ++seen[i];
        level[i] = omp_get_level();
      });
      CHECK(seen == std::vector<int>(1000, 1));
      // A region of a single thread would count, too.
      CHECK(level == std::vector<int>(1000, worth && threads > 1 ? 1 : 0));
      CHECK(largest_of(1000, worth, [](int i) { return i == 700 ? 3.0 : i == 20 ? 2.0 : -1.0; }) == 3.0);
      CHECK(largest_of(1000, worth, [](int) { return -1.0; }) == 0.0);
    }
  }
  omp_set_num_threads(before);
}
