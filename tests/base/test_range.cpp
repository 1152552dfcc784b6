#include "base/range.hpp"
#include "catch.hpp"

using namespace fabricsh;

TEST_CASE("the words of a range", "[base][number]") {
  CHECK(number_words(positive, "m") == "a positive number in m");
  CHECK(number_words(not_negative, "") == "a number of at least 0");
  CHECK(number_words(Range{1, 9}, "", "integer") == "an integer from 1 to 9");
  CHECK(number_words(Range{-1, 10, true, false}, "") == "a number above -1 to 10");
  CHECK(number_words(Range{0, 1, true, true}, "") == "a number above 0 to below 1");
  CHECK(number_words(everything, "Pa") == "a number in Pa");
}
