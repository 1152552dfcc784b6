#include <cstdlib>
#include <limits>

#include "message_of.hpp"
#include "plot/figure.hpp"
#include "plot/gnuplot.hpp"
#include "scratch.hpp"

using namespace fabricsh;
using namespace fabricsh::plot;
using Names = std::set<std::string>;

namespace {

const std::vector<Curve> two_curves = {{"it's a_b {x}", {0, 1, 2}, {0, 1, 4}},
                                       {"second\nline", {0, 2}, {0, 2}, CurveStyle::dashed}};

struct Path {
  explicit Path(const char* value) : before(std::getenv("PATH")) { setenv("PATH", value, 1); }
  ~Path() { setenv("PATH", before.c_str(), 1); }
  std::string before;
};

}  // namespace

TEST_CASE("a figure in each format, text taken as it is", "[files]") {
  const ScratchFolder folder;
  draw(folder / "out/a.svg", {"S over E", {"E"}, {"S, MPa"}, two_curves});
  draw(folder / "out/a.png", {"t", {"x"}, {"y"}, two_curves});
  draw(folder / "out/a.pdf", {"t", {"x"}, {"y"}, two_curves});
  CHECK(folder.listing() == Names{"out", "out/a.pdf", "out/a.png", "out/a.svg"});
  const std::string svg = content_of(folder / "out/a.svg");
  CHECK(svg.find("<svg") != std::string::npos);
  CHECK(svg.find("</svg>") != std::string::npos);
  CHECK(svg.find("S, MPa") != std::string::npos);
  CHECK(svg.find("a_b {x}") != std::string::npos);
  CHECK(svg.find("second line") != std::string::npos);
  CHECK(content_of(folder / "out/a.png").starts_with("\x89PNG"));
  CHECK(content_of(folder / "out/a.pdf").starts_with("%PDF"));
}

TEST_CASE("all styles, and a value that is not finite", "[files]") {
  const ScratchFolder folder;
  const double gap = std::numeric_limits<double>::quiet_NaN();
  std::vector<Curve> curves;
  for (const CurveStyle style :
       {CurveStyle::line, CurveStyle::dashed, CurveStyle::points, CurveStyle::line_points})
    curves.push_back({"", {0, 1, 2, 3}, {0, gap, 1, 2}, style});
  draw(folder / "a.svg", {"", {""}, {""}, curves});
  CHECK(content_of(folder / "a.svg").find("</svg>") != std::string::npos);
}

TEST_CASE("a figure that cannot be says why and leaves the old one", "[files]") {
  const ScratchFolder folder;
  std::ofstream(folder / "a.svg") << "old";
  says(message_of([&] {
         draw(folder / "a.gif", {"", {""}, {""}, two_curves});
       }),
       "ends in .svg, .pdf, .eps or .png");
  says(message_of([&] { draw(folder / "a.svg", {"", {""}, {""}, {}}); }), "at least one curve");
  says(message_of([&] { draw(folder / "a.svg", {"", {""}, {""}, {{"k", {1, 2}, {1}}}}); }), "curve 'k'");
  says(message_of([&] {
         draw(folder / "a.svg", {"", {""}, {""}, {{"k", {}, {}}}});
       }),
       "figure: curve 'k': nothing to draw: none of its 0 points is finite");
  const double gap = std::numeric_limits<double>::quiet_NaN();
  says(message_of([&] {
         draw(folder / "a.svg", {"", {""}, {""}, {{"k", {1, 2}, {gap, gap}}}});
       }),
       "curve 'k': nothing to draw: none of its 2 points is finite");
  says(message_of([&] {
         draw(folder / "a.svg", {"", {""}, {"", {}, {}, true}, {{"k", {1, 2}, {0, -1}}}});
       }),
       "none of its 2 points is finite and positive on the logarithmic axis");
  says(message_of([&] {
         draw(folder / "a.svg", {"", {"", 0, 2, true}, {""}, two_curves});
       }),
       "a logarithmic axis has no room for zero and below, got a range of x from 0 to 2");
  says(message_of([&] {
         draw(folder / "a.svg", {"", {"", 5, 6}, {""}, two_curves});
       }),
       "no point of any curve lies inside the range asked for");
  says(message_of([&] { draw(folder / "a.svg/b.svg", {"", {""}, {""}, two_curves}); }), "Not a directory");
  CHECK(content_of(folder / "a.svg") == "old");
  CHECK(folder.listing() == Names{"a.svg"});
}

TEST_CASE("what a logarithmic axis cannot show is counted", "[files]") {
  const ScratchFolder folder;
  const double gap = std::numeric_limits<double>::quiet_NaN();
  Figure f{"", {""}, {"", {}, {}, true}, {{"k", {0, 1, 2, 3}, {-1, 0, gap, 5}}, {"", {1, 2}, {1, 2}}}};
  f.curves[1].error = {{0.5, -1}, {2, 3}};
  const auto words = draw(folder / "a.svg", f);
  REQUIRE(words.size() == 2);
  CHECK(
      words[0] ==
      "curve 'k': 2 of 4 y are zero or below, for which a logarithmic axis has no place; they are not drawn");
  CHECK(words[1].starts_with("curve 2: 1 of 4 ends of error bars are zero or below"));
  f.y.logarithmic = false;
  CHECK(draw(folder / "a.svg", f).empty());
  f.x.logarithmic = true;
  CHECK(draw(folder / "a.svg", f).at(0).starts_with("curve 'k': 1 of 4 x are zero or below"));
}

TEST_CASE("axes: ranges, logarithms; letters for a terminal", "[files]") {
  const ScratchFolder folder;
  const Figure figure{
      "a law", {"strain, %", 0.5, 20}, {"stress", {}, {}, true}, {{"S", {1, 2, 10}, {1, 10, 100}}}};
  draw(folder / "a.svg", figure);
  CHECK(content_of(folder / "a.svg").find("100") != std::string::npos);
  const std::string text = drawn_in_letters(figure, 60, 20);
  INFO(text);
  for (const char* word : {"a law", "strain, %", "stress", "100", "S"})
    CHECK(text.find(word) != std::string::npos);
  std::size_t width = 0, lines = 1, at = 0;
  for (const char c : text) {
    at = c == '\n' ? 0 : at + 1;
    lines += c == '\n' ? 1 : 0;
    width = std::max(width, at);
  }
  CHECK(width <= 60);
  CHECK(lines <= 20);
}

TEST_CASE("without gnuplot the figure says what to install", "[files]") {
  const ScratchFolder folder;
  const Path path(folder.path.c_str());
  says(message_of([&] {
         draw(folder / "a.svg", {"", {""}, {""}, two_curves});
       }),
       "apt-get install gnuplot-nox");
  CHECK(folder.listing().empty());
}

TEST_CASE("gnuplot's reason comes through, without its script and the place in it", "[files]") {
  CHECK(message_of([] { run_gnuplot("plot no_such_function(x)\n"); }) ==
        "figure: gnuplot failed: undefined function: no_such_function");
  CHECK(message_of([] { run_gnuplot("set output\n"); }) == "figure: gnuplot drew nothing: it gave no reason");
}
