// A picture's description survives the way to the program that draws it.
#include <sstream>

#include "catch.hpp"
#include "message_of.hpp"
#include "plot/picture.hpp"
#include "scratch.hpp"

using namespace fabricsh::plot;
using fabricsh::message_of;

namespace {

Picture sample() {
  Picture p;
  p.png = "/tmp/a b/c.png";
  p.panels = {{"x 1.vtu", "(a) 0 s, 20 %", 30, -12.5}, {"y.vtu", ""}};
  p.title = "Blend, \"warp\" \\ #1";
  p.array = "S", p.component = "S11", p.bar = "S11, MPa", p.factor = 1e-6;
  p.fixed_range = true, p.low = -1.0 / 3, p.high = 2e9;
  p.smooth = true, p.dpi = 300, p.font_size = 7.5, p.width = 640, p.height = 480, p.edges = false,
  p.columns = 2;
  return p;
}

}  // namespace

TEST_CASE("a picture reads back as it was written") {
  const Picture p = sample();
  std::istringstream text(picture_text(p));
  const Picture q = read_picture(text);
  CHECK(picture_text(q) == picture_text(p));
  CHECK(q.panels.size() == 2);
  CHECK(q.panels[0].vtu == "x 1.vtu");
  CHECK(q.panels[0].label == "(a) 0 s, 20 %");
  CHECK(q.panels[0].elevation == -12.5);
  CHECK(q.panels[1].elevation == 90);
  CHECK(q.smooth);
  CHECK(q.title == p.title);
  CHECK(q.low == p.low);
  CHECK(q.fixed_range);
  CHECK(q.axes);
  CHECK(!q.edges);
}

TEST_CASE("a line end in a title stays inside it") {
  Picture p = sample();
  p.title = "one\npng /etc/two";
  std::istringstream text(picture_text(p));
  const Picture q = read_picture(text);
  CHECK(q.png == p.png);
  CHECK(q.title == "one png /etc/two");
}

TEST_CASE("a file that is not a picture is refused with its line") {
  for (const std::string bad : {"colour blue", "width wide", "label before its panel"}) {
    std::istringstream text(bad + "\n");
    CHECK(message_of([&] { read_picture(text); }).find(bad) != std::string::npos);
  }
}

TEST_CASE("a missing drawing program is named") {
  Picture p = sample();
  const fabricsh::ScratchFolder folder;
  p.png = folder / "picture.png";
  CHECK(message_of([&] { render(p, "/no/such/fabricsh-render"); }).find("/no/such/fabricsh-render") !=
        std::string::npos);
}
