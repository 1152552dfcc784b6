#include <cmath>
#include <random>

#include "catch.hpp"
#include "lab/markers.hpp"
#include "message_of.hpp"

using namespace fabricsh::lab;

namespace {

// A grid that is stretched along y to E and contracts by -ratio E, with noise on every coordinate.
Tracks stretched(double ratio, double noise, std::uint64_t seed, std::size_t frames = 25) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 1);
  Tracks t{6, 4, frames, {}, {}};
  for (std::size_t f = 0; f < frames; ++f) {
    const double E = 0.15 * static_cast<double>(f) / static_cast<double>(frames - 1);
    const double along = std::sqrt(1 + 2 * E), across = std::sqrt(1 - 2 * ratio * E);
    for (std::size_t m = 0; m < t.markers(); ++m) {
      t.x.push_back(static_cast<double>(m % t.columns) * 5 * across + noise * normal(random));
      t.y.push_back(static_cast<double>(m / t.columns) * 5 * along + noise * normal(random));
    }
  }
  return t;
}

}  // namespace

TEST_CASE("the contraction ratio of an exact grid", "[lab]") {
  for (const double ratio : {0.12, 0.99, 2.04}) {
    const Ratio r = contraction_ratio(stretched(ratio, 0, 1), 0, 0.01);
    CHECK(std::abs(r.value - ratio) < 1e-12);
    CHECK(r.uncertainty < 1e-12);
  }
}

TEST_CASE("noise in the positions is found and no longer biases the ratio", "[lab]") {
  double sum = 0, plain = 0, noise = 0;
  constexpr int repeats = 400;
  for (std::uint64_t seed = 0; seed < repeats; ++seed) {
    const Ratio r = contraction_ratio(stretched(0.6, 0.05, seed), -1, 0.02);
    sum += r.value / repeats;
    plain += r.plain / repeats;
    noise += r.noise / repeats;
  }
  CHECK(std::abs(noise - 0.05) < 0.002);
  CHECK(std::abs(sum - 0.6) < 0.0035);  // three standard errors of the 400
  CHECK(plain < 0.6 - 0.004);           // what eq. 3.3's plain line would say
}

TEST_CASE("four pins of a diamond give the ratio of its diagonals, in any order", "[lab]") {
  // A pull along a direction that need not be y; the pins' distances are those of a diamond 84 by 48.
  for (const double ratio : {0.3, -0.4, 1.1})
    for (const double turned : {0.0, 0.2, 1.5})
      for (const auto& order :
           {std::array{0, 1, 2, 3}, {0, 2, 1, 3}, {3, 1, 0, 2}, {2, 0, 3, 1}, {1, 2, 3, 0}}) {
        Tracks t{2, 2, 20, {}, {}};
        for (std::size_t f = 0; f < t.frames; ++f) {
          const double E = 0.2 * static_cast<double>(f) / 19;
          const double along = 42 * std::sqrt(1 + 2 * E), across = 24 * std::sqrt(1 - 2 * ratio * E);
          const std::array<std::array<double, 2>, 4> pins = {
              {{0, along}, {across, 0}, {0, -along}, {-across, 0}}};
          for (const int pin : order) {
            const auto& [x, y] = pins[static_cast<std::size_t>(pin)];
            t.x.push_back(std::cos(turned) * x - std::sin(turned) * y);
            t.y.push_back(std::sin(turned) * x + std::cos(turned) * y);
          }
        }
        INFO("ratio " << ratio << ", turned " << turned << ", order " << order[0] << order[1] << order[2]
                      << order[3]);
        CHECK(arrangement_of(t).diamond);
        CHECK(std::abs(contraction_ratio(t, 0, 0.01).value - ratio) < 1e-12);
      }
}

