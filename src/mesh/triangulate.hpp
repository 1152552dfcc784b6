// Triangles between given points inside a border, with exact decisions on integer coordinates.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/curve.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

using GridPoint = std::array<std::int64_t, 2>;  // up to most_coordinate in size
inline constexpr std::int64_t most_coordinate = std::int64_t{1} << 28;

// Twice the area of the triangle a b c, positive if they run counter-clockwise; exact.
std::int64_t doubled_area(const GridPoint& a, const GridPoint& b, const GridPoint& c);
// Whether the segments a b and c d have a point in common.
bool touch(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d);

using Segment = std::array<Index, 2>;  // numbers of two points
using Corners = std::array<Index, 3>;  // of a triangle, counter-clockwise, the smallest number first

// The Delaunay triangles of the points, changed where a segment of the border is not an edge of them, as far
// as they are inside: to the left of the segments. points: all different. border: closed lines that neither
// cross nor touch. The triangles are sorted.
std::vector<Corners> triangulate(const std::vector<GridPoint>& points, const std::vector<Segment>& border);

// --- Moves nodes of a flat mesh of quadrilaterals so that these come closer to squares of one size.

// Moves the nodes of the list in turn, each to where the elements about it are best. For a corner with the
// sides a and b that is (a^2 + b^2) / (2 a x b), 1 in a square, and for an element the mean area over its
// own; the worst count most. An element that is not convex may become so.
void smooth(std::vector<Vec2>& nodes, const std::vector<std::array<Index, 4>>& elements,
            const std::vector<Index>& free);

}  // namespace fabricsh::mesh
