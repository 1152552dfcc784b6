// A weight from 0 to 1, with two continuous derivatives, by which two crossing segments count.
//
// It falls to zero where the segments are parallel, since their closest points are then not unique;
// and, if requested, where a closest point reaches a segment's end, since a corner takes over there.
#pragma once
#include "contact/touch.hpp"

namespace fabricsh::contact {

struct Fading {
  bool at_ends = false;
  double first = 0.5, second = 0.5;  // share of each segment's length over which the weight fades, 0 to 1/2
};

struct Modulation {
  double value = 0;
  bool constant = true;  // all derivatives are zero
  Vector12 gradient = Vector12::Zero();
};

// The modulation of the segments 0-1 and 2-3. Second derivatives that are not zero go to `hessian`, if given.
Modulation modulation(const Corners& x, const Fading& fading, Matrix12* hessian = nullptr);

}  // namespace fabricsh::contact
