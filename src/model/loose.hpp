// How thick cloth is that nothing presses, as contact has it.
#pragma once
#include "card/card.hpp"

namespace fabricsh::model {

struct Loose {
  double thickness = 0;        // m, at which contact with a plate on either side begins
  double solid_thickness = 0;  // m, what the fibres alone fill
};

// Without a measured compression contact begins at the thickness of the card.
Loose loose(const card::Card& card);

}  // namespace fabricsh::model
