// How far two simplices may move along straight lines without meeting.
//
// Additive conservative advancement [li2021]: the distance can't fall faster than the corners move against
// each other, so a step of (distance - least)/(fastest approach) is safe, and is repeated until little of the
// first distance is left. Plain doubles; what rounding can do to a distance is taken off it.
#pragma once
#include "contact/touch.hpp"

namespace fabricsh::contact {

enum class Simplices : std::uint8_t { point_triangle, segment_segment };

// Share of the motion from `start` to `end`, 0 to 1, over which the distance stays above `least` (m). 1: all
// of it. Never too large; below 1 also where the motion merely comes near, to a tenth of the distance it
// started with. 0: nearer than `least` at the start already, or as near as rounding can tell.
double safe_share(Simplices kind, const Corners& start, const Corners& end, double least);

// The bound of an explicit step: while twice the largest displacement of any corner (m) stays below the
// smallest gap (m), no two simplices can meet.
inline bool cannot_meet(double displacement, double gap) { return 2 * displacement < gap; }

}  // namespace fabricsh::contact
