// Brightness between the pixels of a photograph, by the cubic spline through all of them [unser1999].
#pragma once
#include <array>
#include <vector>

#include "photograph/image.hpp"

namespace fabricsh::photograph {

class Spline {
 public:
  explicit Spline(const Image& image);
  // Whether all pixels that the value at a place is made of lie in the picture.
  bool holds(double column, double row) const {
    return column >= 1 && row >= 1 && column < width_ - 2 && row < height_ - 2;
  }
  // At a place that it holds.
  double at(double column, double row) const;
  // Brightness per pixel along columns and rows, in the middle of a pixel that is not at the rim.
  std::array<double, 2> slope(int column, int row) const;
  // The variance that independent noise of the pixels, with variance one, has in the value at a place, less
  // between pixels than on them, and in either slope.
  static double kept(double column, double row);
  static double slope_noise();

 private:
  const double* place(int column, int row) const {
    return weights_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + column;
  }

  int width_, height_;
  std::vector<double> weights_;
};

}  // namespace fabricsh::photograph
