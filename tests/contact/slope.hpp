// Derivatives against central differences, by slope: halving the step must divide the difference by four,
// until rounding takes over; a derivative that is wrong by a constant does not fall at all.
#pragma once
#include <cmath>
#include <functional>
#include <random>

#include "contact/touch.hpp"

namespace fabricsh::test {

using contact::Corners;
using contact::Vector12;

inline Corners moved(const Corners& x, const Vector12& by, double h) {
  Corners out;
  for (std::size_t i = 0; i < 4; ++i) out[i] = x[i] + h * by.segment<3>(3 * int(i));
  return out;
}

// The observed order of central differences of `value` against `slope` along `by`: 2 for a right derivative.
// Both steps are large enough that rounding stays far below the truncation error. Where the difference is at
// rounding already (a quadratic function) it gives 2.
inline double order(const std::function<double(const Corners&)>& value, double slope, const Corners& x,
                    const Vector12& by, double h) {
  const auto error = [&](double step) {
    return std::fabs((value(moved(x, by, step)) - value(moved(x, by, -step))) / (2 * step) - slope);
  };
  const double size = std::fabs(value(x)) + std::fabs(slope) * h, rounding = 1e-14 * size / h;
  const double coarse = error(h), fine = error(h / 2);
  if (fine <= 100 * rounding) return 2;
  return std::log2(coarse / fine);
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vec3 vector(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
  Vector12 direction() {
    Vector12 out;
    for (int i = 0; i < 12; ++i) out[i] = (*this)(-1, 1);
    return out.normalized();
  }

 private:
  std::mt19937 engine_;
};

}  // namespace fabricsh::test
