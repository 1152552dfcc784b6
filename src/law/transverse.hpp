// Transverse shear that a law has at least.
#pragma once
#include <array>
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

// Pa: what derived moduli of transverse shear have to carry in bending through the thickness.
struct DerivedShear {
  double shear = 0;  // the modulus, of which 0 is one that is given, or follows the shear in the plane
  double axis = 0;   // the first modulus along the yarn
};
std::array<DerivedShear, 2> derived_shear(const card::Card& card);  // against the bending of warp and of weft

}  // namespace fabricsh::law
