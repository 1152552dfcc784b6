// Whether a surface intersects itself or another one: every edge against the triangles near it. For tests and
// for the initial state.
#pragma once
#include <span>
#include <utility>
#include <vector>

#include "contact/touch.hpp"

namespace fabricsh::contact {

// Whether the segment from p to q intersects the triangle, its border included.
bool cuts(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

using Edge = std::array<std::int32_t, 2>;
using Triangle = std::array<std::int32_t, 3>;
// All pairs (edge, triangle), by number, that intersect and share no corner; ascending.
std::vector<std::pair<std::size_t, std::size_t>> intersections(std::span<const Vec3> x,
                                                               std::span<const Edge> edges,
                                                               std::span<const Triangle> triangles);

// The edges that the triangles do not walk as often in either direction, ascending: a surface without them is
// closed. Two triangles share an edge, more where solids touch.
std::vector<Edge> open_edges(std::span<const Triangle> triangles);

// Whether a point lies inside a closed surface whose triangles run counter-clockwise as seen from outside.
bool encloses(std::span<const Vec3> x, std::span<const Triangle> triangles, const Vec3& point);

}  // namespace fabricsh::contact
