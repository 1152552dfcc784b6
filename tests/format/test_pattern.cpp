// Patterns in DXF files: places, units, curves, notches, grain, and what is missing or wrong.
#include <cmath>

#include "format/pattern.hpp"
#include "mesh/check.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::format;
using Catch::Detail::Approx;
using mesh::Vec2;

namespace {

std::string pair(int code, const std::string& value) { return std::to_string(code) + "\n" + value + "\n"; }
std::string at(double x, double y) { return pair(10, std::to_string(x)) + pair(20, std::to_string(y)); }
std::string point(const std::string& layer, double x, double y) {
  return pair(0, "POINT") + pair(8, layer) + at(x, y);
}
std::string line(const std::string& layer, const Vec2& a, const Vec2& b) {
  return pair(0, "LINE") + pair(8, layer) + at(a.x(), a.y()) + pair(11, std::to_string(b.x())) +
         pair(21, std::to_string(b.y()));
}
std::string text(const std::string& words) {
  return pair(0, "TEXT") + pair(8, "1") + at(0, 0) + pair(40, "1") + pair(1, words);
}
std::string polyline(const std::string& layer, const std::vector<Vec2>& points, bool closed = true,
                     double bulge = 0) {
  std::string out = pair(0, "POLYLINE") + pair(8, layer) + pair(66, "1") + pair(70, closed ? "1" : "0");
  for (const Vec2& x : points)
    out += pair(0, "VERTEX") + pair(8, layer) + at(x.x(), x.y()) +
           (bulge != 0 ? pair(42, std::to_string(bulge)) : "");
  return out + pair(0, "SEQEND") + pair(8, layer);
}
std::string block(const std::string& name, const std::string& inside) {
  return pair(0, "BLOCK") + pair(8, "1") + pair(2, name) + pair(70, "64") + at(0, 0) + inside +
         pair(0, "ENDBLK") + pair(8, "1");
}
std::string file(const std::string& blocks, const std::string& header = "",
                 const std::string& entities = "") {
  const auto section = [](const std::string& name, const std::string& inside) {
    return pair(0, "SECTION") + pair(2, name) + inside + pair(0, "ENDSEC");
  };
  return section("HEADER", header) + section("BLOCKS", blocks) + section("ENTITIES", entities) +
         pair(0, "EOF");
}
std::string units(int code) { return pair(9, "$INSUNITS") + pair(70, std::to_string(code)); }

// A trapezoid of 310 x 220 with an armhole in its right side, in the units of the file.
const std::vector<Vec2> front{{0, 0}, {310, 0}, {290, 90}, {285, 140}, {240, 220}, {50, 220}};
std::string piece(const std::string& more = "") {
  return text("Piece Name: FRONT") + polyline("1", front) + point("3", 290, 90) + point("3", 285, 140) +
         line("7", {100, 50}, {100, 180}) + more;
}

mesh::Mesh meshed(PatternPiece& found, double size) {
  found.panel.size = size;
  return mesh::panel(found.panel);
}

std::string refused(const std::string& bytes, std::optional<double> unit = {}) {
  return message_of([&] { parse_dxf_pattern("f.dxf", bytes, unit, nullptr); });
}

}  // namespace

TEST_CASE("a pattern: its piece, unit, grain, curve, edges, notches and cutouts", "[format][pattern]") {
  Remarks remarks;
  const std::string more =
      point("4", 155, 0.7) + point("82", 0, 500) + polyline("8", {{1, 1}, {9, 9}}, false) +
      polyline("11", {{100, 100}, {160, 100}, {160, 140}, {100, 140}}) + point("77", 3, 3);
  auto pieces = parse_dxf_pattern("f.dxf", file(block("FRONT-38", piece(more)), units(4)), {}, &remarks);
  REQUIRE(pieces.size() == 1);
  CHECK(remarks.empty());
  PatternPiece& found = pieces[0];
  CHECK(found.name == "FRONT");
  CHECK(found.has_grain);
  CHECK(found.panel.grain == Approx(90));
  REQUIRE(found.panel.outline.size() == 4);
  CHECK(found.panel.holes.size() == 1);
  // The spline passes through the points of the curve.
  for (const Vec2& x : {front[1], front[2], front[3], front[4]}) {
    double least = 1;
    for (const auto& side : found.panel.outline)
      least = std::min(least, (side.curve.at(side.curve.nearest(1e-3 * x)) - 1e-3 * x).norm());
    CHECK(least < 1e-12);
  }
  REQUIRE(found.panel.notches.size() == 1);  // the other is off the boundary
  CHECK((*found.panel.notches[0].point - Vec2(0.155, 0)).norm() < 1e-15);
  REQUIRE(found.remarks.size() == 2);
  says(found.remarks[0], "f.dxf: piece 'FRONT': notch2 at (0, 0.5) m is left out, 0.284");
  says(found.remarks[1], "layers that are not used: '77', '8' (inner lines)");
  const mesh::Mesh mesh = meshed(found, 0.01);
  CHECK(mesh::check(mesh).ok());
  for (const char* set : {"edge1", "edge2", "edge3", "edge4", "notch1"}) CHECK(!mesh.set(set).empty());
  CHECK((mesh.nodes[mesh.set("notch1")[0]] - Vec3(0.155, 0, 0)).norm() < 1e-15);
}

