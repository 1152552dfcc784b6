#include <cstdlib>
#include <functional>
#include <limits>
#include <sstream>

#include "base/number.hpp"
#include "message_of.hpp"
#include "plot/figure.hpp"
#include "plot/gnuplot.hpp"
#include "plot/layout.hpp"
#include "plot/script.hpp"
#include "scratch.hpp"

using namespace fabricsh;
using namespace fabricsh::plot;
using Names = std::set<std::string>;

namespace {

const std::vector<PlottedCurve> two_curves = {{"it's a_b {x}", {0, 1, 2}, {0, 1, 4}},
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
  std::vector<PlottedCurve> curves;
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

TEST_CASE("points that a logarithmic axis cannot show are counted", "[files]") {
  const ScratchFolder folder;
  const double gap = std::numeric_limits<double>::quiet_NaN();
  Figure f{"", {""}, {"", {}, {}, true}, {{"k", {0, 1, 2, 3}, {-1, 0, gap, 5}}, {"", {1, 2}, {1, 2}}}};
  f.curves[1].error = {{0.5, -1}, {2, 3}};
  const auto words = draw(folder / "a.svg", f);
  REQUIRE(words.size() == 2);
  CHECK(
      words[0] ==
      "curve 'k': 2 of 4 y are zero or below, for which a logarithmic axis has no place; such points are not "
      "drawn");
  CHECK(
      words[1] ==
      "curve 2: 1 of 4 ends of error bars are zero or below, for which a logarithmic axis has no place; what "
      "reaches there is drawn to the frame's edge");
  f.y.logarithmic = false;
  CHECK(draw(folder / "a.svg", f).empty());
  f.x.logarithmic = true;
  CHECK(draw(folder / "a.svg", f).at(0).starts_with("curve 'k': 1 of 4 x are zero or below"));
}

namespace {

// The lines of data of a block in the script that gnuplot gets; none: there is no such block.
std::vector<std::string> block_of(const Figure& f, const std::string& name) {
  Page page;
  page.panels = {f};
  const PageLayout layout = layout_of(page);
  std::istringstream script(script_of(page, layout, layout.width, layout.height, false));
  std::vector<std::string> out;
  bool inside = false;
  for (std::string line; std::getline(script, line);) {
    if (line == "END_OF_CURVE") inside = false;
    if (inside) out.push_back(line);
    if (line == name + " << END_OF_CURVE") inside = true;
  }
  return out;
}
using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE(
    "bands and error bars that reach zero begin at the frame's edge, whether they end at zero or below it") {
  Figure f{"", {"", 0, 4}, {"", 0.01, 100, true}, {{"", {1, 2, 3}, {1, 1, 1}}}};
  f.curves[0].band = {{0, -1, 0.5}, {2, 2, 2}};
  CHECK(block_of(f, "$band0") == Lines{"1 0.01 2", "2 0.01 2", "3 0.5 2"});
  f.curves[0].band = {{0, -2, 0.5}, {2, -1, 2}};  // all of the second lies below
  CHECK(block_of(f, "$band0") == Lines{"1 0.01 2", "", "3 0.5 2"});
  CHECK(block_of(f, "$lone_band0") == Lines{"1 0.01", "1 2", "", "3 0.5", "3 2", ""});
  f.curves[0].band = {{0, 0, 0},
                      {0.01, 0.001, 2}};  // ends at the frame's edge and below it: the band goes on
  CHECK(block_of(f, "$band0") == Lines{"1 0.01 0.01", "2 0.001 0.001", "3 0.01 2"});
  f.curves[0].error = {{0, -1, -2}, {2, 2, -1}};
  const Lines bars = block_of(f, "$error0");
  REQUIRE(bars.size() == 12);  // two bars, each with the cap above alone
  CHECK(Lines(bars.begin(), bars.begin() + 2) == Lines{"1 0.01", "1 2"});
  CHECK(Lines(bars.begin() + 6, bars.begin() + 8) == Lines{"2 0.01", "2 2"});
  f.curves[0].error = {{0.5, 0.5, 0.5}, {2, 2, 2}};
  CHECK(block_of(f, "$error0").size() == 27);  // three bars, each with both caps
  Figure across{"", {"", 0.01, 100, true}, {"", 0, 2}, {{"", {1, 2}, {1, 1}, CurveStyle::points}}};
  across.curves[0].x_error = {{0, -1}, {3, 3}};
  const Lines level = block_of(across, "$across0");
  REQUIRE(level.size() == 12);
  CHECK(Lines(level.begin(), level.begin() + 2) == Lines{"0.01 1", "3 1"});
  CHECK(Lines(level.begin() + 6, level.begin() + 8) == Lines{"0.01 1", "3 1"});
}

TEST_CASE("a point of a line to which no line leads is drawn as a dot", "[files]") {
  const double gap = std::numeric_limits<double>::quiet_NaN();
  Figure f{"", {"", 0, 10}, {"", 0.1, 10, true}, {{"", {1, 2, 3, 4, 5, 6}, {1, gap, 2, 3, -1, 4}}}};
  CHECK(block_of(f, "$curve0") == Lines{"1 1", "", "3 2", "4 3", "", "6 4"});
  CHECK(block_of(f, "$lone0") == Lines{"1 1", "", "", "", "", "6 4"});
  f.curves[0].style = CurveStyle::line_points;
  CHECK(block_of(f, "$lone0").empty());
  f.curves = {{"", {1, 2}, {1, 2}}};
  CHECK(block_of(f, "$lone0").empty());
  const Figure one{"", {"", 0, 2}, {"", 0, 2}, {{"", {1}, {1}}}};
  CHECK(block_of(one, "$lone0") == Lines{"1 1"});
  CHECK(drawn_in_letters(one, 40, 12).find('o') != std::string::npos);
  const ScratchFolder folder;
  draw(folder / "one.svg", one);
  CHECK(content_of(folder / "one.svg").find("<use") != std::string::npos);
}

TEST_CASE("values beyond those of a logarithmic axis are named, and gnuplot is not asked", "[files]") {
  const ScratchFolder folder;
  for (const double tiny : {1e-308, 5e-324}) {
    const Figure f{"", {""}, {"", {}, {}, true}, {{"k", {1, 2, 3}, {tiny, 1, 1}}}};
    for (const auto& drawn : {std::function<void()>([&] { draw(folder / "a.svg", f); }),
                              std::function<void()>([&] { drawn_in_letters(f, 60, 20); })})
      says(message_of(drawn), "figure: a logarithmic axis has room for values from 1e-290 to 1e+290, got " +
                                  number(tiny) + " to 1; give a range of the axis");
  }
  Figure large{"", {""}, {"", {}, {}, true}, {{"k", {1, 2, 3}, {1, 1, 1e308}}}};
  says(message_of([&] { draw(folder / "a.svg", large); }), "got 1 to 1e+308");
  large.y.high = 100;
  draw(folder / "a.svg", large);
  CHECK(folder.listing() == Names{"a.svg"});
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
