#include "law/bending_point.hpp"

#include "base/error.hpp"
#include "card/fields.hpp"

namespace fabricsh::law {

BendingPoint::BendingPoint(const card::Card& card) {
  if (!card.bending)
    throw Error(card::at_field(card, "bending") +
                "expected the card's own bending, {warp=, weft=, twist=} in N.m, got nil");
  springs_ = bending_springs(card);
}

void BendingPoint::reset() {
  states_ = {};
  sample_ = {};
}

BendSample BendingPoint::bend(std::optional<double> k11, std::optional<double> k22,
                              std::optional<double> k12) {
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

}  // namespace fabricsh::law