TEST_CASE("units: of the header, of a text, of the call; straight pieces keep their area",
          "[format][pattern]") {
  const std::vector<Vec2> points{{0, 0}, {30, 0}, {26, 20}, {3, 20}};
  const double drawn = 0.5 * (30 + 23) * 20;
  const auto area = [&](const std::string& bytes, std::optional<double> unit, Remarks* remarks = nullptr) {
    auto pieces = parse_dxf_pattern("f.dxf", bytes, unit, remarks);
    return mesh::check(meshed(pieces.at(0), 0.01 * std::sqrt(pieces[0].panel.outline[0].curve.length())))
        .measures.area;
  };
  const std::string plain = block("A", polyline("1", points));
  CHECK(area(file(plain, units(4)), {}) == Approx(drawn * 1e-6));
  CHECK(area(file(plain, units(5)), {}) == Approx(drawn * 1e-4));
  CHECK(area(file(plain, units(1)), {}) == Approx(drawn * 0.0254 * 0.0254));
  CHECK(area(file(plain, "", text("UNITS: ENGLISH")), {}) == Approx(drawn * 0.0254 * 0.0254));
  CHECK(area(file(block("A", polyline("1", points) + text("Units: Metric"))), {}) == Approx(drawn * 1e-6));
  CHECK(area(file(plain), 0.01) == Approx(drawn * 1e-4));
  Remarks remarks;
  CHECK(area(file(plain, units(4)), 0.0254, &remarks) == Approx(drawn * 0.0254 * 0.0254));
  REQUIRE(remarks.size() == 1);
  CHECK(remarks[0] == "f.dxf: its unit is 0.001 m by its own words, and taken as 0.0254 m");
  CHECK(refused(file(plain)) ==
        "f.dxf: its lengths have no unit: expected unit= (1*mm if one in the file is a millimetre)");
  // Without blocks; a first vertex that comes again; no grain line.
  auto open = parse_dxf_pattern(
      "f.dxf", file("", "", polyline("1", {{0, 0}, {30, 0}, {0, 40}, {0, 0}}, false)), 1e-3, nullptr);
  CHECK_FALSE(open.at(0).has_grain);
  CHECK(mesh::check(meshed(open[0], 0.004)).measures.area == Approx(600e-6));
}

TEST_CASE("bulges are arcs: a round piece", "[format][pattern]") {
  // Four quarters of a circle of 100: the bulge is tan(90/4).
  const double bulge = std::sqrt(2) - 1;
  auto round = parse_dxf_pattern(
      "f.dxf",
      file(block("R", polyline("1", {{100, 0}, {0, 100}, {-100, 0}, {0, -100}}, true, bulge) +
                          pair(0, "CIRCLE") + pair(8, "11") + at(10, 20) + pair(40, "30"))),
      1e-3, nullptr);
  REQUIRE(round.at(0).panel.outline.size() == 4);
  for (const auto& side : round[0].panel.outline) {
    CHECK(side.curve.length() == Approx(0.05 * std::acos(-1)).epsilon(1e-6));  // six digits in the file
    CHECK(side.edge == "edge1");
  }
  REQUIRE(round[0].panel.holes.size() == 1);
  double around = 0;
  for (const auto& side : round[0].panel.holes[0]) around += side.curve.length();
  CHECK(around == Approx(0.06 * std::acos(-1)));
  CHECK(mesh::check(meshed(round[0], 0.01)).ok());
}

