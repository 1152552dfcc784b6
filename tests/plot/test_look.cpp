// Curves of one figure are told apart by readers with each kind of colour blindness.
#include <algorithm>
#include <cstdlib>
#include <set>

#include "catch.hpp"
#include "plot/script.hpp"
#include "plot/seen.hpp"

using namespace fabricsh::plot;

namespace {
constexpr const char* kinds[] = {"all cones", "no red cones", "no green cones", "no blue cones"};

Seen seen_hex(const std::string& hex, std::size_t eye) {
  Seen c{};
  for (std::size_t k = 0; k < 3; ++k)
    c[k] = static_cast<double>(std::strtol(hex.substr(1 + 2 * k, 2).c_str(), nullptr, 16)) / 255;
  return seen(c, eye);
}

double apart(const std::string& a, const std::string& b, std::size_t eye) {
  return distance(seen_hex(a, eye), seen_hex(b, eye));
}

}  // namespace

TEST_CASE("the measure of colours: known values", "[plot]") {
  CHECK_THAT(seen_hex("#ffffff", 0)[0], Catch::Matchers::WithinAbs(100, 1e-3));
  CHECK_THAT(seen_hex("#ff0000", 0)[1], Catch::Matchers::WithinAbs(80.1, 0.1));  // CIE 15, sRGB's red
  // Without green cones red and green of one lightness fall together; with all they are far apart.
  CHECK(apart("#b05050", "#757540", 2) < 0.35 * apart("#b05050", "#757540", 0));
}

// A just noticeable difference is 2.3; 15 and more is another colour at a glance.
TEST_CASE("neighbouring colours stay far apart without any one kind of cones, all others apart", "[plot]") {
  for (std::size_t eye = 0; eye < 4; ++eye)
    for (std::size_t i = 0; i < kColours; ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const std::string a = look(i, CurveStyle::line).colour, b = look(k, CurveStyle::line).colour;
        CAPTURE(kinds[eye], a, b);
        const bool neighbours = i == k + 1 || (k == 0 && i == kColours - 1);
        CHECK(apart(a, b, eye) > (neighbours ? 24 : 15));
        CHECK(apart(a, "#ffffff", eye) > 30);  // and from the paper
      }
}

TEST_CASE("28 lines differ in colour or pattern, 42 marks in colour or shape", "[plot]") {
  std::set<std::string> lines, marks, points;
  for (std::size_t i = 0; i < kColours * kPatterns; ++i) {
    const CurveAppearance l = look(i, CurveStyle::line);
    lines.insert(l.colour + l.dashes);
    CHECK(l.line);
    CHECK(l.marker == 0);
    CHECK(look(i, CurveStyle::dashed).dashes != l.dashes);
  }
  CHECK(lines.size() == kColours * kPatterns);
  for (std::size_t i = 0; i < kColours * kMarkers; ++i) {
    const CurveAppearance open = look(i, CurveStyle::points), filled = look(i, CurveStyle::line_points);
    points.insert(open.colour + std::to_string(open.marker));
    marks.insert(filled.colour + std::to_string(filled.marker));
    CHECK(!open.line);
    CHECK(open.marker != look(i + 1, CurveStyle::points).marker);
  }
  CHECK(points.size() == kColours * kMarkers);
  CHECK(marks.size() == kColours * kMarkers);
}
