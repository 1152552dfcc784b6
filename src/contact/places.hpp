// The places where a pair touches; used for forces, stiffness and friction.
#pragma once
#include <limits>

#include "contact/pair.hpp"

namespace fabricsh::contact {

// The weight of a place is plain + modulated * (the modulation of the pair).
struct Place {
  Touch touch;
  double plain = 1, modulated = 0;
};

// Calls visit(place) for each place of the pair whose gap (distance of the touch less the
// offset) is below `reach`, m. Returns the smallest gap; infinity for edges that do not cross. The edges and
// corners of a facet are never nearer than the facet, so they are skipped when the facet is out of reach.
template <class Visit>
double visit_places(const Pair& pair, const Corners& x, double reach, Visit visit) {
  const auto within = [&](const Touch& touch, double plain, double modulated) {
    if (touch.distance - pair.offset < reach) visit(Place{touch, plain, modulated});
    return touch.distance - pair.offset;
  };
  switch (pair.kind) {
    case PairKind::facet: {
      const FacetTouch nearest = point_triangle(x);
      const double gap = within(nearest.touch, 1, 0);
      if (gap >= reach) return gap;
      for (int k = 1; k <= 3; ++k) {
        const int edge = pair.edge[std::size_t(k - 1)], corner = pair.corner[std::size_t(k - 1)];
        if (edge != 0) within(point_segment(x, 0, k % 3 + 1, (k + 1) % 3 + 1), edge, 0);
        if (corner != 0) within(point_point(x, 0, k), corner, 0);
      }
      return gap;
    }
    case PairKind::plane:
      return within(point_plane(x), 1, 0);
    case PairKind::edges: {
      const std::optional<Touch> touch = segments_crossing(x);
      return touch ? within(*touch, 0, 1) : std::numeric_limits<double>::infinity();
    }
    case PairKind::wrap: {
      const double gap = within(segment_segment(x), 0, 1);
      if (gap >= reach) return gap;
      within(point_segment(x, 0, 2, 3), 0.5, -0.5);
      within(point_segment(x, 1, 2, 3), 0.5, -0.5);
      return gap;
    }
    case PairKind::segment:
      return within(point_segment(x, 0, 1, 2), 1, 0);
    case PairKind::centre:
      break;
  }
  return within(point_point(x, 0, 1), 1, 0);
}

inline bool modulates(PairKind kind) { return kind == PairKind::edges || kind == PairKind::wrap; }

}  // namespace fabricsh::contact
