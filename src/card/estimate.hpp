// Bending rigidities of a cloth whose bending was not measured, from its areal mass.
#pragma once
#include "card/card.hpp"

namespace fabricsh::card {

// The median over 309 woven and knitted cloths measured as cantilevers in three directions [feng2022], as
// powers of the areal mass (kg/m2). The twist is what the rigidity at 45 degrees has over a quarter of the
// other two together. Error: the areal mass lies outside of those measured, 0.015 to 0.87 kg/m2.
BendingEstimate bending_of_areal_mass(const Card& card);

}  // namespace fabricsh::card
