// The share of a straight-line motion that two simplices can make without meeting.
//
// Additive conservative advancement [li2021]: the distance cannot fall faster than the corners approach
// each other, so a step of (distance - least)/(fastest approach) is safe. It is repeated until little
// of the initial distance is left. Plain doubles; a bound of the rounding error is subtracted.
#pragma once
#include "contact/touch.hpp"

namespace fabricsh::contact {

enum class Simplices : std::uint8_t { point_triangle, segment_segment };

// Share of the motion from `start` to `end`, 0 to 1, during which the distance stays above `least`
// (m); never too large. 1: all of it. It may be less although the simplices only come within a
// tenth of their first distance. 0: not above `least` at the start, or equal within rounding.
double safe_fraction(Simplices kind, const Corners& start, const Corners& end, double least);

// Bound for an explicit step: while twice the largest displacement of any
// corner (m) is below the smallest gap (m), no two simplices can meet.
inline bool cannot_meet(double displacement, double gap) { return 2 * displacement < gap; }

}  // namespace fabricsh::contact
