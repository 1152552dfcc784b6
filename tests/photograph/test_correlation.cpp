// Subsets found again on photographs of speckles whose displacement is known at every place.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "message_of.hpp"
#include "photograph/correlation.hpp"
#include "photograph/dots.hpp"
#include "photograph/spline.hpp"

using namespace fabricsh;
using namespace fabricsh::photograph;

namespace {

Speckles speckles() {
  Speckles s;
  s.width = 240;
  s.height = 220;
  return s;
}

CorrelationOptions options() {
  CorrelationOptions o;
  o.region = {20, 20, 220, 200};
  return o;
}

// Where the scene puts a place of the first photograph.
std::array<double, 2> reference(const Speckles& s, double x, double y) {
  const double mx = (s.width - 1) / 2.0, my = (s.height - 1) / 2.0;
  return {mx + s.shift[0] + s.F[0] * (x - mx) + s.F[1] * (y - my),
          my + s.shift[1] + s.F[2] * (x - mx) + s.F[3] * (y - my)};
}

struct Misses {
  double rms = 0, mean_x = 0, mean_y = 0, largest = 0, deviation = 0;
  std::size_t found = 0;
};
Misses misses(const Speckles& s, const std::vector<Subset>& subsets) {
  Misses m;
  for (const Subset& subset : subsets) {
    if (subset.state != Subset::SubsetState::found) continue;
    const auto [x, y] = reference(s, subset.x, subset.y);
    const double dx = subset.x + subset.u - x, dy = subset.y + subset.v - y;
    m.rms += (dx * dx + dy * dy) / 2;
    m.mean_x += dx;
    m.mean_y += dy;
    m.largest = std::max({m.largest, std::abs(dx), std::abs(dy)});
    m.deviation += subset.deviation * subset.deviation;
    ++m.found;
  }
  const auto n = static_cast<double>(m.found);
  m.rms = std::sqrt(m.rms / n), m.deviation = std::sqrt(m.deviation / n);
  m.mean_x /= n, m.mean_y /= n;
  return m;
}

}  // namespace

TEST_CASE("the spline meets every pixel, and a smooth picture between them", "[lab]") {
  Image image{60, 50, {}};
  const auto f = [](double x, double y) { return 0.5 + 0.3 * std::sin(0.4 * x + 0.2) * std::cos(0.3 * y); };
  for (int row = 0; row < 50; ++row)
    for (int column = 0; column < 60; ++column) image.pixels.push_back(static_cast<float>(f(column, row)));
  const Spline spline(image);
  for (int row = 12; row < 38; ++row)
    for (int column = 12; column < 48; ++column) {
      CHECK(std::abs(spline.at(column, row) - image.at(column, row)) < 1e-12);
      const auto [dx, dy] = spline.slope(column, row);
      // A cubic spline's slope at the knots is of fourth order: h^4 f'''''/180.
      CHECK(std::abs(dx - 0.12 * std::cos(0.4 * column + 0.2) * std::cos(0.3 * row)) <
            0.3 * std::pow(0.4, 5) / 150);
      CHECK(std::abs(dy + 0.09 * std::sin(0.4 * column + 0.2) * std::sin(0.3 * row)) <
            0.3 * std::pow(0.4, 5) / 150);
      // And its value h^4 f''''/384 in between; pixels are floats.
      CHECK(std::abs(spline.at(column + 0.5, row) - f(column + 0.5, row)) <
            1.2 * 0.3 * std::pow(0.4, 4) / 384);
      CHECK(std::abs(spline.at(column + 0.3, row + 0.7) - f(column + 0.3, row + 0.7)) <
            1.5 * 0.3 * std::pow(0.4, 4) / 384);
    }
}

