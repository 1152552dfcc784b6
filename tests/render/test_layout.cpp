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

std::set<std::string> texts(const Layout& l) {
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
    const Layout l = layout(bounds, view, "mm", space);
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
  const Layout l = layout({0, 25.4, 0, 94.2, 0, 0}, view_from(0, 90), "mm", space);
  const auto words = texts(l);
  for (const char* wanted : {"0", "x, mm", "y, mm", "90"}) CHECK(words.count(wanted) == 1);
  CHECK(words.count("z, mm") == 0);
  CHECK(l.scale * 94.2 > 0.8 * space.height);
  // The sheet itself stands inside as well.
  CHECK(l.centre[0] - l.scale * 12.7 > 0);
  CHECK(l.centre[1] + l.scale * 47.1 < space.height);
}

TEST_CASE("a sheet seen from the side, without axes, fills its space", "[render]") {
  const Layout l = layout({0, 2, 0, 1, 0, 0.5}, view_from(0, 0), "", space_of(400, 300, 10));
  CHECK(l.words.empty());
  CHECK(l.lines.empty());
  CHECK_THAT(2 * l.scale, Catch::Matchers::WithinRel(390.0, 1e-6));
}

TEST_CASE("labels of a colour bar differ, however narrow its range", "[render]") {
  for (const auto& [low, high] : {std::pair{0.0725, 5.59},
                                  {0.4263, 0.4342},
                                  {1.0, 1.000002},
                                  {-1e-9, 3e-9},
                                  {-0.0182, 0.132},
                                  {123456.0, 123456.5},
                                  {0.95, 1.05}}) {
    CAPTURE(low, high);
    const auto labels = even_labels(low, high, 6);
    REQUIRE(labels.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) {
      CAPTURE(labels[i]);
      const double at = low + (high - low) * static_cast<double>(i) / 5;
      CHECK(std::abs(std::stod(labels[i]) - at) <= 0.1 * (high - low) / 5);
      if (i > 0) CHECK(std::stod(labels[i]) > std::stod(labels[i - 1]));
    }
  }
  CHECK(even_labels(-1, 1, 3) == std::vector<std::string>{"-1", "0", "1"});
}
