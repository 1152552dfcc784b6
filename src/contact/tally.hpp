// Which facet counts a side or a corner that it shares with others.
//
// A point presses a surface with the sum over its facets, less that over the sides which two facets share,
// plus that over corners. For the point it is the same in which of the facets a side or a corner is counted.
// They are counted where they cancel: for a facet whose nearest place lies on its side nothing is left if it
// counts that side. So there is one facet left for most points, and the others need no look until the point
// comes nearer to another part of them.
#pragma once
#include "contact/search.hpp"

namespace fabricsh::contact {

// Sets Pair::edge and corner of what Candidate::shared says, as they cancel at the positions x (m).
void tally(const Scene& scene, std::span<const Vec3> x, Candidate& candidate);

// m: as long as its points have moved against each other by less, nothing of the facet counts; 0: that is not
// known, or something counts now.
double nothing_counts_for(const Pair& facet, const Corners& x);

}  // namespace fabricsh::contact