TEST_CASE("rows that do not follow the pull are refused", "[lab]") {
  Tracks t = stretched(0.3, 0, 1);
  CHECK_FALSE(arrangement_of(t).diamond);
  std::swap(t.x, t.y);  // pulled along the columns' direction
  CHECK_FALSE(arrangement_of(t).diamond);
  Tracks exchanged{4, 6, t.frames, {}, {}};
  for (std::size_t f = 0; f < t.frames; ++f)
    for (std::size_t m = 0; m < t.markers(); ++m) {
      const std::size_t from = f * t.markers() + m % 6 * 4 + m / 6;
      exchanged.x.push_back(t.x[from]);
      exchanged.y.push_back(t.y[from]);
    }
  fabricsh::says(fabricsh::message_of([&] { contraction_ratio(exchanged, 0, 0.01); }),
                 "the cloth is stretched most at 90 degrees to the line from the first row to the last");
}

TEST_CASE("a lost marker takes its boxes out", "[lab]") {
  Tracks t = stretched(0.5, 0, 1);
  for (std::size_t f = 3; f < t.frames; ++f) t.x[f * t.markers() + 5] = std::nan("");
  CHECK(std::abs(contraction_ratio(t, 0, 0.01).value - 0.5) < 1e-12);
}

TEST_CASE("shear of a box is half the product of its yarns [williams2010, 3.16]", "[lab]") {
  const double g = 0.3;
  for (const double angle : {0.0, 0.4, 0.7853981633974483}) {
    const double c = std::cos(angle), s = std::sin(angle);
    // warp stays, weft leans to it by g, then everything turns by 20 degrees
    const double a1[2] = {c, s}, a2[2] = {-s, c};
    const double t1[2] = {c, s},
                 t2[2] = {-s * std::cos(g) + c * std::sin(g), c * std::cos(g) + s * std::sin(g)};
    std::array<double, 4> F{};
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) F[2 * i + j] = t1[i] * a1[j] + t2[i] * a2[j];
    const double r = 0.35, cr = std::cos(r), sr = std::sin(r);
    const std::array<double, 4> turned{cr * F[0] - sr * F[2], cr * F[1] - sr * F[3], sr * F[0] + cr * F[2],
                                       sr * F[1] + cr * F[3]};
    const YarnShear shear = yarn_shear(turned, angle);
    CHECK(std::abs(shear.E12 - std::sin(g) / 2) < 1e-14);
    CHECK(std::abs(shear.warp_stretch - 1) < 1e-14);
    CHECK(std::abs(shear.weft_stretch - 1) < 1e-14);
  }
}

TEST_CASE("the affine map of a box and the zones of a bias specimen", "[lab]") {
  Tracks t{2, 2, 2, {0, 2, 0, 2}, {0, 0, 3, 3}};
  const std::array<double, 4> F{1.1, 0.2, -0.1, 0.9};
  for (std::size_t m = 0; m < 4; ++m) {
    t.x.push_back(F[0] * t.x[m] + F[1] * t.y[m] + 7);
    t.y.push_back(F[2] * t.x[m] + F[3] * t.y[m] - 3);
  }
  const auto got = box_gradient(t, 0, 1);
  for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(got[i] - F[i]) < 1e-14);
  // parts in the mean over all frames, there and back, one box lost for a while and one for good
  const double lost = std::nan("");
  const auto share = shear_ratios({0, 0, 0, 0.1, 0.2, lost, 0.2, lost, lost, 0.01, 0.02, lost}, 3);
  // means 0.15, 0.2, 0.015; the second box is not seen in the second of these frames
  CHECK(std::abs(share[0] - (0.1 * 0.15 + 0.2 * 0.2 + 0.01 * 0.015) /
                                (0.15 * 0.15 + 0.2 * 0.2 + 0.015 * 0.015)) < 1e-12);
  CHECK(std::abs(share[1] - 4.0 / 3) < 1e-12);
  CHECK(std::isnan(share[2]));
  CHECK(bias_zones({0.01, 0.11, 0.2, -0.19, std::nan("")}) == std::vector<int>{1, 2, 3, 3, 1});
}
