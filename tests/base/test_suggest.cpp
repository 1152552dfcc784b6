#include <string>
#include <vector>

#include "base/suggest.hpp"
#include "catch.hpp"

using namespace fabricsh;

TEST_CASE("edit distance counts single edits and swaps", "[base]") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("abc", "") == 3);
  CHECK(edit_distance("", "ab") == 2);
  CHECK(edit_distance("left", "left") == 0);
  CHECK(edit_distance("Left", "lefT") == 0);
  CHECK(edit_distance("lft", "left") == 1);
  CHECK(edit_distance("heigth", "height") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
}

TEST_CASE("nearest name, or none", "[base]") {
  const std::vector<std::string> names = {"left", "right", "bottom", "top", "boundary", "corners", "all"};
  CHECK(nearest("lft", names) == "left");
  CHECK(nearest("Right", names) == "right");
  CHECK(nearest("botom", names) == "bottom");
  CHECK(nearest("corner", names) == "corners");
  CHECK(nearest("al", names) == "all");
  CHECK(nearest("seam", names).empty());
  CHECK(nearest("", names).empty());
  CHECK(nearest("x", std::vector<std::string>{"y", "z"}).empty());
  CHECK(nearest("width", std::vector<std::string>{}).empty());
  CHECK(nearest("heigth", std::vector<std::string>{"width", "height"}) == "height");
}

TEST_CASE("the question behind an unknown name", "[base]") {
  const std::vector<std::string> names = {"left", "right"};
  CHECK(did_you_mean("lft", names) == ", did you mean 'left'?");
  CHECK(did_you_mean("seam", names).empty());
}