TEST_CASE("several pieces, and files that are no pattern", "[format][pattern]") {
  const std::string square = polyline("1", {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const auto two = parse_dxf_pattern(
      "f.dxf", file(block("A", square) + block("NOTE", point("5", 1, 1)) + block("B", square)), 1e-3,
      nullptr);
  REQUIRE(two.size() == 2);
  CHECK(two[1].name == "B");
  CHECK(refused("") == "f.dxf: no piece: expected a closed line on layer 1, got layers none");
  CHECK(refused("nonsense\nof all\nkinds") ==
        "f.dxf: no piece: expected a closed line on layer 1, got layers none");
  CHECK(refused(file(block("A", polyline("CUT", {{0, 0}, {1, 0}, {1, 1}}) + point("14", 1, 1)))) ==
        "f.dxf: no piece: expected a closed line on layer 1, got layers '14' (sew line), 'CUT'");
  CHECK(refused(file(block("A", square + square)), 1) ==
        "f.dxf: piece 'A': expected one closed line on layer 1, the boundary, got 2");
  CHECK(refused(file(block("A", polyline("1", {{0, 0}, {10, 0}, {10, 10}, {0, 1}}, false))), 1) ==
        "f.dxf: piece 'A': open: a line ends at (0, 1), 1 from its start (0, 0) (in units of the file)");
  const auto half =
      parse_dxf_pattern("f.dxf", file(block("A", square + line("6", {0, 0}, {0, 10}))), 1e-3, nullptr);
  REQUIRE(half[0].remarks.size() == 1);
  says(half[0].remarks[0], "has a mirror line (layer 6): this is one half of it");
  // Every beginning of a file is read or refused, and none ends the program.
  const std::string whole = file(block("FRONT", piece()), units(4));
  for (std::size_t n = 0; n < whole.size(); n += 7)
    message_of([&] { parse_dxf_pattern("f.dxf", std::string_view(whole).substr(0, n), {}, nullptr); });
}

TEST_CASE("a boundary of open lines is joined, whichever way round they are drawn", "[format][pattern]") {
  // A kite of 120 x 90 whose side is an arc: three polylines and a line, two of them backward, ends 0.1
  // apart.
  const double bulge = 0.3;
  const std::string arc = pair(0, "POLYLINE") + pair(8, "1") + pair(66, "1") + pair(70, "0") +
                          pair(0, "VERTEX") + pair(8, "1") + at(60, 90) + pair(42, std::to_string(-bulge)) +
                          pair(0, "VERTEX") + pair(8, "1") + at(120, 45) + pair(0, "SEQEND") + pair(8, "1");
  const std::string chain = polyline("1", {{0, 45}, {30, 20}, {60, 0}}, false) + arc +
                            polyline("1", {{0.05, 45.05}, {20, 70}, {60, 90}}, false) +
                            line("1", {60, 0.1}, {120, 45});
  const auto joined = [&](const std::string& inside) {
    auto pieces = parse_dxf_pattern("f.dxf", file(block("KITE", inside)), 1e-3, nullptr);
    return std::pair(mesh::check(meshed(pieces.at(0), 0.006)).measures.area, pieces[0].remarks);
  };
  const auto [area, remarks] = joined(chain);
  const auto [whole, none] =
      joined(pair(0, "POLYLINE") + pair(8, "1") + pair(66, "1") + pair(70, "1") + pair(0, "VERTEX") +
             pair(8, "1") + at(0, 45) + pair(0, "VERTEX") + pair(8, "1") + at(30, 20) + pair(0, "VERTEX") +
             pair(8, "1") + at(60, 0) + pair(0, "VERTEX") + pair(8, "1") + at(120, 45) +
             pair(42, std::to_string(bulge)) + pair(0, "VERTEX") + pair(8, "1") + at(60, 90) +
             pair(0, "VERTEX") + pair(8, "1") + at(20, 70) + pair(0, "SEQEND") + pair(8, "1"));
  CHECK(area == Approx(whole).epsilon(2e-3));
  CHECK(none.empty());
  REQUIRE(remarks.size() == 1);
  says(remarks[0], "f.dxf: piece 'KITE': the lines of its boundary end up to 0.1 mm apart and are joined");
  CHECK(refused(file(block("K", polyline("1", {{0, 0}, {10, 0}, {10, 10}}, false) +
                                    polyline("1", {{0, 0.5}, {0, 10}, {10, 10}}, false))),
                1) ==
        "f.dxf: piece 'K': open: 2 lines on layer 1 make no closed boundary: after 2 of them it ends at (0, "
        "0.5), "
        "0.5 from its start (0, 0) (in units of the file)");
  says(refused(file(block("K", polyline("1", {{0, 0}, {10, 0}, {10, 10}}, false) +
                                   polyline("1", {{10, 12}, {0, 12}, {0, 0}}, false) +
                                   line("1", {40, 40}, {41, 41}))),
               1),
       "make no closed boundary: after 1 of them it ends at (10, 10), 14.1421 from its start (0, 0), and 2 "
       "from "
       "the nearest end of another line");
}

TEST_CASE("sizes of one piece, units that contradict each other, and a bad piece among good ones",
          "[format][pattern]") {
  const auto square = [](double a) { return polyline("1", {{0, 0}, {a, 0}, {a, a}, {0, a}}); };
  const auto named = [](const std::string& name) { return text("Piece Name: " + name); };
  auto pieces = parse_dxf_pattern(
      "f.dxf",
      file(block("B-S", named("BACK") + text("Size: S") + square(200)) +
               block("B-M", named("BACK") + text("SIZE:  M ") + square(220)) +
               block("B_L", named("B") + square(90)) + block("BAD", named("CUFF") + square(5) + square(6)),
           units(4)),
      {}, nullptr);
  REQUIRE(pieces.size() == 4);
  CHECK(pieces[0].size == "S");
  CHECK(pieces[1].size == "M");
  CHECK(pieces[2].size == "L");
  CHECK(pieces[1].block == "B-M");
  CHECK(pieces[0].trouble.empty());
  CHECK(pieces[3].trouble == "f.dxf: piece 'CUFF': expected one closed line on layer 1, the boundary, got 2");
  const std::string one = block("A", square(300));
  for (const auto& [code, word, words] :
       {std::tuple{4, "ENGLISH", "$INSUNITS is 4 (millimetres), and a text says 'Units: ENGLISH' (inches)"},
        std::tuple{6, "english", "$INSUNITS is 6 (metres), and a text says 'Units: ENGLISH' (inches)"},
        std::tuple{1, "Metric", "$INSUNITS is 1 (inches), and a text says 'Units: METRIC'"}}) {
    const std::string bytes = file(one, units(code), text(std::string("Units: ") + word));
    CHECK(refused(bytes) == std::string("f.dxf: its units contradict each other: ") + words +
                                "; expected unit= (1*mm if one in the file is a millimetre)");
    CHECK(refused(bytes, 1e-3) == "no error");
  }
  CHECK(refused(file(one, units(5), text("Units: METRIC"))) == "no error");
  CHECK(refused(file(one, units(1), text("Units: ENGLISH"))) == "no error");
  // Metric units may be centimetres: small patterns are asked about, unless the header or the call says.
  const auto asked = [&](const std::string& bytes, std::optional<double> unit = {}) {
    Remarks remarks;
    parse_dxf_pattern("f.dxf", bytes, unit, &remarks);
    return remarks;
  };
  const std::string metric = text("Units: METRIC");
  const auto small = asked(file(block("A", square(48)), "", metric));
  REQUIRE(small.size() == 1);
  CHECK(small[0] ==
        "f.dxf: 'Units: METRIC' is taken for millimetres, and its largest piece is then 48 mm long: is it in "
        "cm? "
        "unit=1*cm, or unit=1*mm, says");
  CHECK(asked(file(block("A", square(48)) + block("B", square(480)), "", metric)).empty());
  CHECK(asked(file(block("A", square(48)), units(4), metric)).empty());
  CHECK(asked(file(block("A", square(48)), "", metric), 1e-3).empty());
}

namespace {

std::string svg(const std::string& inside,
                const std::string& root = "width='300mm' height='200mm' viewBox='0 0 3000 2000'") {
  return "<?xml version='1.0'?><svg xmlns='http://www.w3.org/2000/svg' xmlns:k='urn:k' k:x='1' " + root +
         ">" + inside + "</svg>";
}

std::string svg_refused(const std::string& bytes, std::optional<double> unit = {}) {
  return message_of([&] { parse_svg_pattern("f.svg", bytes, unit, nullptr); });
}

}  // namespace

TEST_CASE("an SVG drawing: pieces by id, holes, transforms, grain, notches, units", "[format][pattern]") {
  Remarks remarks;
  const std::string drawing =
      "<title>t</title><style>.a{}</style><g id='layer1' style='fill:none' transform='translate(100,50)'>"
      "<path id='FRONT' transform='scale(2)' d='M0 0 h300 l-50 400 h-200 z M100 100 h60 v40 h-60 z'/>"
      "<line id='grain' x1='200' y1='200' x2='300' y2='100'/><circle id='notch_knee' cx='300' cy='3' r='4'/>"
      "<circle id='notch_far' cx='900' cy='900' r='4'/></g>"
      "<rect id='BELT' x='2000' y='100' width='100' height='700'/><path id='fold' d='M0 0 L10 "
      "10'/><text>note</text>";
  auto pieces = parse_svg_pattern("f.svg", svg(drawing), {}, &remarks);
  REQUIRE(pieces.size() == 2);
  CHECK(pieces[0].name == "FRONT");
  CHECK(pieces[1].name == "BELT");
  REQUIRE(remarks.size() == 1);
  CHECK(remarks[0] == "f.svg: open lines that are not used: 'fold'");
  // A unit is 0.1 mm; the trapezoid is drawn at twice its size, from (10, -5) mm on, y upward.
  CHECK(pieces[0].has_grain);
  CHECK(pieces[0].panel.grain == Approx(45));
  CHECK_FALSE(pieces[1].has_grain);
  REQUIRE(pieces[0].panel.notches.size() == 1);
  CHECK(pieces[0].panel.notches[0].name == "notch_knee");
  CHECK((*pieces[0].panel.notches[0].point - Vec2(0.04, -0.005)).norm() < 1e-14);
  const mesh::Mesh mesh = meshed(pieces[0], 0.004);
  CHECK(mesh::check(mesh).measures.area == Approx((0.5 * (300 + 200) * 400 - 60 * 40) * 4e-8).epsilon(1e-12));
  CHECK(mesh::check(mesh).measures.borders == 2);
  CHECK(mesh.set("edge4").size() > 1);
  CHECK(mesh::check(meshed(pieces[1], 0.005)).measures.area == Approx(0.01 * 0.07));
  says(pieces[1].remarks.empty() ? pieces[0].remarks.at(0) : pieces[1].remarks[0],
       "notch_far at (0.1, -0.095) m is left out");
}

TEST_CASE("shapes of an SVG drawing that are defined in one place and used in another", "[format][pattern]") {
  const std::string root =
      "width='400mm' height='300mm' viewBox='0 0 400 300' xmlns:xlink='http://www.w3.org/1999/xlink'";
  const auto read = [&](const std::string& inside) {
    return parse_svg_pattern("f.svg", svg(inside, root), {}, nullptr);
  };
  const std::string cuff =
      "<defs><g id='pair'><path id='cuff' d='M0 0 h60 v20 h-60 z'/><use href='#tab' x='70'/></g>"
      "<rect id='tab' width='10' height='15'/></defs>";
  auto pieces =
      read(cuff +
           "<use xlink:href='#cuff' transform='rotate(90)' x='5' y='-30'/><use id='left' "
           "href='#tab' transform='translate(100 50)'/><g transform='scale(2)'><use href='#pair'/></g>"
           "<use href='#cuff'/>");
  REQUIRE(pieces.size() == 5);
  CHECK(pieces[0].name == "cuff");
  CHECK(pieces[1].name == "left");
  CHECK(pieces[2].name == "cuff-2");
  CHECK(pieces[3].name == "tab");
  CHECK(pieces[4].name == "cuff-3");
  const auto low = [](const PatternPiece& piece) {
    Vec2 x = piece.panel.outline.front().curve.start();
    for (const auto& side : piece.panel.outline) x = x.cwiseMin(side.curve.start());
    return x;
  };
  // x' = -y, y' = x in the drawing, whose y is downward: (5..65, -30..-10) becomes (10..30, 5..65).
  CHECK((low(pieces[0]) - Vec2(0.010, -0.065)).norm() < 1e-12);
  CHECK((low(pieces[1]) - Vec2(0.1, -0.065)).norm() < 1e-12);
  CHECK((low(pieces[3]) - Vec2(0.14, -0.03)).norm() < 1e-12);
  CHECK(mesh::check(meshed(pieces[2], 0.01)).measures.area == Approx(0.12 * 0.04));
  says(message_of([&] { read("<use href='#none'/>"); }),
       "f.svg: <use> of '#none', and no element has this id");
  says(message_of([&] { read("<use href='other.svg#a'/>"); }),
       "expected the id of an element of this drawing");
  says(message_of([&] { read("<g id='a'><use href='#a'/></g>"); }), "inside of itself");
  says(message_of([&] {
         read("<defs><g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g></defs><use href='#a'/>");
       }),
       "uses within uses without end");
  std::string more = "<defs><rect id='l0' width='9' height='9'/>";
  for (int i = 1; i < 12; ++i) {
    more += "<g id='l" + std::to_string(i) + "'>";
    for (int k = 0; k < 10; ++k) more += "<use href='#l" + std::to_string(i - 1) + "'/>";
    more += "</g>";
  }
  says(message_of([&] { read(more + "</defs><use href='#l11'/>"); }), "uses within uses without end");
}

TEST_CASE("SVG: curves, arcs as Bezier curves, units, and what is no drawing", "[format][pattern]") {
  const auto length = [](const std::string& d, const std::string& root, std::optional<double> unit = {}) {
    auto pieces = parse_svg_pattern("f.svg", svg("<path d='" + d + "'/>", root), unit, nullptr);
    CHECK(pieces.at(0).name == "piece1");
    double sum = 0;
    for (const auto& side : pieces[0].panel.outline) sum += side.curve.length();
    return sum;
  };
  const double pi = std::acos(-1);
  const std::string paper = "width='10cm' viewBox='0,0,100,100'";
  // Half a circle of 30 mm and its diameter; a Bezier curve of a sixth of a circle is longer by about 1e-6 of
  // it.
  CHECK(length("M0 0 A30 30 0 0 1 60 0 z", paper) == Approx(0.06 + 0.03 * pi).epsilon(1e-4));
  // The parabola y = x^2 from 0 to 1, quadratic; closed by lines.
  CHECK(length("M0 0 Q 50 0 100 -100 V 0 z", paper) ==
        Approx(0.1 * (std::sqrt(5) / 2 + std::asinh(2) / 4 + 2)).epsilon(1e-9));
  CHECK(length("M0 0 h10 v10 h-10 z", "width='4in' height='2in' viewBox='0 0 8 4'") == Approx(40 * 0.0127));
  CHECK(length("M0 0 h96 v96 h-96 z", "width='10cm'") == Approx(4 * 0.0254));
  CHECK(length("M0 0 h10 v10 h-10 L0 0", "width='500' height='500'", 1e-3) == Approx(0.04));
  CHECK(svg_refused(svg("<path d='M0 0 h9 v9 z'/>", "width='500px'"))
            .starts_with("f.svg: its lengths have no unit: expected unit="));
  CHECK(svg_refused(svg("<path d='M0 0 h9 v9 z'/>", "width='10cm' height='10cm' viewBox='0 0 100 200'"))
            .starts_with("f.svg: its lengths have no unit"));
  CHECK(svg_refused(svg("<path id='a' d='M0 0 h9 v9'/>")) ==
        "f.svg: no piece: expected a closed path, got open ones: 'a'");
  CHECK(svg_refused(svg("")) == "f.svg: no piece: expected a closed path, got none");
  says(svg_refused(svg("<path id='a' d='M0 0 h9 X9'/>")),
       "f.svg: expected an SVG drawing, got what cannot be read: ");
  says(svg_refused(svg("<path id='a' d='M0 0 h9 a300 0 3 0 1 -20 -20 z'/>")),
       "f.svg: expected an SVG drawing, got what cannot be read: a");
  CHECK(svg_refused("nonsense") == "f.svg: expected an SVG drawing, got what is no XML");
  CHECK(svg_refused("") == "f.svg: expected an SVG drawing, got what is no XML");
  says(svg_refused("<html width='9mm'/>"), "f.svg: expected an SVG drawing, got what cannot be read: ");
  const std::string whole =
      svg("<g transform='rotate(30 1,2)'><path id='p' d='M0 0 c1 2 3 4 5 6 s 1 2 3 4 t 9 9 a3 4 5 0 1 9 9 "
          "z'/></g>");
  for (std::size_t n = 0; n < whole.size(); n += 3) svg_refused(whole.substr(0, n), 1e-3);
}
