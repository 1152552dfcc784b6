#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "photograph/dots.hpp"

namespace fabricsh::photograph {

namespace {

constexpr double kDark = 0.1, kLight = 0.9;
constexpr double kReach = 5;  // deviations, where a blot is 4e-6

struct Map {
  const Speckles& s;
  double middle_x = (s.width - 1) / 2.0, middle_y = (s.height - 1) / 2.0;
  double det = s.F[0] * s.F[3] - s.F[1] * s.F[2];

  std::array<double, 2> forward(double X, double Y) const {
    const double x = X - middle_x, y = Y - middle_y;
    return {middle_x + s.shift[0] + s.F[0] * x + s.F[1] * y, middle_y + s.shift[1] + s.F[2] * x + s.F[3] * y};
  }
  std::array<double, 2> back(double x, double y) const {
    const double a = x - middle_x - s.shift[0], b = y - middle_y - s.shift[1];
    return {middle_x + (s.F[3] * a - s.F[1] * b) / det, middle_y + (s.F[0] * b - s.F[2] * a) / det};
  }
};

// The light that a blot around (X, Y) of the undeformed cloth leaves, pixel by pixel.
void blot(const Speckles& s, const Map& map, double X, double Y, std::vector<double>& light) {
  const auto [x, y] = map.forward(X, Y);
  const double across = kReach * s.size * std::hypot(s.F[0], s.F[1]),
               down = kReach * s.size * std::hypot(s.F[2], s.F[3]);
  const int left = std::max(0, static_cast<int>(std::ceil(x - across))),
            right = std::min(s.width - 1, static_cast<int>(std::floor(x + across)));
  const int top = std::max(0, static_cast<int>(std::ceil(y - down))),
            bottom = std::min(s.height - 1, static_cast<int>(std::floor(y + down)));
  for (int row = top; row <= bottom; ++row)
    for (int column = left; column <= right; ++column) {
      const auto [a, b] = map.back(column, row);
      const double square = (a - X) * (a - X) + (b - Y) * (b - Y);
      light[static_cast<std::size_t>(row) * static_cast<std::size_t>(s.width) +
            static_cast<std::size_t>(column)] *= 1 - std::exp(-square / (2 * s.size * s.size));
    }
}

}  // namespace

Image draw(const Speckles& s) {
  const auto pixels = static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height);
  std::vector<double> light(pixels, 1);
  const Map map{s};
  // Blots lie on cloth that is half a picture larger all round, so that some come in from outside.
  const double wide = 2.0 * s.width, high = 2.0 * s.height;
  const auto count =
      static_cast<std::size_t>(std::lround(s.cover * wide * high / (std::numbers::pi * s.size * s.size)));
  std::mt19937_64 random(s.pattern);
  const auto part = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (std::size_t i = 0; i < count; ++i) {
    const double X = wide * part() - s.width / 2.0, Y = high * part() - s.height / 2.0;
    blot(s, map, X, Y, light);
  }
  std::mt19937_64 shaken(s.seed);
  std::normal_distribution<double> normal(0, 1);
  Image image{s.width, s.height, std::vector<float>(pixels)};
  for (std::size_t i = 0; i < pixels; ++i) {
    const double value = kDark + (kLight - kDark) * light[i] + (s.noise > 0 ? s.noise * normal(shaken) : 0);
    image.pixels[i] = static_cast<float>(std::clamp(std::round(255 * value) / 255, 0.0, 1.0));
  }
  return image;
}

}  // namespace fabricsh::photograph
