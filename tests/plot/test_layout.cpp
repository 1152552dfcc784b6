// Nothing in a figure lies on another thing or is cut off, whatever is drawn.
#include <cmath>
#include <random>

#include "message_of.hpp"
#include "plot/layout.hpp"
#include "plot/text.hpp"

using namespace fabricsh;
using namespace fabricsh::plot;

namespace {

bool apart(const PageBox& a, const PageBox& b) {
  return a.right <= b.left || b.right <= a.left || a.top <= b.bottom || b.top <= a.bottom;
}

bool inside(const PageBox& a, const PageBox& all) {
  return a.left >= all.left && a.right <= all.right && a.bottom >= all.bottom && a.top <= all.top;
}

PlottedCurve random_curve(std::mt19937& random, int place) {
  std::uniform_real_distribution<double> unit(0, 1);
  PlottedCurve c;
  c.label = "curve number " + std::to_string(place);
  const double size = std::pow(10, 12 * unit(random) - 6), off = unit(random) < 0.5 ? 0 : size * unit(random);
  for (int i = 0; i < 20; ++i) {
    c.x.push_back(0.013 * i);
    c.y.push_back(off + size * (unit(random) - 0.2));
  }
  if (place % 3 == 1) {
    c.error.low = c.error.high = c.y;
    for (double& v : c.error.high) v += 0.1 * size;
  }
  return c;
}

Page random_page(std::mt19937& random, int number) {
  Page page;
  const int panels = 1 + number % 4;
  for (int i = 0; i < panels; ++i) {
    Figure f{i % 2 == 0 ? "" : "a title", {"strain, %"}, {"stress, MPa"}};
    const int curves = 1 + static_cast<int>(random() % 4);
    for (int k = 0; k < curves; ++k) f.curves.push_back(random_curve(random, k));
    f.key = number % 5 == 0 ? Key::below : number % 7 == 0 ? Key::right : Key::best;
    page.panels.push_back(f);
  }
  page.paper.font_size = 6 + number % 4;
  page.paper.width = 0.085 * std::min(panels, 2), page.paper.height = 0.07 * ((panels + 1) / 2);
  return page;
}

std::vector<std::string> texts(const Scale& s) {
  std::vector<std::string> all;
  for (const Tick& t : s.ticks)
    if (!t.text.empty()) all.push_back(t.text);
  return all;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("no word of a figure lies on another, on a frame or over the edge", "[plot]") {
  std::mt19937 random(1);
  for (int number = 0; number < 120; ++number) {
    const Page page = random_page(random, number);
    const PageLayout l = layout_of(page);
    CHECK(l.warnings.empty());
    const PageBox paper{0, 0, l.width, l.height};
    std::vector<std::pair<PageBox, std::string>> words;
    for (const PlacedPanel& p : l.panels) {
      CHECK(inside(p.frame, paper));
      for (const PlacedWord& word : p.words) words.push_back({box_of(word), word.text});
    }
    CAPTURE(number, page.panels.size(), page.paper.font_size);
    for (std::size_t i = 0; i < words.size(); ++i) {
      CAPTURE(words[i].second, words[i].first.left, words[i].first.right, words[i].first.bottom,
              words[i].first.top, l.width, l.height);
      CHECK(inside(words[i].first, paper));
      for (std::size_t k = 0; k < i; ++k) {
        CAPTURE(words[k].second, words[k].first.left, words[k].first.right, words[k].first.bottom,
                words[k].first.top);
        CHECK(apart(words[i].first, words[k].first));
      }
    }
    for (std::size_t i = 1; i < l.panels.size(); ++i) {
      CHECK_THAT(l.panels[i].frame.width(), Catch::Matchers::WithinRel(l.panels[0].frame.width(), 1e-9));
      CHECK(apart(l.panels[i].frame, l.panels[0].frame));
    }
  }
}

TEST_CASE("the key takes the first corner that no curve passes, else it stands below", "[plot]") {
  const auto key_of = [](const std::vector<double>& y, CurveStyle style = CurveStyle::line) {
    Page page;
    std::vector<double> x;
    for (std::size_t i = 0; i < y.size(); ++i) x.push_back(static_cast<double>(i));
    page.panels = {{"", {}, {}, {{"a curve", x, y, style}}}};
    const PlacedPanel p = layout_of(page).panels[0];
    const PageBox f = p.frame;
    const double middle_x = (f.left + f.right) / 2, middle_y = (f.bottom + f.top) / 2;
    if (p.key.top < f.bottom) return std::string("below");
    CHECK(inside(p.key, f));
    return std::string(p.key.bottom > middle_y ? "top" : "bottom") +
           (p.key.left < middle_x && p.key.right < f.right - 20 ? " left" : " right");
  };
  CHECK(key_of({0, 1, 2, 3}) == "top left");
  CHECK(key_of({3, 2, 1, 0}) == "top right");
  CHECK(key_of({0, 5, 5, 5, 5, 5, 5, 0}) == "below");
  CHECK(key_of({0, 5, 5, 5, 5, 4, 3}) == "bottom right");
  // A line from corner to corner is crossed in its middle as well, where it has no point of its own.
  CHECK(key_of({5, 0}) == "top right");
}

TEST_CASE("ticks stand at steps of 1, 2 or 5, with a common number of decimals", "[plot]") {
  const auto numbers = [](double low, double high, Axis axis = {}) {
    return texts(scale_of(axis, low, high, 150, 8, false));
  };
  CHECK(numbers(0, 0.12) == Texts{"0", "0.05", "0.10"});
  CHECK(numbers(-1, 1) == Texts{"−1.0", "−0.5", "0", "0.5", "1.0"});
  CHECK(numbers(0, 97) == Texts{"0", "20", "40", "60", "80", "100"});
  CHECK(numbers(2e6, 9e6) == Texts{"2×10⁶", "4×10⁶", "6×10⁶", "8×10⁶"});
  CHECK(numbers(5, 5).size() >= 3);
  CHECK(numbers(0, 0).size() >= 3);
  CHECK(numbers(2, 3000, {"", {}, {}, true}) == Texts{"1", "10", "100", "1000", "10000"});
  CHECK(numbers(1e-9, 1, {"", {}, {}, true}) == Texts{"10⁻⁸", "10⁻⁶", "10⁻⁴", "0.01", "1"});
  const Axis sources{"", {}, {}, false, {"warp", "weft", "shear"}};
  CHECK(numbers(1, 3, sources) == Texts{"warp", "weft", "shear"});
  CHECK(scale_of(sources, 1, 3, 150, 8, true).part(2) == 0.5);
  CHECK(numbers(1, 3, {"", 1.5, {}, false, sources.names}) == Texts{"weft", "shear"});
  // The ends that are fixed stay as they are; the others hold all points.
  const Scale fixed = scale_of({"", 0.013}, 0.02, 0.77, 150, 8, false);
  CHECK(fixed.low == 0.013);
  CHECK(fixed.high >= 0.77);
  const Scale tight = scale_of({}, -2e-5, 3e-5, 150, 8, true);
  CHECK(tight.low <= -2e-5);
  CHECK(tight.high >= 3e-5);
  // The rest of a rounding below zero moves no axis.
  CHECK(scale_of({}, -1e-6, 20, 150, 8, true).low == -1e-6);
  CHECK(message_of([&] { scale_of({}, -1.7e308, 1.7e308, 150, 8, false); }).find("on one axis") !=
        std::string::npos);
}

TEST_CASE("sizes: a column of a journal, two with panels, and what is too small", "[plot]") {
  const Figure line{"", {"x"}, {"y"}, {{"k", {0, 1}, {0, 1}}}};
  Page page;
  page.panels = {line};
  constexpr double points = 72 / 0.0254;
  CHECK_THAT(layout_of(page).width, Catch::Matchers::WithinRel(0.085 * points, 1e-12));
  CHECK_THAT(layout_of(page).height, Catch::Matchers::WithinRel(0.060 * points, 1e-12));
  page.panels = {line, line, line};
  CHECK_THAT(layout_of(page).width, Catch::Matchers::WithinRel(0.170 * points, 1e-12));
  CHECK_THAT(layout_of(page).height, Catch::Matchers::WithinRel(0.120 * points, 1e-12));
  page.rows = 1, page.columns = 2;
  CHECK(message_of([&] { layout_of(page); }) == "figure: 3 panels have no room in 1 x 2 places");
  page.panels = {line}, page.rows = page.columns = 0;
  page.paper.width = page.paper.height = 0.02, page.paper.font_size = 12;
  CHECK(message_of([&] {
          layout_of(page);
        }).find("20 x 20 mm have no room for axes and words of 12 points") != std::string::npos);
}

TEST_CASE("a label too long gets smaller letters, and a warning where 6 points do not do", "[plot]") {
  Page page;
  page.panels = {
      {"", {"a label as long as a line of print, and a little longer, MPa"}, {"y"}, {{"", {0, 1}, {0, 1}}}}};
  const auto size = [](const PageLayout& l) {
    for (const PlacedWord& word : l.panels[0].words)
      if (word.text.starts_with("a label")) return word.size;
    return 0.0;
  };
  PageLayout l = layout_of(page);
  CHECK(l.warnings.empty());
  CHECK(size(l) < 8);
  CHECK(size(l) >= 6);
  page.panels[0].x.label += page.panels[0].x.label;
  l = layout_of(page);
  REQUIRE(l.warnings.size() == 1);
  CHECK(l.warnings[0].find("is longer than its room of 85 mm") != std::string::npos);
}
