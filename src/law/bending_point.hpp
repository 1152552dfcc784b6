// One point of a bent sheet: curvatures in, moments per width out. Only the card's own bending is used.
#pragma once
#include <optional>

#include "law/bending_spring.hpp"

namespace fabricsh::law {

// One committed point. k12 is the tensor component; M12 is work-conjugate to 2 k12.
struct BendSample {
  double M11 = 0, M22 = 0, M12 = 0;   // N, moment per width
  double k11 = 0, k22 = 0, k12 = 0;   // 1/m
  double stored = 0, dissipated = 0;  // J/m^2
};

class BendingPoint {
 public:
  // Error: the card has no bending of its own, or its bending is refused.
  explicit BendingPoint(const card::Card& card);
  // Reaches the total curvature in one straight increment and commits; components without a value stay.
  BendSample bend(std::optional<double> k11, std::optional<double> k22, std::optional<double> k12);
  void reset();  // returns to flat virgin cloth

 private:
  std::array<BendingSpring, 3> springs_;
  std::array<BendingState<double>, 3> states_;
  BendSample sample_;
};

}  // namespace fabricsh::law
