// Curves of one figure are told apart by readers with each kind of colour blindness.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

#include "catch.hpp"
#include "plot/script.hpp"

using namespace fabricsh::plot;

namespace {

using Colour = std::array<double, 3>;
using Matrix = std::array<Colour, 3>;

// Linear red, green and blue as seen without one kind of cones (G. Machado, M. Oliveira, L.
// Fernandes, IEEE Transactions on Visualization and Computer Graphics 15, 2009; severity 1).
const std::array<Matrix, 4> eyes = {
    {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
     {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}}};
constexpr const char* kinds[] = {"all cones", "no red cones", "no green cones", "no blue cones"};

double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

Colour product(const Matrix& m, const Colour& c) {
  Colour out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = std::clamp(m[i][0] * c[0] + m[i][1] * c[1] + m[i][2] * c[2], 0.0, 1.0);
  return out;
}

// CIE L*a*b* of linear sRGB under daylight.
Colour lab(const Colour& c) {
  const double x = (0.4124564 * c[0] + 0.3575761 * c[1] + 0.1804375 * c[2]) / 0.95047,
               y = 0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2],
               z = (0.0193339 * c[0] + 0.1191920 * c[1] + 0.9503041 * c[2]) / 1.08883;
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  return {116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

Colour seen(const std::string& hex, std::size_t eye) {
  Colour c{};
  for (std::size_t k = 0; k < 3; ++k)
    c[k] = linear(static_cast<double>(std::strtol(hex.substr(1 + 2 * k, 2).c_str(), nullptr, 16)) / 255);
  return lab(product(eyes[eye], c));
}

double distance(const std::string& a, const std::string& b, std::size_t eye) {
  const Colour p = seen(a, eye), q = seen(b, eye);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace

TEST_CASE("the measure of colours: known values", "[plot]") {
  CHECK_THAT(seen("#ffffff", 0)[0], Catch::Matchers::WithinAbs(100, 1e-3));
  CHECK_THAT(seen("#ff0000", 0)[1], Catch::Matchers::WithinAbs(80.1, 0.1));  // CIE 15, sRGB's red
  // Without green cones red and green of one lightness fall together; with all they are far apart.
  CHECK(distance("#b05050", "#757540", 2) < 0.35 * distance("#b05050", "#757540", 0));
}

// A just noticeable difference is 2.3; 15 and more is another colour at a glance.
TEST_CASE("neighbouring colours stay far apart without any one kind of cones, all others apart", "[plot]") {
  for (std::size_t eye = 0; eye < 4; ++eye)
    for (std::size_t i = 0; i < kColours; ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const std::string a = look(i, CurveStyle::line).colour, b = look(k, CurveStyle::line).colour;
        CAPTURE(kinds[eye], a, b);
        const bool neighbours = i == k + 1 || (k == 0 && i == kColours - 1);
        CHECK(distance(a, b, eye) > (neighbours ? 24 : 15));
        CHECK(distance(a, "#ffffff", eye) > 30);  // and from the paper
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