TEST_CASE("variance of noise in the spline", "[lab]") {
  Image image{400, 300, {}};
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0, 1);
  for (int i = 0; i < 400 * 300; ++i) image.pixels.push_back(static_cast<float>(normal(random)));
  const Spline spline(image);
  double slopes = 0, n = 0;
  for (const double part : {0.0, 0.2, 0.5}) {
    double values = 0, of = 0;
    for (int row = 20; row < 280; ++row)
      for (int column = 20; column < 380; ++column) {
        const double v = spline.at(column + part, row + 0.5);
        const auto [dx, dy] = spline.slope(column, row);
        values += v * v, of += 1;
        slopes += (dx * dx + dy * dy) / 2, n += 1;
      }
    INFO("at " << part << ": " << values / of << " for " << Spline::kept(part, 0.5));
    CHECK(std::abs(values / of / Spline::kept(part, 0.5) - 1) <
          0.03);  // 94,000 values that are not independent
  }
  CHECK(std::abs(slopes / n / Spline::slope_noise() - 1) < 0.03);
  CHECK(std::abs(Spline::kept(7, 9) - 1) < 1e-12);
}

TEST_CASE("shifts of parts of a pixel come back within 0.006 pixels without noise", "[lab]") {
  Speckles s = speckles();
  Correlator correlator(draw(s), options());
  REQUIRE(correlator.subsets().size() == correlator.rows() * correlator.columns());
  for (int k = 0; k <= 10; ++k) {
    s.shift = {0.1 * k, 3 - 0.07 * k};
    const Misses m = misses(s, correlator.add(draw(s)));
    INFO("shift " << s.shift[0] << ", " << s.shift[1] << ": rms " << m.rms << ", mean " << m.mean_x << ", "
                  << m.mean_y << ", largest " << m.largest << " px");
    CHECK(m.found == correlator.subsets().size());
    CHECK(m.largest < 0.006);
    CHECK(m.rms < 0.0015);  // 8 bits
  }
}

TEST_CASE("the effect of noise on a displacement is told", "[lab]") {
  for (const double noise : {0.01, 0.02, 0.04}) {
    double squares = 0, told = 0, n = 0;
    for (int k = 0; k < 6; ++k) {
      Speckles s = speckles();
      s.noise = noise;
      s.pattern = static_cast<std::uint64_t>(k + 1);
      s.seed = static_cast<std::uint64_t>(2 * k + 1);
      Correlator correlator(draw(s), options());
      s.shift = {0.37 + 0.1 * k, -1.2 + 0.13 * k};
      s.seed = static_cast<std::uint64_t>(2 * k + 2);
      const Misses m = misses(s, correlator.add(draw(s)));
      CHECK(m.found == correlator.subsets().size());
      squares += m.rms * m.rms * static_cast<double>(m.found);
      told += m.deviation * m.deviation * static_cast<double>(m.found);
      n += static_cast<double>(m.found);
    }
    const double rms = std::sqrt(squares / n), deviation = std::sqrt(told / n);
    INFO("noise " << noise << ": rms " << rms << " px, told " << deviation);
    CHECK(std::abs(deviation / rms - 1) < 0.08);  // some 1,200 middles, whose subsets touch: 3 %
  }
}

TEST_CASE("strains, turns and large ways", "[lab]") {
  Speckles s = speckles();
  Correlator correlator(draw(s), options());
  const double c = std::cos(0.4), t = std::sin(0.4);
  // Five steps to a stretch of 15 %, a contraction, a shear, turned by 23 degrees and moved by 25 pixels.
  for (int k = 1; k <= 5; ++k) {
    const double part = k / 5.0;
    const double angle = std::atan2(t, c) * part, cc = std::cos(angle), ss = std::sin(angle);
    const double a = 1 + 0.15 * part, b = 1 - 0.06 * part,
                 g = 0.05 * part;  // of the cloth, before it is turned
    s.F = {cc * a, cc * g - ss * b, ss * a, ss * g + cc * b};
    s.shift = {25 * part, -10 * part};
    const auto& subsets = correlator.add(draw(s));
    const Misses m = misses(s, subsets);
    INFO("step " << k << ": rms " << m.rms << ", largest " << m.largest << " px, found " << m.found);
    CHECK(m.rms < 0.01);
    CHECK(m.largest < 0.03);
    double worst = 0;
    std::size_t strained = 0;
    for (const Subset& subset : subsets) {
      if (subset.state != Subset::SubsetState::found || std::isnan(subset.strain[0])) continue;
      ++strained;
      worst = std::max({worst, std::abs(subset.strain[0] - (a * a - 1) / 2),
                        std::abs(subset.strain[1] - (b * b + g * g - 1) / 2),
                        std::abs(subset.strain[2] - a * g / 2)});
    }
    INFO("strain off by " << worst << " at most, of " << strained);
    CHECK(strained > 20);
    CHECK(worst < 5e-4);
  }
}

