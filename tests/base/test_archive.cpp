#include "base/archive.hpp"
#include "catch.hpp"

using namespace fabricsh;

namespace {

struct Part {
  int n = 0;
  std::optional<double> x;
  void keep(Archive& archive) { archive(n, x); }
  bool operator==(const Part&) const = default;
};

struct Whole {
  bool flag = false;
  std::string text;
  std::vector<double> numbers;
  std::vector<Part> parts;
  std::vector<std::string> words;
  void keep(Archive& archive) { archive(flag, text, numbers, parts, words); }
  bool operator==(const Whole&) const = default;
};

const Whole sample{true, std::string("a\0b", 3), {1, -0.0, 1e-310}, {{1, {}}, {2, 0.5}}, {"", "x"}};

}  // namespace

TEST_CASE("an archive gives back what was put in") {
  Whole whole = sample;
  Archive out;
  out(whole);
  CHECK(!out.reading());
  Archive in(out.bytes());
  Whole back{false, "old", {9}, {{9, 9}}, {"old"}};
  in(back);
  CHECK(in.at_end());
  CHECK(back == sample);
}

TEST_CASE("an archive cut short or with a count beyond its end is an error, whatever the place") {
  Whole whole = sample;
  Archive out;
  out(whole);
  for (std::size_t n = 0; n < out.bytes().size(); ++n) {
    Archive in(out.bytes().substr(0, n));
    Whole back;
    CHECK_THROWS_AS(in(back), Error);
  }
  std::uint64_t many = std::uint64_t(1) << 61;
  Archive counts;
  counts(many);
  for (int k = 0; k < 2; ++k) {
    Archive in(counts.bytes());
    std::vector<double> numbers;
    std::vector<std::string> words;
    if (k == 0)
      CHECK_THROWS_AS(in(numbers), Error);
    else
      CHECK_THROWS_AS(in(words), Error);
  }
}

TEST_CASE("numbers whose count is known take no other") {
  std::vector<double> three{1, 2, 3}, two{0, 0};
  Archive out;
  out.filled(three);
  Archive in(out.bytes());
  CHECK_THROWS_AS(in.filled(two), Error);
  CHECK(two[0] == 0);
}
