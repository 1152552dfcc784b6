// The colours of a bar are even to the eye, and keep their order without one kind of cones.
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "plot/colour_scale.hpp"
#include "plot/seen.hpp"

using namespace fabricsh::plot;

namespace {

struct Range {
  double low, high;
};

// Colour i of 256, as an eye with all cones or without green ones sees it.
Seen lab(const Range& bar, int i, bool without_green) {
  return seen(colour(bar.low + (i + 0.5) / 256 * (bar.high - bar.low), bar.low, bar.high),
              without_green ? no_green_cones : all_cones);
}

}  // namespace

TEST_CASE("one sign: lighter all the way, also without green cones", "[plot]") {
  const Range table{0, 1};
  for (const bool without : {false, true})
    for (int i = 16; i < 256; i += 16) {
      CAPTURE(without, i);
      CHECK(lab(table, i, without)[0] > lab(table, i - 16, without)[0] + 1);
    }
  // Lightness rises as a straight line would, within 7 of its 75 units; equal steps are equal to the eye
  // within a factor of 2.2, as in viridis itself.
  double least = 1e9, most = 0;
  for (int i = 0; i < 256; i += 15) {
    const double low = lab(table, 0, false)[0], high = lab(table, 255, false)[0];
    CHECK(std::abs(lab(table, i, false)[0] - (low + (high - low) * i / 255)) < 7);
    if (i == 0) continue;
    const double step = distance(lab(table, i, false), lab(table, i - 15, false));
    least = std::min(least, step), most = std::max(most, step);
  }
  CAPTURE(least, most);
  CHECK(most < 2.2 * least);
}

TEST_CASE("two signs: white at zero, even steps to either end, the ends apart without green cones",
          "[plot]") {
  const Range table{-1, 1};
  CHECK(lab(table, 127, false)[0] > 96);
  double least = 1e9, most = 0;
  for (int i = 15; i < 256; i += 15) {
    if (i > 113 && i < 143) continue;  // around the turn at zero
    const double step = distance(lab(table, i, false), lab(table, i - 15, false));
    least = std::min(least, step), most = std::max(most, step);
  }
  CAPTURE(least, most);
  CHECK(most < 1.05 * least);
  for (int i = 0; i < 90; i += 10) CHECK(distance(lab(table, i, true), lab(table, 255 - i, true)) > 20);
  // As much above zero as below it is equally strong.
  for (int i = 0; i < 128; i += 8)
    CHECK(std::abs(lab(table, i, false)[0] - lab(table, 255 - i, false)[0]) < 0.5);
}

TEST_CASE("a range of one sign with a trace of the other stays of one sign", "[plot]") {
  CHECK(lab({-0.01, 1}, 0, false)[0] < 20);
  CHECK(lab({-0.5, 1}, 85, false)[0] > 95);  // zero, at a third
}
