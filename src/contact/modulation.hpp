// How much two segments count as crossing, from 0 to 1, with two continuous derivatives.
//
//   It falls to zero where they are parallel, since their closest points are then not one place, and, if so
//   asked, where the closest points come to an end of either segment, since a corner takes over there.
#pragma once
#include "contact/touch.hpp"

namespace fabricsh::contact {

struct Fading {
  bool at_ends = false;
  double first = 0.5, second = 0.5;  // share of each segment's length over which it fades, 0 to 1/2
};

struct Modulation {
  double value = 0;
  bool constant = true;  // no derivative to be added
  Vector12 gradient = Vector12::Zero();
  Matrix12 hessian = Matrix12::Zero();  // where it was asked for
};

// For the segments 0-1 and 2-3.
Modulation modulation(const Corners& x, const Fading& fading, bool with_hessian);

}  // namespace fabricsh::contact
