// 100,000 random closed loops per card: ctest -L long, or test_law "[long]". About a quarter of an hour.
#include "catch.hpp"
#include "law/loops.hpp"

using namespace fabricsh::test;

TEST_CASE("100,000 closed loops per card never make energy", "[long][energy]") {
  for (int f = 0; f < 4; ++f) potential_loops(f, 100000);
}

TEST_CASE("100,000 closed loops of the comparison laws per card", "[long][energy]") {
  comparison_loops(100000);
}
