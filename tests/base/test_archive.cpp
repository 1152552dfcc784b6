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

namespace {

struct Motion {
  std::vector<double> v;
  int steps = 0;
  void keep(Archive& archive) {
    archive.section("motion", [&] { archive(v, steps); });
  }
};
struct MotionWithMore {
  std::vector<double> v;
  int steps = 0;
  bool told = false;
  void keep(Archive& archive) {
    archive.section("motion", [&] { archive(v, steps, told); });
  }
};
struct MotionInAnotherOrder {
  std::vector<double> v;
  int steps = 0;
  void keep(Archive& archive) {
    archive.section("motion", [&] { archive(steps, v); });
  }
};
struct Renamed {
  std::vector<double> v;
  int steps = 0;
  void keep(Archive& archive) {
    archive.section("movement", [&] { archive(v, steps); });
  }
};
struct Listed {
  std::vector<Part> parts;
  std::optional<Part> one;
  void keep(Archive& archive) {
    archive.section("list", [&] { archive(parts, one); });
  }
};
struct ListedText {  // as Listed where the lists are empty, but for what is in them
  std::vector<std::string> parts;
  std::optional<Part> one;
  void keep(Archive& archive) {
    archive.section("list", [&] { archive(parts, one); });
  }
};

template <class T>
std::string written(T value) {
  Archive archive;
  archive(value);
  return archive.bytes();
}
template <class T>
T taken(const std::string& bytes) {
  Archive archive(bytes);
  T value;
  archive(value);
  CHECK(archive.at_end());
  return value;
}

}  // namespace

TEST_CASE("a section of other members is refused by its name, and nothing of it is taken up") {
  const std::string bytes = written(Motion{{1, 2, 3}, 7});
  const Motion back = taken<Motion>(bytes);
  CHECK(back.v == std::vector<double>{1, 2, 3});
  CHECK(back.steps == 7);
  const std::string other = "its part 'motion' was written by a build in which that part has other members";
  CHECK_THROWS_WITH(taken<MotionWithMore>(bytes), other);
  CHECK_THROWS_WITH(taken<MotionInAnotherOrder>(bytes), other);
  CHECK_THROWS_WITH(taken<Motion>(written(MotionWithMore{{1, 2, 3}, 7, true})), other);
  CHECK_THROWS_WITH(taken<Renamed>(bytes), "it has 'motion' where 'movement' is expected");
  Motion kept{{5}, 1};
  Archive archive(written(MotionWithMore{{1, 2, 3}, 7, true}));
  CHECK_THROWS_AS(archive(kept), Error);
  CHECK(kept.steps == 1);
}

TEST_CASE(
    "what a section's list holds is known where the list is empty, and does not hang on how long it is") {
  const std::string none = written(Listed{});
  CHECK_THROWS_WITH(taken<ListedText>(none),
                    "its part 'list' was written by a build in which that part has other members");
  Listed some;
  some.parts.resize(3);
  some.one.emplace();
  const Listed back = taken<Listed>(written(some));
  CHECK(back.parts.size() == 3);
  CHECK(back.one.has_value());
  CHECK_FALSE(taken<Listed>(none).one.has_value());
}
