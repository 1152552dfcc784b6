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

// The number of a place on a side of a facet, see nearest_part().
inline std::size_t part_on_side(const Touch& touch, std::size_t opposite) {
  if (touch.feature == Feature::point_edge) return opposite;
  const std::size_t first = opposite % 3 + 1;
  return 3 + (touch.weight[first] != 0 ? first : first % 3 + 1);
}

// Calls visit(touch, times) for each place of a facet that counts, the nearest first. Where the facet, its
// sides and corners are nearest to the point in the same place, their counts are added up: most cancel.
template <class Visit>
void each_counted(const Pair& pair, const Corners& x, const FacetTouch& nearest, Visit visit) {
  std::array<int, 7> times{};
  std::array<Touch, 7> touch;
  times[nearest.part] = 1;
  for (std::size_t k = 1; k <= 3; ++k) {
    if (const int corner = pair.corner[k - 1]; corner != 0) {
      touch[3 + k] = point_point(x, 0, int(k));
      times[3 + k] += corner;
    }
    const int edge = pair.edge[k - 1];
    if (edge == 0) continue;
    const Touch side = point_segment(x, 0, int(k % 3 + 1), int((k + 1) % 3 + 1));
    const std::size_t part = part_on_side(side, k);
    touch[part] = side;
    times[part] += edge;
  }
  if (const int first = times[nearest.part]; first != 0) visit(nearest.touch, first);
  for (std::size_t part = 1; part < times.size(); ++part)
    if (part != nearest.part && times[part] != 0) visit(touch[part], times[part]);
}

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
      const double gap = nearest.touch.distance - pair.offset;
      if (gap < reach)
        each_counted(pair, x, nearest, [&](const Touch& touch, int times) { within(touch, times, 0); });
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
