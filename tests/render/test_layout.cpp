#include <random>
#include <set>

#include "catch.hpp"
#include "render/layout.hpp"

using namespace fabricsh::render;

namespace {

Space space_of(double width, double height, double letter) {
  return {width, height, letter, [letter](const std::string& text) {
            return Point{0.6 * letter * static_cast<double>(text.size()), letter};
          }};
}

bool apart(const Word& a, const Word& b) {
  for (std::size_t k = 0; k < 2; ++k)
    if (std::abs(a.centre[k] - b.centre[k]) >= (a.size[k] + b.size[k]) / 2) return true;
  return false;
}

bool inside(const Word& word, const Space& space) {
  const Point end{space.width, space.height};
  for (std::size_t k = 0; k < 2; ++k)
    if (word.centre[k] - word.size[k] / 2 < 0 || word.centre[k] + word.size[k] / 2 > end[k]) return false;
  return true;
}

std::set<std::string> texts(const ViewLayout& l) {
  std::set<std::string> all;
  for (const Word& word : l.words) all.insert(word.text);
  return all;
}

}  // namespace

TEST_CASE("no word of the axes lies on another or is cut off, from wherever the sheet is seen", "[render]") {
  std::mt19937 random(1);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 400; ++i) {
    Bounds bounds{};
    for (std::size_t k = 0; k < 3; ++k) {
      bounds[2 * k] = uniform(-1, 1) * std::pow(10, uniform(-2, 3));
      bounds[2 * k + 1] = bounds[2 * k] + std::pow(10, uniform(-1, 3));
    }
    if (i % 3 == 0) bounds[5] = bounds[4];
    const View view = i % 4 == 0 ? view_from(0, 90) : view_from(uniform(-180, 180), uniform(-90, 90));
    const Space space = space_of(uniform(250, 1200), uniform(250, 1200), uniform(10, 20));
    const ViewLayout l = layout(bounds, view, "mm", space);
    CAPTURE(i, space.width, space.height, space.letter, l.scale);
    CHECK(l.words.size() >= 2);
    for (std::size_t a = 0; a < l.words.size(); ++a) {
      CAPTURE(l.words[a].text);
      CHECK(inside(l.words[a], space));
      for (std::size_t b = 0; b < a; ++b) {
        CAPTURE(l.words[b].text);
        CHECK(apart(l.words[a], l.words[b]));
      }
    }
  }
}

TEST_CASE("a sheet from above fills its space, with round numbers along two axes", "[render]") {
  const Space space = space_of(400, 900, 16);
  const ViewLayout l = layout({0, 25.4, 0, 94.2, 0, 0}, view_from(0, 90), "mm", space);
  const auto words = texts(l);
  for (const char* wanted : {"0", "x, mm", "y, mm", "90"}) CHECK(words.count(wanted) == 1);
  CHECK(words.count("z, mm") == 0);
  CHECK(l.scale * 94.2 > 0.8 * space.height);
  // The sheet itself stands inside as well.
  CHECK(l.centre[0] - l.scale * 12.7 > 0);
  CHECK(l.centre[1] + l.scale * 47.1 < space.height);
}

TEST_CASE("a sheet seen from the side, without axes, fills its space", "[render]") {
  const ViewLayout l = layout({0, 2, 0, 1, 0, 0.5}, view_from(0, 0), "", space_of(400, 300, 10));
  CHECK(l.words.empty());
  CHECK(l.lines.empty());
  CHECK_THAT(2 * l.scale, Catch::Matchers::WithinRel(390.0, 1e-6));
}

TEST_CASE("a colour bar has round numbers that differ, however narrow its range", "[render]") {
  for (const auto& [low, high] : {std::pair{0.0725, 5.59},
                                  {0.4263, 0.4342},
                                  {1.0, 1.000002},
                                  {-1e-9, 3e-9},
                                  {-0.0182, 0.132},
                                  {123456.0, 123456.5},
                                  {2e7, 9e9},
                                  {0.95, 1.05}}) {
    CAPTURE(low, high);
    for (const bool fixed : {false, true}) {
      const Bar bar = round_bar(low, high, fixed, 6);
      CHECK(bar.low <= low);
      CHECK(bar.high >= high);
      REQUIRE(bar.numbers.size() >= 3);
      REQUIRE(bar.numbers.size() <= 8);
      const double step = bar.numbers[1].first - bar.numbers[0].first;
      const double digit = step / std::pow(10, std::floor(std::log10(step) + 1e-6));
      CHECK(std::min({std::abs(digit - 1), std::abs(digit - 2), std::abs(digit - 5)}) < 1e-6);
      for (std::size_t i = 0; i < bar.numbers.size(); ++i) {
        const auto& [value, text] = bar.numbers[i];
        CAPTURE(text);
        CHECK(std::abs(std::stod(text) - value) <= 1e-6 * step);
        CHECK(value >= bar.low - 1e-6 * step);
        CHECK(value <= bar.high + 1e-6 * step);
        if (i > 0) CHECK(text != bar.numbers[i - 1].second);
      }
      if (fixed) CHECK((bar.low == low && bar.high == high));
      if (!fixed) CHECK(std::abs(bar.numbers.front().first - bar.low) < 1e-6 * step);
    }
  }
  std::vector<std::string> words;
  for (const auto& [value, text] : round_bar(30.9, 35.4, false, 6).numbers) words.push_back(text);
  CHECK(words == std::vector<std::string>{"30", "31", "32", "33", "34", "35", "36"});
}

TEST_CASE("panels of one scale: none is drawn larger than asked", "[render]") {
  Space space = space_of(400, 300, 10);
  const double free = layout({0, 2, 0, 1, 0, 0.5}, view_from(0, 0), "mm", space).scale;
  space.most = 0.7 * free;
  CHECK_THAT(layout({0, 2, 0, 1, 0, 0.5}, view_from(0, 0), "mm", space).scale,
             Catch::Matchers::WithinRel(0.7 * free, 1e-6));
}
