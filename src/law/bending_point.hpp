// One point of a bent sheet: curvatures in, moments per width out. Only the card's own bending is used.
#pragma once
#include <optional>

#include "base/error.hpp"
#include "card/fields.hpp"
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
  explicit BendingPoint(const card::Card& card) {
    if (!card.bending)
      throw Error(card::at_field(card, "bending") +
                  "expected the card's own bending, {warp=, weft=, twist=} in N.m, got nil");
    springs_ = bending_springs(card);
  }
  // Reaches the total curvature in one straight increment and commits; components without a value stay.
  BendSample bend(std::optional<double> k11, std::optional<double> k22, std::optional<double> k12) {
    BendSample out;
    out.k11 = k11.value_or(sample_.k11);
    out.k22 = k22.value_or(sample_.k22);
    out.k12 = k12.value_or(sample_.k12);
    const double kappa[] = {out.k11, out.k22, 2 * out.k12};
    double* const M[] = {&out.M11, &out.M22, &out.M12};
    for (std::size_t i = 0; i < springs_.size(); ++i) {
      *M[i] = bending_moment(springs_[i], AtSwitch::loading, kappa[i], states_[i]).M;
      out.stored += bending_stored(springs_[i], kappa[i], states_[i]);
      out.dissipated += states_[i].lost;
    }
    return sample_ = out;
  }

  // Returns to flat virgin cloth.
  void reset() {
    states_ = {};
    sample_ = {};
  }

 private:
  std::array<BendingSpring, 3> springs_;
  std::array<BendingState<double>, 3> states_;
  BendSample sample_;
};

}  // namespace fabricsh::law