TEST_CASE("a patch that leaves the picture is lost and found again, and a blank patch is told", "[lab]") {
  Speckles s = speckles();
  Image first = draw(s);
  for (int row = 90; row < 150; ++row)
    for (int column = 100; column < 160; ++column) first.at(column, row) = 0.5F;
  Correlator correlator(first, options());
  std::size_t blank = 0;
  for (const Subset& subset : correlator.subsets())
    if (subset.state == Subset::SubsetState::textureless) {
      ++blank;
      CHECK((subset.x > 100 && subset.x < 160 && subset.y > 90 && subset.y < 150));
    }
  CHECK(blank >= 4);
  Image empty = first;
  std::fill(empty.pixels.begin(), empty.pixels.end(), 0.5F);
  for (const Subset& subset : correlator.add(empty)) CHECK(subset.state != Subset::SubsetState::found);
  std::size_t found = 0;
  for (const Subset& subset : correlator.add(first)) {
    if (subset.state != Subset::SubsetState::found) continue;
    ++found;
    CHECK(std::hypot(subset.u, subset.v) < 1e-6);
    CHECK(subset.correlation > 1 - 1e-9);
  }
  CHECK(found + blank == correlator.subsets().size());
}

TEST_CASE("a subset that resembles the wrong place is lost, not misplaced", "[lab]") {
  const Image first = draw(speckles());
  CorrelationOptions o = options();
  o.step = 25;
  Correlator correlator(first, o);
  const std::size_t middle = correlator.rows() / 2 * correlator.columns() + correlator.columns() / 2;
  const int x = static_cast<int>(correlator.subsets()[middle].x),
            y = static_cast<int>(correlator.subsets()[middle].y);
  Image second = first;  // what the subset shows stands 9 pixels to the right, on a cloth that is still
  for (int row = -12; row <= 12; ++row)
    for (int column = -12; column <= 12; ++column)
      second.at(x + 9 + column, y + row) = first.at(x + column, y + row);
  const auto& subsets = correlator.add(second);
  CHECK(subsets[middle].state == Subset::SubsetState::lost);
  CHECK(std::abs(subsets[middle].u - 9) < 1e-3);  // where it was seen
  std::size_t still = 0;
  for (const Subset& subset : subsets) {
    if (subset.state != Subset::SubsetState::found) continue;
    ++still;
    CHECK(std::hypot(subset.u, subset.v) < 0.01);
  }
  CHECK(still + 3 >= subsets.size());
}

TEST_CASE("photographs without a texture, or of another size, are refused", "[lab]") {
  Image grey{200, 200, std::vector<float>(40000, 0.5F)};
  CorrelationOptions o = options();
  o.region = {0, 0, 200, 200};
  CHECK(message_of([&] { Correlator(grey, o); }).find("has a texture that determines a displacement") !=
        std::string::npos);
  // Stripes tell one direction only.
  for (int row = 0; row < 200; ++row)
    for (int column = 0; column < 200; ++column)
      grey.at(column, row) = static_cast<float>(0.5 + 0.3 * std::sin(0.5 * column));
  CHECK(message_of([&] { Correlator(grey, o); }).find("has a texture that determines a displacement") !=
        std::string::npos);
  o.region = {0, 0, 20, 200};
  CHECK(message_of([&] { Correlator(draw(speckles()), o); }).find("expected a region of at least 25 x 25") !=
        std::string::npos);
  Correlator correlator(draw(speckles()), options());
  CHECK(message_of([&] { correlator.add(grey); }) ==
        "correlate: expected photographs of 240 x 220 pixels as the first, got one of 200 x 200");
}
