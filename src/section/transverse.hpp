// The stiffness against transverse shear that a section has at least on a mesh.
#pragma once
#include "section/section.hpp"

namespace fabricsh::section {

// Where the card has bending rigidities B of its own, the assumed transverse shear alone makes the sheet
// softer than B. Raises its stiffness so far that the deflection by shear is small on elements of this size
// (m): of a cantilever n elements long it is 4 / (20 n^2) of that by bending. Without rigidities of its own:
// no change.
void hide_transverse_shear(Section& section, const card::Card& card, double size);

}  // namespace fabricsh::section
