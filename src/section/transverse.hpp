// The stiffness against transverse shear that a section has at least on a mesh.
#pragma once
#include "section/section.hpp"

namespace fabricsh::section {

// Where the card has bending rigidities B of its own, nothing but the assumed transverse shear makes the
// sheet softer than B. It is therefore at least so stiff that it does not show on elements of this size (m):
// where n of them bend between one support and the free end it adds 4 / (20 n^2) of the deflection.
void hide_transverse_shear(Section& section, const card::Card& card, double size);

}  // namespace fabricsh::section
