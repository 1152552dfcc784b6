// Transverse shear that a law has at least.
#pragma once
#include <memory>

#include "law/law.hpp"

namespace fabricsh::law {

// Pa, against the bending of warp and of weft.
struct TransverseModuli {
  double warp = 0, weft = 0;
};

// The card's law with moduli of transverse shear of at least these where they are derived from other numbers
// of the card; null if all are as large, given by the card, or follow the shear in the plane.
std::shared_ptr<const Law> compile_stiffer(const card::Card& card, const TransverseModuli& least);

}  // namespace fabricsh::law
