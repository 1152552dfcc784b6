#include "photograph/spline.hpp"

#include <algorithm>
#include <cmath>

namespace fabricsh::photograph {

namespace {

// From the values along a line to the weights of the cubic B-splines that meet them, mirrored at both ends
// [unser1999]: one recursion forwards and one back.
void prefilter(double* line, int n, int stride) {
  if (n < 2) return;
  const double pole = std::sqrt(3.0) - 2;
  const auto c = [&](int i) -> double& { return line[static_cast<std::ptrdiff_t>(i) * stride]; };
  double sum = c(0), power = pole;
  const int reach = std::min(n - 1, 40);  // pole^40 is below 1e-22
  for (int i = 1; i <= reach; ++i, power *= pole) sum += power * c(i);
  c(0) = 6 * sum;
  for (int i = 1; i < n; ++i) c(i) = 6 * c(i) + pole * c(i - 1);
  c(n - 1) = pole / (pole * pole - 1) * (c(n - 1) + pole * c(n - 2));
  for (int i = n - 2; i >= 0; --i) c(i) = pole * (c(i + 1) - c(i));
}

std::array<double, 4> basis(double t) {
  const double s = 1 - t;
  return {s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * s * s + 3 * s * s * s) / 6,
          t * t * t / 6};
}

// Sum over k of h(k) h(k + m), where the weights are the pixels with h: h(k) = a pole^|k|.
double together(int m) {
  const double pole = std::sqrt(3.0) - 2, square = pole * pole, a = -6 * pole / (1 - square);
  return a * a * std::pow(pole, std::abs(m)) * ((1 + square) / (1 - square) + std::abs(m));
}

double kept_along(double t) {
  static const std::array<double, 4> products{together(0), together(1), together(2), together(3)};
  const auto b = basis(t);
  double sum = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      sum += b[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)] *
             products[static_cast<std::size_t>(std::abs(i - j))];
  return sum;
}

}  // namespace

double Spline::kept(double column, double row) {
  return kept_along(column - std::floor(column)) * kept_along(row - std::floor(row));
}

double Spline::slope_noise() { return (together(0) - together(2)) / 2; }

Spline::Spline(const Image& image)
    : width_(image.width), height_(image.height), weights_(image.pixels.begin(), image.pixels.end()) {
  for (int row = 0; row < height_; ++row)
    prefilter(weights_.data() + static_cast<std::ptrdiff_t>(row) * width_, width_, 1);
  for (int column = 0; column < width_; ++column) prefilter(weights_.data() + column, height_, width_);
}

double Spline::at(double column, double row) const {
  const double c = std::floor(column), r = std::floor(row);
  const auto across = basis(column - c), down = basis(row - r);
  double sum = 0;
  for (int j = 0; j < 4; ++j) {
    const double* line = place(static_cast<int>(c) - 1, static_cast<int>(r) - 1 + j);
    sum += down[j] * (across[0] * line[0] + across[1] * line[1] + across[2] * line[2] + across[3] * line[3]);
  }
  return sum;
}

std::array<double, 2> Spline::slope(int column, int row) const {
  const auto w = [&](int i, int j) { return *place(column + i, row + j); };
  // A difference along one axis, its mean 1 : 4 : 1 along the other.
  const double x = (w(1, -1) - w(-1, -1) + 4 * (w(1, 0) - w(-1, 0)) + w(1, 1) - w(-1, 1)) / 12;
  const double y = (w(-1, 1) - w(-1, -1) + 4 * (w(0, 1) - w(0, -1)) + w(1, 1) - w(1, -1)) / 12;
  return {x, y};
}

}  // namespace fabricsh::photograph
