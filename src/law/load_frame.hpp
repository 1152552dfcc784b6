// The in-plane frame of a pull at an angle to the warp: axis 1 along the pull, axis 2 across it.
#pragma once
#include <array>
#include <cmath>

namespace fabricsh::law {

// Exact at multiples of 90 degrees, so that a pull along a yarn gives no shear.
class LoadFrame {
 public:
  explicit LoadFrame(double angle) : c_(snap(std::cos(angle))), s_(snap(std::sin(angle))) {}

  // Converts strain (E11 E22 E12, tensor) from the load frame to material axes.
  std::array<double, 3> strain(const std::array<double, 3>& e) const {
    return {c_ * c_ * e[0] + s_ * s_ * e[1] - 2 * c_ * s_ * e[2],
            s_ * s_ * e[0] + c_ * c_ * e[1] + 2 * c_ * s_ * e[2],
            c_ * s_ * (e[0] - e[1]) + (c_ * c_ - s_ * s_) * e[2]};
  }
  // Converts strain (tensor) or stress from material axes to the load frame.
  std::array<double, 3> strain_in(const std::array<double, 3>& e) const {
    return {c_ * c_ * e[0] + s_ * s_ * e[1] + 2 * c_ * s_ * e[2],
            s_ * s_ * e[0] + c_ * c_ * e[1] - 2 * c_ * s_ * e[2],
            c_ * s_ * (e[1] - e[0]) + (c_ * c_ - s_ * s_) * e[2]};
  }
  std::array<double, 3> stress(const std::array<double, 3>& S) const { return strain_in(S); }

 private:
  static double snap(double x) {
    if (std::fabs(x) < 1e-15) return 0;
    return std::fabs(std::fabs(x) - 1) < 1e-15 ? std::copysign(1.0, x) : x;
  }
  double c_, s_;
};

}  // namespace fabricsh::law
